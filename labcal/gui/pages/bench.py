"""Bench: every instrument by role with who answered, over which link, and what to do where none did; the cage."""

from __future__ import annotations

import time
from math import hypot
from pathlib import Path

from PySide6.QtCore import Qt, QTimer
from PySide6.QtWidgets import QFileDialog, QHBoxLayout, QSizePolicy, QVBoxLayout, QWidget

from labcal.gui.ipc.answers import Cage, Doubt, Earth, Identified, Instrument
from labcal.gui.ipc.messages import FindOnLines, Identify
from labcal.gui.ipc.wire import Fault
from labcal.gui.theming.theme import GRID, Theme
from labcal.gui.translations.translate import translated
from labcal.gui.viewmodels.answers_again import LIFTED
from labcal.gui.viewmodels.app_state import AppState
from labcal.gui.viewmodels.applied_field import applied_field
from labcal.gui.viewmodels.bench_to_do import remedy_of, to_do
from labcal.gui.viewmodels.lab import Triple
from labcal.gui.viewmodels.lab_now import LIGHT_SHAPES, age_words, field_age, old_s
from labcal.gui.viewmodels.not_at_rest import not_at_rest, why_not_at_rest
from labcal.gui.viewmodels.number_format import format_number, short_number
from labcal.gui.viewmodels.role_words import ORDER, reading_text, role_word
from labcal.gui.viewmodels.simulated_bench import open_simulated_bench
from labcal.gui.widgets.bench_chooser import choose_bench
from labcal.gui.widgets.bench_editor import BenchEditor
from labcal.gui.widgets.cage_view import CageView, vector_colours
from labcal.gui.widgets.common import Card, FaceStack, button, label, set_primary, set_state
from labcal.gui.widgets.fault_card import FaultCard
from labcal.gui.widgets.flow import Flow
from labcal.gui.widgets.kept_focus import focus_kept_in
from labcal.gui.widgets.measurement_table import Table

READINGS_MS = 500
TOGETHER_S = 2  # read no further apart, currents and field are of one moment
MOST_ROWS = 12  # of the table would like to be seen
LETTERS = 40  # of how an instrument stands
HEADINGS = ("role", "instrument", "link", "who answered", "last reading", "state")


def one_sentence(words: str) -> str:
    """What has room in a column beside others; the whole stands above the table."""
    first = words.partition(". ")[0]
    return first if len(first) <= LETTERS else first[: LETTERS - 1].rpartition(" ")[0] + " …"


class BenchPage(QWidget):
    """The bench file's instruments, checked at a click; the cage with the field of now."""

    shows_only = True  # where there is no room for it the page is scrolled, and nothing in it is squeezed

    def __init__(self, app_state: AppState, theme: Theme) -> None:
        super().__init__()
        self._app_state, self._theme = app_state, theme
        column = QVBoxLayout(self)
        column.setContentsMargins(2 * GRID, 2 * GRID, 2 * GRID, 2 * GRID)
        column.setSpacing(2 * GRID)
        self.fault = FaultCard(hands=app_state.hands)
        self.fault.report_requested.connect(app_state.report_requested)
        self.fault.zero_wanted.connect(self.check_all)
        column.addWidget(self.fault)
        self.faces, self.editor = FaceStack(), BenchEditor(app_state, theme)
        self.editor.left.connect(lambda: self.faces.setCurrentIndex(0))
        self.editor.saved.connect(self._edited)
        self.faces.addWidget(self._bench())
        self.faces.addWidget(self.editor)
        column.addWidget(self.faces, 1)
        for changed in (app_state.bench_changed, app_state.watch.was_read):
            changed.connect(self._bench_known)
        app_state.run.changed.connect(self._run_changed)
        self._readings = QTimer(self, interval=READINGS_MS)
        self._readings.timeout.connect(self.show_readings)
        app_state.lab.changed.connect(self._lab_changed)
        self._bench_known()

    def _run_changed(self) -> None:
        if self.check.isEnabled() == self._app_state.run.alive or self._app_state.facts is None:
            self._enable()

    def showEvent(self, event: object) -> None:
        """Readings as they come, while somebody looks."""
        self._readings.start()
        self.show_readings()

    def hideEvent(self, event: object) -> None:
        """Nobody looks."""
        self._readings.stop()

    def set_theme(self, theme: Theme) -> None:
        """States and arrows in the theme's colours."""
        self._theme = theme
        self.editor.set_theme(theme)
        self._bench_known()

    def _bench(self) -> QWidget:
        holder = QWidget()
        column = QVBoxLayout(holder)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(2 * GRID)
        column.addWidget(self._instruments_card())
        column.addWidget(self._cage_card(), 1)
        return holder

    def _instruments_card(self) -> Card:
        card = Card(self.tr("Instruments"), " ")
        self.heading, self.file = card.heading, card.unit
        self.check = button(
            self.tr("Check all"),
            self.tr("Ask every instrument who it is. Nothing is energised or moved."),
        )
        self.check.clicked.connect(self.check_all)
        self.reconnect = button(
            self.tr("Reconnect"),
            self.tr("Let go of every link, read the bench file again and ask every instrument who it is"),
        )
        self.reconnect.clicked.connect(self._reconnect)
        self.choose = button(
            self.tr("Open a bench file …"), self.tr("A bench file (.toml): what stands in the lab, on which lines")
        )
        self.choose.clicked.connect(self._choose)
        self.simulated = simulated = button(self.tr("Simulated lab"), self.tr("A whole lab without hardware"))
        simulated.clicked.connect(lambda: open_simulated_bench(self._app_state))
        self.edit = button(self.tr("Edit …"), self.tr("Settings of this bench file, limits first"))
        self.edit.clicked.connect(lambda: self._edit(self._app_state.bench))
        self.make = button(
            self.tr("New …"), self.tr("Ask who answers on this computer's lines, and write a draft of a bench file")
        )
        self.make.clicked.connect(self._make)
        not_in_a_run = (simulated, self.choose, self.make, self.reconnect, self.check)
        self._tips = {widget: widget.toolTip() for widget in not_in_a_run}
        row = Flow(simulated, self.choose, self.make, self.edit, self.reconnect, self.check, left=True)
        self.table = Table(HEADINGS, 3)
        self.table.show_rows(MOST_ROWS, MOST_ROWS)
        self.table.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Maximum)  # no empty half
        for column in ("last reading", "state"):  # beside the name, where a narrow window shows them too
            header, at = self.table.horizontalHeader(), HEADINGS.index(column)
            header.moveSection(header.visualIndex(at), 2)
        self.empty = label(self.tr("Open a bench file, or take the simulated lab."), "ask", wrap=True)
        self.to_do = label("", wrap=True)
        set_state(self.to_do, "bad")
        self.after_it = label(self.tr("A run goes on and holds the instruments: after it."), "caption", wrap=True)
        self.after_it.hide()
        card.body.addLayout(row)  # above what comes and goes: nothing moves a button away under a click
        card.body.addWidget(self.after_it)
        card.body.addWidget(self.to_do)
        card.body.addWidget(self.empty)
        card.body.addWidget(self.table, 1)
        return card

    def _cage_card(self) -> Card:
        card = Card(self.tr("The cage"), " ")
        self.when = card.unit
        self.cage, self.cage_words = CageView(self._theme), label("", wrap=True)
        self.cage_words.setTextFormat(Qt.TextFormat.RichText)
        row = QHBoxLayout()
        row.addWidget(self.cage, 3)
        row.addWidget(self.cage_words, 1)
        card.body.addLayout(row, 1)
        return card

    def _choose(self) -> None:
        choose_bench(self, self._app_state)

    def _edit(self, file: str) -> None:
        self.editor.open(file)
        self.faces.setCurrentWidget(self.editor)

    def _edited(self, file: str) -> None:
        """The bench that is open is read again."""
        if file == self._app_state.bench:
            self._app_state.open_bench(file)

    def _make(self) -> None:
        path, _ = QFileDialog.getSaveFileName(self, self.tr("A draft of a bench file"), "bench.toml", "*.toml")
        if path:
            self.look_for_instruments(path)

    def look_for_instruments(self, out: str) -> None:
        """Ask who answers, then edit the draft that is written to `out`. Nothing is set."""
        if self._app_state.run.alive:
            return self.fault.show_fault(
                Fault("input", self.tr("A run goes on and holds the instruments; check them after it."))
            )
        self.make.setEnabled(False)
        self._app_state.lab.update(message=self.tr("Asking who answers on this computer's lines …"))
        return self._app_state.off_worker.request(
            FindOnLines(out), lambda said: self._found(out, said), self._not_found
        )

    def _found(self, out: str, said: tuple[str, ...]) -> None:
        self.make.setEnabled(True)
        words = self.tr("{0} answered: {1}").format(len(said), "; ".join(said) or "–")
        self._app_state.lab.update(message=words)
        self._edit(out)

    def _not_found(self, fault: Fault) -> None:
        self.make.setEnabled(True)
        self.fault.show_fault(fault)

    def check_all(self) -> None:
        """Ask every instrument who it is."""
        if self._app_state.run.alive:
            return self.fault.show_fault(
                Fault("input", self.tr("A run goes on and holds the instruments; check them after it."))
            )
        with focus_kept_in(self, self.table):
            self.check.setEnabled(False)
        self._say_asking(self.tr("Asking …"), asking=True)
        return self._app_state.off_worker.request(
            Identify(self._app_state.bench), self._identified, self._not_identified
        )

    def _reconnect(self) -> None:
        if not self._app_state.run.alive:
            for worker in (self._app_state.bench_worker, self._app_state.off_worker):
                worker.close(500)
            self._app_state.open_bench(self._app_state.bench)
        self.check_all()

    def _identified(self, said: Identified) -> None:
        self._app_state.take_identified(said)
        silent = [one.name for one in said.instruments if one.fault is not None]
        answered = self.tr("{0} of {1} instruments answered").format(
            len(said.instruments) - len(silent), len(said.instruments)
        )
        words = self.tr("All {0} instruments answered").format(len(said.instruments))
        self._app_state.lab.update(message=f"{answered}: ✕ {', '.join(silent)}" if silent else words)
        if said.doubt is not None:
            self._show_doubt(said.doubt)
        self._checked()

    def _show_doubt(self, doubt: Doubt) -> None:
        """A zero that the reference did not see was measured again."""
        if doubt.lifted:
            return self._app_state.lab.update(message=translated(str(LIFTED)))
        remedy = self.tr("Who answers for it says so on the terminal: labcal bench check {0} --clear-as NAME")
        name = Path(self._app_state.bench).name
        return self.fault.show_fault(Fault("zero", doubt.words, remedy.format(name), doubt.before))

    def _not_identified(self, fault: Fault) -> None:
        self.fault.show_fault(fault)
        self._checked()

    def _checked(self) -> None:
        self.check.setEnabled(True)
        self._say_asking(self.tr("Check all"), asking=False)
        self._show()

    def _say_asking(self, words: str, *, asking: bool) -> None:
        """On the button, and in the row of each who has not answered yet."""
        self.check.setText(words)
        self._app_state.lab.update(asking=asking)
        self._app_state.grow_old()

    def _bench_known(self) -> None:
        self._show()
        self.show_readings()

    def _show(self) -> None:
        facts = self._app_state.facts
        there = sorted(facts.instruments.items(), key=lambda one: ORDER.index(one[1].role)) if facts else []
        self.heading.setText(self.tr("Instruments of {0}").format(facts.name) if facts else self.tr("Instruments"))
        self.file.setText(Path(self._app_state.bench).name)
        self.file.setToolTip(self._app_state.bench)
        self.empty.setVisible(not there)
        self.table.setVisible(bool(there))
        self._enable()
        set_primary(self.choose, not there)
        self.table.setRowCount(len(there))
        for row, (name, one) in enumerate(there):
            self._show_row(row, name, one)

    def _enable(self) -> None:
        """What asks the instruments waits for the end of a run, and says so."""
        alive, there = self._app_state.run.alive, self._app_state.facts is not None
        self.after_it.setVisible(alive)
        reason = self.after_it.text()
        for widget, tip in self._tips.items():
            asks_them = widget in (self.check, self.reconnect)
            widget.setEnabled(not alive and (there or not asks_them))
            widget.setToolTip(reason if alive else tip)
        self.edit.setEnabled(there)

    def _show_row(self, row: int, name: str, one: Instrument) -> None:
        for column, text in enumerate((role_word(one.role), name, one.link)):
            self.table.set_cell(row, column, text, tip=f"{text}   ({one.driver})")
        self._show_identity(row, name, one.role)

    def _show_identity(self, row: int, name: str, role: str) -> None:
        """Who answered; amber where that is another than is stated, which what is typed at the top may change."""
        facts, answered = self._app_state.facts, self._app_state.answered.get(name)
        identity = (answered.identity if answered is not None else "") or "–"
        simulated = facts is not None and facts.simulated and answered is not None and role == "dut"
        said = self.tr("{0}, simulated: whichever DUT is typed").format(identity) if simulated else identity
        other = dict(self._app_state.lab.state.other_serials).get(name, "")
        ink = self._theme.warning if other else ""
        self.table.set_cell(row, 3, f"▲ {other}: {said}" if other else said, colour=ink)

    def _standing(self, name: str) -> tuple[str, str]:
        """How an instrument stands now, in the words of the panel at the right."""
        now, facts = self._app_state.lab.state.now, self._app_state.facts
        light, words = next(((light, words) for one, light, words in now.lights if one == name), ("absent", ""))
        shape, colour, plain = LIGHT_SHAPES[light]
        role = "" if facts is None else facts.instruments[name].role
        said = words or translated(plain), not_at_rest(role, light, driven=now.driven)
        back = "".join(f", {said}" for one, said in self._app_state.lab.state.back if one == name)
        return f"{shape} {', '.join(filter(None, said))}{back}", {"": "muted", "old": "muted"}.get(colour, colour)

    def _lab_changed(self) -> None:
        """At once, as the panel at the right: at 20 times its pace a lab is another one half a second later."""
        if self.isVisible():
            self._show_lab()

    def show_readings(self) -> None:
        """What each instrument sent last; the coils' currents as they were read back."""
        facts = self._app_state.facts
        set_primary(
            self.check, facts is not None and self._app_state.path.next().page == "Bench"
        )  # the blue one is Next
        self._show_lab()
        self._say_what_to_do()

    def _show_lab(self) -> None:
        run, now, facts = self._app_state.run, self._app_state.lab.state.now, self._app_state.facts
        ages = {name: age_words(since) for name, since in now.heard_old_s}
        seen = now.field_measured_nT  # what the panel at the right says of it
        for row in range(self.table.rowCount()):
            name = self.table.text(row, 1)
            role = "" if facts is None else facts.instruments[name].role
            self._show_identity(row, name, role)
            words, age, said = "–", ages.get(name, ""), run.last.values.get(name)
            if role.startswith("coil"):
                current = now.coil_A["xyz".index(role[-1])]
                words = "–" if current is None else f"{format_number(current, 3)} A"
                age = age_words(now.coil_old_s)
            elif role == "reference" and seen is not None:
                words, age = reading_text(role, seen), field_age(now)
            elif role == "platform" and now.platform_deg is not None:
                words, age = reading_text(role, (now.platform_deg,)), age_words(now.platform_old_s)
            elif said is not None:
                age = age_words(old_s(run.last.read_s[name], time.monotonic()))  # its own: to answer is no reading
                words = reading_text(role, said[1]) + (f" {facts.dut.unit}" if facts and role == "dut" else "")
            old = bool(age) and words != "–"
            standing, colour = self._standing(name)
            text = f"{words}   {age}" if old and not standing.endswith(age) else words  # an age stands once in a row
            self.table.set_cell(row, 4, text, colour=self._theme.muted if old else self._theme.text)
            told = standing, why_not_at_rest(standing), remedy_of(self._app_state, name)
            tip = "\n".join(filter(None, told))
            self.table.set_cell(row, 5, one_sentence(standing), colour=getattr(self._theme, colour), tip=tip)
        self._show_cage()

    def _say_what_to_do(self) -> None:
        """Why Next leads here: what does not answer, or coils that are not known to be at zero."""
        words = to_do(self._app_state)
        self.to_do.setText(words)
        self.to_do.setVisible(bool(words))

    def _show_cage(self) -> None:
        """The field's parts, of what the panel at the right shows; the ambient field where both were read together."""
        facts, now = self._app_state.facts, self._app_state.lab.state.now
        ages = now.coil_old_s, now.field_old_s
        old = ages != (None, None)
        self.when.setText(
            self.tr("as read last, not now; all arrows to one scale") if old else self.tr("all arrows to one scale")
        )
        if facts is None:
            return
        applied, reference = applied_field(now.coil_A, facts.cage.matrix), now.field_measured_nT
        ambient: Triple | None = None
        if now.field_changing:
            reference = None
        elif applied is not None and reference is not None and abs((ages[0] or 0) - (ages[1] or 0)) <= TOGETHER_S:
            ambient = (reference[0] - applied[0], reference[1] - applied[1], reference[2] - applied[2])
        self.cage.show_vectors(applied, ambient, reference)
        words = self._legend((applied, ambient, reference)), self._expected(facts.earth), self._limits(facts.cage)
        self.cage_words.setText("".join(words))

    def _legend(self, vectors: tuple[Triple | None, ...]) -> str:
        names = (self.tr("applied"), self.tr("ambient"), self.tr("reference"))
        lines = []
        for name, colour, vector, arrow in zip(names, vector_colours(self._theme), vectors, "➝➝⇢", strict=True):
            size = "–" if vector is None else f"{format_number(hypot(*vector), 0, signed=False)} nT"
            lines.append(f'<span style="color: {colour}; font-weight: 600">{arrow} {name}</span>&nbsp; {size}')
        return "<br>".join(lines)

    def _expected(self, earth: Earth | None) -> str:
        """What the Earth's field is outdoors at this place today, beside the ambient field that was recorded."""
        if earth is None:
            return ""
        size, U = (format_number(one, 0, signed=False) for one in (earth.magnitude_nT, earth.U_nT))
        return self.tr("<br>{0} here, outdoors: {1} ± {2} nT").format(earth.model, size, U)

    def _limits(self, cage: Cage) -> str:
        most = " / ".join(map(short_number, dict.fromkeys(cage.limit_A)))
        field = format_number(cage.limit_nT, 0, signed=False)
        return self.tr("<br><br>at most {0} A a coil<br>at most {1} nT").format(most, field)

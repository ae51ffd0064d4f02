"""What to run: the procedures on the left, the form of the chosen one beside it, one button."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from functools import partial

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QComboBox, QHBoxLayout, QWidget

from labcal.bench.parameters import for_modes, for_rate
from labcal.gui.ipc.answers import Procedure, Procedures
from labcal.gui.ipc.bench_facts import Bench
from labcal.gui.ipc.messages import ListProcedures, ListRuns, Rehearse
from labcal.gui.ipc.simulated_clock import SPEEDS
from labcal.gui.ipc.wire import Fault
from labcal.gui.theming.theme import GRID
from labcal.gui.translations.sentences import in_words
from labcal.gui.translations.translate import procedure_title, translated
from labcal.gui.viewmodels.app_state import AppState
from labcal.gui.viewmodels.begun_on import begun_on
from labcal.gui.viewmodels.bench_of_run import limits_of
from labcal.gui.viewmodels.path import Wanted
from labcal.gui.viewmodels.plan_words import needs_text, plan_line
from labcal.gui.widgets.common import Card, button, flat, label, set_primary, set_state
from labcal.gui.widgets.flow import Flow
from labcal.gui.widgets.idle_queue import IdleQueue
from labcal.gui.widgets.kept_focus import focus_kept_in
from labcal.gui.widgets.one_place import OnePlace
from labcal.gui.widgets.parameter_form import ParameterForm, title_of
from labcal.gui.widgets.procedure_list import ProcedureList
from labcal.gui.widgets.rolled_form import RolledForm
from labcal.gui.widgets.run_chooser import run_title
from labcal.gui.widgets.work_bar import WorkBar

AREA_PX = 18 * GRID  # of the settings: below a long plan, too, some are in sight
HEADING = Qt.ItemDataRole.UserRole  # of an item that is no procedure
PACE_WORDS = {"true": "real time"}


class Choose(QWidget):
    """Procedures with what they do, and the settings of the one that is chosen."""

    def __init__(self, app_state: AppState) -> None:
        super().__init__()
        self._app_state, self._idle_queue = app_state, IdleQueue(self)
        self._procedures: dict[str, Procedure] = {}
        self.form: ParameterForm | None = None
        self._wanted, self._plan_wanted = Wanted("preflight"), False
        self._shown, self._typed = "", dict[str, dict[str, str]]()  # whose form it is; what was typed, by procedure
        self._proposed, self._is_as_proposed = Wanted(""), False  # with its settings; shown so
        self._typed_for = ""  # the DUT that stood at the top when a setting was typed last
        self._rehearsed: object | None = None  # what is being rehearsed; Start waits for it
        self._planned: tuple[str, dict[str, str]] | None = None  # what the plan is of
        self._planned_on: Bench | None = None  # whose plan it is
        self._cannot_be = False  # so the plan says: nothing is begun before its reason is away
        self._limits = limits_of(None)  # of the bench that the form is for
        self._needs_of: Procedure | None = None  # the procedure of the form, as it is set
        row = QHBoxLayout(self)
        row.setContentsMargins(0, 0, 0, 0)
        row.setSpacing(2 * GRID)
        self.procedures = ProcedureList()
        found = self.procedures
        self.list, self.search, self.none_found = found.list, found.search, found.none_found
        self.list.currentTextChanged.connect(self._chosen)
        row.addWidget(self.procedures, 1)
        row.addWidget(self._form_card(), 3)
        app_state.lab.changed.connect(self._check)
        app_state.bench_changed.connect(self._bench_known)
        app_state.scan_vm.changed.connect(self._check)
        for changed in (app_state.path.changed, app_state.lab.changed, app_state.fault, app_state.fault_over):
            changed.connect(self._show_unfinished)
        app_state.run.ended.connect(self._refresh)
        app_state.request(ListProcedures(), self.show_procedures)

    def showEvent(self, event: object) -> None:
        """What there is now."""
        self._check()
        self._refresh()

    def hideEvent(self, event: object) -> None:
        """Elsewhere what is refused here speaks of the DUT that it was typed for alone."""
        self._check()

    def _refresh(self) -> None:
        """Whether a run is to be gone on with: of this window, or of one before it."""
        self._app_state.request(ListRuns(), self._app_state.path.take_runs)

    def _form_card(self) -> Card:
        card = Card(self.tr("Settings"))
        self.heading, self.title = card.heading, label("", wrap=True)
        self.plan = label("", wrap=True)
        self.plan.setAccessibleName(self.tr("The plan"))
        self.area = RolledForm(self.plan)
        self.needs = label("", "caption", wrap=True)
        self.usual = button(self.tr("Usual settings"), self.tr("Every setting as it was before anybody typed"))
        self.usual.clicked.connect(self._make_usual)
        head = QHBoxLayout()
        head.addWidget(self.title, 1)
        head.addWidget(self.usual, 0, Qt.AlignmentFlag.AlignTop)
        card.body.addLayout(head)
        card.body.addWidget(self.needs)
        card.body.addWidget(self.area, 1)
        self.objection = label("", "caption", wrap=True)
        self.objection.setAlignment(Qt.AlignmentFlag.AlignRight)
        self.pace_label, self.pace = label(self.tr("Simulated time")), QComboBox()
        for pace in SPEEDS:
            self.pace.addItem(translated(PACE_WORDS.get(pace, pace)), pace)
        self.pace.setCurrentIndex(self.pace.findData(str(self._app_state.settings.value("pace", "20 times"))))
        self.pace.setToolTip(
            self.tr("How fast simulated time passes: as in the lab, faster, or as fast as the computer goes")
        )
        self.pace.currentIndexChanged.connect(
            lambda _: self._app_state.settings.setValue("pace", self.pace.currentData())
        )
        tip = self.tr("Asks every instrument who it is, then begins. Nothing is energised before you are asked.")
        self.start = button(self.tr("Begin"), tip, primary=True)
        self.start.clicked.connect(self._start)
        self.show_plan = button(
            self.tr("The plan"),
            self.tr(
                "Rehearse this on the simulated lab: field, rate, angles, temperature, time, and what you are asked"
            ),
        )
        self.show_plan.clicked.connect(self.rehearse)
        self.give_up = button(self.tr("Cancel"), self.tr("End the rehearsal; nothing was begun"))
        self.give_up.clicked.connect(self._give_up)
        self.of_the_plan = OnePlace(self.show_plan, self.give_up)
        self.work = WorkBar()
        row = Flow(self.pace_label, self.pace, self.of_the_plan, self.start)
        for part in (self.work, self.objection, self._unfinished()):
            card.body.addWidget(part)
        card.body.addLayout(row)
        return card

    def _unfinished(self) -> QWidget:
        """A run of the DUT at the top that did not come to its end is gone on with from here."""
        self.unfinished, self.go_on = flat(Card(self.tr("▲ Unfinished run"))), button("", "", primary=True)
        self.go_on.setToolTip(self.tr("What is missing of it; you are asked whether the mounting stands"))
        self.go_on.clicked.connect(self._go_on)
        self.which = label("", "caption", wrap=True)
        self.unfinished.body.addWidget(self.which)
        self.unfinished.body.addWidget(self.go_on, 0, Qt.AlignmentFlag.AlignRight)
        self.unfinished.hide()
        return self.unfinished

    def _show_unfinished(self) -> None:
        app_state = self._app_state
        broken = None if app_state.run.alive else app_state.path.unfinished()
        self.unfinished.setVisible(broken is not None)
        self.go_on.setEnabled(not app_state.objection())
        resumes = broken is not None and app_state.path.next().resumes == broken  # else Next has another run in mind
        calm = not (app_state.off.warns or app_state.lab.state.now.to_be_mended)  # a red card comes first
        set_primary(self.start, calm and not resumes)
        set_primary(self.go_on, calm and resumes)
        if broken is not None:
            other = app_state.path.another_bench(broken)
            self.which.setText("\n".join(filter(None, (run_title(broken), other or begun_on(broken)))))
            set_state(self.which, "warning" if other else "")
            self.go_on.setText(self.tr("Go on with {0}").format(broken.dut_serial))

    def _go_on(self) -> None:
        if (one := self._app_state.path.unfinished()) is not None:
            self._app_state.resume(one.run_id, one.procedure, one.dut_serial)

    def rehearse(self) -> None:
        """Say what the chosen procedure would do, before anything real moves; Start waits for it."""
        self._plan_wanted = self.form is None
        if self.form is None or self._app_state.run.alive or not self._app_state.bench:
            return
        self._rehearsed = mine = object()
        self._planned = name, given = self.list.currentItem().text(), self.form.given()
        self._planned_on, self._cannot_be = self._app_state.facts, False

        def show_plan(text: str) -> None:
            if self._rehearsed is mine:
                self._rehearsed = None
                self.area.show_plan(text)
                self._check()

        def planned(lines: tuple[str, ...]) -> None:
            self._needs_of = replace(self._procedures[name], lasts_min=None)  # the plan says it better
            said = map(plan_line, lines[1:])  # the first stands above as heading
            show_plan("\n".join([*said, *self._what_for()]))

        def refused(fault: Fault) -> None:
            self._cannot_be = self._rehearsed is mine and fault.kind == "input"
            show_plan(f"✕ {in_words(fault.text)} {in_words(fault.remedy)}")

        self.area.show_plan(self.tr("Rehearsing on the simulated lab …"))
        self._check()
        self._app_state.bench_worker.request(Rehearse(name, self._app_state.bench, given), planned, refused)

    def _give_up(self) -> None:
        """Wait for no plan any more: who rehearses it is ended."""
        self._rehearsed = self._planned = None
        self.area.show_plan(self.tr("given up"))
        self._app_state.bench_worker.kill()
        self._check()

    def _what_for(self) -> list[str]:
        """Where the run is wanted to tell causes apart: what becomes of it."""
        study, item = self._app_state.study_vm, self.list.currentItem()
        if not study.wanted or item.text() != study.wanted:
            return []
        words = self.tr("What this measures is added to run {0}; then the cause is decided again, by itself.")
        mine = self.tr("Its settings are those that tell most there; the next run has the usual ones again.")
        return [words.format(study.run), *([mine] if self._is_as_proposed else [])]

    def _make_usual(self) -> None:
        if self.form is not None:
            with focus_kept_in(self, self.form):
                self.form.make_usual()

    def _setting_typed(self) -> None:
        self._typed_for = self._app_state.lab.state.dut_serial
        self._other_settings()

    def _other_settings(self) -> None:
        """A plan is that of its settings."""
        if self.form is not None and (self.list.currentItem().text(), self.form.given()) != self._planned:
            self._forget_plan()
            self._needs_of = self._as_set(self._procedures[self.list.currentItem().text()])
        self._check()
        if self.form is not None and self.form.valid():
            self._app_state.said_for_now.put_away()

    def _forget_plan(self) -> None:
        self._rehearsed = self._planned = None
        self._cannot_be = False
        self.area.show_plan("")

    def show_procedures(self, there: Procedures) -> None:
        """List what there is to run, and by name what does not load, with the reason."""
        self._procedures, self._typed, self._shown = {one.name: one for one in there.found}, {}, ""
        self._app_state.path.take_resumable(frozenset(one.name for one in there.found if one.resumable))
        self.procedures.show_procedures(there)
        self.choose(self._wanted.names, self._wanted.settings)
        if self._plan_wanted:
            self.rehearse()

    def choose(self, names: str, settings: Mapping[str, str] | None = None) -> None:
        """Choose the first procedure there is of `names`, apart by |; also before the list is known.

        With `settings` its form is as it is proposed, for one run; what was typed there before stays for the next.
        """
        self._wanted = Wanted(names, settings=settings or {})
        found = (self.list.findItems(name, Qt.MatchFlag.MatchExactly) for name in names.split("|"))
        if (item := next((items[0] for items in found if items), None)) is None:
            return
        self._proposed = Wanted(item.text(), settings=self._wanted.settings)
        if item is self.list.currentItem() and (settings or self._is_as_proposed):
            self._chosen(item.text())
        self.list.setCurrentItem(item)

    def _chosen(self, name: str) -> None:
        self._keep_typed()
        one = self._procedures[name]
        self.heading.setText(procedure_title(name))
        self.title.setText(in_words(one.title))
        self._needs_of = one
        if self.form is not None and self.form is not self.area.form:
            self.form.hide()  # it never came to be shown, and nothing else would take it away
            self.form.deleteLater()
        self._limits = modes, fastest = limits_of(self._app_state.facts)
        self.form = ParameterForm([for_rate(for_modes(spec, modes), fastest) for spec in one.parameters])
        self._shown = name
        proposed = self._proposed.settings if self._proposed.names == name else {}
        self._is_as_proposed = bool(proposed)
        for key, text in ({} if proposed else self._typed.get(name, {})).items():
            self.form.set_text(key, text)
        self.form.propose(proposed)
        self.form.changed.connect(self._setting_typed)
        self.form.setParent(self.area.viewport())  # it gets its style sheet there, before it is seen
        self._idle_queue.put("form", partial(self._show_form, self.form))
        self._other_settings()

    def _bench_known(self) -> None:
        """A form is that of its bench: another DUT may have other power modes, and another fastest rate."""
        other = self._limits != limits_of(self._app_state.facts)
        if self.form is not None and self._shown in self._procedures and other:
            self._chosen(self._shown)
        if self._cannot_be and self._app_state.facts is not self._planned_on:  # another bench may be able to
            self._forget_plan()
        self._check()

    def _as_set(self, one: Procedure) -> Procedure:
        """How long a procedure takes is known of its own settings alone; of others the plan says it."""
        return replace(one, lasts_min=None) if self.form is not None and self.form.given() else one

    def _keep_typed(self) -> None:
        """Whoever comes back to a procedure finds its settings as they were typed."""
        if self.form is not None and self._shown in self._procedures and not self._is_as_proposed:
            self._typed[self._shown] = self.form.texts()

    def _show_form(self, form: ParameterForm) -> None:
        self.area.hold(form)

    def _check(self) -> None:
        virtual = self._app_state.facts is not None and self._app_state.facts.virtual_time
        for widget in (self.pace, self.pace_label):
            widget.setVisible(virtual)
        objection = self._app_state.objection()
        refused = self.form.refused() if self.form is not None else None
        state = self._app_state.lab.state
        if objection and objection in (state.dut_objection, state.operator_objection):
            objection = self.tr("Correct what is red at the top.")  # where it is said why
            if refused is not None:
                objection = self.tr("Correct what is red at the top, and what is marked ✕ above.")
        if not objection and refused is not None:
            objection = self.tr("A setting is not accepted: see above.")
        if not objection and self._cannot_be:
            objection = self.tr("It cannot be begun as it is set: the plan says why.")
        shortfall = self.form.shortfall() if self.form is not None and self._planned is None else ""  # the plan says it
        doubts = "\n".join(f"▲ {doubt}" for doubt in (self._app_state.named_serials.asked(), shortfall) if doubt)
        self.objection.setText(objection or doubts)
        self.objection.setVisible(bool(self.objection.text()))
        set_state(self.objection, "bad" if objection else "warning")
        if self._needs_of is not None:
            self.needs.setText(needs_text(self._needs_of, plannable=not objection and self._planned is None))
        ready = not objection and self.form is not None and not self._app_state.run.alive and self._rehearsed is None
        rehearsing = self._rehearsed is not None and not self._app_state.run.alive
        with focus_kept_in(self, self.give_up, self.show_plan):
            self.of_the_plan.setCurrentWidget(self.give_up if rehearsing else self.show_plan)
            self.start.setEnabled(ready)
            self.show_plan.setEnabled(ready or (self._cannot_be and not self._app_state.run.alive))
        self.work.show_work(rehearsing)
        of_preflight = self._shown == "preflight"
        mended = self.tr("the plan") if self._cannot_be else title_of(refused) if refused is not None else ""
        speaks = of_preflight and (self.isVisible() or self._typed_for == state.dut_serial)
        self.usual.setEnabled(self.form is not None and not self.form.is_usual())
        self._app_state.path.take_form(mended if speaks else "", self._shown if ready else "")

    def refused_field(self) -> QWidget | None:
        """Where the first setting that is not accepted is typed."""
        refused = self.form.refused() if self.form is not None else None
        return None if self.form is None or refused is None else self.form.fields[refused.name]

    def _start(self) -> None:
        if self.form is not None:
            self._app_state.start(self.list.currentItem().text(), self.form.given())
        if self._is_as_proposed:  # for one run
            self._proposed = Wanted("")
            self._chosen(self._shown)

"""Start, the page of seven in the morning: what holds from yesterday, what is due, and one button."""

from __future__ import annotations

import re
from datetime import UTC, date, datetime

from PySide6.QtCore import QDate, QLocale, Qt, QTimer
from PySide6.QtWidgets import QHBoxLayout, QLabel, QPushButton, QVBoxLayout, QWidget

from labcal.gui.ipc.answers import Cage, CalibrationFile, Checked, RunLine
from labcal.gui.ipc.messages import LastCageCheck, LastClosingCheck, ListCalibrations, ListRuns
from labcal.gui.theming.theme import GRID, STATES, Theme
from labcal.gui.translations.translate import MORNING, MORNING_CHECKS, translated
from labcal.gui.viewmodels.app_state import AppState
from labcal.gui.viewmodels.hands_now import left_words
from labcal.gui.viewmodels.lab_now import mark_of
from labcal.gui.viewmodels.left_without_end import AGAIN_MS
from labcal.gui.viewmodels.number_format import format_number, short_number, step_title
from labcal.gui.viewmodels.path import SHAPES
from labcal.gui.viewmodels.resumed import to_be_resumed
from labcal.gui.viewmodels.run_count import count_words
from labcal.gui.viewmodels.run_results import AT_ONCE, RunResults
from labcal.gui.viewmodels.run_search import cells
from labcal.gui.viewmodels.signing import doubtful
from labcal.gui.viewmodels.simulated_bench import open_simulated_bench
from labcal.gui.viewmodels.what_happens import in_shape
from labcal.gui.widgets.bench_chooser import choose_bench
from labcal.gui.widgets.common import Card, button, label, set_primary, set_state
from labcal.gui.widgets.fact_grid import FactGrid
from labcal.gui.widgets.kept_focus import focus_kept_in
from labcal.gui.widgets.laboratory import Logo
from labcal.gui.widgets.measurement_table import Table
from labcal.gui.widgets.run_chooser import run_title
from labcal.gui.widgets.unfinished_runs import UnfinishedRuns
from labcal.gui.widgets.way_ahead import WayAhead

DUE_DAYS = 365
LAST, LAST_WIDE = 3, AT_ONCE  # runs, where their card has the width of half the page, and of all of it
LAST_RUNS = ("started", "DUT", "result", "calibration", "procedure")
SEEN = LAST  # of them before the page is rolled; where there is more room all
CAGE_DAYS = 30  # a cage calibration older than this is checked again


class StartPage(QWidget):
    """Answers "may I begin?" before it is asked."""

    shows_only = True

    def __init__(self, app_state: AppState, theme: Theme) -> None:
        super().__init__()
        self._app_state = app_state
        self._cage_check: Checked | None = None
        self.again = QTimer(self, interval=AGAIN_MS, singleShot=True)
        self.again.timeout.connect(lambda: self.refresh() if self.isVisible() else None)
        column = QVBoxLayout(self)
        column.setContentsMargins(2 * GRID, 2 * GRID, 2 * GRID, 2 * GRID)
        column.setSpacing(2 * GRID)
        column.addWidget(self._hello_card())
        self.interrupted = UnfinishedRuns(
            app_state, lambda one: app_state.resume(one.run_id, one.procedure, one.dut_serial)
        )
        column.addWidget(self.interrupted)
        self.grid = FactGrid()
        self.grid.laid_out.connect(lambda: self._say_runs(self._app_state.path.runs))
        self._theme, self.results = theme, RunResults(app_state.quick_worker, app_state.path.results)
        self.results.changed.connect(lambda: self._say_runs(self._app_state.path.runs))
        self.facts: dict[str, tuple[QLabel, QLabel]] = {}
        self.check_cage = button(self.tr("Check the cage"), self.tr("The procedure cage-calibration, on the Run page"))
        self.check_cage.clicked.connect(lambda: self._app_state.open_procedure("cage-calibration"))
        titles = {
            "closing": self.tr("Last closing check"),
            "reference": self.tr("Reference sensor"),
            "cage": self.tr("Cage calibration"),
        }
        cards = [self._fact_card(key, title) for key, title in titles.items()]
        self.grid.take([*cards, self._runs_card()])
        column.addWidget(self.grid, 1)
        app_state.bench_changed.connect(self._bench_known)
        app_state.lab.changed.connect(self._enable)
        app_state.run.changed.connect(self._enable)
        app_state.scan_vm.changed.connect(self._enable)
        app_state.run.ended.connect(self.refresh)
        app_state.left.changed.connect(self.refresh)
        app_state.path.changed.connect(self._enable)
        self._bench_known()

    def showEvent(self, event: object) -> None:
        """What holds now."""
        self.refresh()

    def refresh(self) -> None:
        """Ask again."""
        self._app_state.left.look()
        self._app_state.request(ListRuns(), self._runs_known)
        self._app_state.request(LastClosingCheck(), self._closing_known)
        self._app_state.request(LastCageCheck(), self._cage_known)
        self._app_state.request(ListCalibrations(), self._calibrations_known)

    def _hello_card(self) -> Card:
        card = Card()
        today = QLocale().toString(QDate.currentDate(), QLocale.FormatType.LongFormat)
        self.date, self.question = label(today, "caption"), label("", wrap=True)
        self.to_do, self.way = label("", "ask", wrap=True), label("", wrap=True)
        self.go_on = button("", self.tr("The page where that is done"), primary=True)
        self.go_on.clicked.connect(self._app_state.next_requested)
        self.morning = button(
            translated(MORNING),
            self.tr("Signs and axes, the procedure axes-check: 1 minute of measuring, 3 with your own time"),
        )
        self.morning.clicked.connect(self._morning)
        self.calibrate = button(self.tr("Calibrate a DUT"), self.tr("The preflight on the Run page"), primary=True)
        self.calibrate.clicked.connect(lambda: self._app_state.open_procedure("preflight"))
        self.simulated = button(self.tr("Simulated lab"), self.tr("A whole lab without hardware, to learn on"))
        self.simulated.clicked.connect(lambda: open_simulated_bench(self._app_state))
        self.open = button(self.tr("Open a bench …"), self.tr("The file of what stands in this lab"), primary=True)
        self.open.clicked.connect(lambda: choose_bench(self, self._app_state))
        self.logo, self.laboratory = Logo(), label("", "caption", wrap=True)
        row = QHBoxLayout()
        row.setSpacing(GRID)
        row.addWidget(self.logo)
        words = QVBoxLayout()
        words.setSpacing(GRID)
        for said in (self.laboratory, self.date, self.to_do, self.way, self.question):
            words.addWidget(said)
        words.addStretch()
        row.addLayout(words, 1)
        acts = QVBoxLayout()  # below each other: beside each other they are wider than a small window
        for widget in (self.go_on, self.simulated, self.open, self.calibrate, self.morning):
            acts.addWidget(widget)
        acts.addStretch()
        row.addLayout(acts)
        card.body.addLayout(row)
        return card

    def _fact_card(self, key: str, title: str) -> Card:
        card = Card(title)
        word, detail = label("…", "ask"), label(self.tr("Looking into the store."), wrap=True)
        self.facts[key] = word, detail
        card.body.addWidget(word)
        card.body.addWidget(detail)
        if key == "cage":
            card.body.addWidget(self.check_cage, 0, Qt.AlignmentFlag.AlignLeft)
        card.body.addStretch()
        return card

    def _runs_card(self) -> Card:
        card = Card(self.tr("Last runs"), " ")
        self.counted, self.no_runs, self.runs = card.unit, label("", wrap=True), Table(LAST_RUNS, len(LAST_RUNS) - 1)
        self.runs.show_rows(SEEN, LAST)
        self.runs.end_with_rows()
        self.way_ahead = WayAhead()
        for part in (self.no_runs, self.way_ahead):
            card.body.addWidget(part)
        card.body.addWidget(self.runs, 1)
        card.body.addStretch()
        return card

    def set_theme(self, theme: Theme) -> None:
        """Results in the theme's colours."""
        self._theme = theme
        self._say_runs(self._app_state.path.runs)

    def _say(self, key: str, word: str, detail: str, state: str = "") -> None:
        shown, beside = self.facts[key]
        if key == "cage":
            self.check_cage.setVisible(state == "warning")
        shown.setText(word)
        set_state(shown, state)
        beside.setText(detail)

    def _morning(self) -> None:
        self._app_state.open_procedure("|".join(MORNING_CHECKS))

    def _enable(self) -> None:
        run, objection, facts = self._app_state.run, self._app_state.objection(), self._app_state.facts
        lab = self._app_state.lab.state
        to = self._app_state.path.next()
        goes_on = self.tr("A run goes on: {0}, DUT {1}. See the Run page.")
        self.question.setText(
            (goes_on.format(run.order.procedure, run.order.dut) if run.alive and run.order else objection)
            or self._not_ready()
            or "\n".join(filter(None, (in_shape(left_words(lab.now), lab.keep_off[0]), self._broken_off())))
            or (
                self.tr("Ready. {0} is to be measured on {1}.").format(
                    self._app_state.lab.state.dut_serial, "" if facts is None else facts.name
                )
                if to.page == "Run" and self._app_state.lab.state.keep_off[1] != "bad"
                else ""
            )
        )
        self._point()
        if not (known := facts is not None):
            for fact in ("reference", "cage"):
                self._say(fact, *self._no_bench())
        with focus_kept_in(self, self.calibrate):
            for widget in (self.morning, self.calibrate):
                widget.setVisible(known)
                widget.setEnabled(not self._app_state.run.alive and not self._app_state.scan_vm.asks)
            for widget in (self.simulated, self.open):
                widget.setVisible(not known)
            self.check_cage.setEnabled(self.calibrate.isEnabled())

    def _broken_off(self) -> str:
        """A run of the DUT at the top that is to be gone on with comes before another one."""
        here = self._app_state.lab.state.dut_serial
        if here not in self.interrupted.duts:
            return ""
        return self.tr("▲ A run of {0} did not come to its end: go on with it below, or measure anew.").format(here)

    def _not_ready(self) -> str:
        """What the lab itself has against a run, as the side panel shows it; "" where nothing."""
        now = self._app_state.lab.state.now
        if mark_of(now.coil_words)[1] == "bad":
            return self.tr("✕ Not ready: see what is said of the coils.")
        failed = ", ".join(now.failed)
        return self.tr("✕ Not ready: {0}. See the Bench page.").format(failed) if failed else ""

    def _bench_known(self) -> None:
        facts = self._app_state.facts
        self._show_reference("" if facts is None else facts.reference.calibration or "")
        self._show_cage(None if facts is None else facts.cage)
        self.laboratory.setText("" if facts is None else facts.laboratory)
        self.laboratory.setVisible(bool(self.laboratory.text()))
        self._enable()

    def _no_bench(self) -> tuple[str, str]:
        if self._app_state.lab.state.opening:
            return "…", self.tr("The bench is being opened …")
        return self.tr("not known"), self.tr("No bench is open.")

    def _show_reference(self, said: str) -> None:
        if self._app_state.facts is None:
            return self._say("reference", *self._no_bench())
        dated = re.search(r"\d{4}-\d{2}-\d{2}", said)
        if dated is None:
            words = self.tr("The bench file states no calibration date.")
            return self._say("reference", self.tr("not stated"), words)
        days = (datetime.now(UTC).date() - date.fromisoformat(dated.group())).days
        words = self.tr("Calibrated {0}, {1} days ago.").format(dated.group(), days)
        if days > DUE_DAYS:
            return self._say("reference", self.tr("▲ due"), words, "warning")
        return self._say("reference", self.tr("✓ in date"), words, "good")

    def _show_cage(self, cage: Cage | None) -> None:
        if cage is None:
            return self._say("cage", *self._no_bench())
        if self._cage_check is not None:
            return self._show_cage_check(self._cage_check)
        if not cage.stated:
            words = self.tr("Coil constants only: Check the cage measures the matrix.")
            return self._say("cage", self.tr("▲ not measured"), words, "warning")
        if cage.calibration:
            words = self.tr("The matrix is that of the approved cage calibration {0}.").format(cage.calibration)
            return self._say("cage", self.tr("✓ approved"), words, "good")
        words = self.tr("A matrix without a date: Check the cage says whether it holds.")
        return self._say("cage", self.tr("? not checked"), words, "warning")

    def _cage_known(self, said: Checked | None) -> None:
        self._cage_check = said
        self._show_cage(None if self._app_state.facts is None else self._app_state.facts.cage)

    def _show_cage_check(self, said: Checked) -> None:
        """What the last cage-calibration found, and how long ago."""
        days = days_since(said.run.started_utc)
        words = self.tr("Checked {0}, {1} days ago.").format(said.run.started_utc[:10], days)
        if (worst := said.measurement) is not None:
            words += (
                f"\n{step_title(worst.name)}: {format_number(worst.value)} {worst.unit} ({short_number(worst.limit)})"
            )
        self._say_cage(words, days, said.verdict)

    def _say_cage(self, words: str, days: int, verdict: str) -> None:
        """It holds where the last look at it says so, and that is not too long ago."""
        shape, state = STATES.get(verdict, ("", ""))
        if days > CAGE_DAYS:
            return self._say("cage", self.tr("▲ due"), words, "warning")
        found = self.tr("holds") if verdict == "PASS" else translated(verdict)
        return self._say("cage", f"{shape} {found}", words, state)

    def _closing_known(self, said: Checked | None) -> None:
        what = self.tr("At its end a run comes back to a position of before, and has to read the same there.")
        if said is None or said.measurement is None:
            none = self.tr("No finished run in the store has a closing check.")
            return self._say("closing", self.tr("none yet"), f"{none}\n{what}")
        worst = said.measurement
        shape, state = STATES.get(said.verdict, ("", ""))
        U = format_number(2 * worst.u, signed=False)
        limit = "" if worst.limit is None else f" ({short_number(worst.limit)})"
        value = f"{step_title(worst.name)}: {format_number(worst.value)} ± {U} {worst.unit}{limit}"
        return self._say(
            "closing", f"{shape} {translated(said.verdict)}", f"{value}\n{run_title(said.run)}\n{what}", state
        )

    def _runs_known(self, runs: tuple[RunLine, ...]) -> None:
        self._app_state.path.take_runs(runs)
        self._app_state.propose_dut()
        self.results.ask(runs[:LAST_WIDE])
        self._say_runs(runs)
        if any(one.status == "running" for one in runs) and not self._app_state.run.alive:  # in another process
            self.again.start()
        had_focus = self.interrupted.show_runs(to_be_resumed(runs, self._app_state.path.resumable))
        self._enable()
        if had_focus:  # else Qt gives it to the DUT's serial, selected: the next key would replace it
            again = (one for one in self.go_on_buttons if one.objectName() == "primary")
            there = next(again, self.calibrate)
            there.show()
            there.setFocus(Qt.FocusReason.OtherFocusReason)

    def _calibrations_known(self, files: tuple[CalibrationFile, ...]) -> None:
        self._app_state.path.take_calibrations(files)
        self._say_runs(self._app_state.path.runs)

    def _say_runs(self, runs: tuple[RunLine, ...]) -> None:
        """The last ones, how they came out, and what became of their calibrations."""
        words = self.tr("A run from the Run page, or a bundle imported on the History page, comes up here.")
        listed = self._app_state.path.listed  # else nobody knows yet whether there are any
        self.counted.setText(count_words(len(runs)) if runs else self.tr("none yet") if listed else "…")
        self.no_runs.setText("" if runs else words if listed else self.tr("Looking into the store."))
        self.no_runs.setVisible(not runs)
        self.way_ahead.setVisible(
            listed and not runs and self.grid.wide
        )  # with less room the bar below says what is next
        self.runs.setVisible(bool(runs))
        last = runs[: LAST_WIDE if self.grid.wide else LAST]
        self.runs.setRowCount(len(last))
        order = self.runs.horizontalHeader()
        order.moveSection(order.visualIndex(0), 0 if self.grid.wide else 2)  # who and how come before when
        for row, one in enumerate(last):
            self._write_run(row, one)

    def _write_run(self, row: int, one: RunLine) -> None:
        word, state = self.results.word(one)
        started, dut, procedure, _, result, calibration, _ = cells(one, self._app_state.path.stands(one.run_id), word)
        for column, text in enumerate((started, dut, result, calibration or "–", procedure)):
            text = text if column or self.grid.wide else text.partition("-")[2]  # the year is in the tip
            ink = {2: state, 3: "warning" if doubtful(text) else ""}.get(column) or "text"
            self.runs.set_cell(row, column, text, colour=getattr(self._theme, ink), tip=run_title(one))

    @property
    def go_on_buttons(self) -> list[QPushButton]:
        """Those of the runs that can be gone on with, the newest first."""
        return self.interrupted.go_on_buttons

    def _point(self) -> None:
        """The one thing to do, as Next says it: of runs that broke off that which it goes on with."""
        to, known = self._app_state.path.next(), self._app_state.facts is not None
        now = self._app_state.lab.state.now  # it is said above who is silent
        mine = self.interrupted.point(to, mended=not now.to_be_mended, may=known and not now.failed)
        begins = to.page in ("Run", "Start")
        self.to_do.setText(to.words)
        marks = self._app_state.path.marks()
        self.way.setText("  →  ".join(f"{SHAPES[mark]} {translated(page)}" for page, mark in marks.items()))
        self.way.setVisible(known)
        self.go_on.setText(to.words)
        self.go_on.setVisible(known and not begins and not to.off and not self._app_state.run.alive)
        set_primary(self.go_on, not mine)
        set_primary(self.calibrate, not mine and not to.waits and to.page == "Run")


def days_since(utc: str) -> int:
    """Whole days since an ISO 8601 time."""
    return (datetime.now(UTC) - datetime.fromisoformat(utc.replace("Z", "+00:00"))).days

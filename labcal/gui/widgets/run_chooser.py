"""Which run: a list of the store's finished and imported runs, the newest first, kept up to date."""

from __future__ import annotations

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QComboBox, QPushButton, QSizePolicy, QStyledItemDelegate

from labcal.gui.ipc.answers import RunLine
from labcal.gui.ipc.messages import ListRuns
from labcal.gui.translations.translate import translated
from labcal.gui.viewmodels.app_state import AppState
from labcal.gui.viewmodels.run_search import local_time
from labcal.gui.widgets.common import Chooser, button
from labcal.record.endings import ended_word

VISIBLE_CHARS = 10  # of a run's line are seen where there is no room for all
LISTED = ("finished", "imported", "stopped", "interrupted", "failed")
BROKEN = {"stopped": "■", "interrupted": "▲", "failed": "✕"}  # said first of all of a run that did not come to its end
NO_RUNS = "No run yet: record one on the Run page, or import a bundle on the History page."


def run_title(one: RunLine) -> str:
    """A run in one line: which DUT, when, what, whether SIMULATED, how it ended."""
    return f"{run_name(one)} · {translated(ended_word(one.status, stopped=one.stopped, by_off=one.by_off))}"


def run_name(one: RunLine) -> str:
    """Which run it is, on every page: its DUT first, which is seen where there is no room for more."""
    when = f"{local_time(one.started_utc):%Y-%m-%d %H:%M}"
    simulated = translated("SIMULATED") if one.simulated else ""
    return " · ".join(filter(None, (one.dut_serial, when, one.procedure or "bundle", simulated)))


class RunChooser(Chooser):
    """`chosen` carries the run id that a person picked."""

    chosen = Signal(str)
    known = Signal()

    def __init__(self, app_state: AppState) -> None:
        super().__init__()
        self._app_state = app_state
        self.setSizeAdjustPolicy(QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon)
        self.setMinimumContentsLength(VISIBLE_CHARS)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        self.setItemDelegate(QStyledItemDelegate(self))  # Qt's own knows nothing of the style sheet
        self.setAccessibleName(self.tr("Run"))
        self.setToolTip(self.tr("The run to look at, the newest first"))
        self.setPlaceholderText(self.tr("Choose a run"))
        self.activated.connect(lambda index: self.chosen.emit(self.itemData(index)))
        app_state.run.ended.connect(self.refresh)
        app_state.store_changed.connect(self.refresh)
        self._wanted, self.none = "", False

    def showEvent(self, event: object) -> None:
        """The list as it is now."""
        self.refresh()

    def refresh(self) -> None:
        """Ask for the list again."""
        self._app_state.request(ListRuns(), self._known)

    def why_none(self) -> str:
        """Why nothing can be looked at: what is recorded has not ended, or nothing is; "" where something can."""
        run, runs = self._app_state.run, self._app_state.path.runs
        if run.alive and run.order is not None:
            return self.tr("{0} is being measured: its run can be looked at once it has ended.").format(run.order.dut)
        if self.none and runs:
            return self.tr("The run in the store has not ended yet: it can be looked at then.")
        return translated(NO_RUNS) if self.none else ""

    def show_run(self, run: str) -> None:
        """Show `run` as the one that is chosen."""
        self._wanted = run
        self.setCurrentIndex(self.findData(run))

    def _known(self, runs: tuple[RunLine, ...]) -> None:
        self._app_state.path.take_runs(runs)
        kept = self._wanted or self.currentData()
        self.clear()
        for one in runs:
            if one.status.startswith(LISTED):
                self.addItem(run_label(one), one.run_id)
        self.none = self.count() == 0
        self.setCurrentIndex(self.findData(kept))
        if self.isVisible():
            self._app_state.one_dut.take_up()
        self.known.emit()


def run_label(one: RunLine) -> str:
    """A run's line, begun with how it ended where it did not come to its end; of a finished one nothing is said."""
    status = one.status.partition(":")[0]
    if status in BROKEN:
        shape = BROKEN.get(ended_word(one.status, stopped=one.stopped), BROKEN[status])
        word = ended_word(one.status, stopped=one.stopped, by_off=one.by_off)
        return f"{shape} {translated(word)} · {run_name(one)}"
    return run_name(one) if status == "finished" else run_title(one)


def go_to_run_button(app_state: AppState) -> QPushButton:
    """The way out of a page that has no run yet."""
    made = button(translated("Go to Run"), translated("Record a run, or import one on the History page"), primary=True)
    made.clicked.connect(lambda: app_state.page_requested.emit("Run"))
    made.hide()
    return made

"""The runs that broke off and may be gone on with: a button each, and on which bench each was begun."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from PySide6.QtWidgets import QApplication, QLabel, QPushButton, QWidget

from labcal.gui.ipc.answers import RunLine
from labcal.gui.viewmodels.app_state import AppState
from labcal.gui.viewmodels.begun_on import begun_on
from labcal.gui.viewmodels.path import Next
from labcal.gui.viewmodels.run_search import local_time
from labcal.gui.widgets.common import Card, button, label, set_primary, set_state
from labcal.gui.widgets.flow import Flow
from labcal.gui.widgets.run_chooser import run_title

LISTED = 3


class UnfinishedRuns(Card):
    """`resume` goes on with one; `listed`: each with its line and its button."""

    def __init__(self, app_state: AppState, resume: Callable[[RunLine], object]) -> None:
        super().__init__(" ")
        self.heading.setText(self.tr("▲ Unfinished run"))
        self._app_state, self._resume = app_state, resume
        self.listed: list[tuple[RunLine, QLabel, QPushButton]] = []
        self.hide()

    @property
    def duts(self) -> set[str]:
        """Those whose runs are listed."""
        return {one.dut_serial for one, _, _ in self.listed}

    @property
    def go_on_buttons(self) -> list[QPushButton]:
        """Those of the runs that can be gone on with, the newest first."""
        return [again for _, _, again in self.listed]

    def show_runs(self, broken: Sequence[RunLine]) -> bool:
        """A line and a button each; how many more there are is said. Returns whether one of those before had focus."""
        here = QApplication.focusWidget()
        had_focus = here is not None and self.isAncestorOf(here)
        while (old := self.body.takeAt(0)) is not None:
            if (widget := old.widget()) is not None:
                widget.hide()
                widget.deleteLater()
        self.setVisible(bool(broken))
        lost = self.tr(
            "Turns that were finished are kept; the zero, the axes and the timing are measured again. Where none was "
            "finished it begins with the first step."
        )
        more = self.tr("{0} more on the History page.").format(len(broken) - LISTED) if len(broken) > LISTED else ""
        bench = "" if self._app_state.facts is not None else self.tr("Open a bench first.")
        self.body.addWidget(label(" ".join(filter(None, (lost, bench, more))), wrap=True))
        self.listed = [(one, label("", wrap=True), self._go_on_button(one)) for one in broken[:LISTED]]
        for _, where, _ in self.listed:
            self.body.addWidget(where)
        row = QWidget()
        row.setLayout(Flow(*self.go_on_buttons, left=True))
        self.body.addWidget(row)
        return had_focus

    def point(self, to: Next, *, mended: bool, may: bool) -> bool:
        """That which Next goes on with is the one thing to do, once all is `mended`; returns whether it is of these."""
        mine = [to.resumes is not None and one.run_id == to.resumes.run_id for one, _, _ in self.listed]
        for first, (one, where, again) in zip(mine, self.listed, strict=True):
            set_primary(again, first and mended)
            again.setEnabled(may)
            other = self._app_state.path.another_bench(one)
            where.setText(f"{_which(one)}: {other or begun_on(one)}" if other or one.bench else "")
            where.setVisible(bool(where.text()))
            set_state(where, "warning" if other else "")
        return any(mine)

    def _go_on_button(self, one: RunLine) -> QPushButton:
        tip = self.tr("What is missing of it; you are asked whether the mounting stands")
        again = button(self.tr("Go on with {0}").format(_which(one)), f"{run_title(one)}\n{tip}")
        again.clicked.connect(lambda: self._resume(one))
        again.setEnabled(self._app_state.facts is not None)
        return again


def _which(one: RunLine) -> str:
    return f"{one.dut_serial} · {local_time(one.started_utc):%Y-%m-%d %H:%M}"

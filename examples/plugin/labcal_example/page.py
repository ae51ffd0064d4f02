"""A page of the window: how many runs each DUT has in the store."""

from __future__ import annotations

from collections import Counter

from PySide6.QtWidgets import QVBoxLayout, QWidget

from labcal.gui.ipc.answers import RunLine
from labcal.gui.ipc.messages import ListRuns
from labcal.gui.theming.theme import GRID, Theme
from labcal.gui.viewmodels.app_state import AppState
from labcal.gui.widgets.common import Card, button, flat, label


class DutsPage(QWidget):
    """Runs in the store, counted by DUT."""

    def __init__(self, app_state: AppState, theme: Theme) -> None:
        super().__init__()
        self._app_state = app_state
        self.counts = label("", wrap=True)
        self.again = button("Count again", "Ask the store once more")
        self.again.clicked.connect(self.refresh)
        card = flat(Card("Runs of each DUT"))
        card.body.addWidget(self.counts)
        card.body.addWidget(self.again)
        column = QVBoxLayout(self)
        column.setContentsMargins(2 * GRID, 2 * GRID, 2 * GRID, 2 * GRID)
        column.addWidget(card)
        column.addStretch()

    def showEvent(self, event: object) -> None:
        """What is in the store now."""
        self.refresh()

    def refresh(self) -> None:
        """Ask a worker: nothing here waits."""
        self._app_state.request(ListRuns(), self._known)

    def _known(self, runs: tuple[RunLine, ...]) -> None:
        counted = Counter(run.dut_serial for run in runs)
        self.counts.setText("\n".join(f"{dut}: {n}" for dut, n in counted.most_common()) or "No runs yet.")

"""Whether hands may go in while a run is paused, at the size that this has at a question."""

from __future__ import annotations

from PySide6.QtWidgets import QLabel

from labcal.gui.viewmodels.hands_now import dated
from labcal.gui.viewmodels.lab import LabState
from labcal.gui.widgets.common import set_state


class PausedHands(QLabel):
    """Nothing is seen of it else."""

    def __init__(self) -> None:
        super().__init__()
        self.setObjectName("title")
        self.setWordWrap(True)
        self.setAccessibleName(self.tr("Whether hands may go in"))
        self.hide()

    def show_state(self, state: LabState, *, paused: bool) -> None:
        """As the side panel says it."""
        words, mark = dated(*state.hands, state.now)
        self.setText(words)
        set_state(self, mark)
        self.setVisible(paused and bool(words))

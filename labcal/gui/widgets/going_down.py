"""The window is to close when its run has ended: how coils and platform go to rest, until they were read back."""

from __future__ import annotations

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QVBoxLayout, QWidget

from labcal.gui.theming.theme import GRID
from labcal.gui.viewmodels.lab_now import mark_of
from labcal.gui.widgets.common import button, label, set_state
from labcal.gui.widgets.growing_dialog import GrowingDialog
from labcal.gui.widgets.lab_lines import LabLines


class GoingDown(GrowingDialog):
    """`stays`: the window is not to close after all; the run ends none the less."""

    stays = Signal()

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self.setModal(True)
        self.setWindowTitle(self.tr("Closing"))
        self.heading = label(self.tr("Going to zero; the window closes after that …"), "title", wrap=True)
        self.heading.setMinimumWidth(60 * GRID)
        self.lab_lines = LabLines()
        self.stay = button(self.tr("Stay"), self.tr("The run ends, and the window does not close (Esc)"))
        self.stay.clicked.connect(self.reject)
        self.rejected.connect(self.stays)
        column = QVBoxLayout(self)
        column.setContentsMargins(3 * GRID, 3 * GRID, 3 * GRID, 3 * GRID)
        column.setSpacing(2 * GRID)
        for part in (self.heading, self.lab_lines, self.stay):
            column.addWidget(part)

    def say_lab(self, coil_words: str, platform_words: str) -> None:
        """How coils and platform are now."""
        self.lab_lines.say(coil_words, platform_words)
        if mark_of(coil_words)[1] == "bad":  # it is not the way down that is waited for any more
            self.heading.setText(self.tr("HANDS OFF: not at zero yet. The window does not close by itself."))
            set_state(self.heading, "bad")

    def say_end(self) -> None:
        """What stands below was read back."""
        set_state(self.heading, "")
        self.heading.setText(self.tr("The run has ended; the window closes."))

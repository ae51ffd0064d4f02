"""A line to type into that is as wide as what it says is wanted."""

from __future__ import annotations

from PySide6.QtCore import QSize
from PySide6.QtWidgets import QLineEdit

from labcal.gui.theming.theme import GRID

AROUND_PX = 3 * GRID  # its edge, the padding of the style sheet, and what Qt keeps beside the letters


class WantedLine(QLineEdit):
    """Says `wanted` until something is typed; a row gives it the room for all of that in any letters."""

    def __init__(self, wanted: str, tip: str) -> None:
        super().__init__()
        self.setPlaceholderText(wanted)
        self.setAccessibleName(wanted)
        self.setToolTip(tip)

    def sizeHint(self) -> QSize:
        """Qt's own, or as wide as its words."""
        words = self.fontMetrics().horizontalAdvance(self.placeholderText()) + AROUND_PX
        return super().sizeHint().expandedTo(QSize(words, 0))

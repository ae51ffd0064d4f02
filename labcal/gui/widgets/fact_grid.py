"""Cards side by side: where there is room three in a row with the last one below them all; else two by two."""

from __future__ import annotations

from collections.abc import Sequence

from PySide6.QtCore import Signal
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import QGridLayout, QWidget

from labcal.gui.theming.theme import GRID
from labcal.gui.widgets.common import Card

LETTERS = 24  # of a heading that a card holds on a line, or it is too narrow


class FactGrid(QWidget):
    """`wide`: three in a row. `laid_out` when that changes."""

    laid_out = Signal()

    def __init__(self) -> None:
        super().__init__()
        self.wide = False
        self._cards: Sequence[Card] = ()
        self._grid = QGridLayout(self)
        self._grid.setContentsMargins(0, 0, 0, 0)
        self._grid.setSpacing(2 * GRID)

    def take(self, cards: Sequence[Card]) -> None:
        """These, the last of which may be long."""
        self._cards = cards
        self._place()

    def resizeEvent(self, event: QResizeEvent) -> None:
        """As many in a row as there is room for, in letters of the size that they have."""
        super().resizeEvent(event)
        letters = self._cards[0].heading.fontMetrics().averageCharWidth() * LETTERS if self._cards else 0
        if (wide := self.width() >= 3 * (letters + 4 * GRID)) is not self.wide:
            self.wide = wide
            self._place()
            self.laid_out.emit()

    def _place(self) -> None:
        across = 3 if self.wide else 2
        for number, card in enumerate(self._cards):
            last = self.wide and number == len(self._cards) - 1
            self._grid.addWidget(card, number // across, number % across, 1, across if last else 1)
        for column in range(3):
            self._grid.setColumnStretch(column, int(column < across))
        for row in range(2):
            self._grid.setRowStretch(row, int(self.wide and row == 1))  # what may be long has the rest of the page

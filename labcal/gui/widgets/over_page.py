"""A card that lies over the top of the page: it comes and goes, and nothing below moves under anybody's hand."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QObject
from PySide6.QtWidgets import QStackedWidget, QWidget

from labcal.gui.theming.theme import GRID

OVER = "over_page"  # the property of such a card: it covers what it lies over


class OverPage(QObject):
    """Keeps `card` over whichever page of `stack` is in sight, as high as its words need."""

    def __init__(self, card: QWidget, stack: QStackedWidget) -> None:
        super().__init__(stack)
        self._card, self._stack = card, stack
        card.setProperty(OVER, True)
        hidden = card.isHidden()
        card.setParent(stack)  # which hides it
        card.setHidden(hidden)
        for watched in (card, stack):
            watched.installEventFilter(self)
        stack.currentChanged.connect(self._place)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Where the room is another one, or the words are."""
        if event.type() in (QEvent.Type.Resize, QEvent.Type.Show, QEvent.Type.LayoutRequest):
            self._place()
        return False

    def _place(self) -> None:
        card, width = self._card, self._stack.width() - 4 * GRID
        height = max(card.heightForWidth(width), card.minimumSizeHint().height())
        card.setGeometry(2 * GRID, 0, max(0, width), height)
        card.raise_()

"""A column of figures that rolls where there is no room: its bar stands beside them, and no row is cut in two."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QObject, QPoint
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import QLabel, QLayout

from labcal.gui.theming.theme import GRID
from labcal.gui.widgets.rolled import Rolled


class RolledColumn(Rolled):
    """`margin` [px] is kept at the right, and the bar stands in that: figures do not move as it comes and goes."""

    def __init__(self, layout: QLayout, margin: int) -> None:
        self._margin = margin
        super().__init__(layout, least=GRID, beside_bar=margin)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Other rows may have come to the end of what is in sight."""
        taken = super().eventFilter(watched, event)
        if event.type() in (QEvent.Type.LayoutRequest, QEvent.Type.Resize):
            self._end_with_a_row()
        return taken

    def resizeEvent(self, event: QResizeEvent) -> None:
        """The bar has come or gone: what it takes is taken from the margin."""
        super().resizeEvent(event)
        if (layout := self._holder.layout()) is not None:
            layout.setContentsMargins(0, 0, max(0, self._margin - self._bar_width()), 0)
        self._end_with_a_row()

    def _bar_width(self) -> int:
        return self.width() - self.viewport().width()

    def _end_with_a_row(self) -> None:
        """What is in sight before it is rolled ends above the row that would be halved."""
        end = self.height()
        seen = [one for one in self._holder.findChildren(QLabel) if one.isVisible()]
        tops = [(one.mapTo(self._holder, QPoint()).y(), one.height()) for one in seen]
        halved = min((top for top, high in tops if 0 < top < end < top + high), default=end)
        below = end - halved if self._holder.height() > end else 0
        if self.viewportMargins().bottom() != below:
            self.setViewportMargins(0, 0, 0, below)

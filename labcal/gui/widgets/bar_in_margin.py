"""What rolls with its bar in the margin at the right: nothing moves as the bar comes and goes."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QObject, QSize
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import QLayout

from labcal.gui.theming.theme import GRID
from labcal.gui.widgets.rolled import Rolled


class BarInMargin(Rolled):
    """`margin` [px] is kept at the right of `layout`, and the bar stands in that."""

    def __init__(self, layout: QLayout, margin: int) -> None:
        self._margin = margin
        super().__init__(layout, least=GRID, beside_bar=margin)

    def resizeEvent(self, event: QResizeEvent) -> None:
        """The bar has come or gone: what it takes is taken from the margin."""
        super().resizeEvent(event)
        if (layout := self._holder.layout()) is not None:
            layout.setContentsMargins(0, 0, max(0, self._margin - self.width() + self.viewport().width()), 0)


class WholeInWidth(BarInMargin):
    """One that is never narrower than what is in it: only its height is rolled."""

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """It may need another width."""
        taken = super().eventFilter(watched, event)
        if event.type() == QEvent.Type.LayoutRequest:
            self.updateGeometry()
        return taken

    def minimumSizeHint(self) -> QSize:
        """As wide as what is in it, with its margin."""
        layout = self._holder.layout()
        right = self._margin if layout is None else layout.contentsMargins().right()
        return QSize(self._holder.minimumSizeHint().width() - right + self._margin, self.minimumHeight())

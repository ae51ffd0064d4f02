"""A card that is never lower than its wrapped texts."""

from __future__ import annotations

from PySide6.QtCore import QSize
from PySide6.QtGui import QResizeEvent

from labcal.gui.widgets.common import Card


class WholeCard(Card):
    """One that takes the lines of its wrapped texts from no other: a page without room for them is scrolled."""

    def minimumSizeHint(self) -> QSize:
        """As high as its texts are at this width."""
        hint, layout = super().minimumSizeHint(), self.layout()
        if layout is not None and layout.hasHeightForWidth():
            hint.setHeight(max(hint.height(), layout.totalHeightForWidth(self.width())))
        return hint

    def resizeEvent(self, event: QResizeEvent) -> None:
        """At another width they have other lines."""
        super().resizeEvent(event)
        if event.size().width() != event.oldSize().width():
            self.updateGeometry()

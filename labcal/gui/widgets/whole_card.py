"""Cards that are never lower than their wrapped texts."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QSize
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


class UncutCard(Card):
    """One whose texts have their lines at this width, and whatever else is in it the least that it needs."""

    def event(self, event: QEvent) -> bool:
        """A page that is too low rolls, and cuts nothing."""
        done, layout = super().event(event), self.layout()
        if layout is not None and event.type() in (QEvent.Type.Resize, QEvent.Type.LayoutRequest):
            least = layout.totalMinimumHeightForWidth(self.width())
            self.setMinimumHeight(max(0, least))  # where nothing is wrapped Qt says -1
        return done


class SharedCard(UncutCard):
    """One that shares the height of a page with others: it is never laid lower than its least, nor over the next.

    Where heights follow widths Qt asks each part for all it would like, and takes what there is not from the largest,
    whatever its least is. This one has seen to its own.
    """

    def hasHeightForWidth(self) -> bool:
        """Its least height is its own, of the width that it has."""
        return False

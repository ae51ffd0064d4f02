"""A column of figures that rolls where there is no room: no row is cut in two."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QObject, QPoint
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import QLabel

from labcal.gui.widgets.bar_in_margin import BarInMargin


class RolledColumn(BarInMargin):
    """Ends, before it is rolled, above the row that would be halved."""

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Other rows may have come to the end of what is in sight."""
        taken = super().eventFilter(watched, event)
        if event.type() in (QEvent.Type.LayoutRequest, QEvent.Type.Resize):
            self._end_with_a_row()
        return taken

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Another height: another row at its end."""
        super().resizeEvent(event)
        self._end_with_a_row()

    def _end_with_a_row(self) -> None:
        """What is in sight before it is rolled ends above the row that would be halved."""
        end = self.height()
        seen = [one for one in self._holder.findChildren(QLabel) if one.isVisible()]
        tops = [(one.mapTo(self._holder, QPoint()).y(), one.height()) for one in seen]
        halved = min((top for top, high in tops if 0 < top < end < top + high), default=end)
        below = end - halved if self._holder.height() > end else 0
        if self.viewportMargins().bottom() != below:
            self.setViewportMargins(0, 0, 0, below)

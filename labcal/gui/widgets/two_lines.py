"""A sentence that goes on in a second line where there is room for one, and never shows the half of it."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QRect, QSize, Qt
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import QSizePolicy

from labcal.gui.widgets.common import OneLine

ROUNDED_PX = 2  # a line may lack of its spacing, and is whole


class TwoLines(OneLine):
    """As `OneLine`; where its place is high enough it goes on in a second line first."""

    def __init__(self) -> None:
        super().__init__()
        self.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Ignored)

    def minimumSizeHint(self) -> QSize:
        """One line's: what stands beside it says how high its place is."""
        return QSize(1, self.fontMetrics().lineSpacing())

    def sizeHint(self) -> QSize:
        """Likewise."""
        return self.minimumSizeHint()

    def hasHeightForWidth(self) -> bool:
        """No: a longer text makes its place no higher."""
        return False

    def is_cut(self) -> bool:
        """Whether the place is not high enough for all its lines."""
        if not self.wordWrap():
            return super().is_cut()
        place = self.contentsRect()
        room = QRect(0, 0, max(1, place.width()), 10_000)
        needed = self.fontMetrics().boundingRect(room, int(Qt.TextFlag.TextWordWrap), self.text())
        return needed.height() > place.height() + ROUNDED_PX or needed.width() > place.width()

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Another height: another number of lines."""
        super().resizeEvent(event)
        self._wrap()

    def changeEvent(self, event: QEvent) -> None:
        """Larger letters: likewise."""
        super().changeEvent(event)
        if event.type() in (QEvent.Type.FontChange, QEvent.Type.StyleChange):
            self._wrap()

    def _wrap(self) -> None:
        whole = self.contentsRect().height() + ROUNDED_PX >= 2 * self.fontMetrics().lineSpacing()
        if whole is not self.wordWrap():
            self.setWordWrap(whole)

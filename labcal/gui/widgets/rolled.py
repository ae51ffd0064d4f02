"""Words that are rolled where there is no room for them: what stands below them keeps its place."""

from __future__ import annotations

from collections.abc import Sequence

from PySide6.QtCore import QEvent, QObject, QPoint, Qt
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import QLayout, QScrollArea, QWidget

from labcal.gui.theming.theme import GRID

LEAST_PX, MOST_LINES = 16 * GRID, 14  # of them that are in sight without a bar; with more of it buttons would move


class Rolled(QScrollArea):
    """Shows `layout`, as high as its wrapped texts are at this width, never cut; down to `first` without a bar.

    It keeps a height of `least`, and what it shows `beside_bar` from where a bar stands [px].
    """

    def __init__(
        self, layout: QLayout, first: QWidget | None = None, *, least: int = LEAST_PX, beside_bar: int = GRID
    ) -> None:
        super().__init__()
        self._first = first
        self._holder = QWidget()
        self._holder.setLayout(layout)
        layout.setContentsMargins(0, 0, beside_bar, 0)  # no word touches the bar
        self.setWidgetResizable(True)
        self.setFrameShape(QScrollArea.Shape.NoFrame)
        self.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.setMinimumHeight(least)
        self.viewport().setAutoFillBackground(False)
        self.setWidget(self._holder)
        self._holder.setAutoFillBackground(False)
        self._holder.installEventFilter(self)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Other words: other lines, and others at the end of what is in sight."""
        if watched is self._holder and event.type() == QEvent.Type.LayoutRequest:
            self._be_whole()
        if event.type() in (QEvent.Type.LayoutRequest, QEvent.Type.Resize):
            self._end_with_a_row()
        return super().eventFilter(watched, event)

    def resizeEvent(self, event: QResizeEvent) -> None:
        """At another width they have other lines, and at another height another row at the end."""
        super().resizeEvent(event)
        self._be_whole()
        self._end_with_a_row()

    def _rows(self) -> Sequence[QWidget]:
        """What is not to be cut in two where what is in sight ends before it is rolled."""
        return ()

    def _end_with_a_row(self) -> None:
        end, seen = self.height(), [one for one in self._rows() if one.isVisible()]
        tops = [(one.mapTo(self._holder, QPoint()).y(), one.height()) for one in seen]
        halved = min((top for top, high in tops if 0 < top < end < top + high), default=end)
        below = end - halved if self._holder.height() > end else 0
        if self.viewportMargins().bottom() != below:
            self.setViewportMargins(0, 0, 0, below)

    def _be_whole(self) -> None:
        layout = self._holder.layout()
        if layout is not None:
            high = layout.totalMinimumHeightForWidth(self.viewport().width())
            self._holder.setMinimumHeight(max(0, high))  # of a width of nothing Qt says -1
            if self._first is not None and self.minimumHeight() != (least := self._least(layout, self._first)):
                self.setMinimumHeight(least)

    def crowded(self, width: int) -> bool:
        """Whether the gravest words, as wide as this, would end below the middle: what stands above has to be large."""
        layout, first = self._holder.layout(), self._first
        if layout is None or first is None:
            return False
        return 2 * self._end(layout, first, width - self.width() + self.viewport().width()) > self.height()

    def _least(self, layout: QLayout, first: QWidget) -> int:
        """What of it is to be in sight without a bar, at this width."""
        most = MOST_LINES * first.fontMetrics().height()  # letters of another desktop may be higher
        return min(most, max(LEAST_PX, self._end(layout, first, self.viewport().width())))

    def _end(self, layout: QLayout, first: QWidget, width: int) -> int:
        """What stands above the end of the gravest words; 0 where they are not in sight."""
        margins, high = layout.contentsMargins(), 0
        width -= margins.left() + margins.right()
        for n in range(layout.count()):
            item = layout.itemAt(n)
            widget = None if item is None else item.widget()
            if widget is None or widget.isHidden():
                continue
            wrapped = widget.hasHeightForWidth()  # one that fits its letters to its place hints at those it has now
            own = widget.heightForWidth(width) if wrapped else widget.minimumSizeHint().height()
            high += max(own, widget.minimumHeight()) + layout.spacing()
            if widget is first:
                return high
        return 0

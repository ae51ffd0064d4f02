"""Words that are rolled where there is no room for them: what stands below them keeps its place."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QObject, Qt
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import QLayout, QScrollArea, QWidget

from labcal.gui.theming.theme import GRID

LEAST_PX = 16 * GRID


class Rolled(QScrollArea):
    """Shows `layout`, as high as its wrapped texts are at this width, and never cut."""

    def __init__(self, layout: QLayout) -> None:
        super().__init__()
        self._holder = QWidget()
        self._holder.setLayout(layout)
        layout.setContentsMargins(0, 0, GRID, 0)  # no word touches the bar
        self.setWidgetResizable(True)
        self.setFrameShape(QScrollArea.Shape.NoFrame)
        self.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.setMinimumHeight(LEAST_PX)
        self.viewport().setAutoFillBackground(False)
        self.setWidget(self._holder)
        self._holder.setAutoFillBackground(False)
        self._holder.installEventFilter(self)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Other words: other lines."""
        if watched is self._holder and event.type() == QEvent.Type.LayoutRequest:
            self._be_whole()
        return super().eventFilter(watched, event)

    def resizeEvent(self, event: QResizeEvent) -> None:
        """At another width they have other lines."""
        super().resizeEvent(event)
        self._be_whole()

    def _be_whole(self) -> None:
        layout = self._holder.layout()
        if layout is not None:
            high = layout.totalMinimumHeightForWidth(self.viewport().width())
            self._holder.setMinimumHeight(max(0, high))  # of a width of nothing Qt says -1

"""The cage in two projections, from above and from the side, with applied, ambient and total field as arrows."""

from __future__ import annotations

from math import atan2, cos, hypot, sin

from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QSizePolicy, QWidget

from labcal.gui.lab_vm import Triple
from labcal.gui.theme import Theme

VIEWS = (("from above", 0, 1, "X", "Y"), ("from the side", 0, 2, "X", "Z"))


class CageView(QWidget):
    """Vectors in the cage's frame, all to one scale; what is not known is not drawn."""

    def __init__(self, theme: Theme) -> None:
        super().__init__()
        self._theme = theme
        self._vectors: list[tuple[str, str, Triple]] = []
        self.setMinimumHeight(220)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        self.setAccessibleName(self.tr("The cage with its field vectors"))

    def show_vectors(self, applied: Triple | None, ambient: Triple | None, total: Triple | None) -> None:
        """Fields [nT] in the cage's frame."""
        named = (("applied", self._theme.accent, applied), ("ambient", self._theme.muted, ambient),
                 ("total", self._theme.axis_x, total))  # fmt: skip
        self._vectors = [(name, colour, vector) for name, colour, vector in named if vector is not None]
        self.update()

    def paintEvent(self, event: QPaintEvent) -> None:
        """Draw."""
        width = self.width() / len(VIEWS)
        with QPainter(self) as painter:
            painter.setRenderHint(QPainter.RenderHint.Antialiasing)
            for n, (title, right, up, x, y) in enumerate(VIEWS):
                self._view(painter, QRectF(n * width, 0, width, self.height()), self.tr(title), right, up, x, y)

    def _view(self, painter: QPainter, area: QRectF, title: str, right: int, up: int, x: str, y: str) -> None:
        centre = QPointF(area.center().x(), area.center().y() + 8)
        half = 0.36 * min(area.width(), area.height() - 24)
        painter.setPen(QColor(self._theme.muted))
        painter.drawText(QRectF(area.x(), 0, area.width(), 20), Qt.AlignmentFlag.AlignCenter, title)
        painter.setPen(QPen(QColor(self._theme.line), 6))
        painter.setBrush(Qt.BrushStyle.NoBrush)
        painter.drawRect(QRectF(centre.x() - half, centre.y() - half, 2 * half, 2 * half))
        painter.setPen(QPen(QColor(self._theme.line), 1))
        painter.drawLine(QPointF(centre.x() - half, centre.y()), QPointF(centre.x() + half, centre.y()))
        painter.drawLine(QPointF(centre.x(), centre.y() - half), QPointF(centre.x(), centre.y() + half))
        painter.setPen(QColor(self._theme.muted))
        painter.drawText(QPointF(centre.x() + half + 8, centre.y() + 5), x)
        painter.drawText(QPointF(centre.x() - 4, centre.y() - half - 8), y)
        longest = max((hypot(*vector) for _, _, vector in self._vectors), default=0.0) or 1.0
        for name, colour, vector in self._vectors:
            tip = QPointF(
                centre.x() + 0.92 * half * vector[right] / longest, centre.y() - 0.92 * half * vector[up] / longest
            )
            self._arrow(painter, centre, tip, colour, name)

    def _arrow(self, painter: QPainter, start: QPointF, tip: QPointF, colour: str, name: str) -> None:
        if hypot(tip.x() - start.x(), tip.y() - start.y()) < 6:
            return
        painter.setPen(QPen(QColor(colour), 2.4))
        painter.setBrush(QColor(colour))
        painter.drawLine(start, tip)
        angle = atan2(tip.y() - start.y(), tip.x() - start.x())
        wings = [QPointF(tip.x() - 10 * cos(angle + s), tip.y() - 10 * sin(angle + s)) for s in (0.4, -0.4)]
        painter.drawPolygon([tip, *wings])
        painter.drawText(QPointF(tip.x() + 12 * cos(angle) - 4, tip.y() + 14 * sin(angle) + 4), name)

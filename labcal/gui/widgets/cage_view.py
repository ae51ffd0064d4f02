"""The cage in three dimensions and in two projections, with applied, ambient and reference field as arrows.

Drawn by QPainter alone: it looks the same with OpenGL, without it and over a remote screen.
"""

from __future__ import annotations

from math import atan2, cos, hypot, radians, sin

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QKeyEvent, QMouseEvent, QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QSizePolicy, QWidget

from labcal.gui.theming.theme import Theme
from labcal.gui.translations.translate import translated
from labcal.gui.viewmodels.lab import Triple

Array = NDArray[np.float64]
Corner = tuple[float, float, float]
FLAT = (("from above", (0.0, 90.0)), ("from the side", (0.0, 0.0)))  # turn and tilt of the eye [deg]
SPACE_SHARE = 0.5  # of the width
STEP_DEG = 5.0  # a key turns the cage by
REACH = 1.36  # of the names of the axes, in half sides
NAMED_PX, LEAST_PX = 26.0, 6.0  # an axis shorter than these has no name, an arrow is not drawn
HALF_GAP = 0.54  # of a square coil pair's half side: Helmholtz spacing 0.5445 of the side


def seen_from(turn_deg: float, tilt_deg: float) -> Array:
    """Right and up of the eye (2, 3) in the cage's frame, turned about z and tilted above the horizon."""
    t, p = radians(turn_deg), radians(tilt_deg)
    return np.array([[cos(t), sin(t), 0.0], [-sin(t) * sin(p), cos(t) * sin(p), cos(p)]])


def coils() -> list[tuple[int, list[Corner]]]:
    """Axis and corners of the six square windings, half side 1."""
    found = []
    for axis in range(3):
        for place in (-HALF_GAP, HALF_GAP):
            square = []
            for a, b in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
                corner = [float(a), float(a), float(a)]
                corner[axis], corner[(axis + 1) % 3], corner[(axis + 2) % 3] = place, float(a), float(b)
                square.append((corner[0], corner[1], corner[2]))
            found.append((axis, square))
    return found


def half_px(width: float, height: float, share: float, name_px: float) -> float:
    """Half a side of the cage in a place of this size: no name of an axis reaches out of it, in letters of any size."""
    return max(0.0, min(share * min(width, height), (min(width, height) - name_px) / 2 / REACH))


def vector_colours(theme: Theme) -> tuple[str, str, str]:
    """Of the applied, the ambient and the reference field; the last is dashed as well."""
    return theme.text, theme.muted, theme.text


class CageView(QWidget):
    """Vectors in the cage's frame, all to one scale; what is not known is not drawn. Drag, or arrow keys, turn it."""

    def __init__(self, theme: Theme) -> None:
        super().__init__()
        self._theme = theme
        self.vectors: list[tuple[str, Triple]] = []
        self.dashed: Triple | None = None  # of them: that of the reference, which may lie on another
        self.eye = [-28.0, 22.0]
        self._dragged_from: QPointF | None = None
        self.setMinimumHeight(220)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        self.setAccessibleName(self.tr("The cage with its field vectors"))
        self.setToolTip(self.tr("Drag, or use the arrow keys, to look from another side"))

    def set_theme(self, theme: Theme) -> None:
        """Draw in the theme's colours; the vectors come in theirs."""
        self._theme = theme
        self.update()

    def show_vectors(self, applied: Triple | None, ambient: Triple | None, reference: Triple | None) -> None:
        """Fields [nT] in the cage's frame."""
        known = zip(vector_colours(self._theme), (applied, ambient, reference), strict=True)
        self.vectors = [(colour, vector) for colour, vector in known if vector is not None]
        self.dashed = reference
        self.update()

    def turn(self, by_deg: float, tilt_deg: float) -> None:
        """Look from further round, and from higher up."""
        self.eye = [self.eye[0] + by_deg, min(90.0, max(-90.0, self.eye[1] + tilt_deg))]
        self.update()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Arrow keys turn the cage."""
        turns = {Qt.Key.Key_Left: (-1, 0), Qt.Key.Key_Right: (1, 0), Qt.Key.Key_Up: (0, 1), Qt.Key.Key_Down: (0, -1)}
        if (way := turns.get(Qt.Key(event.key()))) is None:
            return super().keyPressEvent(event)
        return self.turn(STEP_DEG * way[0], STEP_DEG * way[1])

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Begin to turn."""
        self._dragged_from = event.position()

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        """Turn by as far as was dragged."""
        if self._dragged_from is not None:
            moved, self._dragged_from = event.position() - self._dragged_from, event.position()
            self.turn(-0.4 * moved.x(), 0.4 * moved.y())

    def paintEvent(self, event: QPaintEvent) -> None:
        """Draw."""
        space = SPACE_SHARE * self.width()
        flat = (self.width() - space) / len(FLAT)
        with QPainter(self) as painter:
            painter.setRenderHint(QPainter.RenderHint.Antialiasing)
            self._view(painter, QRectF(0, 0, space, self.height()), "", seen_from(*self.eye), 0.30)
            for n, (title, eye) in enumerate(FLAT):
                area = QRectF(space + n * flat, 0, flat, self.height())
                self._view(painter, area, translated(title), seen_from(*eye), 0.34)
            if self.hasFocus():
                painter.setPen(QPen(QColor(self._theme.accent), 2))
                painter.setBrush(Qt.BrushStyle.NoBrush)
                painter.drawRect(self.rect().adjusted(1, 1, -1, -1))

    def _view(self, painter: QPainter, area: QRectF, title: str, eye: Array, share: float) -> None:
        letters = painter.fontMetrics()
        above = float(letters.height()) if title else 0.0
        centre = QPointF(area.center().x(), area.center().y() + above / 2)
        half = half_px(area.width(), area.height() - above, share, letters.height())
        painter.setPen(QColor(self._theme.muted))
        painter.drawText(QRectF(area.x(), 0, area.width(), above), Qt.AlignmentFlag.AlignCenter, title)

        def at(point: Array | Corner) -> QPointF:
            x, y = eye @ np.asarray(point)
            return QPointF(centre.x() + half * float(x), centre.y() - half * float(y))

        self._paint_coils(painter, at, eye)
        self._paint_axes(painter, at)
        longest = max((hypot(*vector) for _, vector in self.vectors), default=0.0) or 1.0
        for colour, vector in self.vectors:
            style = Qt.PenStyle.DotLine if vector is self.dashed else Qt.PenStyle.SolidLine
            self._arrow(painter, centre, at(0.95 * np.asarray(vector) / longest), colour, style)

    def _paint_coils(self, painter: QPainter, at: object, eye: Array) -> None:
        assert callable(at)
        toward = np.cross(eye[0], eye[1])
        painter.setBrush(Qt.BrushStyle.NoBrush)
        for _, square in sorted(coils(), key=lambda one: float(np.mean(one[1], axis=0) @ toward)):
            painter.setPen(QPen(QColor(self._theme.line), 4, j=Qt.PenJoinStyle.RoundJoin))
            painter.drawPolygon([at(corner) for corner in square])

    def _paint_axes(self, painter: QPainter, at: object) -> None:
        assert callable(at)
        for name, colour, end in zip("XYZ", self._theme.axes, np.eye(3), strict=True):
            start, tip, beyond = at((0.0, 0.0, 0.0)), at(1.2 * end), at(REACH * end)
            if hypot(tip.x() - start.x(), tip.y() - start.y()) < NAMED_PX:
                continue
            painter.setPen(QPen(QColor(colour), 1, Qt.PenStyle.DashLine))
            painter.drawLine(start, tip)
            painter.setPen(QColor(colour))
            high = painter.fontMetrics().height()
            place = QRectF(beyond.x() - high / 2, beyond.y() - high / 2, high, high)
            painter.drawText(place, Qt.AlignmentFlag.AlignCenter, name)

    def _arrow(self, painter: QPainter, start: QPointF, tip: QPointF, colour: str, style: Qt.PenStyle) -> None:
        if hypot(tip.x() - start.x(), tip.y() - start.y()) < LEAST_PX:
            return
        painter.setPen(QPen(QColor(colour), 2.4, style))
        painter.setBrush(QColor(colour))
        painter.drawLine(start, tip)
        painter.setPen(QPen(QColor(colour), 2.4))
        angle = atan2(tip.y() - start.y(), tip.x() - start.x())
        wings = [QPointF(tip.x() - 10 * cos(angle + s), tip.y() - 10 * sin(angle + s)) for s in (0.4, -0.4)]
        painter.drawPolygon([tip, *wings])

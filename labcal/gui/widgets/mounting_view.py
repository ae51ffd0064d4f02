"""The mounting, drawn: the DUT as a box on the platform, which body axis is up, and which way it will turn."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from math import atan2, cos, degrees, radians, sin
from typing import Any

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QLineF, QPointF, QRectF, QSize, Qt
from PySide6.QtGui import QColor, QFont, QFontMetricsF, QPainter, QPainterPath, QPaintEvent, QPen, QPolygonF
from PySide6.QtWidgets import QSizePolicy, QWidget

from labcal.geometry import rotate, unit
from labcal.gui.theming.theme import SMALL, TEXT, Theme
from labcal.gui.translations.translate import translated
from labcal.gui.widgets.placed_names import Tip, near, placed

Array = NDArray[np.float64]
TURN, TILT = radians(25), radians(24)  # of the eye, about the vertical and above the horizon
RIGHT = np.array([cos(TURN), sin(TURN), 0.0])
UP = np.array([-sin(TURN) * sin(TILT), cos(TURN) * sin(TILT), cos(TILT)])
TOWARD = np.cross(RIGHT, UP)
BOX = np.array([0.46, 0.36, 0.28])  # half sizes along body x, y, z
WIDE, ABOVE, BELOW_IT = 3.0, 1.7, 0.9  # that the drawing has, in radii of the platform; and above and below its centre
EDGE_PX = 2.0
SMALL_LETTERS = SMALL / TEXT  # as captions have them
BELOW = Qt.AlignmentFlag.AlignHCenter | Qt.AlignmentFlag.AlignTop | Qt.TextFlag.TextWordWrap
FACES = [(axis, sign) for axis in range(3) for sign in (-1, 1)]


class Mounting(QWidget):
    """Draws `drawing` of a prompt: body_from_cage (3x3) on a platform about axis_cage, or a dial's angle_deg."""

    def __init__(self, theme: Theme) -> None:
        super().__init__()
        self._theme = theme
        self._drawing: dict[str, Any] = {}
        self.platform_deg: float | None = None  # None: not known
        self.platform_age = ""
        self._lines: list[QLineF] = []
        self._wanted: list[tuple[QPointF, float, str, str]] = []  # names of arrows: tip, angle, name, colour
        self.names: dict[str, QRectF] = {}  # where each stands
        self.setMinimumSize(QSize(128, 200))
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)

    def set_theme(self, theme: Theme) -> None:
        """Draw in the theme's colours."""
        self._theme = theme
        self.update()

    def show_drawing(self, drawing: Any) -> None:
        """Draw this; what has no picture hides the widget."""
        self._drawing = dict(drawing)
        self.setVisible("body_from_cage" in drawing or "angle_deg" in drawing)
        up = self._up()
        self.setToolTip(self.platform_words() if up else "")
        self.setAccessibleName(self.tr("Drawing: body {0} up").format(up) if up else self.tr("Drawing of a dial"))
        self.update()

    def show_platform(self, angle_deg: float | None, age: str = "") -> None:
        """Draw the DUT as it stands on a platform that stands there; None: nobody knows, and the picture says so.

        `age`: of that reading, in words; "" where it is fresh.
        """
        if (angle_deg, age) != (self.platform_deg, self.platform_age):
            self.platform_deg, self.platform_age = angle_deg, age
            self.setToolTip(self.platform_words() if "body_from_cage" in self._drawing else "")
            self.update()

    def platform_words(self) -> str:
        """At which angle of the platform the DUT is drawn."""
        if self.platform_deg is None:
            return self.tr("drawn for platform angle 0°; where it stands is not known")
        at = self.tr("platform at {0}°").format(str(round(self.platform_deg)).replace("-", "−"))
        return ", ".join(filter(None, (at, self.platform_age)))

    def body(self) -> Array:
        """The DUT's axes (3, 3) in C as drawn, one a row: as stated for angle 0, turned with the platform."""
        stated = np.asarray(self._drawing["body_from_cage"], dtype=float)
        return rotate(self._axis(), np.full(3, radians(self.platform_deg or 0.0)), stated)

    def _up(self) -> str:
        if "body_from_cage" not in self._drawing:
            return ""
        along = np.asarray(self._drawing["body_from_cage"]) @ self._axis()
        most = int(np.argmax(np.abs(along)))
        return ("" if along[most] > 0 else "−") + "XYZ"[most]

    def _axis(self) -> Array:
        return unit(np.asarray(self._drawing.get("axis_cage", (0.0, 0.0, 1.0)), dtype=float))

    def paintEvent(self, event: QPaintEvent) -> None:
        """Draw."""
        with QPainter(self) as painter:
            painter.setRenderHint(QPainter.RenderHint.Antialiasing)
            if "body_from_cage" in self._drawing:
                self._paint_mounting(painter)
            elif "angle_deg" in self._drawing:
                self._paint_dial(painter, float(self._drawing["angle_deg"]))

    def _at(self, point: Array) -> QPointF:
        high = self.height() - self._words_high()
        scale, centre = min(self.width() / WIDE, high / (ABOVE + BELOW_IT)), high * ABOVE / (ABOVE + BELOW_IT)
        return QPointF(self.width() / 2 + scale * float(point @ RIGHT), centre - scale * float(point @ UP))

    def _paint_mounting(self, painter: QPainter) -> None:
        body, axis = self.body(), self._axis()
        self._lines, self._wanted = [], []
        self._paint_platform(painter, axis)
        centre = axis * float(np.abs(body @ axis) @ BOX)
        self._paint_box(painter, body, centre)
        self._paint_axes(painter, body, centre)
        self._paint_turn(painter, axis)
        self._paint_names(painter)
        self._paint_words(painter)

    def _paint_words(self, painter: QPainter) -> None:
        """Below the platform, at which angle of it this is."""
        painter.setPen(QColor(self._theme.muted))
        painter.setFont(self.font())
        top = self.words_top()
        painter.drawText(QRectF(0, top, self.width(), self.height() - top), BELOW, self.platform_words())

    def words_top(self) -> float:
        """Where the words begin: the platform ends there."""
        return self._at(-BELOW_IT * UP).y()

    def _words_high(self) -> float:
        room = QRectF(0, 0, self.width(), 1e4)
        return QFontMetricsF(self.font()).boundingRect(room, BELOW, self.platform_words()).height()

    def _paint_platform(self, painter: QPainter, axis: Array) -> None:
        side = unit(np.cross(axis, (0.3, 0.9, 0.2)))
        rim = 1.0 * rotate(axis, np.radians(np.arange(0, 361, 6.0)), side)
        painter.setPen(QPen(QColor(self._theme.muted), 1.2))
        painter.setBrush(QColor(self._theme.sunken))
        self._outline(painter, [self._at(p) for p in rim])
        for direction, name in zip(np.eye(3), ("cage X", "cage Y", ""), strict=True):
            flat = direction - (direction @ axis) * axis
            if name and np.linalg.norm(flat) > 0.3:
                self._arrow(painter, 0.98 * unit(flat), 1.32 * unit(flat), self._theme.muted, translated(name), 1.4)

    def _paint_box(self, painter: QPainter, body: Array, centre: Array) -> None:
        seen = sorted(FACES, key=lambda face: face[1] * float(body[face[0]] @ TOWARD))[3:]
        for axis, sign in seen:
            painter.setPen(QPen(QColor(self._theme.text), 1.3))
            fill = QColor(self._theme.surface)
            painter.setBrush(
                fill.darker(100 + 6 * axis) if self._theme.name == "light" else fill.lighter(112 + 10 * axis)
            )
            self._outline(painter, [self._at(centre + body.T @ corner) for corner in _corners(axis, sign)])

    def _outline(self, painter: QPainter, corners: list[QPointF]) -> None:
        """Filled, and its edges are lines that no name is to stand on."""
        painter.drawPolygon(QPolygonF(corners))
        self._lines += [QLineF(a, b) for a, b in pairwise([*corners, corners[0]])]

    def _paint_axes(self, painter: QPainter, body: Array, centre: Array) -> None:
        order = sorted(range(3), key=lambda n: float(body[n] @ TOWARD))
        for n in order:
            start, end = centre + BOX[n] * body[n], centre + (BOX[n] + 0.52) * body[n]
            self._arrow(painter, start, end, self._theme.axes[n], translated("body {0}").format("XYZ"[n]), 3.0)

    def _paint_turn(self, painter: QPainter, axis: Array) -> None:
        """An arc with a head in front of the platform: right-handed about its axis."""
        toward = TOWARD - (TOWARD @ axis) * axis
        if np.linalg.norm(toward) < 1e-6:
            return
        path = 1.14 * rotate(axis, np.radians(np.arange(-38, 39, 2.0)), unit(toward))
        painter.setBrush(Qt.BrushStyle.NoBrush)
        painter.setPen(QPen(QColor(self._theme.text), 2.4))
        painter.drawPolyline(QPolygonF([self._at(p) for p in path]))
        self._lines.append(QLineF(self._at(path[0]), self._at(path[-1])))
        self._arrow(painter, path[-3], path[-1] + 1.5 * (path[-1] - path[-2]), self._theme.text, "", 2.4)

    def _arrow(self, painter: QPainter, start: Array, end: Array, colour: str, name: str, width: float) -> None:
        a, b = self._at(start), self._at(end)
        painter.setPen(QPen(QColor(colour), width))
        painter.drawLine(a, b)
        self._lines.append(QLineF(a, b))
        angle = atan2(b.y() - a.y(), b.x() - a.x())
        head = 4 + 2.5 * width
        wings = [QPointF(b.x() - head * cos(angle + s), b.y() - head * sin(angle + s)) for s in (0.42, -0.42)]
        painter.setBrush(QColor(colour))
        painter.drawPolygon(QPolygonF([b, *wings]))
        if name:
            self._wanted.append((b, angle, name, colour))

    def _font(self, name: str, scale: float = 1.0) -> QFont:
        font = QFont(self.font())
        font.setPointSizeF(scale * self.font().pointSizeF())
        font.setBold(name.startswith(translated("body {0}").format("")))
        return font

    def _paint_names(self, painter: QPainter) -> None:
        """Those of the body's axes first: they are what is looked for."""
        wanted = sorted(self._wanted, key=lambda one: not self._font(one[2]).bold())
        within = QRectF(EDGE_PX, 0.0, self.width() - 2 * EDGE_PX, self.words_top())
        for scale in (1.0, SMALL_LETTERS):  # in a small drawing names of the usual size stand on its lines
            fonts = [self._font(name, scale) for _, _, name, _ in wanted]
            sizes = [QFontMetricsF(font).size(0, name) for font, (_, _, name, _) in zip(fonts, wanted, strict=True)]
            tips = [Tip(tip, angle, size) for (tip, angle, _, _), size in zip(wanted, sizes, strict=True)]
            places = placed(tips, self._lines, within)
            if near(tips, places):
                break
        self.names = {name: place for (_, _, name, _), place in zip(wanted, places, strict=True)}
        for (_, _, name, colour), font, place in zip(wanted, fonts, places, strict=True):
            letters = QPainterPath()
            letters.addText(QPointF(place.left(), place.top() + QFontMetricsF(font).ascent()), font, name)
            painter.strokePath(letters, QPen(QColor(self._theme.surface), 4.0))  # no line runs through them
            painter.fillPath(letters, QColor(colour))

    def _paint_dial(self, painter: QPainter, angle_deg: float) -> None:
        radius = 0.38 * min(self.width(), self.height())
        centre = QPointF(self.width() / 2, self.height() / 2)
        painter.setPen(QPen(QColor(self._theme.muted), 1.5))
        painter.setBrush(QColor(self._theme.sunken))
        painter.drawEllipse(centre, radius, radius)
        hand = radians(angle_deg)
        tip = QPointF(centre.x() + radius * cos(hand), centre.y() - radius * sin(hand))
        painter.setPen(QPen(QColor(self._theme.text), 4))
        painter.drawLine(centre, tip)
        painter.drawText(QRectF(0, 0, self.width(), 24), Qt.AlignmentFlag.AlignCenter, f"{degrees(hand):.0f}°")


def _corners(axis: int, sign: int) -> Sequence[Array]:
    """The four corners of one face of the box, in body axes, in order round it."""
    one, other = (axis + 1) % 3, (axis + 2) % 3
    found = []
    for a, b in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
        corner = np.zeros(3)
        corner[axis], corner[one], corner[other] = sign * BOX[axis], a * BOX[one], b * BOX[other]
        found.append(corner)
    return found

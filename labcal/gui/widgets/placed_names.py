"""Where the names of arrows stand: near their tips, over no other name, and where it can be helped on no line."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import product
from math import cos, sin
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QLineF, QPointF, QRectF, QSizeF

AWAY_PX = (8.0, 20.0, 34.0, 50.0, 70.0)
ASIDE = (0.0, 0.5, -0.5, 1.0, -1.0, 1.7, -1.7, 2.4, -2.4)  # rad, from along the arrow
APART_PX = 6.0  # two names that touch are read as one
OFF_PX = 2.0  # a line that touches a name is read as a part of it
POINTS = 24  # of a line that are looked at
OVER_NAME, ON_LINE, FAR, TURNED = 1000.0, 60.0, 1.0, 4.0  # what they cost: a px², a point, a px, a rad


class Tip(NamedTuple):
    """The end of an arrow that points along `angle` [rad, downwards positive], and the size of its name."""

    at: QPointF
    angle: float
    size: QSizeF


def placed(tips: Sequence[Tip], lines: Sequence[QLineF], within: QRectF) -> list[QRectF]:
    """A place for each name, the first before the others; all of it `within`."""
    on_lines = [line.pointAt(n / POINTS) for line in lines for n in range(POINTS + 1)]
    points = np.array([(point.x(), point.y()) for point in on_lines]).reshape(-1, 2)
    found: list[QRectF] = []
    for tip in tips:
        places = [(_at(tip, away, aside, within), away, aside) for away, aside in product(AWAY_PX, ASIDE)]
        costs = [_cost(place, found, points) + FAR * away + TURNED * abs(aside) for place, away, aside in places]
        found.append(places[costs.index(min(costs))][0])
    return found


def near(tips: Sequence[Tip], places: Sequence[QRectF]) -> bool:
    """Whether each name stands nearer to its own tip than to any other, and has not had to go far from it."""
    far = AWAY_PX[1]
    apart = [[_apart(place, tip.at) for tip in tips] for place in places]
    return all(min(row) == row[n] <= far for n, row in enumerate(apart))


def _apart(place: QRectF, point: QPointF) -> float:
    aside = max(place.left() - point.x(), 0.0, point.x() - place.right())
    above = max(place.top() - point.y(), 0.0, point.y() - place.bottom())
    return float(np.hypot(aside, above))


def _at(tip: Tip, away: float, aside: float, within: QRectF) -> QRectF:
    along, width, height = tip.angle + aside, tip.size.width(), tip.size.height()
    x = tip.at.x() + away * cos(along) - width * (1 - cos(along)) / 2
    y = tip.at.y() + away * sin(along) - height * (1 - sin(along)) / 2
    x = max(within.left(), min(x, within.right() - width))
    return QRectF(x, max(within.top(), min(y, within.bottom() - height)), width, height)


def _cost(place: QRectF, taken: Sequence[QRectF], points: NDArray[np.float64]) -> float:
    over = (place.intersected(other.adjusted(-APART_PX, -APART_PX, APART_PX, APART_PX)) for other in taken)
    area = sum(one.width() * one.height() for one in over if one.isValid())
    room = place.adjusted(-OFF_PX, -OFF_PX, OFF_PX, OFF_PX)
    low, high = (room.left(), room.top()), (room.right(), room.bottom())
    return OVER_NAME * area + ON_LINE * int(((points >= low) & (points <= high)).all(axis=1).sum())

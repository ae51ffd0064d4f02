"""The points of a calibration's working range at which its budget is drawn up."""

from __future__ import annotations

import itertools
from collections.abc import Iterator, Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from labcal.model import Calibration
from labcal.model.apply import linearised
from labcal.model.readings import Readings
from labcal.record import Run

Array = NDArray[np.float64]
SETTLED_S = 1e5  # after which a slow response has settled
LOWER = 0.9  # of the largest field: a smallest one above it is no point of its own
ROUNDS = 4  # to the reading at which the field is the wanted one: effects are small against it


@dataclass(frozen=True, slots=True, eq=False)
class Point:
    """A field in B, and the channels at which it is measured."""

    field_nT: Array  # (3,)
    channels: Mapping[str, float]
    says: str


def working_points(calibration: Calibration, run: Run) -> list[Point]:
    """The largest field both ways along each axis, the smallest along each, and both ends of each effect's channel.

    A channel is at its reference value, where k belongs, unless it is the one that is at an end.
    """
    low, high = calibration.validity.field_nT
    at = _reference_values(calibration, run)
    points = [_point(sign * high, axis, at) for sign, axis in itertools.product((1, -1), range(3))]
    if 0 < low < LOWER * high:
        points += [_point(low, axis, at) for axis in range(3)]
    for name in at:
        for end in _ends(run, name):
            points += [_point(high, axis, {**at, name: end}, f", {name} = {end:.4g}") for axis in range(3)]
    return points


def slopes_at(calibration: Calibration, points: list[Point]) -> tuple[Array, Array]:
    """The reading (n, 3) at each point, and how the field depends on the joint parameters there (n, 3, p)."""
    wanted = np.array([point.field_nT for point in points])
    reading = _inverse(calibration, wanted)
    for _ in range(ROUNDS if calibration.effects else 0):
        found, _slopes = linearised(calibration, _at_rest(calibration, points, reading))
        reading = reading + (wanted - found[1::2]) @ np.linalg.inv(calibration.affine.K).T
    return reading, linearised(calibration, _at_rest(calibration, points, reading))[1][1::2]


def _point(size_nT: float, axis: int, channels: Mapping[str, float], more: str = "") -> Point:
    says = f"{abs(size_nT) / 1000:.4g} µT along {'−' if size_nT < 0 else '+'}{'xyz'[axis]}{more}"
    return Point(size_nT * np.eye(3)[axis], dict(channels), says)


def _reference_values(calibration: Calibration, run: Run) -> dict[str, float]:
    """Where each channel of the effects is when it is at no end: its reference value, else what the run had."""
    stated = {**calibration.k_at, **{n: v for e in calibration.effects for n, v in e.reference_value.items()}}
    names = dict.fromkeys(name for effect in calibration.effects for name in effect.channels)
    return {name: stated.get(name, float(np.nanmedian(run.channel(name).values))) for name in names}


def _ends(run: Run, name: str) -> Iterator[float]:
    values = run.channel(name).values
    yield from sorted({float(np.nanmin(values)), float(np.nanmax(values))})


def _inverse(calibration: Calibration, field_nT: Array) -> Array:
    return np.asarray(np.linalg.solve(calibration.affine.K, (field_nT + calibration.affine.k_nT).T).T)


def _at_rest(calibration: Calibration, points: list[Point], reading: Array) -> Readings:
    """Two rows a point, each a segment of its own: the second in the middle of the run's span, all settled."""
    middle = float(np.mean(calibration.span_s))
    names = points[0].channels
    return Readings(
        reading=np.repeat(reading, 2, axis=0),
        t_s=np.tile([middle - SETTLED_S, middle], len(points)),
        segment=np.repeat(np.arange(len(points)), 2),
        mode=np.full(2 * len(points), next(iter(calibration.validity.modes), "")),
        channels={name: np.repeat([point.channels[name] for point in points], 2) for name in names},
    )

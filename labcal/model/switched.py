"""Loads that are switched, in telemetry that is slower than the rows and drawn straight between its samples.

When a load that holds its levels was switched between two samples nobody knows: on the way from one level to the next
it was at either. The straight line is its mean there, f of the way from one end; the variance about it is f (1 − f) of
the step's square, if the moment is as likely anywhere between the two samples. A pulse that one sample saw is drawn
there and back again, and a segment may begin or end on the way: the load was at two levels all the same.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from labcal.model.calibration import Calibration
from labcal.model.effects import of_temperature
from labcal.model.pieces import Recording, Taken, Walk
from labcal.model.records import EffectRecord

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]
HELD = 0.02  # of the span: a smaller step from row to row is none
ALIKE = 0.1  # of a step: as near the next one is on a straight way; a step alone may be a mean over the switching
SHORTEST = 3  # steps of a way, the first and the last shorter than it is steep
LEVEL = 0.1  # of the span: what holds its levels stays as near between two ways, what bends back and forth does not
MOSTLY = 0.5  # of the steps of a load that is switched are none, and of those of a way that is drawn alike


def drawn_between_levels(values: Array, edges: NDArray[np.intp]) -> Mask:
    """Rows (n,) on a straight way from one level to another of a channel that holds its levels most of the time.

    `edges` are the first row of each segment, and n. Straight in the middle: where a way begins or ends between two
    rows its first and last steps are smaller.
    """
    out = np.zeros(len(values), dtype=bool)
    for way in _ways(values, edges):
        out[way] = True
    return out


class EitherLevel:
    """An effect along a recording whose channels were at the level before each way all along it, and at that after."""

    def __init__(self, calibration: Calibration, record: EffectRecord, recording: Recording) -> None:
        self._walks = [Walk(calibration, record, one) for one in _at_either_level(record, recording)]

    def with_variance(self, rows: slice, taken: Taken) -> Taken:
        """What was taken in the rows, with what it may be off: (e − e₀) (e₁ − e) of an effect e between the two."""
        if not self._walks:
            return taken
        before, after = (walk.take(rows).value for walk in self._walks)
        between = np.maximum((taken.value - before) * (after - taken.value), 0.0)
        between[~taken.usable] = 0.0
        return replace(taken, variance=taken.variance + between)


def _at_either_level(record: EffectRecord, recording: Recording) -> list[Recording]:
    """The recording with the effect's channels at either end of each of their ways; none where there is no way.

    The weather is never switched.
    """
    ends: tuple[dict[str, Array], dict[str, Array]] = ({}, {})
    for name in () if of_temperature(record) else record.channels:
        values = recording.readings.channels[name]
        for way in _straight_ways(values, recording.edges):
            for channels, level in zip(ends, (way.before, way.after), strict=True):
                channels.setdefault(name, values.copy())[way.rows] = level
    return [
        replace(recording, readings=replace(recording.readings, channels={**recording.readings.channels, **channels}))
        for channels in ends
        if channels
    ]


@dataclass(frozen=True, slots=True)
class _StraightWay:
    """The rows from one sample to the next, and the levels there."""

    rows: slice
    before: float
    after: float


def _straight_ways(values: Array, edges: NDArray[np.intp]) -> list[_StraightWay]:
    """Each way from level to level; one there and back, of a pulse that one sample saw, is two.

    Of one that begins before its segment, or ends after it, the level out of sight is as far as the rows of a whole way
    lead at its slope: one sample comes as soon after another.
    """
    ways = [straight for way in _ways(values, edges) for straight in _turned_back(values, way)]
    cut = [(way.start in edges[1:-1] or way.start == 0, way.stop in edges) for way in ways]
    whole = [way.stop - way.start for way, (begins, ends) in zip(ways, cut, strict=True) if not (begins or ends)]
    rows = int(np.median(whole)) if whole else 0
    found = []
    for way, (begins, ends) in zip(ways, cut, strict=True):
        before, after = values[way.start], values[way.stop - 1]
        more = (after - before) * max(rows - (way.stop - way.start), 0) / max(way.stop - 1 - way.start, 1)
        found.append(_StraightWay(way, float(before - more * begins), float(after + more * ends)))
    return found


def _turned_back(values: Array, way: slice) -> Iterator[slice]:
    """The parts of a way between which it turns back, each with the row where it does."""
    step = np.diff(values[way])
    corners = way.start + 1 + np.flatnonzero(step[1:] * step[:-1] < 0)
    for start, stop in pairwise([way.start, *corners.tolist(), way.stop - 1]):
        yield slice(start, stop + 1)


def _ways(values: Array, edges: NDArray[np.intp]) -> Iterator[slice]:
    """The rows of each way, with those at either end of it."""
    known = np.isfinite(values)
    if not known.any() or not np.ptp(values[known]):
        return
    step = np.diff(values) / float(np.ptp(values[known]))
    moves = np.abs(step) > HELD
    moves[edges[1:-1] - 1] = False
    if np.mean(moves) > 1 - MOSTLY or not _holds_levels(values, moves, edges):
        return
    begins = np.diff(np.concatenate([[0], moves.astype(np.int8), [0]]))
    moving = list(zip(np.flatnonzero(begins > 0).tolist(), np.flatnonzero(begins < 0).tolist(), strict=True))
    ways = [(start, stop) for start, stop in moving if _straight_on(step[start:stop])]
    if ways:  # then a step alone at the edge of a segment is the rest of one
        ways += [(a, b) for a, b in moving if b == a + 1 and (a in edges or b + 1 in edges)]
    yield from (slice(start, stop + 1) for start, stop in ways)


def _holds_levels(values: Array, moves: Mask, edges: NDArray[np.intp]) -> bool:
    """Whether it is as good as constant from way to way, in most of the stretches between."""
    firsts = np.unique(np.concatenate([np.flatnonzero(moves) + 1, edges[:-1]]))
    stretches = [part for part in np.split(values, firsts) if len(part) > 1 and np.isfinite(part).any()]
    ranges = [float(np.nanmax(part) - np.nanmin(part)) for part in stretches]
    return bool(ranges) and float(np.median(ranges)) <= LEVEL * float(np.ptp(values[np.isfinite(values)]))


def _straight_on(step: Array) -> bool:
    """Whether most of the steps of a way have a neighbour of the same size, but for a tenth; its ends lie between rows.

    A way of two or three steps goes one way.
    """
    if len(step) <= SHORTEST:
        return len(step) > 1 and bool(np.all(step * step[0] > 0))
    inner = step[1:-1]
    same = np.abs(np.diff(inner)) <= ALIKE * np.abs(inner[1:])
    return bool(np.mean(np.append(same, False) | np.append(False, same)) >= MOSTLY)

"""Loads that are switched, in telemetry that is slower than the rows and drawn straight between its samples.

When a load that holds its levels was switched between two samples nobody knows: on the way from one level to the next
it was at either. The straight line is its mean there, f of the way from one end; the variance about it is f (1 − f) of
the step's square, if the moment is as likely anywhere between the two samples.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

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
        for way in _ways(values, recording.edges):
            for channels, end in zip(ends, (way.start, way.stop - 1), strict=True):
                channels.setdefault(name, values.copy())[way] = values[end]
    return [
        replace(recording, readings=replace(recording.readings, channels={**recording.readings.channels, **channels}))
        for channels in ends
        if channels
    ]


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
    for start, stop in zip(np.flatnonzero(begins > 0).tolist(), np.flatnonzero(begins < 0).tolist(), strict=True):
        if _straight_on(step[start:stop]):
            yield slice(start, stop + 1)


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

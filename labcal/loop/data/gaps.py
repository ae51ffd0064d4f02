"""Rows in unresolved gaps of a channel: left out, for every candidate alike, once a cause with evidence rests on it.

Slow telemetry that is drawn straight between its samples may have gaps too: when a load that holds its levels was
switched between two samples nobody knows.
"""

from __future__ import annotations

from collections.abc import Collection

import numpy as np
from numpy.typing import NDArray

from labcal.model.effects.regressors import stretches
from labcal.model.gaps import bridged
from labcal.record import Run

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]
HELD = 0.02  # of the span: a smaller step from row to row is none
ALIKE = 0.1  # of a step: as near the next one is on a straight way; a step alone may be a mean over the switching
SHORTEST = 3  # steps of a way, the first and the last shorter than it is steep
MOSTLY = 0.5  # of the steps of a load that is switched are none, and of those of a way that is drawn alike


def unresolved_gaps(run: Run, channels: Collection[str]) -> Mask:
    """Rows (n,) in gaps of these channels whose values cannot be inferred."""
    sure = np.ones(len(run), dtype=bool)
    for channel in run.channels:
        if channel.name in channels:
            sure &= bridged(run.t_s, channel.values)[1]
    return ~sure


def drawn_between_levels(values: Array, segment: NDArray[np.intp]) -> Mask:
    """Rows (n,) on a straight way from one level to another of a channel that holds its levels most of the time.

    Straight in the middle: where a way begins or ends between two rows its first and last steps are smaller.
    """
    known = np.isfinite(values)
    out = np.zeros(len(values), dtype=bool)
    if not known.any() or not np.ptp(values[known]):
        return out
    step = np.diff(values) / float(np.ptp(values[known]))
    moves = (np.abs(step) > HELD) & (segment[1:] == segment[:-1])
    if np.mean(moves) > 1 - MOSTLY:
        return out
    for part in stretches(segment):
        edges = np.flatnonzero(np.diff(np.concatenate([[0], moves[part.start : part.stop - 1], [0]]))) + part.start
        for start, stop in zip(edges[::2].tolist(), edges[1::2].tolist(), strict=True):
            if _straight_on(step[start:stop]):
                out[start : stop + 1] = True
    return out


def _straight_on(step: Array) -> bool:
    """Whether most of the steps of a way have a neighbour of the same size, but for a tenth; its ends lie between rows.

    A way of less than three steps may be one row that is a mean over the switching.
    """
    if len(step) <= SHORTEST:
        return len(step) == SHORTEST
    inner = step[1:-1]
    same = np.abs(np.diff(inner)) <= ALIKE * np.abs(inner[1:])
    return bool(np.mean(np.append(same, False) | np.append(False, same)) >= MOSTLY)

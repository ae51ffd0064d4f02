"""Rows in unresolved gaps of a channel: left out, for every candidate alike, once a cause with evidence rests on it.

Slow telemetry that is drawn straight between its samples has gaps too: a load that is on or off was never halfway, and
when it was switched between two samples nobody knows.
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
AT_A_LEVEL = 0.1  # of the span: as near a row is at one of two levels
MOSTLY = 0.8  # of the rows are at a level of a load that is on or off
TWO_SAMPLES = 2  # rows and more on the way: one alone may be a mean over the switching


def unresolved_gaps(run: Run, channels: Collection[str]) -> Mask:
    """Rows (n,) in gaps of these channels whose values cannot be inferred."""
    sure = np.ones(len(run), dtype=bool)
    for channel in run.channels:
        if channel.name in channels:
            sure &= bridged(run.t_s, channel.values)[1] & ~drawn_between_levels(channel.values, run.segment_index)
    return ~sure


def drawn_between_levels(values: Array, segment: NDArray[np.intp]) -> Mask:
    """Rows (n,) on a straight way from one level to the other of a channel that has two, and nowhere else to be."""
    known = np.isfinite(values)
    out = np.zeros(len(values), dtype=bool)
    if not known.any() or not np.ptp(values[known]):
        return out
    low, span = float(np.min(values[known])), float(np.ptp(values[known]))
    share = (values - low) / span
    between = (share > AT_A_LEVEL) & (share < 1 - AT_A_LEVEL)
    if np.mean(between[known]) > 1 - MOSTLY:
        return out
    for part in stretches(segment):
        edges = np.flatnonzero(np.diff(np.concatenate([[0], between[part], [0]]))) + part.start
        for start, stop in zip(edges[::2].tolist(), edges[1::2].tolist(), strict=True):
            inside = part.start < start and stop < part.stop and stop - start >= TWO_SAMPLES
            if (
                inside
                and (share[start - 1] < AT_A_LEVEL) != (share[stop] < AT_A_LEVEL)
                and _straight(share[start:stop])
            ):
                out[start - 1 : stop + 1] = True
    return out


def _straight(share: Array) -> bool:
    """Whether a stretch goes on by equal steps, but for a tenth of one."""
    steps = np.diff(share)
    return bool(np.ptp(steps) <= AT_A_LEVEL * np.abs(steps).max())

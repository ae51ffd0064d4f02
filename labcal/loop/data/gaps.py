"""Rows in unresolved gaps of a channel: left out, for every candidate alike, once a cause with evidence rests on it.

Slow telemetry that is drawn straight between its samples has gaps too: a load that is on or off was never halfway, and
when it was switched between two samples nobody knows. A cause that follows a channel after a delay rests on what the
channel was then: its gaps lie as much later.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping

import numpy as np
from numpy.typing import NDArray

from labcal.model.effects import DELAY, Term
from labcal.model.effects.regressors import stretches
from labcal.model.gaps import bridged
from labcal.record import Run

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]
AT_A_LEVEL = 0.1  # of the span: as near a row is at one of two levels
MOSTLY = 0.8  # of the rows are at a level of a load that is on or off
TWO_SAMPLES = 2  # rows and more on the way: one alone may be a mean over the switching


def unresolved_gaps(run: Run, channels: Mapping[str, Collection[float]]) -> Mask:
    """Rows (n,) in gaps of these channels whose values cannot be inferred, now or one of their delays [s] ago."""
    out = np.zeros(len(run), dtype=bool)
    for channel in run.channels:
        if channel.name in channels:
            known = bridged(run.t_s, channel.values)[1]
            gaps = ~known | drawn_between_levels(channel.values, run.segment_index)
            for delay_s in {0.0, *channels[channel.name]} if gaps.any() else ():
                out |= _later(gaps, run.t_s, run.segment_index, delay_s)
    return out


def delays_of(terms: Iterable[Term]) -> dict[str, set[float]]:
    """The delays [s] after which terms follow each of their channels."""
    out = dict[str, set[float]]()
    for term in terms:
        late = term.of(DELAY)
        for name in term.channels:
            out.setdefault(name, set()).update([] if late is None else [late.value])
    return out


def _later(gaps: Mask, t_s: Array, segment: NDArray[np.intp], delay_s: float) -> Mask:
    """Rows (n,) whose time less the delay lies in a gap, or between a row in a gap and the next one."""
    if not delay_s:
        return gaps
    out = np.zeros_like(gaps)
    for part in stretches(segment):
        share = np.interp(t_s[part] - delay_s, t_s[part], gaps[part].astype(float))
        out[part] = share > 0
    return out


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

"""Channels with gaps, by what they are: a switched load keeps its level, what moves smoothly is bridged.

A gap is sure where its values can be inferred: of a switched channel where the level is the same on both sides and
the gap is no longer than a level usually lasts, of any other where the gap is shorter than the channel's own memory.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from labcal.record import period_s

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]
JUMP = 0.2  # of the span: a larger move between two rows is a switch
WITHIN = 0.1  # of the variance, at most, lies between the switches of a switched channel


def bridged(t_s: Array, values: Array) -> tuple[Array, Mask]:
    """`values` (n,) with its gaps filled, and the rows that are known or sure."""
    known = np.isfinite(values)
    if known.all():
        return values, known
    t, x, gap = t_s[known], values[known], np.flatnonzero(~known)
    lasting = _lasting_s(t, x)
    before = np.cumsum(known, dtype=np.int32)[gap] - 1
    after = np.minimum(before + 1, len(x) - 1)
    inside = (before >= 0) & (t[after] >= t_s[gap])
    before = np.maximum(before, 0)
    length = t[after] - t[before]
    filled, sure = values.copy(), known.copy()
    if lasting is not None:
        filled[gap] = x[before]
        sure[gap] = inside & (np.abs(x[after] - x[before]) <= JUMP * np.ptp(x)) & (length <= lasting)
    else:
        filled[gap] = np.interp(t_s[gap], t, x)
        sure[gap] = inside & (length <= _memory_s(t, x))
    return filled, sure


def is_known_enough(t_s: Array, values: Array) -> bool:
    """Whether half of the rows have a value, or one that can be inferred: slow telemetry leaves most cells empty."""
    known = np.isfinite(values)
    if 2 * np.count_nonzero(known) >= len(known):
        return True
    return bool(known.any() and 2 * np.count_nonzero(bridged(t_s, values)[1]) >= len(known))


def _lasting_s(t: Array, x: Array) -> float | None:
    """How long a level of a switched channel usually lasts; None where it moves between its switches too."""
    moved = np.diff(x)
    switches = np.flatnonzero(np.abs(moved, out=moved) > JUMP * np.ptp(x)) + 1
    del moved
    if not len(switches):
        return None
    count = np.diff([0, *switches.tolist(), len(x)])
    means = np.bincount(np.repeat(np.arange(len(count)), count), x) / count
    apart = np.repeat(means, count)
    np.subtract(x, apart, out=apart)
    within = np.mean(np.square(apart, out=apart))
    np.subtract(x, x.mean(), out=apart)
    if within > WITHIN * np.mean(np.square(apart, out=apart)):
        return None
    return float(np.median(np.diff(t[np.concatenate([[0], switches, [len(t) - 1]])])))


def _memory_s(t: Array, x: Array) -> float:
    """The time over which a channel moves by its own spread: its correlation has fallen to a half."""
    rows = np.unique(np.geomspace(1, max(len(x) // 2, 1), 30).astype(int))
    moved = np.array([np.mean((x[m:] - x[:-m]) ** 2) if m < len(x) else 0.0 for m in rows])
    far = rows[moved > np.var(x)]
    return period_s(t) * float(far[0] if len(far) else len(x))

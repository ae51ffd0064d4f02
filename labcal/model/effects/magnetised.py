"""The magnetisation of a core by Jiles and Atherton (J. Magn. Magn. Mater. 61, 48, 1986), without a mean field.

Walls that are pinned follow the curve L of a core without pins, L(u) = coth u − 1/u, behind it by a field:
dM/ds = (L(s / a) − M) / ± k, where s moves M towards L; where it moves away, M stays. What the mean field adds is
another a and k. M is a state: whatever it was when a recording began is forgotten over a way k of the field.
"""

from __future__ import annotations

import math
from collections.abc import Iterable

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
SMALL = 1e-2  # of u: below it the series of L is exact to 1e-12
Way = tuple[float, float, float, bool]  # of a row: the way over k, the curve's rise, the curve, whether all begins
Before = tuple[Array, Array]  # drive and state (k,) each, of the row before the first


def langevin(u: Array) -> Array:
    """L(u) = coth u − 1/u of any shape."""
    small = np.abs(u) < SMALL
    safe = np.where(small, 1.0, u)
    return np.where(small, u / 3 - u**3 / 45 + 2 * u**5 / 945, 1 / np.tanh(safe) - 1 / safe)


def bent(u: Array) -> Array:
    """What L lacks of a straight line: L(u) − u / 3."""
    return langevin(u) - u / 3


def magnetised(
    drive: Array,
    bend_nT: float,
    pin_nT: float,
    starts: NDArray[np.intp],
    before: Before | None = None,
    off: float = 0.0,
    part: float = 1.0,
) -> tuple[Array, Array]:
    """M along rows of drive (n, k) [nT], and the part (n, k) that is left of what it was where it began.

    It begins in each row of `starts` at a part of the curve, and `off` that; the first row goes on from the one
    `before` it where it is no start. Exact where L is straight from row to row.
    """
    last, state = (drive[0], langevin(drive[0] / bend_nT)) if before is None else before
    step, curve = np.diff(drive, axis=0, prepend=last[None]), langevin(drive / bend_nT)
    rise = np.diff(curve, axis=0, prepend=langevin(last / bend_nT)[None])
    anew = np.zeros(len(drive), dtype=bool)
    anew[starts] = True
    out, left = np.empty_like(drive), np.empty_like(drive)
    for k in range(drive.shape[1]):
        ways = zip(*(one.tolist() for one in (np.abs(step[:, k]) / pin_nT, rise[:, k], curve[:, k], anew)), strict=True)
        out[:, k], left[:, k] = _followed(ways, float(state[k]), off, part)
    return out, left


def _followed(ways: Iterable[Way], state: float, off: float, part: float) -> tuple[list[float], list[float]]:
    """The state of one column and what is left of its beginning, in every row."""
    out, left, remains = list[float](), list[float](), 1.0
    for way, rise, curve, anew in ways:
        if anew:
            state, remains = part * curve + off, 1.0
        elif rise:
            ahead = (state - curve + rise) / rise  # of this row's way, until the curve has come to where M is
            if ahead < 1.0:
                start = curve - rise if ahead <= 0.0 else state
                way *= 1.0 - max(ahead, 0.0)
                keep = math.exp(-way)
                ramp = (1.0 - keep) / way if way > 0.0 else 1.0
                state = curve + (state - start) * keep - (curve - start) * ramp
                remains *= keep
        out.append(state)
        left.append(remains)
    return out, left

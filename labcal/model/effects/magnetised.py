"""The magnetisation of a core by Jiles and Atherton (J. Magn. Magn. Mater. 61, 48, 1986), without a mean field.

Walls that are pinned follow the curve L of a core without pins, L(u) = coth u − 1/u, behind it by a field:
dM/ds = (L(s / a) − M) / ± k, where s moves M towards L; where it moves away, M stays. What the mean field adds is
another a and k. M is a state: whatever it was when a recording began is forgotten over a way k of the field.

A row's state grows with the one before it, at a rate between e^(−way / k), where M follows, and 1, where it stays, and
the rate has no steps: all rows are found together by Newton, whose linear recursions are scans.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from labcal.model.effects.recursion import affine_recursion

Array = NDArray[np.float64]
ROUNDS, ARRIVED = 50, 1e-13  # of Newton, who mostly needs six; and the change that ends them
SMALL = 1e-2  # of u: below it the series of L is exact to 1e-12
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
    way = np.abs(np.diff(drive, axis=0, prepend=last[None])) / pin_nT
    curve = langevin(drive / bend_nT)
    rise = np.diff(curve, axis=0, prepend=langevin(last / bend_nT)[None])
    begins, M = part * curve[starts] + off, curve
    for _ in range(ROUNDS):
        keep, there = _followed(np.vstack([state[None], M[:-1]]), curve, rise, way)
        keep[starts], there[starts] = 0.0, begins
        was, M = M, affine_recursion(keep, there, state)
        if float(np.abs(M - was).max(initial=0.0)) < ARRIVED:
            break
    ones = np.zeros_like(M)
    ones[starts] = 1.0
    return M, affine_recursion(keep, ones, 1.0)


def _followed(before: Array, curve: Array, rise: Array, way: Array) -> tuple[Array, Array]:
    """Of each row's state as it follows from the one `before` it: how fast it grows with that, and what is beside.

    Of a row's way the part counts on which M follows: from where the curve comes to it, if at all.
    """
    inside = np.clip(before, np.minimum(curve - rise, curve), np.maximum(curve - rise, curve))
    part = np.divide(curve - inside, rise, out=np.zeros_like(rise), where=rise != 0)
    keep = np.exp(-way * part)
    ramp = np.divide(1.0 - keep, way, out=np.zeros_like(way), where=way > 0)
    return keep, curve - rise * ramp - keep * inside

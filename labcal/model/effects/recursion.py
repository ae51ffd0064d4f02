"""States that follow a drive row by row, all rows at once: the steps of a state compose, so that a scan finds them.

A step of one kind followed by another is again of that kind; doubling the reach of every row's step log2(n) times
gives each row's step from the start (Hillis & Steele, Comm. ACM 29, 1170, 1986).
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


def affine(keep: Array, add: Array, start: Array | float) -> Array:
    """z_i = keep_i z_{i−1} + add_i along rows (n, ...), from z = `start` before the first row."""
    keep, add = keep.copy(), add.copy()
    reach = 1
    while reach < len(keep):
        add[reach:] += keep[reach:] * add[:-reach]
        keep[reach:] = keep[reach:] * keep[:-reach]
        reach *= 2
    return np.asarray(keep * start + add)


def clipped(step: Array, limit: float) -> Array:
    """z_i = min(max(z_{i−1} + step_i, −limit), limit) along rows (n, ...), from z = 0 before the first row."""
    add, low, high = step.copy(), np.full_like(step, -limit), np.full_like(step, limit)
    reach = 1
    while reach < len(step):
        low[reach:], high[reach:] = (
            np.clip(bound[:-reach] + add[reach:], low[reach:], high[reach:]) for bound in (low, high)
        )
        add[reach:] = add[reach:] + add[:-reach]
        reach *= 2
    return np.asarray(np.clip(add, low, high))

"""States that follow a drive row by row, all rows at once: the steps of a state compose, so that a scan finds them.

A step of one kind followed by another is again of that kind; doubling the reach of every row's step log2(n) times
gives each row's step from the start (Hillis & Steele, Comm. ACM 29, 1170, 1986).
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


def affine_recursion(keep: Array, add: Array, start: Array | float) -> Array:
    """z_i = keep_i z_{i−1} + add_i along rows (n, ...), from z = `start` before the first row."""
    keep, add = keep.copy(), add.copy()
    reach = 1
    while reach < len(keep):
        add[reach:] += keep[reach:] * add[:-reach]
        keep[reach:] = keep[reach:] * keep[:-reach]
        reach *= 2
    return np.asarray(keep * start + add)


def clipped_recursion(step: Array, limit: Array | float, anew: NDArray[np.intp]) -> Array:
    """z_i = min(max(z_{i−1} + step_i, −limit), limit) along rows (n, k), from z = 0 before each row of `anew` (starts).

    `limit` is one for all columns, or (k,). The first row is one of `anew`.
    """
    add, bounds = step.copy(), np.empty((2, *step.shape))
    bounds[0], bounds[1] = -limit, limit
    bounds[:, anew] = np.clip(step[anew], -limit, limit)
    longest, reach = int(np.diff(anew, append=len(step)).max(initial=0)), 1
    while reach < longest:
        low, high = bounds[:, reach:]
        bounds[:, reach:] = np.minimum(np.maximum(bounds[:, :-reach] + add[reach:], low), high)
        add[reach:] = add[reach:] + add[:-reach]
        reach *= 2
    return np.asarray(np.minimum(np.maximum(add, bounds[0]), bounds[1]))

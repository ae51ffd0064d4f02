"""A prediction at another time, each row with the noise of one row.

A reading's and an angle's noise is in every row of the prediction. Interpolation between two rows averages theirs, and
a lag of half a sample would then fit better than none where there is none. So the nearest row is taken as it is, and
what it changes until the time that is wanted comes from rows on either side of it, without itself: that is
uncorrelated with its own noise, to first order for every stationary noise.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from labcal.model.effects.regressors import shifted, stretches

Array = NDArray[np.float64]
SLOPE_OVER_s = 0.05  # rows at least so far apart tell the slope: nearer ones tell their noise
EACH_SIDE = 2
OTHERS = np.array([[j for j in range(2 * EACH_SIDE) if j != k] for k in range(2 * EACH_SIDE)])


def displaced(t_s: Array, segment: NDArray[np.intp], values: Array, by_s: Array) -> Array:
    """`values` (n, d) at t + by_s (n,), within each segment; held slope beyond its ends. Short segments: `shifted`."""
    out = np.array(values, dtype=float)
    for rows in stretches(segment):
        t, v = t_s[rows], values[rows]
        long = len(t) > 2 * EACH_SIDE and bool(np.all(np.diff(t) > 0))
        out[rows] = _within(t, v, t + by_s[rows]) if long else shifted(t, segment[rows], v, by_s[rows])
    return out


def _within(t: Array, v: Array, at: Array) -> Array:
    stride = int(min(max(1.0, np.rint(SLOPE_OVER_s / np.median(np.diff(t)))), (len(t) - 1) // (2 * EACH_SIDE)))
    inside = np.clip(at, t[0], t[-1])
    nearest = _nearest(t, inside)
    others = _others(nearest, stride, len(t))
    change = _weights(t[others] - t[nearest][:, None], inside - t[nearest])
    end = _weights(t[others] - inside[:, None], at - inside, straight=True)
    return np.asarray(v[nearest] + np.einsum("nk,nkd->nd", change + end, v[others]))


def _nearest(t: Array, at: Array) -> NDArray[np.intp]:
    """The row nearest to each time; of two as near the one that is later, as each is for a time a little before."""
    right = np.clip(np.searchsorted(t, at), 1, len(t) - 1)
    return np.where(at - t[right - 1] < t[right] - at, right - 1, right)


def _others(nearest: NDArray[np.intp], stride: int, n: int) -> NDArray[np.intp]:
    """Two rows on each side of each (n, 4), `stride` apart; at an end of the segment those inward."""
    middle = np.clip(nearest, EACH_SIDE * stride, n - 1 - EACH_SIDE * stride)
    steps = np.array([k for k in range(-EACH_SIDE, EACH_SIDE + 1) if k]) * stride
    found = middle[:, None] + steps
    return np.where(found == nearest[:, None], middle[:, None], found)


def _weights(x: Array, at: Array, *, straight: bool = False) -> Array:
    """Of values at x (n, 4): what the cubic through them changes from 0 to `at`; `straight`: its slope there."""
    others = x[:, OTHERS]  # (n, 4, 3)
    size = np.prod(x[:, :, None] - others, axis=2)
    e1 = others.sum(axis=2)
    e2 = (e1**2 - (others**2).sum(axis=2)) / 2
    a = at[:, None]
    return np.asarray(a * e2 / size if straight else a * (e2 - a * (e1 - a)) / size)

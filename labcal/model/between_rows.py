"""What rows were between their times: polynomials through as many neighbours as leave a row's noise no larger.

Where a field turns by twenty degrees from row to row, a cubic misses a thousandth of it between them, eight rows
nothing that is seen. Rows that lie unevenly, beside a gap or at an end, would multiply their noise: there fewer count.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
MOST = 8  # rows that a polynomial goes through
ROUNDING = 1e-9


def between(t: Array, v: Array, at: Array) -> tuple[Array, Array]:
    """The values v (n, ...) at other times (m,) than their own t (n,), and the same through a row less.

    Beyond the ends, both with the slope there.
    """
    inside, shape = np.clip(at, t[0], t[-1]), (-1, *[1] * (v.ndim - 1))
    left = np.clip(np.searchsorted(t, inside, side="right") - 1, 0, len(t) - 2)
    found = v[left]
    with_less = found.copy()
    for count in range(2, min(MOST, len(t)) + 1):
        rows = np.clip(left - count // 2 + 1, 0, len(t) - count)[:, None] + np.arange(count)
        weights = _weights(t[rows] - inside[:, None])
        calm = np.sum(weights**2, axis=1) <= 1 + ROUNDING
        with_less[calm] = found[calm]
        found[calm] = np.einsum("mk,mk...->m...", weights[calm], v[rows[calm]])
    first, last = (v[1] - v[0]) / (t[1] - t[0]), (v[-1] - v[-2]) / (t[-1] - t[-2])
    beyond = (at - inside).reshape(shape) * np.where((at < inside).reshape(shape), first, last)
    return found + beyond, with_less + beyond


def _weights(x: Array) -> Array:
    """Lagrange's weights (m, k) at 0 of values at x (m, k)."""
    k = x.shape[1]
    others = np.array([[j for j in range(k) if j != i] for i in range(k)])
    return np.asarray(np.prod(x[:, others] / (x[:, others] - x[:, :, None]), axis=2))

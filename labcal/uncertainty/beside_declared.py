"""What a residual holds that no declared error can have left in it: that alone is the device's noise, or structure."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
LARGEST = 3.29  # standard deviations of a declared error: what is beyond them 999 of 1000 never are


def beside_declared(residual: Array, left: Array) -> Array:
    """The residual (n, q) less what declared errors left of it; `left` (n, q, d) is what one standard deviation leaves.

    Their sums are Σ c_j left_j with c_j of variance one: along each direction of theirs, normal with its own size. What
    is too small to show in the residual is not asked, and what is larger than they can be stays.
    """
    if not left.shape[2] or not residual.size:
        return residual
    U, size, _ = np.linalg.svd(left.reshape(-1, left.shape[2]), full_matrices=False)
    shows = size**2 > np.mean(residual**2)
    U, most = U[:, shows], LARGEST * size[shows]
    along = np.clip(U.T @ residual.ravel(), -most, most)
    return np.asarray(residual - (U @ along).reshape(residual.shape))


def share(residual: Array, rest: Array) -> float:
    """The part of a residual's square that the rest of it is."""
    return float(np.sum(rest**2) / max(np.sum(residual**2), 1e-300))

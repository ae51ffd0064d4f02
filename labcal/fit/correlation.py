"""How many rows count as one: residuals that resemble their predecessors carry less than their number says."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
SURE = 5.0  # standard deviations by which neighbours must correlate before anything is widened


def variance_inflation(residual: Array, segment: NDArray[np.intp]) -> float:
    """1 + 2 Σ ρ_k over the lags until ρ_k is within its noise; 1 where neighbours are independent.

    `residual` (n, q) weighted and in time order, ρ_k taken inside segments. The variance of a mean over correlated rows
    is that many times what independent rows would give (Bartlett 1946).
    """
    power, noise = float(np.sum(residual**2)), 1 / np.sqrt(max(len(residual), 1))
    total, lag, limit = 1.0, 1, SURE * noise
    while power > 0 and lag < len(residual) // 10:
        together = segment[lag:] == segment[:-lag]
        rho = float(np.sum(residual[lag:][together] * residual[:-lag][together])) / power
        if rho < limit:
            break
        total, lag, limit = total + 2 * rho, lag + 1, 2 * noise
    return total

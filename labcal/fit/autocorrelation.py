"""Autocorrelation of residuals inside segments, and how much it widens a covariance."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
SIGNIFICANT = 5.0  # standard deviations by which neighbours must correlate before anything is widened


def lagged_products(y: Array, lag: int, segment: NDArray[np.intp] | None = None) -> Array:
    """Σ y_i y_{i+lag} of each component of y (n, q), over pairs of rows of one segment."""
    products = y[lag:] * y[:-lag]
    if segment is not None:
        products = products[segment[lag:] == segment[:-lag]]
    return np.asarray(products.sum(axis=0))


def autocorrelation(y: Array, lag: int, segment: NDArray[np.intp] | None = None) -> float:
    """ρ at one lag, pooled over the components of y (n, q), about zero; 0 where y is zero."""
    power = float(np.sum(y**2))
    return float(lagged_products(y, lag, segment).sum()) / power if power else 0.0


def variance_inflation(residual: Array, segment: NDArray[np.intp]) -> float:
    """1 + 2 Σ ρ_k over the lags until ρ_k is within its noise; 1 where neighbours are independent.

    `residual` (n, q) weighted and in time order. The variance of a mean over correlated rows is that many times what
    independent rows would give (Bartlett 1946).
    """
    noise = 1 / np.sqrt(max(len(residual), 1))
    total, lag, limit = 1.0, 1, SIGNIFICANT * noise
    while lag < len(residual) // 10:
        rho = autocorrelation(residual, lag, segment)
        if rho < limit:
            break
        total, lag, limit = total + 2 * rho, lag + 1, 2 * noise
    return total

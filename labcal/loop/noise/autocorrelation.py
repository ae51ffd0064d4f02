"""Autocorrelation of a residual: how long it lasts, and whether there is any (Ljung & Box, Biometrika 65, 1978)."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from labcal.fit.autocorrelation import autocorrelation, lagged_products
from labcal.loop import policy

Array = NDArray[np.float64]
LAGS = 10  # rows, of Ljung and Box's sum
LONGEST_LAG = 4  # part of the rows: beyond n / 4 too few products are averaged (Box & Jenkins)


def ljung_box(y: Array) -> float:
    """Ljung and Box's Q over LAGS lags, summed over the components of y (n, q); chi-squared with LAGS · q freedoms."""
    n, y = len(y), y - y.mean(axis=0)
    power = np.maximum(np.sum(y**2, axis=0), 1e-300)
    lags = np.arange(1, LAGS + 1)
    rho = np.array([lagged_products(y, lag) / power for lag in lags.tolist()])
    return float(np.sum(n * (n + 2) * rho**2 / (n - lags)[:, None]))


def predictable_share(y: Array) -> float:
    """The share of the square of y (n, q) that an earlier row predicts: its largest squared autocorrelation."""
    y = y - y.mean(axis=0)
    return max(autocorrelation(y, lag) ** 2 for lag in range(1, LAGS + 1))


def serially_correlated(y: Array, segment: NDArray[np.intp]) -> bool:
    """Whether y (n, q) correlates significantly and materially with its past rows inside segments."""
    from scipy.special import chdtrc

    rho = np.array([autocorrelation(y, lag, segment) for lag in range(1, LAGS + 1)])
    statistic = y.size * (y.size + 2) * float(np.sum(rho**2 / (y.size - np.arange(1, LAGS + 1))))
    significant = bool(chdtrc(LAGS, statistic) < policy.POLICY.significance)
    return significant and float(np.max(rho**2)) >= policy.POLICY.material_share


def correlation_time_s(t_s: Array, y: Array) -> float:
    """The first lag [s] at which the autocorrelation of y (n, q) falls below 1/e, times evenly spaced."""
    n = len(y)
    power = np.sum(np.abs(np.fft.rfft(y - y.mean(axis=0), n=2 * n, axis=0)) ** 2, axis=1)
    correlation = np.fft.irfft(power)[: n // LONGEST_LAG]
    below = np.flatnonzero(correlation < correlation[0] / np.e)
    return float(below[0] if len(below) else n // LONGEST_LAG) * float(np.median(np.diff(t_s)))

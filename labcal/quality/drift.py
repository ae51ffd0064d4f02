"""Drift of a parameter over years: a line through calibrations, each with its own u, and what scatters beyond it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.optimize import brentq
from scipy.special import ndtri, stdtrit

Array = NDArray[np.float64]
FEWEST = 3


@dataclass(frozen=True, slots=True, eq=False)
class Drift:
    """value = `last` + `rate` (t - t_last); `interval` is that of the rate, 95 %; `covariance` (2, 2) of both.

    `scatter` is the standard deviation of a calibration beyond its own u, 0 where u explains all; `quantile` what 95 %
    of the estimate's distribution are within.
    """

    last: float
    rate: float
    u_rate: float
    interval: tuple[float, float]
    covariance: Array
    scatter: float
    quantile: float
    t_last: float
    n: int

    @property
    def significant(self) -> bool:
        """Whether zero is outside the interval."""
        return self.interval[0] > 0 or self.interval[1] < 0

    def at(self, time: float) -> tuple[float, float]:
        """The value at `time` and its standard uncertainty, without the scatter of single calibrations."""
        row = np.array([1.0, time - self.t_last])
        return float(row @ [self.last, self.rate]), float(np.sqrt(row @ self.covariance @ row))


def drift(times: ArrayLike, values: ArrayLike, u: ArrayLike) -> Drift:
    """The line of `values` (n,) with standard uncertainties `u` (n,) at `times` (n,).

    Weights are 1 / (u² + scatter²), the scatter such that weighted squares are what they should be (Paule and Mandel,
    J. Res. NBS 87 (1982) 377). Where u explains all, the interval is normal, else of Student's t with n - 2. Raises
    ValueError for fewer than three calibrations, or all at one time.
    """
    when, y, s = (np.asarray(column, dtype=float) for column in (times, values, u))
    if len(when) < FEWEST or np.ptp(when) == 0:
        raise ValueError(f"a drift needs {FEWEST} calibrations at different times, and here are {len(when)}")
    s = np.where(np.isfinite(s), s, 0.0)
    X = np.column_stack([np.ones(len(when)), when - when.max()])
    scatter = _scatter(X, y, s)
    weight = 1 / np.maximum(s**2 + scatter**2, 1e-300)
    covariance = np.linalg.inv(X.T @ (weight[:, None] * X))
    last, rate = covariance @ (X.T @ (weight * y))
    quantile = float(stdtrit(len(y) - 2, 0.975)) if scatter > 0 else float(ndtri(0.975))
    u_rate = float(np.sqrt(covariance[1, 1]))
    interval = float(rate - quantile * u_rate), float(rate + quantile * u_rate)
    return Drift(float(last), float(rate), u_rate, interval, covariance, scatter, quantile, float(when.max()), len(y))


def _scatter(X: Array, y: Array, u: Array) -> float:
    """The standard deviation beyond u that makes the weighted sum of squares n - 2; 0 where it is less already."""
    dof = len(y) - 2
    size = float(np.sqrt(np.sum((y - X @ np.linalg.lstsq(X, y)[0]) ** 2)))
    floor = 1e-9 * size
    if size == 0 or _excess(floor, X, y, u, dof) <= 0:
        return 0.0
    high = 10 * size + float(u.max())
    return float(brentq(_excess, floor, high, args=(X, y, u, dof)))


def _excess(scatter: float, X: Array, y: Array, u: Array, dof: int) -> float:
    root = 1 / np.sqrt(u**2 + scatter**2)
    residual = root * y - (root[:, None] * X) @ np.linalg.lstsq(root[:, None] * X, root * y)[0]
    return float(residual @ residual) - dof

"""`ekf`: the extended Kalman filter of (c, E) (Crassidis, Lai & Harman 2003, (23) to (27)).

Differences from the print: the innovation subtracts the noise mean, v counts as in `scalar_check`, the noise that L
shares with v is taken off as in `moments`, and the start is `live`'s. Written in scalars: a step costs a few
microseconds, of which matrices take half.
"""

from __future__ import annotations

from math import sqrt

import numpy as np
from numpy.typing import NDArray

from labcal.fit.filters.scalar_step import Terms, shared_gradient, terms
from labcal.fit.filters.sequential import LiveFilter, fit_live
from labcal.fit.result import Fit
from labcal.record import Run

Array = NDArray[np.float64]


def ekf(run: Run) -> Fit:
    """Calibrate `run` from magnitudes by the extended Kalman filter, row by row."""
    return fit_live(run, "ekf", EKF)


def step(
    x: Array, P: Array, reading: Array, magnitude: float, noise: Array, reference_noise: float
) -> tuple[Array, Array, float]:
    """One update, (25); see `live.FilterUpdate`. With R the variance of v, K = P⁺ Hᵀ / R."""
    at = terms(x, reading, magnitude, noise, reference_noise)
    row = np.array(slope(at))
    Pr = P @ row
    expected = float(row @ Pr) + at.variance
    half = Pr / sqrt(expected)
    P = P - half[:, None] * half
    correction = row * at.innovation
    correction -= shared_gradient(at)
    correction /= at.variance
    return x + P @ correction, P, at.innovation * at.innovation / expected


def slope(at: Terms) -> list[float]:
    """H(x) = L − ∂|b|²/∂x (9,), (26) and (27)."""
    (b0, b1, b2), (i0, i1, i2) = at.b, at.inner
    return [
        2 * (b0 - i0),
        2 * (b1 - i1),
        2 * (b2 - i2),
        i0 * i0 - b0 * b0,
        i1 * i1 - b1 * b1,
        i2 * i2 - b2 * b2,
        2 * (i0 * i1 - b0 * b1),
        2 * (i0 * i2 - b0 * b2),
        2 * (i1 * i2 - b1 * b2),
    ]


class EKF(LiveFilter):
    """The extended Kalman filter, live."""

    step = staticmethod(step)

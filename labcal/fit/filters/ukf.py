"""`ukf` and `ukf-augmented`: the unscented filter of (c, E) (Crassidis, Lai & Harman 2003, (28) to (47)).

The state is constant, so prediction, (37) to (41), falls away. The first form has nine states and adds the variance of
v, (5b); the second appends the reading's noise n, (47), and takes v = 2 uᵀn + nᵀMn at its sigma points. (38) prints the
third block as χʷ; it is χᵛ. As in `ekf` v counts as in `scalar_check`, the noise that L shares with v is taken off, and
the start is `live`'s.
"""

from __future__ import annotations

from math import sqrt

import numpy as np
from numpy.typing import NDArray
from scipy.linalg.lapack import dpotrf

from labcal.fit.filters.scalar_step import Terms, shared_gradient, terms
from labcal.fit.filters.sequential import LiveFilter, fit_live
from labcal.fit.result import Fit
from labcal.fit.scalar.scalar_check import PLACE
from labcal.record import Run

Array = NDArray[np.float64]

ALPHA, BETA = 0.1, 2.0  # the paper's, below (48)
SPREAD = ALPHA * sqrt(3)  # γ = √(L + λ) with κ = 3 − L, (35) and (36): the same for nine and twelve states
WEIGHT = 1 / (2 * SPREAD**2)  # (39c)
OF_E = 3 + PLACE  # where E's elements stand in the state
BOTH_WAYS = SPREAD * np.concatenate([np.eye(9), -np.eye(9)])
EYE = np.eye(3)


def ukf(run: Run) -> Fit:
    """Calibrate `run` from magnitudes by the unscented filter with nine states, row by row."""
    return fit_live(run, "ukf", UKF)


def ukf_augmented(run: Run) -> Fit:
    """Calibrate `run` from magnitudes by the unscented filter with the noise as three more states, row by row."""
    return fit_live(run, "ukf-augmented", AugmentedUKF)


def step(
    x: Array, P: Array, reading: Array, magnitude: float, noise: Array, reference_noise: float
) -> tuple[Array, Array, float]:
    """One `live.FilterUpdate` with nine states. R = σ²(x̂) is added to the innovation's variance, below (47)."""
    at = terms(x, reading, magnitude, noise, reference_noise)
    root, odd, even = spread(x, P, at)
    mean, expected = moments_of((odd, even))
    return update(x, P, at, root @ odd, expected + at.variance, mean)


def step_augmented(
    x: Array, P: Array, reading: Array, magnitude: float, noise: Array, reference_noise: float
) -> tuple[Array, Array, float]:
    """One update with twelve states; the noise's sigma points carry v with its mean and variance."""
    at = terms(x, reading, magnitude, noise, reference_noise)
    root, odd, even = spread(x, P, at)
    n = SPREAD * factor(noise)
    linear = np.array(at.u) @ n
    square = np.add.reduce(n * (n + x.take(OF_E) @ n))
    mean, expected = moments_of((odd, even), (4 * linear, 2 * square))
    expected += 4 * (reference_noise * magnitude) ** 2
    return update(x, P, at, root @ odd, expected, mean - at.mean)


def factor(covariance: Array) -> Array:
    """The Cholesky factor; raises ArithmeticError where a covariance is no longer positive definite."""
    root, fault = dpotrf(covariance, 1, 1)
    if fault:
        raise ArithmeticError("the filter's covariance is no longer positive definite")
    return np.asarray(root)


def spread(x: Array, P: Array, at: Terms) -> tuple[Array, Array, Array]:
    """√P (9, 9), and of ζ at the sigma points (33), (43) the differences ζ₊ − ζ₋ (9,) and the rises ζ₊ + ζ₋ − 2 ζ(0).

    ζ₊ stands for x + γ times a column of √P, ζ₋ for x − it.
    """
    root = factor(P)
    points = BOTH_WAYS @ root.T + x
    c = points[:, :3, None]
    square = (c.swapaxes(1, 2) @ np.linalg.solve(EYE + points.take(OF_E, axis=1), c)).ravel()
    plus, minus = square[:9], square[9:]
    return root, 2 * SPREAD * (np.array(at.regressor) @ root) + (minus - plus), 2 * at.square - (plus + minus)


def moments_of(*points: tuple[Array, Array]) -> tuple[float, float]:
    """Weighted mean and variance of ζ − ζ(0), (39), (42) and (44), from `spread`'s differences and rises."""
    mean = WEIGHT * sum(float(np.add.reduce(even)) for _, even in points)
    square = sum(float(odd @ odd + even @ even) for odd, even in points)
    return mean, WEIGHT / 2 * square + (BETA - ALPHA**2) * mean * mean


def update(
    x: Array, P: Array, at: Terms, difference: Array, expected: float, mean: float
) -> tuple[Array, Array, float]:
    """(29) to (31) with P^xz = γ WEIGHT `difference`, then the noise that L shares with v."""
    innovation = at.innovation - mean
    half = difference * (SPREAD * WEIGHT / sqrt(expected))
    P = P - half[:, None] * half
    x = x + half * (innovation / sqrt(expected)) - P @ np.array(shared_gradient(at)) / at.variance
    return x, P, innovation * innovation / expected


class UKF(LiveFilter):
    """The unscented filter with nine states, live."""

    step = staticmethod(step)


class AugmentedUKF(LiveFilter):
    """The unscented filter with twelve states, live."""

    step = staticmethod(step_augmented)

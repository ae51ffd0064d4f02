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

from labcal.fit.live import LiveFilter, fit_live
from labcal.fit.result import Fit
from labcal.fit.scalar_step import Terms, shared_gradient, terms
from labcal.record import Run

Array = NDArray[np.float64]

ALPHA, BETA = 0.1, 2.0  # the paper's, below (48)
SPREAD = ALPHA * sqrt(3)  # γ = √(L + λ) with κ = 3 − L, (35) and (36): the same for nine and twelve states
WEIGHT = 1 / (2 * SPREAD**2)  # (39c)
SYMMETRIC = np.array([[3, 6, 7], [6, 4, 8], [7, 8, 5]])  # where E's elements stand in the state
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
    """One update with nine states; see `live.Step`. R = σ²(x̂) is added to the innovation's variance, below (47)."""
    at = terms(x, reading, magnitude, noise, reference_noise)
    root, rise = spread(x, P, at)
    mean, expected = moments_of(rise)
    return update(x, P, at, root @ (rise[:9] - rise[9:]), expected + at.variance, mean)


def step_augmented(
    x: Array, P: Array, reading: Array, magnitude: float, noise: Array, reference_noise: float
) -> tuple[Array, Array, float]:
    """One update with twelve states; the noise's sigma points carry v with its mean and variance."""
    at = terms(x, reading, magnitude, noise, reference_noise)
    root, rise = spread(x, P, at)
    n = SPREAD * factor(noise)
    linear = 2 * (np.array(at.u) @ n)
    square = np.add.reduce(n * ((EYE + x.take(SYMMETRIC)) @ n))
    mean, expected = moments_of(np.concatenate([rise, square + linear, square - linear]))
    expected += 4 * (reference_noise * magnitude) ** 2
    return update(x, P, at, root @ (rise[:9] - rise[9:]), expected, mean - at.mean)


def factor(covariance: Array) -> Array:
    """The Cholesky factor; raises ArithmeticError where a covariance is no longer positive definite."""
    root, fault = dpotrf(covariance, lower=1, clean=1)
    if fault:
        raise ArithmeticError("the filter's covariance is no longer positive definite")
    return np.asarray(root)


def spread(x: Array, P: Array, at: Terms) -> tuple[Array, Array]:
    """γ√P (9, 9), and ζ − ζ(0) (18,) at the sigma points x + its columns, then x − its columns, (33) and (43)."""
    root = SPREAD * factor(P)
    points = np.empty((18, 9))
    np.add(x, root.T, points[:9])
    np.subtract(x, root.T, points[9:])
    c = points[:, :3]
    inner = np.linalg.solve(EYE + points.take(SYMMETRIC, axis=1), c[:, :, None])[:, :, 0]
    linear = np.array(at.regressor) @ root
    rise = at.square - np.einsum("ij,ij->i", inner, c)
    rise[:9] += linear
    rise[9:] -= linear
    return root, rise


def moments_of(rise: Array) -> tuple[float, float]:
    """Weighted mean and variance of ζ − ζ(0) at the 2 L sigma points, (42) and (44); at the centre it is zero."""
    mean = WEIGHT * float(np.add.reduce(rise))
    states = len(rise) / 2
    centre = 1 - states / SPREAD**2 + 1 - ALPHA**2 + BETA  # (39b)
    return mean, WEIGHT * float(rise @ rise) + (centre - 2 + states / SPREAD**2) * mean * mean


def update(
    x: Array, P: Array, at: Terms, difference: Array, expected: float, mean: float
) -> tuple[Array, Array, float]:
    """(29) to (31) with P^xz = WEIGHT `difference`, then the noise that L shares with v."""
    innovation = at.innovation - mean
    half = difference * (WEIGHT / sqrt(expected))
    P = P - half[:, None] * half
    x = x + half * (innovation / sqrt(expected)) - P @ np.array(shared_gradient(at)) / at.variance
    return x, P, innovation * innovation / expected


class UKF(LiveFilter):
    """The unscented filter with nine states, live."""

    step = staticmethod(step)


class AugmentedUKF(LiveFilter):
    """The unscented filter with twelve states, live."""

    step = staticmethod(step_augmented)

"""The Kalman filters of Crassidis, Lai & Harman 2003 as they are printed: start (48), no noise mean in (25a) and (30).

For the reproduction of Table 1 alone; `labcal.fit.filters.ekf` and `.ukf` are the ones to use. With `carried` the
start (48), which is written for (b, D), is carried to (c, E), and the innovation subtracts the noise mean: the two
mendings that suggest themselves, and that do not suffice.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from labcal.fit.scalar import scalar_check

Array = NDArray[np.float64]
ALPHA, BETA, STATES = 0.1, 2.0, 9
LAMBDA = ALPHA**2 * 3 - STATES
GAMMA = np.sqrt(STATES + LAMBDA)
W0_MEAN = LAMBDA / (STATES + LAMBDA)
W0_COVARIANCE = W0_MEAN + 1 - ALPHA**2 + BETA
W = 1 / (2 * (STATES + LAMBDA))


def start(*, carried: bool) -> tuple[Array, Array]:
    """State (9,) and covariance (9, 9) of (c, E) [mG]: (48) as printed, or carried by 20 000 draws of (b, D)."""
    P = np.diag([500.0] * 3 + [0.001] * 6)
    if not carried:
        return np.zeros(9), P
    draws = np.random.default_rng(0).standard_normal((20_000, 9)) * np.sqrt(np.diag(P))
    c_E = np.array([scalar_check.to_c_E(draw[:3], scalar_check.unstacked(draw[3:])) for draw in draws])
    return c_E.mean(axis=0), np.cov(c_E.T)


def run(
    reading: Array, magnitude: Array, sigma: float, *, unscented: bool, carried: bool = False
) -> tuple[Array, Array]:
    """Final state and covariance after all readings (n, 3) and magnitudes (n,) [mG], Σ = sigma² I."""
    x, P = start(carried=carried)
    L = scalar_check.regressors(reading.T)[:9].T
    z = np.sum(reading**2, axis=1) - magnitude**2
    mean = 3 * sigma**2 if carried else 0.0
    for row, seen in zip(L, z - mean, strict=True):
        predicted, cross, variance = (by_sigma_points if unscented else by_slope)(x, P, row)
        variance += measurement_variance(x, row, sigma)
        gain = cross / variance
        x = x + gain * (seen - predicted)
        P = P - np.outer(gain, gain) * variance
        P = (P + P.T) / 2
    return x, P


def measurement_variance(x: Array, row: Array, sigma: float) -> float:
    """σ²(x̂), (5b) with Σ = sigma² I: |(I + D) B − b|² = |B|² − L x + |b|²."""
    B = row[:3] / 2
    return 4 * sigma**2 * float(B @ B - row @ x + scalar_check.bias_square(x)[0]) + 6 * sigma**4


def by_slope(x: Array, P: Array, row: Array) -> tuple[float, Array, float]:
    """Predicted z, P Hᵀ and H P Hᵀ, (25) to (27)."""
    square, gradient = scalar_check.bias_square(x)
    H = row - gradient
    return float(row @ x - square), P @ H, float(H @ P @ H)


def by_sigma_points(x: Array, P: Array, row: Array) -> tuple[float, Array, float]:
    """Predicted z, cross covariance and variance, (33) to (46) with nine states."""
    root = GAMMA * np.linalg.cholesky(P)
    points = np.vstack([x, x + root.T, x - root.T])
    E = np.array([scalar_check.unstacked(point[3:]) for point in points])
    inner = np.linalg.solve(np.eye(3) + E, points[:, :3, None])[:, :, 0]
    zeta = points @ row - np.sum(inner * points[:, :3], axis=1)
    predicted = W0_MEAN * zeta[0] + W * zeta[1:].sum()
    off = zeta - predicted
    return (
        float(predicted),
        W * (points[1:] - x).T @ off[1:],
        float(W0_COVARIANCE * off[0] ** 2 + W * off[1:] @ off[1:]),
    )

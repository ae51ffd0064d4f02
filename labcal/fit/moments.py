"""What a run says about (c, E), in weighted sums; Crassidis, Lai & Harman 2003, (15) to (18).

Beside the paper's sums it holds what the noise adds to them. L is made of the readings and shares their noise with v,
so the loss' gradient at the truth is not zero on average but Σ Cov(L, v)/σ², with Cov(B, v) = 2 S u (`scalar_check`).
This is linear in (c, E). Set against the gradient it takes away the bias of the published estimates, some (σ/|h|)²
times the condition of the problem; set against the information it leaves what the signal, not the noise, determines.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from labcal.fit.scalar_check import (
    COLUMN,
    MISSING,
    ROW,
    TWICE,
    noise_mean,
    noise_variance,
    observation,
    regressor,
    unstacked,
)

Array = NDArray[np.float64]
UNIT_C = np.eye(9)[:, :3]  # c and E of the nine unit vectors of θ'
UNIT_M = np.array([unstacked(e[3:]) for e in np.eye(9)])
SIGNAL_OVER_NOISE = 1.0


@dataclass(frozen=True, slots=True, eq=False)
class Moments:
    """Sums weighted by 1/σ².

    `L` (9,) and `z` (less the noise mean) are the means (15); `variance` is σ̄² (16); `information` (9, 9) and
    `projection` (9,) are the sums of L̃ᵀL̃ and of L̃ᵀ(z̃ − μ̃), (18). The gradient's mean at the truth is
    `noise_gradient` (9,) − `noise_information` (9, 9) @ (c, E).
    """

    L: Array
    z: float
    variance: float
    information: Array
    projection: Array
    noise_gradient: Array
    noise_information: Array


def moments(reading: Array, magnitude: Array, c_E: Array, noise: Array, reference_noise: float = 0.0) -> Moments:
    """Moments of readings (n, 3) and magnitudes (n,), weighted and centred by the noise at `c_E` (9,)."""
    variance = noise_variance(reading, magnitude, c_E, noise, reference_noise)
    z = observation(reading, magnitude) - noise_mean(c_E, noise)
    return weighted(regressor(reading), z, variance, noise)


def weighted(L: Array, z: Array, variance: Array, noise: Array) -> Moments:
    """Moments of the regressors `L` (n, 9) and observations less their noise mean `z` (n,) at given variances (n,)."""
    weight = 1 / variance
    total = float(weight.sum())
    L_mean, z_mean = weight @ L / total, float(weight @ z / total)
    centred = L - L_mean
    of_row = centred.T * weight
    at_noise = noise_part(L_mean, 1 / total, noise)
    return Moments(L_mean, z_mean, 1 / total, of_row @ centred, of_row @ (z - z_mean), *at_noise)


def noise_part(L_mean: Array, variance: float, noise: Array) -> tuple[Array, Array]:
    """`noise_gradient` and `noise_information`; both follow from the mean of L alone, which holds ΣwB and ΣwBBᵀ."""
    first, second = L_mean[:3] / 2 / variance, unstacked(L_mean[3:] / -TWICE) / variance
    q = 2 * (UNIT_M @ first - UNIT_C / variance) @ noise
    Bq = 2 * (second @ UNIT_M - first[:, None] * UNIT_C[:, None, :]) @ noise
    both = Bq + Bq.transpose(0, 2, 1)
    slopes = np.hstack([2 * q, -TWICE * both[:, ROW, COLUMN]])  # (9, 9), one row a unit of c or E
    return slopes[3:6].sum(axis=0), -slopes.T


def determined(information: Array, noise_information: Array) -> None:
    """Raise ArithmeticError where the information (9, 9) on some direction is the noise's rather than the signal's.

    Readings that lie in one plane, or on one sphere for the centred data, still differ by their noise; what that seems
    to tell is taken off, and a direction counts where the signal tells as much again.
    """
    half = np.linalg.cholesky(noise_information)
    ratio = np.linalg.eigvalsh(np.linalg.solve(half, np.linalg.solve(half, information).T)) - 1
    if ratio.min() < SIGNAL_OVER_NOISE:
        raise ArithmeticError(f"the magnitudes do not determine all nine parameters: {MISSING}")

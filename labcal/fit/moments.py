"""What a run says about (c, E), in weighted sums; Crassidis, Lai & Harman 2003, (15) to (18).

Beside the paper's sums it holds what the noise adds to them. L is made of the readings and shares their noise with v,
so the loss' gradient at the truth is not zero on average but Σ Cov(L, v)/σ², with Cov(B, v) = 2 S u (`scalar_check`).
This is linear in (c, E). Set against the gradient it takes away the bias of the published estimates, some (σ/|h|)²
times the condition of the problem; set against the information it leaves what the signal, not the noise, determines.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache

import numpy as np
from numpy.typing import NDArray
from scipy.linalg.lapack import dpotrf

from labcal.fit.scalar_check import (
    COLUMN,
    MISSING,
    ROW,
    SYMMETRIC,
    TWICE,
    noise_mean,
    noise_variance,
    observation,
    unstacked,
)

Array = NDArray[np.float64]
UNIT_C = np.eye(9)[:, :3]  # c and E of the nine unit vectors of θ'
UNIT_M = np.concatenate([np.zeros((3, 3, 3)), SYMMETRIC])
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


def moments(L: Array, magnitude: Array, c_E: Array, noise: Array, reference_noise: float = 0.0) -> Moments:
    """Moments of regressors (n, 9) and magnitudes (n,), weighted and centred by the noise at `c_E` (9,)."""
    variance = noise_variance(L, magnitude, c_E, noise, reference_noise)
    return weighted(L, observation(L, magnitude) - noise_mean(c_E, noise), variance, noise)


def weighted(L: Array, z: Array, variance: Array, noise: Array) -> Moments:
    """Moments of the regressors `L` (n, 9) and observations less their noise mean `z` (n,) at given variances (n,)."""
    weight = 1 / variance
    total = float(weight.sum())
    L_mean, z_mean = L.T @ weight / total, float(weight @ z) / total
    centred = L.T - L_mean[:, None]
    of_row = centred * weight
    at_noise = noise_part(L_mean, 1 / total, noise)
    return Moments(L_mean, z_mean, 1 / total, of_row @ centred.T, of_row @ (z - z_mean), *at_noise)


def noise_part(L_mean: Array, variance: float, noise: Array) -> tuple[Array, Array]:
    """`noise_gradient` and `noise_information`; both follow from the mean of L alone, which holds ΣwB and ΣwBBᵀ."""
    by_sums, by_total = _slopes_of_units()
    slopes = (by_sums @ np.outer(noise, L_mean).ravel() + by_total @ noise.ravel()).reshape(9, 9) / variance
    return slopes[3] + slopes[4] + slopes[5], -slopes.T


@cache
def _slopes_of_units() -> tuple[Array, Array]:
    """`_slopes`, linear in the noise (9,) and in the sums (10,): its values (81, 81) and (81, 9) for the unit ones."""
    each = np.array([[_slopes(S, sums).ravel() for sums in np.eye(10)] for S in np.eye(9).reshape(9, 3, 3)])
    return np.ascontiguousarray(each[:, :9].reshape(81, 81).T), np.ascontiguousarray(each[:, 9].T)


def _slopes(noise: Array, sums: Array) -> Array:
    """Σ w Cov(L, v) (9, 9), one row a unit of c or of M; `sums` are ΣwL (9), then Σw."""
    first, second = sums[:3] / 2, unstacked(sums[3:9] / -TWICE)
    q = 2 * (UNIT_M @ first - UNIT_C * sums[9]) @ noise
    Bq = 2 * (second @ UNIT_M - first[:, None] * UNIT_C[:, None, :]) @ noise
    both = Bq + Bq.transpose(0, 2, 1)
    return np.hstack([2 * q, -TWICE * both[:, ROW, COLUMN]])


def determined(information: Array, noise_information: Array) -> None:
    """Raise ArithmeticError where the information (p, p) on some direction is the noise's rather than the signal's.

    Readings that lie in one plane, or on one sphere for the centred data, still differ by their noise; what that seems
    to tell is taken off, and a direction counts where the signal tells as much again.
    """
    if dpotrf(information - (1 + SIGNAL_OVER_NOISE) * noise_information)[1]:
        raise ArithmeticError(f"the magnitudes do not determine all nine parameters: {MISSING}")

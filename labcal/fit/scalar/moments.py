"""What a run says about (c, E), in weighted sums; Crassidis, Lai & Harman 2003, (15) to (18).

Beside the paper's sums it holds what the noise adds to them. L is made of the readings and shares their noise with v,
so the loss' gradient at the truth is not zero on average but Σ Cov(L, v)/σ², with Cov(B, v) = 2 S u (`scalar_check`).
This is linear in (c, E). Set against the gradient it takes away the bias of the published estimates, some (σ/|h|)²
times the condition of the problem; set against the information it leaves what the signal, not the noise, determines.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy.linalg.lapack import dpotrf

from labcal.fit.scalar.scalar_check import MISSING, PERFECT, PLACE, SYMMETRIC, noise_mean, noise_variance

Array = NDArray[np.float64]


def _covariance() -> Array:
    """Cov((L, 1), (L, 1)) (10, 10) as a map (9, 1000) of the noise and of (L, 1): the rows' slopes hold B and 1."""
    slopes = np.zeros((10, 3, 4))  # ∂(L, 1)/∂B = slopes @ (1, B)
    slopes[:3, :, 0], slopes[3:9, :, 1:] = 2 * np.eye(3), -2 * SYMMETRIC
    of_rows = np.zeros((4, 4, 10))  # (1, B)(1, B)ᵀ = of_rows @ (L, 1)
    of_rows[0, 0, 9] = 1.0
    of_rows[0, 1:, :3] = of_rows[1:, 0, :3] = np.eye(3) / 2
    of_rows[1:, 1:, 3:9] = -SYMMETRIC.transpose(1, 2, 0) / np.where(np.eye(3), 1, 2)[:, :, None]
    by_noise = np.einsum("iap,jbq,pqk->abijk", slopes, slopes, of_rows, optimize=True)
    return np.asarray(by_noise.reshape(9, 1000))


COVARIANCE = _covariance()
# Where the products (10, 10) of (L, 1) with itself stand among those (8, 10) of (−S, 1, |H|²) with it, and times what:
# those of 2B with 2B are −4 or −2 times those of −S with 1.
WHERE, TIMES = np.arange(-30, 70).reshape(10, 10), np.ones((10, 10))
WHERE[:3], TIMES[:3, :3] = WHERE[:, :3].T, -2 - 2 * np.eye(3)
WHERE[:3, :3] = WHERE[9, 3:9].take(PLACE)


class Sums(NamedTuple):
    """Sums over the readings, weighted by 1/σ².

    `products` (10, 10) are those of the rows (L, 1) among themselves, `noise` (10, 10) what the readings' noise adds to
    them, and `cross_products` (10,) those of the rows with −|H|² − μ, which v would be if (c, I + E) were zero.
    """

    products: Array
    noise: Array
    cross_products: Array


class Moments(NamedTuple):
    """The same about the means.

    `L` (9,) and `z` (less the noise mean) are the means (15); `variance` is σ̄² (16); `information` (9, 9) and
    `projection` (9,) are the sums of L̃ᵀL̃ and of L̃ᵀ(z̃ − μ̃), (18). The gradient's mean at the truth is
    `noise_gradient` (9,) − `noise_information` (9, 9) @ (c, E).
    """

    L: Array
    z: float
    variance: float
    information: Array
    projection: Array
    noise_information: Array

    @property
    def noise_gradient(self) -> Array:
        """The gradient's mean (9,) at c = 0, E = 0 if that were the truth."""
        return np.asarray(-self.noise_information @ PERFECT)


def weighted(of_row: Array, rows: Array, mean: float, covariance: Array) -> Sums:
    """Sums of the rows (L, 1, |H|²) (11, n), of which `of_row` is the last eight over their variances; `mean` is μ.

    `covariance` (100, 10) is that of the rows, as `row_covariance` gives it.
    """
    lower = of_row.dot(rows[:10].T)
    products = lower.take(WHERE)
    products *= TIMES
    return Sums(products, covariance.dot(lower[6]).reshape(10, 10), -lower[7] - mean * lower[6])


def row_covariance(noise: Array) -> Array:
    """Cov((L, 1), (L, 1)) by the reading's noise (3, 3), as a map (100, 10) of (L, 1), which holds B and BBᵀ."""
    return np.asarray(noise.ravel().dot(COVARIANCE).reshape(100, 10))


def moments(rows: Array, square: Array, c_E: Array, noise: Array, reference_noise: float = 0.0) -> Moments:
    """Moments of rows (10, n) and |H|² (n,), weighted and centred by the noise at `c_E` (9,)."""
    variance = noise_variance(rows, square, c_E, noise, reference_noise)
    return centred(rows, square + noise_mean(c_E, noise), variance, noise)


def centred(rows: Array, square: Array, variance: Array, noise: Array) -> Moments:
    """Moments of rows (10, n) at given variances (n,); `square` (n,) is |H|² + μ."""
    weight = 1 / variance
    total = float(weight.sum())
    mean = rows @ weight / total
    z = -(PERFECT @ rows[:9]) - square  # (3a)
    z_mean = float(weight @ z) / total
    about = rows[:9] - mean[:9, None]
    of_row = about * weight
    by_noise = noise_information(mean[:9], 1 / total, noise)
    return Moments(mean[:9], z_mean, 1 / total, of_row @ about.T, of_row @ (z - z_mean), by_noise)


def noise_information(L: Array, variance: float, noise: Array) -> Array:
    """Σ w Cov(L, L) (9, 9) from the mean of L (9,) and 1/Σw."""
    by_rows = row_covariance(noise) @ np.append(L, 1.0) / variance
    return np.asarray(by_rows.reshape(10, 10)[:9, :9])


def determined(signal: Array, noise: Array) -> None:
    """Raise ArithmeticError where the information on some direction is the noise's (p, p) rather than the signal's.

    Readings that lie in one plane, or on one sphere for the centred data, still differ by their noise; the
    information that noise seems to give is subtracted, and a direction counts where the signal gives as much again.
    """
    if dpotrf(signal - noise)[1]:
        raise ArithmeticError(f"the magnitudes do not determine all nine parameters: {MISSING}")

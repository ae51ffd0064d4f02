"""Scalar checking: what magnitudes say about bias and scale without any attitude.

Crassidis, Lai & Harman, "Real-time attitude-independent three-axis magnetometer calibration", 2003, eqs (1) to (14),
(26) and (27): the reading is B = (I + D)⁻¹ (h + b + ε) with |h| known and D symmetric. Readings, magnitudes, bias and
noise share any one unit. Symmetric matrices are stacked 11 22 33 12 13 23, (2d); θ' is (c, E), θ is (b, D).

The noise is given where a data sheet gives it, at the reading: covariance S (3, 3) of n in ε = (I + D) n, so that
Σ = (I + D) S (I + D) in the paper's words. With M = I + E and u = M B − c = (I + D) h, everything that (5) needs is
then a polynomial of θ': Tr Σ = Tr S M and hᵀΣh = uᵀSu.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

ROW, COLUMN = np.array([0, 1, 2, 0, 0, 1]), np.array([0, 1, 2, 1, 2, 2])
MISSING = "turn the sensor about another body axis, or in a field of another magnitude"
TWICE = np.array([1.0, 1.0, 1.0, 2.0, 2.0, 2.0])  # an off-diagonal element stands in a quadratic form twice


@dataclass(frozen=True, slots=True, eq=False)
class Estimate:
    """`bias` (3,) in the readings' unit, `D` (3, 3) symmetric, `covariance` (9, 9) of θ = (b, D)."""

    bias: Array
    D: Array
    covariance: Array

    @property
    def theta(self) -> Array:
        """(b, D) as nine numbers, (10)."""
        return np.concatenate([self.bias, stacked(self.D)])

    def in_unit(self, unit: float) -> Estimate:
        """The same where one unit of the readings is `unit` of another."""
        scale = np.repeat([unit, 1.0], [3, 6])
        return Estimate(self.bias * unit, self.D, self.covariance * np.outer(scale, scale))


def stacked(symmetric: Array) -> Array:
    """The six numbers 11 22 33 12 13 23 of a symmetric matrix (3, 3), (2d)."""
    return np.asarray(symmetric[ROW, COLUMN])


def unstacked(six: Array) -> Array:
    """The symmetric matrix (3, 3) of six numbers."""
    out = np.empty((3, 3))
    out[ROW, COLUMN] = out[COLUMN, ROW] = six
    return out


def regressor(reading: Array) -> Array:
    """L = [2 Bᵀ, −S] (n, 9) for readings (n, 3), (2c) and (4a)."""
    x, y, z = reading.T
    out = np.empty((len(reading), 9))
    out[:, :3] = 2 * reading
    for column, product in enumerate((x * x, y * y, z * z, 2 * x * y, 2 * x * z, 2 * y * z), start=3):
        np.negative(product, out[:, column])
    return out


def observation(reading: Array, magnitude: Array) -> Array:
    """Z = |B|² − |H|² (n,), (3a)."""
    return np.asarray(np.einsum("ij,ij->i", reading, reading) - magnitude**2)


def noise_mean(c_E: Array, noise: Array) -> float:
    """Mean of v for the covariance `noise` (3, 3) of the reading: +Tr Σ.

    (5a) prints −Tr Σ; by (1) the reading contains the noise, so v = 2 hᵀε + |ε|².
    """
    return float(np.sum(noise * (np.eye(3) + unstacked(c_E[3:]))))


def noise_variance(reading: Array, magnitude: Array, c_E: Array, noise: Array, reference_noise: float = 0.0) -> Array:
    """Variance of v (n,), (5b), for the covariance `noise` (3, 3) of the reading.

    `reference_noise`, the standard deviation of |H|, is not in (5b). The direction of h comes from the reading, its
    length from |H|: weights that share the reading's noise would bias the estimate.
    """
    M = np.eye(3) + unstacked(c_E[3:])
    u = reading @ M - c_E[:3]
    square = np.einsum("ij,ij->i", u - c_E[:3], reading) + bias_square(c_E)[0]
    of_reading = np.einsum("ij,ij->i", u @ noise, u) * magnitude**2 / square
    return np.asarray(4 * (of_reading + (reference_noise * magnitude) ** 2) + 2 * np.sum((noise @ M) * (noise @ M).T))


def to_c_E(bias: Array, D: Array) -> Array:
    """θ' (9,) of b and D, (2a) and (2b)."""
    return np.concatenate([bias + D @ bias, stacked(2 * D + D @ D)])


def to_b_D(c_E: Array) -> tuple[Array, Array]:
    """B (3,) and D (3, 3) of θ' (9,), (6) to (9). Raises ArithmeticError where I + E is not positive definite."""
    values, vectors = np.linalg.eigh(np.eye(3) + unstacked(c_E[3:]))
    if not values[0] > 0:
        raise ArithmeticError(f"I + E is not positive definite, so no real scale factors belong to it: {MISSING}")
    root = np.sqrt(values)
    return (vectors / root) @ vectors.T @ c_E[:3], (vectors * (root - 1)) @ vectors.T


def jacobian(bias: Array, D: Array) -> Array:
    """∂(c, E)/∂(b, D) (9, 9), (12) to (14).

    Built from dE = 2 dD + D dD + dD D and dc = dD b, which settles the misprint in row 5, column 6 of (13).
    """
    out = np.zeros((9, 9))
    out[:3, :3] = np.eye(3) + D
    for column in range(6):
        dD = unstacked(np.eye(6)[column])
        out[:3, 3 + column] = dD @ bias
        out[3:, 3 + column] = stacked(2 * dD + D @ dD + dD @ D)
    return out


def from_c_E(c_E: Array, covariance: Array) -> Estimate:
    """θ and its covariance from θ' and its covariance (9, 9), (6) to (11). Raises ArithmeticError as `to_b_D` does."""
    bias, D = to_b_D(c_E)
    back = np.linalg.inv(jacobian(bias, D))
    return Estimate(bias, D, back @ covariance @ back.T)


def bias_square(c_E: Array) -> tuple[float, Array]:
    """|b|² = cᵀ (I + E)⁻¹ c and its gradient (9,), (27a) and (27b)."""
    inner = np.linalg.solve(np.eye(3) + unstacked(c_E[3:]), c_E[:3])
    return float(inner @ c_E[:3]), np.concatenate([2 * inner, -TWICE * inner[ROW] * inner[COLUMN]])

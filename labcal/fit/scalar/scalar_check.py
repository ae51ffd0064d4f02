"""Scalar checking: what magnitudes say about bias and scale without any attitude.

Crassidis, Lai & Harman, "Real-time attitude-independent three-axis magnetometer calibration", 2003, eqs (1) to (14),
(26) and (27): the reading is B = (I + D)⁻¹ (h + b + ε) with |h| known and D symmetric. Readings, magnitudes, bias and
noise share any one unit. Symmetric matrices are stacked 11 22 33 12 13 23, (2d); θ' is (c, E), θ is (b, D).

The noise is given where a data sheet gives it, at the reading: covariance S (3, 3) of n in ε = (I + D) n, so that
Σ = (I + D) S (I + D) in the paper's words. With M = I + E and u = M B − c = (I + D) h, everything that (5) needs is
then a polynomial of θ': Tr Σ = Tr S M and hᵀΣh = uᵀSu.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray
from scipy.linalg.lapack import dsyev

Array = NDArray[np.float64]

ROW, COLUMN = np.array([0, 1, 2, 0, 0, 1]), np.array([0, 1, 2, 1, 2, 2])
MISSING = "turn the sensor about another body axis, or in a field of another magnitude"
TWICE = np.array([1.0, 1.0, 1.0, 2.0, 2.0, 2.0])  # an off-diagonal element stands in a quadratic form twice
PLACE = np.array([[0, 3, 4], [3, 1, 5], [4, 5, 2]])  # where a matrix' elements stand among the six
PERFECT = np.repeat([0.0, 1.0, 0.0], 3)  # c and M = I + E of a perfect sensor
OF_M = 3 + PLACE  # where M stands in (c, M)
C_AND_M = np.column_stack([[0, 1, 2], OF_M])  # where c and M stand side by side
FORM = np.array([1, 2, 3, 5, 10, 15, 6, 7, 11, 0])  # −4 (−1, B)ᵀ Q (−1, B) is these elements of Q
FACTOR = np.repeat([4.0, -4.0], [9, 1])  # times these, by (L, 1)
SYMMETRIC = np.eye(6)[:, PLACE]  # (6, 3, 3): the symmetric matrices of the six unit vectors


@dataclass(frozen=True, eq=False)
class Estimate:
    """`bias` (3,) in the readings' unit and `D` (3, 3) symmetric; `spread` works out the `covariance`.

    `centred`: the mean of v, (17), was left out of the fit, so that its residuals have a mean of their own.
    """

    bias: Array
    D: Array
    spread: Callable[[], Array]
    centred: bool = False

    @cached_property
    def covariance(self) -> Array:
        """The covariance (9, 9) of θ = (b, D), worked out when first asked for."""
        return self.spread()

    @property
    def theta(self) -> Array:
        """(b, D) as nine numbers, (10)."""
        return np.concatenate([self.bias, stacked(self.D)])

    @property
    def c_E(self) -> Array:
        """θ' as nine numbers, (2a) and (2b)."""
        return to_c_E(self.bias, self.D)

    def in_unit(self, unit: float) -> Estimate:
        """The same where one unit of the readings is `unit` of another."""

        def spread() -> Array:
            scale = np.repeat([unit, 1.0], [3, 6])
            return self.covariance * np.outer(scale, scale)

        return replace(self, bias=self.bias * unit, spread=spread)

    def moved(self, by: Array) -> Estimate:
        """The same where all readings are larger by `by` (3,): b grows by (I + D) `by`."""

        def spread() -> Array:
            slope = np.eye(9)  # ∂(b, D) after over before
            slope[:3, 3:] = (SYMMETRIC @ by).T
            return slope @ self.covariance @ slope.T

        return replace(self, bias=self.bias + by + self.D.dot(by), spread=spread)

    def wider(self, factor: float) -> Estimate:
        """The same with all of its covariance times `factor`."""
        return replace(self, spread=lambda: self.covariance * factor)


def stacked(symmetric: Array) -> Array:
    """The six numbers 11 22 33 12 13 23 of a symmetric matrix (3, 3), (2d)."""
    return np.asarray(symmetric[ROW, COLUMN])


def unstacked(six: Array) -> Array:
    """The symmetric matrix (3, 3) of six numbers."""
    return six.take(PLACE)


def regressors(B: Array, out: Array | None = None) -> Array:
    """L = [2 Bᵀ, −S], (2c) and (4a), and 1, one below the other (10, n), for readings (3, n)."""
    minus = -B
    if out is None:
        out = np.empty((10, B.shape[1]))
    np.add(B, B, out=out[:3])
    np.multiply(B, minus, out=out[3:6])
    np.multiply(out[0], minus[1:], out=out[6:8])
    np.multiply(out[1], minus[2], out=out[8])
    out[9] = 1.0
    return out


def lifted(c_E: Array) -> Array:
    """(c, I + E, −|b|²) (10,): minus its product with a row (L, 1) is |(I + D) B − b|²."""
    return np.append(c_E + PERFECT, -bias_square(c_E)[0])


def noise_mean(c_E: Array, noise: Array) -> float:
    """Mean of v for the covariance `noise` (3, 3) of the reading: +Tr Σ.

    (5a) prints −Tr Σ; by (1) the reading contains the noise, so v = 2 hᵀε + |ε|².
    """
    return mean_at(c_E + PERFECT, noise)


def mean_at(x: Array, noise: Array) -> float:
    """The same at x = (c, I + E) or `lifted`."""
    return float(np.vdot(noise, x.take(OF_M)))


def noise_variance(rows: Array, square: Array, c_E: Array, noise: Array, reference_noise: float = 0.0) -> Array:
    """Variance of v (n,), (5b), from the regressors (10, n) and |H|² (n,), for the covariance `noise` (3, 3).

    `reference_noise`, the standard deviation of |H|, is not in (5b). The direction of h comes from the reading, its
    length from |H|: weights that share the reading's noise would bias the estimate.
    """
    return variance_at(rows, square, lifted(c_E), noise, reference_noise)


def variance_at(rows: Array, square: Array, x: Array, noise: Array, reference_noise: float) -> Array:
    """The same at the `lifted` x (10,)."""
    K = x.take(C_AND_M)  # u = K (−1, B)
    form = K.T.dot(noise.dot(K))
    variance = (FACTOR * form.take(FORM) + 4 * reference_noise**2 * x).dot(rows)  # −4 uᵀSu, and what |H| adds
    variance /= x.dot(rows)  # over −|(I + D) B − b|²
    variance *= square
    variance += 2 * float(np.vdot(noise, form[1:, 1:]))
    return np.asarray(variance)


def to_c_E(bias: Array, D: Array) -> Array:
    """θ' (9,) of b and D, (2a) and (2b)."""
    return np.concatenate([bias + D @ bias, stacked(2 * D + D @ D)])


def to_b_D(c_E: Array) -> tuple[Array, Array]:
    """B (3,) and D (3, 3) of θ' (9,), (6) to (9). Raises ArithmeticError where I + E is not positive definite."""
    values, vectors, _ = dsyev((c_E + PERFECT).take(OF_M))
    if not values[0] > 0:
        raise ArithmeticError(f"I + E is not positive definite, so no real scale factors belong to it: {MISSING}")
    root = np.sqrt(values)
    return vectors.dot(c_E[:3].dot(vectors) / root), (vectors * (root - 1)).dot(vectors.T)


def jacobian(bias: Array, D: Array) -> Array:
    """∂(c, E)/∂(b, D) (9, 9), (12) to (14).

    Built from dE = 2 dD + D dD + dD D and dc = dD b, which settles the misprint in row 5, column 6 of (13).
    """
    moved = D @ SYMMETRIC
    out = np.zeros((9, 9))
    out[:3, :3] = np.eye(3) + D
    out[:3, 3:] = (SYMMETRIC @ bias).T
    out[3:, 3:] = (2 * SYMMETRIC + moved + moved.transpose(0, 2, 1))[:, ROW, COLUMN].T
    return out


def from_c_E(c_E: Array, covariance: Array) -> Estimate:
    """θ and its covariance from θ' and its covariance (9, 9), (6) to (11). Raises ArithmeticError as `to_b_D` does."""
    return lazily(c_E, lambda: covariance)


def lazily(c_E: Array, covariance: Callable[[], Array]) -> Estimate:
    """The same where the covariance of θ' has still to be worked out, if anybody asks."""
    bias, D = to_b_D(c_E)

    def carried() -> Array:
        back = np.linalg.inv(jacobian(bias, D))
        return np.asarray(back @ covariance() @ back.T)

    return Estimate(bias, D, carried)


def bias_square(c_E: Array) -> tuple[float, list[float]]:
    """|b|² = cᵀ (I + E)⁻¹ c and its gradient (9,), (27a) and (27b)."""
    return bias_square_at(c_E + PERFECT)


def bias_square_at(x: Array) -> tuple[float, list[float]]:
    """The same at x = (c, I + E) (9,)."""
    c0, c1, c2, *_ = numbers = x.tolist()
    i0, i1, i2 = inner(numbers)
    slope = [2 * i0, 2 * i1, 2 * i2, -i0 * i0, -i1 * i1, -i2 * i2, -2 * i0 * i1, -2 * i0 * i2, -2 * i1 * i2]
    return i0 * c0 + i1 * c1 + i2 * c2, slope


def inner(x: list[float]) -> tuple[float, float, float]:
    """(I + E)⁻¹ c of x = (c, I + E) by cofactors: in plain floats, because the filters need it at every reading."""
    c0, c1, c2, m00, m11, m22, m01, m02, m12 = x
    a00, a01, a02 = m11 * m22 - m12 * m12, m02 * m12 - m01 * m22, m01 * m12 - m02 * m11
    a11, a12, a22 = m00 * m22 - m02 * m02, m01 * m02 - m00 * m12, m00 * m11 - m01 * m01
    determinant = m00 * a00 + m01 * a01 + m02 * a02
    return (
        (a00 * c0 + a01 * c1 + a02 * c2) / determinant,
        (a01 * c0 + a11 * c1 + a12 * c2) / determinant,
        (a02 * c0 + a12 * c1 + a22 * c2) / determinant,
    )

"""The terms of one reading that every Kalman form of (c, E) needs, in plain floats: calls cost more than such arrays.

Crassidis, Lai & Harman 2003, (3) to (5) and (27), with `scalar_check`'s noise: M = I + E, u = M B − c, and
Cov(B, v) = 2 S u.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from labcal.fit.scalar.scalar_check import inner

Array = NDArray[np.float64]
Triple = tuple[float, float, float]


class Terms(NamedTuple):
    """Of the reading `b`: `inner` (I + E)⁻¹ c, `square` |b|² of the bias, `innovation` z − h(x) − μ, and of v the
    `variance`, the `mean` and with `shared` Cov(B, v); `u` is (I + D) h.
    """

    b: Triple
    inner: Triple
    square: float
    innovation: float
    variance: float
    mean: float
    shared: Triple
    u: Triple

    @property
    def regressor(self) -> list[float]:
        """L (9,), (4a)."""
        b0, b1, b2 = self.b
        squares = [-b0 * b0, -b1 * b1, -b2 * b2, -2 * b0 * b1, -2 * b0 * b2, -2 * b1 * b2]
        return [2 * b0, 2 * b1, 2 * b2, *squares]


def terms(x: Array, reading: Array, magnitude: float, noise: Array, reference_noise: float) -> Terms:
    """Terms of `reading` (3,) at the state `x` (9,); `noise` (3, 3) is its covariance, one unit throughout."""
    b0, b1, b2 = b = reading.tolist()
    c0, c1, c2, m00, m11, m22, m01, m02, m12 = x.tolist()
    m00, m11, m22 = 1 + m00, 1 + m11, 1 + m22
    (s00, s01, s02), (_, s11, s12), (_, _, s22) = noise.tolist()
    i0, i1, i2 = inner([c0, c1, c2, m00, m11, m22, m01, m02, m12])
    u0 = m00 * b0 + m01 * b1 + m02 * b2 - c0
    u1 = m01 * b0 + m11 * b1 + m12 * b2 - c1
    u2 = m02 * b0 + m12 * b1 + m22 * b2 - c2
    bias = i0 * c0 + i1 * c1 + i2 * c2
    square = (u0 - c0) * b0 + (u1 - c1) * b1 + (u2 - c2) * b2 + bias  # |(I + D) B − b|²
    q0 = 2 * (s00 * u0 + s01 * u1 + s02 * u2)
    q1 = 2 * (s01 * u0 + s11 * u1 + s12 * u2)
    q2 = 2 * (s02 * u0 + s12 * u1 + s22 * u2)
    mean = s00 * m00 + s11 * m11 + s22 * m22 + 2 * (s01 * m01 + s02 * m02 + s12 * m12)
    H = magnitude * magnitude
    variance = 2 * (u0 * q0 + u1 * q1 + u2 * q2) * H / square + 4 * reference_noise**2 * H + 2 * mean * mean / 3
    return Terms(b, (i0, i1, i2), bias, square - H - mean, variance, mean, (q0, q1, q2), (u0, u1, u2))


def shared_gradient(at: Terms) -> list[float]:
    """Cov(L, v) (9,): what the gradient of one reading is on average at the truth (`moments`)."""
    (b0, b1, b2), (q0, q1, q2) = at.b, at.shared
    return [
        2 * q0,
        2 * q1,
        2 * q2,
        -2 * b0 * q0,
        -2 * b1 * q1,
        -2 * b2 * q2,
        -2 * (b0 * q1 + b1 * q0),
        -2 * (b0 * q2 + b2 * q0),
        -2 * (b1 * q2 + b2 * q1),
    ]

"""The objectives of Riwanto et al. 2017, for a whole swarm at once.

A particle is (K row by row, k), b = K m − k. |b|² is a quadratic form in m, so the magnitudes of all particles and
samples are one matrix product over the ten monomials of m; the moments of a locus transform as K M Kᵀ, so its plane
costs the same however many samples it has. `particles` is (p, 12), values are (p,).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from labcal.geometry import unit

Array = NDArray[np.float64]
SignRule = Literal["two-samples", "sequence"]

_CACHE_VALUES = 12_000  # particles times samples of one block: a block of doubles that stays in the processor's cache
_TINY = float(np.finfo(float).tiny)
_FIRST, _SECOND = np.array([0, 1, 2, 0, 0, 1]), np.array([0, 1, 2, 1, 2, 2])  # the six entries of a symmetric matrix


@dataclass(frozen=True, slots=True, eq=False)
class MagnitudeObjective:
    """F1 (8b): how far |K m − k| is from the known magnitude, summed over the samples."""

    centre: Array  # (3,) of the readings: the quadratic form is expanded there, far from cancellation
    monomials: Array  # (10, n)
    magnitude: Array  # (n,) [nT]
    scratch: Array  # one block, reused: fresh memory costs more than the arithmetic. Not for two threads at once

    @classmethod
    def of(cls, reading: ArrayLike, magnitude: ArrayLike) -> MagnitudeObjective:
        """From readings (n, 3) and the magnitude (n,) of the field [nT]."""
        reading = np.asarray(reading, dtype=float)
        centre = reading.mean(axis=0)
        x, y, z = (reading - centre).T
        rows = np.stack([x * x, y * y, z * z, 2 * x * y, 2 * x * z, 2 * y * z, x, y, z, np.ones_like(x)])
        return cls(centre, rows, np.asarray(magnitude, dtype=float), np.empty(_CACHE_VALUES))

    def squares(self, K: Array, k: Array) -> Array:
        """F1 (p,) [nT²] for K (3, 3, p) and k (3, p)."""
        form = self._form(K, k)
        total, step = np.zeros(len(form)), max(1, _CACHE_VALUES // len(form))
        scratch = self.scratch if len(form) <= _CACHE_VALUES else np.empty(len(form))
        for first in range(0, len(self.magnitude), step):
            known = self.magnitude[first : first + step]
            length = scratch[: len(form) * len(known)].reshape(len(form), -1)
            np.matmul(form, self.monomials[:, first : first + step], out=length)
            np.sqrt(np.maximum(length, 0.0, out=length), out=length)
            length -= known
            total += np.vecdot(length, length)
        return total

    def _form(self, K: Array, k: Array) -> Array:
        """Coefficients (p, 10) of |K m − k|² over the monomials."""
        k = k - np.einsum("ijp,j->ip", K, self.centre)
        columns = K.swapaxes(0, 1)
        quadratic = np.sum(columns[_FIRST] * columns[_SECOND], axis=1)
        linear = -2 * np.sum(columns * k, axis=1)
        return np.ascontiguousarray(np.concatenate([quadratic, linear, np.sum(k * k, axis=0)[None]]).T)


@dataclass(frozen=True, slots=True, eq=False)
class Planes:
    """F2 (9): how far the normal of each calibrated locus is from the known rotation axis."""

    moments: Array  # (l, 9) [unit²] second moments of the readings about their mean, by locus
    axes: Array  # (l, 3) rotation axes in B
    turn: Array  # (l, 3) [unit²] Σ (m_s − m̄) × (m_{s+1} − m̄)
    pair: Array  # (2, l, 3) the two samples of Algorithm 3, step 6
    sign: SignRule

    @classmethod
    def of(
        cls,
        loci: Sequence[Array],
        axes: ArrayLike,
        sign: SignRule = "sequence",
        forward: Sequence[Array] | None = None,
    ) -> Planes:
        """From the readings (n_l, 3) of each locus in the order they were taken, and their axes (l, 3) in B.

        `sign` "two-samples" is Algorithm 3 (the first sample and the one a quarter further on); "sequence" takes the
        sense of turning from all successive samples about their centroid, each counted by its entry (n_l − 1,) of
        `forward`: 1 where the turn is right-handed about the axis, -1 where it goes back.
        """
        centred = [locus - locus.mean(axis=0) for locus in loci]
        forward = forward or [np.ones(len(locus) - 1) for locus in loci]
        return cls(
            np.stack([(x.T @ x / len(x)).ravel() for x in centred]),
            unit(axes),
            np.stack([way @ np.cross(x[:-1], x[1:]) for x, way in zip(centred, forward, strict=True)]),
            np.stack([[locus[0] for locus in loci], [locus[len(locus) // 4] for locus in loci]]),
            sign,
        )

    def cosines(self, K: Array, k: Array, cofactor: Array) -> Array:
        """n̂ · (−ω̂) (l, p) by Algorithm 3, for K (3, 3, p), k (3, p) and K's cofactors (3, 3, p).

        With N the projector onto the direction of least spread, |n̂ · ω̂|² = ω̂ᵀ N ω̂; the sign is that of ω̂ᵀ N S,
        where S is the sense of turning and K a × K c = cof(K) (a × c).
        """
        products = K[_FIRST][:, :, None] * K[_SECOND][:, None, :]
        moments = self.moments @ products.reshape(6, 9, -1)  # (6, l, p): K M Kᵀ
        along = _onto_least_spread(moments, self.axes.T[:, :, None])
        size = np.sqrt(np.maximum(np.einsum("li,ilp->lp", self.axes, along), 0.0))
        return np.asarray(np.copysign(size, -np.einsum("ilp,ilp->lp", along, self._sense(K, k, cofactor))))

    def _sense(self, K: Array, k: Array, cofactor: Array) -> Array:
        if self.sign == "sequence":
            return np.asarray(self.turn @ cofactor)
        first, second = (self.pair @ K[:, None]).swapaxes(0, 1) - k[:, None]
        return _cross(first, second)

    def squares(self, K: Array, k: Array, cofactor: Array) -> Array:
        """F2 (p,)."""
        return np.asarray(np.sum((1 - self.cosines(K, k, cofactor)) ** 2, axis=0))


def _onto_least_spread(moments: Array, v: Array) -> Array:
    """N v (3, l, p): `v` (3, l, 1) projected onto the eigenvector of the smallest eigenvalue.

    `moments` (6, l, p) holds xx, yy, zz, xy, xz, yz of symmetric matrices C. The eigenvalue λ is the trigonometric
    root of the characteristic cubic (Smith, Commun. ACM 4, 168, 1961), and N = adj(C − λ) / tr adj(C − λ); applied
    twice, what rounding left of the next eigenvector in it is squared away.
    """
    xx, yy, zz, xy, xz, yz = moments
    mean = (xx + yy + zz) / 3
    x, y, z = xx - mean, yy - mean, zz - mean
    xy2, xz2, yz2 = xy * xy, xz * xz, yz * yz
    spread = np.sqrt((x * x + y * y + z * z) / 6 + (xy2 + xz2 + yz2) / 3) + _TINY
    cosine = (x * y * z + 2 * xy * xz * yz - x * yz2 - y * xz2 - z * xy2) / (2 * spread * spread * spread)
    angle = np.arccos(np.minimum(np.maximum(cosine, -1.0), 1.0)) / 3
    smallest = 2 * spread * np.cos(angle + 2 * np.pi / 3)  # λ less the mean
    x, y, z = x - smallest, y - smallest, z - smallest
    own = y * z - yz2, x * z - xz2, x * y - xy2
    adjugate = np.stack([*own, xz * yz - xy * z, xy * yz - xz * y, xy * xz - yz * x]) / (sum(own) + _TINY)
    return _times(adjugate, _times(adjugate, v))


def _cross(a: Array, b: Array) -> Array:
    """A × b along the first axis; numpy's own takes five times as long on arrays so small."""
    return np.stack([a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]])


def _times(symmetric: Array, v: Array) -> Array:
    """Products (3, l, p) of the matrices xx, yy, zz, xy, xz, yz (6, l, p) with vectors (3, l, p)."""
    xx, yy, zz, xy, xz, yz = symmetric
    x, y, z = v
    return np.stack([xx * x + xy * y + xz * z, xy * x + yy * y + yz * z, xz * x + yz * y + zz * z])


@dataclass(frozen=True, slots=True, eq=False)
class RotationAxisObjective:
    """F (10): c_f1 √F1 / n_s + c_f2 √F2 / n_l, and −c_det log|det K| where the swarm shall not fall to K → 0.

    `planes` None leaves the scalar checking objective alone. The weights by hand are the paper's.
    """

    magnitudes: MagnitudeObjective
    planes: Planes | None = None
    weight_magnitude: float = 1.0
    weight_axis_nT: float = 4e4
    weight_det_nT: float = 0.0

    def __call__(self, particles: Array) -> Array:
        """F (p,) [nT] at `particles` (p, 12)."""
        columns = np.ascontiguousarray(particles.T)
        K, k = columns[:9].reshape(3, 3, -1), columns[9:]
        samples = len(self.magnitudes.magnitude)
        value = self.weight_magnitude / samples * np.sqrt(self.magnitudes.squares(K, k))
        of_K = cofactor(K)
        if self.planes is not None:
            loci = len(self.planes.axes)
            value += self.weight_axis_nT / loci * np.sqrt(self.planes.squares(K, k, of_K))
        if self.weight_det_nT:
            determinant = np.abs(np.sum(K[0] * of_K[0], axis=0)) + _TINY
            value -= self.weight_det_nT * np.log(determinant)
        return np.asarray(value)


def cofactor(K: Array) -> Array:
    """cof(K) (3, 3, p), with K a × K c = cof(K) (a × c)."""
    following, after = K[[1, 2, 0]], K[[2, 0, 1]]
    return np.asarray(following[:, [1, 2, 0]] * after[:, [2, 0, 1]] - following[:, [2, 0, 1]] * after[:, [1, 2, 0]])

"""The base model's residuals as one weighted system, whatever a row offers.

Row i gives the residual r = b − p of rank 3 (vector), 2 (known axis, no angle) or 1 (magnitude). All three are carried
by an information matrix G (3, 3) of that rank and the weighted residual h = G r (3,), so that any column
d(residual)/d(parameter) = E (n, 3) adds Σ EᵀGE to the normal matrix and Σ Eᵀh to the gradient: the map's own columns,
the unknown phases and heights, and effects.

The readings carry noise of covariance Σ, so the map's columns stand at the estimated true reading m̂ = m − Σ Kᵀ h: with
them the normal equations are the gradient of Σ rᵀ C⁻¹ r with C = K Σ Kᵀ + Σ_ref + … (Deming's weights). That is the
likelihood of the *readings*: the normaliser of C and the Jacobian of m → K m both are log|det K|, and cancel. Noise
that is white in the field (σ² I in place of K Σ Kᵀ) leaves the Jacobian alone, n log|det K|; the same fit with
Σ = σ² (KᵀK)⁻¹, renewed as K is found, replaces its gradient n K⁻ᵀ by the Σ h hᵀ K⁻ᵀ σ² of the rows at hand.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from labcal.fit.vector.observations import AXIS, SCALAR, VECTOR, Observations

Array = NDArray[np.float64]
Rows = slice | NDArray[np.intp] | NDArray[np.bool_]
WhiteIn = Literal["reading", "field"]
BLOCK = 1 << 15  # rows evaluated at once: bounds the memory
SMALL = 0.01  # of the field: a circle of a smaller radius says nothing
# (3, 4) rows [K_a · scale, k_a] against the contract's order, K row by row, then k
CONTRACT_ORDER = np.array([0, 1, 2, 4, 5, 6, 8, 9, 10, 3, 7, 11])


@dataclass(frozen=True, slots=True, eq=False)
class Noise:
    """Standard deviations by which rows are weighted; of reading and reference, that of one axis."""

    reading: float  # DUT units
    reference_nT: float = 0.0
    angle_rad: Array | float = 0.0  # (n,) or one number
    time_s: Array | float = 0.0  # (n,) or one number
    shape: Array | None = None  # (3, 3) covariance of the reading's noise over reading²; white where None

    def select(self, rows: Rows) -> Noise:
        """Return the noise of these rows."""
        angle, time = (v[rows] if isinstance(v, np.ndarray) else v for v in (self.angle_rad, self.time_s))
        return replace(self, angle_rad=angle, time_s=time)

    def covariance(self, scale: float) -> Array:
        """Covariance (3, 3) of the reading's noise, in units of `scale`²."""
        return np.asarray((self.reading / scale) ** 2 * (np.eye(3) if self.shape is None else self.shape))


@dataclass(frozen=True, slots=True, eq=False)
class Evaluated:
    """The system's rows at one set of parameters."""

    field: Array  # (n, 3) b [nT]
    prediction: Array  # (n, 3) p [nT, B]; only its direction is free where the row is no vector
    residual: Array  # (n, 3) b − p [nT], zero in the directions that the row does not see
    information: Array  # (n, 3, 3) G [1/nT²]
    weighted_residual: Array  # (n, 3) h = G r [1/nT]
    cost: Array  # (n,) rᵀ G r
    columns: Array  # (n, 4) x = (m̂ / scale, −1): d b_a / d(K_a · scale, k_a)
    tangent: Array  # (n, 3) d residual / d unknown: axis × p [nT/rad] of a phase, zero where none is unknown


def map_of(theta: Array, scale: float) -> tuple[Array, Array]:
    """K (3, 3) in nT per DUT unit and k (3,) from the scaled parameters (12,), K · scale row by row, then k."""
    return theta[:9].reshape(3, 3) / scale, theta[9:]


def evaluate(
    seen: Observations, noise: Noise, theta: Array, phase: Array, correction: Array | float = 0.0
) -> Evaluated:
    """Evaluate residuals and weights of every row of `seen`.

    `theta` (12,) are K · scale row by row, then k, all in nT; `phase` (unknowns,) rad, where it is a height nT;
    `correction` (n, 3) nT is the sum of the effects, subtracted from K m − k.
    """
    K, k = theta[:9].reshape(3, 3), theta[9:]
    field = seen.reading @ K.T - k - correction
    prediction = _turn(seen, phase, seen.target)
    spread = noise.covariance(seen.scale)
    base = K @ spread @ K.T + noise.reference_nT**2 * np.eye(3)
    tangent, height = cross(seen.axis, prediction), heights(seen, phase)
    G, residual = np.empty((len(seen), 3, 3)), np.empty((len(seen), 3))
    for kind, rows in _kinds(seen.kind):
        if kind == VECTOR:
            G[rows] = _inverse(base, _spreads(seen, noise, phase, tangent, rows))
            residual[rows] = field[rows] - prediction[rows]
        else:
            offers = _axis_rows if kind == AXIS else _magnitude_rows
            G[rows], residual[rows] = offers(seen, rows, field[rows], base, height, noise.reference_nT)
    if seen.loci:
        on = (seen.kind == AXIS) & (seen.group >= 0)
        tangent[on] = _height_slopes(seen, on, field[on], height[on])
    weighted_residual = np.einsum("nab,nb->na", G, residual)
    cost = np.sum(weighted_residual * residual, axis=1)
    columns = np.full((len(seen), 4), -1.0)
    columns[:, :3] = seen.reading - weighted_residual @ K @ spread
    tangent[seen.group < 0] = 0.0
    return Evaluated(field, prediction, residual, G, weighted_residual, cost, columns, tangent)


def normal(seen: Observations, at: Evaluated, weight: Array) -> tuple[Array, Array]:
    """Normal matrix (12 + unknowns)² and gradient (12 + unknowns,) of ½ Σ w rᵀ C⁻¹ r, in nT and rad."""
    groups, n = seen.unknowns, len(seen)
    G, h = weight[:, None, None] * at.information, weight[:, None] * at.weighted_residual
    x = at.columns
    xx = (x[:, :, None] * x[:, None, :]).reshape(n, 16)
    maps = (G.reshape(n, 9).T @ xx).reshape(3, 3, 4, 4).transpose(0, 2, 1, 3).reshape(12, 12)
    N, g = np.zeros((12 + groups, 12 + groups)), np.zeros(12 + groups)
    N[:12, :12] = maps[np.ix_(CONTRACT_ORDER, CONTRACT_ORDER)]
    g[:12] = (h.T @ x).reshape(12)[CONTRACT_ORDER]
    if groups:
        member = (seen.group[:, None] == np.arange(groups)).astype(float)
        t = at.tangent
        Gt = np.einsum("nab,nb->na", G, t)
        mixed = member.T @ (Gt[:, :, None] * x[:, None, :]).reshape(n, 12)
        N[12:, :12] = mixed[:, CONTRACT_ORDER]
        N[:12, 12:] = N[12:, :12].T
        N[12:, 12:] = np.diag(member.T @ np.sum(Gt * t, axis=1))
        g[12:] = member.T @ np.sum(h * t, axis=1)
    return N, g


def blocks(seen: Observations, noise: Noise) -> Iterator[tuple[slice, Observations, Noise]]:
    """The system in pieces of at most BLOCK rows."""
    for start in range(0, len(seen), BLOCK):
        rows = slice(start, start + BLOCK)
        yield rows, seen.select(rows), noise.select(rows)


def _turn(seen: Observations, phase: Array, vector: Array) -> Array:
    """R(axis, −phase) vector for the rows with an unknown starting phase, as they are for the others."""
    if not len(phase):
        return vector
    unknown = seen.group >= 0
    angle = np.where(unknown, -phase[seen.group], 0.0)[:, None]
    along = np.sum(seen.axis * vector, axis=1, keepdims=True) * seen.axis
    return np.asarray(along + np.cos(angle) * (vector - along) + np.sin(angle) * cross(seen.axis, vector))


def _kinds(kind: NDArray[np.int8]) -> Iterator[tuple[int, slice | NDArray[np.intp]]]:
    """The rows of each kind; a slice where all are of one."""
    if len(kind) and (kind == kind[0]).all():
        yield int(kind[0]), slice(None)
        return
    for value in (VECTOR, AXIS, SCALAR):
        rows = np.flatnonzero(kind == value)
        if len(rows):
            yield value, rows


def _spreads(seen: Observations, noise: Noise, phase: Array, tangent: Array, rows: Rows) -> list[Array]:
    """Standard deviations along one direction each, (n, 3) [nT]: the angle's and the time's, where there are any."""
    angle, time = np.asarray(noise.angle_rad), np.asarray(noise.time_s)
    spreads = []
    if (angle > 0).any():
        spreads.append((angle[..., None] * tangent)[rows])
    if (time > 0).any():
        spreads.append((time[..., None] * _turn(seen, phase, seen.velocity))[rows])
    return spreads


def _inverse(base: Array, spreads: list[Array]) -> Array:
    """(base + Σ s sᵀ)⁻¹ (n, 3, 3), or (1, 3, 3) without spreads: one Sherman-Morrison step a direction."""
    G = np.asarray(np.linalg.inv(base)[None], dtype=np.float64)
    for s in spreads:
        Gs = np.einsum("nab,nb->na", np.broadcast_to(G, (len(s), 3, 3)), s)
        G = G - Gs[:, :, None] * Gs[:, None, :] / (1 + np.sum(s * Gs, axis=1))[:, None, None]
    return G


def cross(a: Array, b: Array) -> Array:
    """A × b of rows (n, 3); several times faster than numpy's for few columns."""
    return np.column_stack(
        [
            a[:, 1] * b[:, 2] - a[:, 2] * b[:, 1],
            a[:, 2] * b[:, 0] - a[:, 0] * b[:, 2],
            a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0],
        ]
    )


def heights(seen: Observations, phase: Array) -> Array:
    """`along` (n,) [nT], with the heights of `phase` (unknowns,) where it is not known."""
    if not seen.loci:
        return seen.along
    return np.where((seen.kind == AXIS) & (seen.group >= 0), phase[seen.group], seen.along)


def _magnitude_rows(seen: Observations, rows: Rows, b: Array, base: Array, _: Array, __: float) -> tuple[Array, Array]:
    """Information and residual of rows that know |b| alone.

    The mean of |b| is above the true one by (tr C − uᵀCu) / 2|b|, from the noise across u = b/|b|.
    """
    length = np.maximum(np.linalg.norm(b, axis=1), 1e-9)
    u = b / length[:, None]
    along = np.sum(u @ base * u, axis=1)
    bias = (np.trace(base) - along) / (2 * np.maximum(length, np.sqrt(np.trace(base))))
    return _outer(u, u / along[:, None]), (length - bias - seen.magnitude[rows])[:, None] * u


def _axis_rows(
    seen: Observations, rows: Rows, b: Array, base: Array, heights: Array, reference_nT: float
) -> tuple[Array, Array]:
    """Information and residual of rows that know `axis · b` and |b|: b up to a turn about the axis.

    That is a height along the axis and a radius across it. The mean radius is above the true one by tᵀCt / 2ρ, from the
    noise along the turn t. Where the circle is small against the noise or the field, the height says all; but an
    unknown height says nothing without the circle. It has no noise of the reference, the radius has |b|/radius of it.
    """
    axis, height, unknown = seen.axis[rows], heights[rows], seen.group[rows] >= 0
    radius = _radius(seen.magnitude[rows], height, unknown)
    h = np.sum(axis * b, axis=1)
    across = b - h[:, None] * axis
    rho = np.maximum(np.linalg.norm(across, axis=1), 1e-9)
    u = across / rho[:, None]
    t = cross(axis, u)
    aC, uC = axis @ base, u @ base
    aa, au, uu = np.sum(aC * axis, axis=1), np.sum(aC * u, axis=1), np.sum(uC * u, axis=1)
    tt = np.sum(t @ base * t, axis=1)
    own = np.where(unknown, reference_nT**2, 0.0)
    aa, tt, uu = aa - own, tt - own, uu - own + own * (seen.magnitude[rows] / np.maximum(radius, 1e-9)) ** 2
    circle = unknown | (radius > np.maximum(SMALL * seen.magnitude[rows], 3 * np.sqrt(np.trace(base))))
    au = np.where(circle, au, 0.0)
    det = aa * uu - au**2
    to_axis = (uu / det)[:, None] * axis - (au / det)[:, None] * u
    to_u = np.where(circle, aa / det, 0.0)[:, None] * u - (au / det)[:, None] * axis
    excess = np.where(circle, rho - tt / (2 * np.maximum(rho, np.sqrt(tt))) - radius, 0.0)
    return _outer(axis, to_axis) + _outer(u, to_u), (h - height)[:, None] * axis + excess[:, None] * u


def _radius(magnitude: Array, height: Array, unknown: NDArray[np.bool_]) -> Array:
    """√(|b|² − height²) (n,) [nT]; where the height is a parameter it stays above zero, whatever that tries."""
    return np.asarray(np.sqrt(np.maximum(magnitude**2 - height**2, np.where(unknown, SMALL * magnitude, 0.0) ** 2)))


def _height_slopes(seen: Observations, rows: Rows, b: Array, height: Array) -> Array:
    """How the residual (n, 3) changes with an unknown height: the plane moves up, the circle shrinks."""
    axis = seen.axis[rows]
    across = b - np.sum(axis * b, axis=1, keepdims=True) * axis
    u = across / np.maximum(np.linalg.norm(across, axis=1, keepdims=True), 1e-9)
    radius = _radius(seen.magnitude[rows], height, np.ones(len(b), dtype=bool))
    return np.asarray((height / radius)[:, None] * u - axis)


def _outer(a: Array, c: Array) -> Array:
    """A cᵀ of each row, (n, 3, 3)."""
    return np.asarray(a[:, :, None] * c[:, None, :])

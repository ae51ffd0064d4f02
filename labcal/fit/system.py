"""The base model's residuals as one weighted system, whatever a row offers.

Row i gives the residual r = b − p of rank 3 (vector), 2 (known axis, no angle) or 1 (magnitude). All three are carried
by an information matrix G (3, 3) of that rank and the pull h = G r (3,), so that any column d(residual)/d(parameter)
= E (n, 3) adds Σ EᵀGE to the normal matrix and Σ Eᵀh to the gradient: the map's own columns, the phases, and effects.

The readings carry noise, so the map's columns stand at the estimated true reading m̂ = m − Σ Kᵀ h: with them the
normal equations are the exact gradient of Σ rᵀ C⁻¹ r with C = K Σ Kᵀ + Σ_ref + … (Deming's weights). That is the
likelihood of the *readings*: the normaliser log|det K| of the field's noise and the Jacobian of m → K m cancel.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from labcal.fit.observations import AXIS, SCALAR, VECTOR, Observations
from labcal.geometry import rotate

Array = NDArray[np.float64]
BLOCK = 1 << 15  # rows evaluated at once: bounds the memory
# (3, 4) rows [K_a · scale, k_a] against the contract's order, K row by row, then k
CONTRACT_ORDER = np.array([0, 1, 2, 4, 5, 6, 8, 9, 10, 3, 7, 11])


@dataclass(frozen=True, slots=True, eq=False)
class Noise:
    """Standard deviations that weigh the rows; of reading and reference, that of one axis."""

    reading: float  # DUT units
    reference_nT: float = 0.0
    angle_rad: Array | float = 0.0  # (n,) or one number
    time_s: Array | float = 0.0  # (n,) or one number

    def select(self, rows: slice | NDArray[np.intp] | NDArray[np.bool_]) -> Noise:
        """Return the noise of these rows."""
        angle, time = (v[rows] if isinstance(v, np.ndarray) else v for v in (self.angle_rad, self.time_s))
        return Noise(self.reading, self.reference_nT, angle, time)


@dataclass(frozen=True, slots=True, eq=False)
class Evaluated:
    """The system's rows at one set of parameters."""

    field: Array  # (n, 3) b [nT]
    prediction: Array  # (n, 3) p [nT, B]; only its direction is free where the row is no vector
    residual: Array  # (n, 3) b − p [nT], zero in the directions that the row does not see
    information: Array  # (n, 3, 3) G [1/nT²]
    pull: Array  # (n, 3) h = G r [1/nT]
    cost: Array  # (n,) rᵀ G r
    columns: Array  # (n, 4) x = (m̂ / scale, −1): d b_a / d(K_a · scale, k_a)
    tangent: Array  # (n, 3) −dp/dφ = axis × p [nT/rad], zero where no phase is unknown


def map_of(theta: Array, scale: float) -> tuple[Array, Array]:
    """K (3, 3) in nT per DUT unit and k (3,) from the scaled parameters (12,), K · scale row by row, then k."""
    return theta[:9].reshape(3, 3) / scale, theta[9:]


def evaluate(
    seen: Observations, noise: Noise, theta: Array, phase: Array, correction: Array | float = 0.0
) -> Evaluated:
    """Evaluate residuals and weights of every row of `seen`.

    `theta` (12,) are K · scale row by row, then k, all in nT; `phase` (groups,) rad; `correction` (n, 3) nT is the sum
    of the effects, subtracted from K m − k.
    """
    K, k = theta[:9].reshape(3, 3), theta[9:]
    field = seen.reading @ K.T - k - correction
    prediction = _prediction(seen, phase)
    sigma = noise.reading / seen.scale
    base = sigma**2 * (K @ K.T) + noise.reference_nT**2 * np.eye(3)
    tangent = np.cross(seen.axis, prediction)
    G, residual = np.empty((len(seen), 3, 3)), np.zeros((len(seen), 3))
    for kind, rows in _kinds(seen.kind):
        if kind == VECTOR:
            spread = [_scaled(noise.select(rows).angle_rad, tangent[rows])]
            spread += [_scaled(noise.select(rows).time_s, _turn(seen, phase, seen.velocity)[rows])]
            G[rows], residual[rows] = _inverse(base, spread), field[rows] - prediction[rows]
        else:
            G[rows], residual[rows] = _magnitude_rows(seen, rows, field[rows], base, with_axis=kind == AXIS)
    pull = np.einsum("nab,nb->na", G, residual)
    cost = np.einsum("na,na->n", pull, residual)
    fitted = seen.reading - sigma**2 * (pull @ K)
    columns = np.column_stack([fitted, np.full(len(seen), -1.0)])
    tangent[seen.group < 0] = 0.0
    return Evaluated(field, prediction, residual, G, pull, cost, columns, tangent)


def normal(seen: Observations, at: Evaluated, weight: Array) -> tuple[Array, Array]:
    """Normal matrix (12 + groups)² and gradient (12 + groups,) of ½ Σ w rᵀ C⁻¹ r, in nT and rad."""
    groups, n = len(seen.phase_names), len(seen)
    G, h = weight[:, None, None] * at.information, weight[:, None] * at.pull
    x = at.columns
    xx = (x[:, :, None] * x[:, None, :]).reshape(n, 16)
    maps = (G.reshape(n, 9).T @ xx).reshape(3, 3, 4, 4).transpose(0, 2, 1, 3).reshape(12, 12)
    N, g = np.zeros((12 + groups, 12 + groups)), np.zeros(12 + groups)
    N[:12, :12] = maps[np.ix_(CONTRACT_ORDER, CONTRACT_ORDER)]
    g[:12] = (h.T @ x).reshape(12)[CONTRACT_ORDER]
    for group in range(groups):
        rows = seen.group == group
        t = at.tangent[rows]
        Gt = np.einsum("nab,nb->na", G[rows], t)
        cross = (Gt.T @ x[rows]).reshape(12)[CONTRACT_ORDER]
        N[12 + group, :12] = N[:12, 12 + group] = cross
        N[12 + group, 12 + group] = np.sum(Gt * t)
        g[12 + group] = np.sum(h[rows] * t)
    return N, g


def blocks(seen: Observations, noise: Noise) -> Iterator[tuple[slice, Observations, Noise]]:
    """The system in pieces of at most BLOCK rows."""
    for start in range(0, len(seen), BLOCK):
        rows = slice(start, start + BLOCK)
        yield rows, seen.select(rows), noise.select(rows)


def _prediction(seen: Observations, phase: Array) -> Array:
    return _turn(seen, phase, seen.target)


def _turn(seen: Observations, phase: Array, vector: Array) -> Array:
    """R(axis, −phase) vector for the rows with an unknown starting phase; a new array."""
    out = vector.copy()
    rows = seen.group >= 0
    if rows.any():
        out[rows] = rotate(seen.axis[rows], -phase[seen.group[rows]], vector[rows])
    return out


def _kinds(kind: NDArray[np.int8]) -> Iterator[tuple[int, NDArray[np.intp]]]:
    for value in (VECTOR, AXIS, SCALAR):
        rows = np.flatnonzero(kind == value)
        if len(rows):
            yield value, rows


def _scaled(sigma: Array | float, direction: Array) -> Array | None:
    """The standard deviation as a vector (n, 3) [nT]; None where it is nought everywhere."""
    return np.asarray(np.reshape(sigma, (-1, 1)) * direction) if np.any(np.asarray(sigma) > 0) else None


def _inverse(base: Array, spread: list[Array | None]) -> Array:
    """(base + Σ s sᵀ)⁻¹ (n, 3, 3) for a constant base (3, 3), one Sherman-Morrison step a direction."""
    G = np.asarray(np.linalg.inv(base)[None], dtype=np.float64)
    for s in spread:
        if s is not None:
            Gs = np.einsum("nab,nb->na", np.broadcast_to(G, (len(s), 3, 3)), s)
            G = G - Gs[:, :, None] * Gs[:, None, :] / (1 + np.sum(s * Gs, axis=1))[:, None, None]
    return G


def _magnitude_rows(
    seen: Observations, rows: NDArray[np.intp], b: Array, base: Array, *, with_axis: bool
) -> tuple[Array, Array]:
    """Information and residual of rows that know |b|, and `axis · b` where `with_axis`.

    The mean of |b| is above the true one by (tr C − uᵀCu) / 2|b|, from the noise across it. The axis is taken
    across u = b/|b| (its part along u tells nothing new); rows within half a degree of it give the magnitude alone.
    """
    length = np.maximum(np.linalg.norm(b, axis=1), 1e-9)
    u = b / length[:, None]
    along = np.einsum("na,ab,nb->n", u, base, u)
    bias = (np.trace(base) - along) / (2 * np.maximum(length, np.sqrt(np.trace(base))))
    excess = length - bias - seen.magnitude[rows]
    residual = excess[:, None] * u
    if not with_axis:
        return u[:, :, None] * u[:, None, :] / along[:, None, None], residual
    cosine = np.sum(seen.axis[rows] * u, axis=1)
    across = seen.axis[rows] - cosine[:, None] * u
    sine = np.linalg.norm(across, axis=1)
    usable = sine > 0.01
    e = np.where(usable[:, None], across / np.maximum(sine, 0.01)[:, None], 0.0)
    lateral = (np.sum(seen.axis[rows] * b, axis=1) - seen.along[rows] - cosine * excess) / np.maximum(sine, 0.01)
    ue, ee = np.einsum("na,ab,nb->n", u, base, e), np.einsum("na,ab,nb->n", e, base, e)
    ee = np.where(usable, ee, 1.0)
    G = ee * _outer(u, u) - ue * (_outer(u, e) + _outer(e, u)) + along * _outer(e, e)
    return np.moveaxis(G / (along * ee - ue**2), -1, 0), residual + np.where(usable, lateral, 0.0)[:, None] * e


def _outer(a: Array, c: Array) -> Array:
    """A cᵀ of each row, (3, 3, n)."""
    return np.asarray(a.T[:, None, :] * c.T[None, :, :])

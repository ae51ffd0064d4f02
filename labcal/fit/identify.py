"""What a run determines: the information that excitation gives, apart from what noise feigns."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from labcal.fit.observations import Observations
from labcal.fit.solve import Form, Solution
from labcal.fit.system import CONTRACT_ORDER, Noise, blocks, evaluate
from labcal.geometry import unit

Array = NDArray[np.float64]
NAMES = (*(f"K_{a}{b}" for a in "xyz" for b in "xyz"), "k_x", "k_y", "k_z")
SIGNAL_OVER_NOISE = 4.0  # a direction counts where excitation gives four times the information that noise feigns
LARGEST_U = 0.05  # of the largest field: beyond it the linear propagation, too, means little


@dataclass(frozen=True, slots=True, eq=False)
class Identified:
    """Rank, covariance and the worst uncertainty in the working range."""

    rank: int
    size: int
    covariance: Array  # (12, 12) of the scaled parameters [nT²]; only where `why_not` is None
    worst_u_nT: float
    why_not: str | None


def identify(seen: Observations, noise: Noise, allowed: Form, found: Solution) -> Identified:
    """Decide by rank and by the uncertainty propagated over the working range whether the map is determined.

    The phases are eliminated first. The scaled parameters are all in nT at the rms reading, so that their eigenvalues
    compare. Noise in the readings adds to Σ xᵀGx what it would without any motion; that part is taken off, and the
    covariance is S⁻¹ N S⁻¹ with S the rest (Fuller, Measurement Error Models, 1987, section 2.2).
    """
    q = allowed.basis.shape[1]
    N, feigned = _without_phases(found.normal, q), allowed.basis.T @ _feigned(seen, noise, found) @ allowed.basis
    S = N - feigned
    values, vectors = np.linalg.eigh(S)
    by_noise = np.einsum("aj,ab,bj->j", vectors, feigned, vectors)
    known = (values > SIGNAL_OVER_NOISE * by_noise) & (values > 1e-10 * values[-1])
    rank, nothing = int(known.sum()), np.full((12, 12), np.nan)
    if rank < q:
        return Identified(rank, q, nothing, np.inf, _reason(seen, allowed, vectors[:, ~known], rank))
    inverse = vectors @ np.diag(1 / values) @ vectors.T
    covariance = allowed.basis @ (inverse @ N @ inverse) @ allowed.basis.T
    worst = worst_uncertainty(found.theta, covariance, float(seen.magnitude.max()))
    if worst > LARGEST_U * seen.magnitude.max():
        weakest = vectors[:, :1]
        why = _reason(seen, allowed, weakest, rank, f"; the field would be uncertain by {worst:.0f} nT")
        return Identified(rank, q, covariance, worst, why)
    return Identified(rank, q, covariance, worst, None)


def worst_uncertainty(theta: Array, covariance: Array, field_nT: float) -> float:
    """The largest standard uncertainty of one direction of b [nT] over 26 directions of a field of that size."""
    grid = np.stack(np.meshgrid(*[[-1.0, 0.0, 1.0]] * 3), axis=-1).reshape(-1, 3)
    b = field_nT * unit(grid[grid.any(axis=1)])
    K = theta[:9].reshape(3, 3)
    try:
        m = np.asarray(np.linalg.solve(K, (b + theta[9:]).T).T)
    except np.linalg.LinAlgError:
        return float("inf")
    return float(np.sqrt(max(np.linalg.eigvalsh(field_covariance(m, covariance)).max(), 0.0)))


def field_covariance(reading: Array, covariance: Array) -> Array:
    """Covariance (n, 3, 3) [nT²] of K m − k for readings (n, 3), from that of (K row by row, k) (12, 12)."""
    x = np.column_stack([reading, np.full(len(reading), -1.0)])
    order = np.argsort(CONTRACT_ORDER)
    blocks_ = covariance[np.ix_(order, order)].reshape(3, 4, 3, 4)
    return np.asarray(np.einsum("ni,aibj,nj->nab", x, blocks_, x, optimize=True))


def _without_phases(N: Array, q: int) -> Array:
    """The information on the first q parameters when the others are free (Schur complement)."""
    if len(N) == q:
        return N
    return np.asarray(N[:q, :q] - N[:q, q:] @ np.linalg.pinv(N[q:, q:], rcond=1e-13, hermitian=True) @ N[q:, :q])


def _feigned(seen: Observations, noise: Noise, found: Solution) -> Array:
    """Σ w G ⊗ cov(m̂) (12, 12): the information that the noise left in the estimated readings would seem to give."""
    out = np.zeros((3, 3, 4, 4))
    K, variance = found.theta[:9].reshape(3, 3), (noise.reading / seen.scale) ** 2
    for rows, part, part_noise in blocks(seen, noise):
        G = evaluate(part, part_noise, found.theta, found.phase).information
        left = variance * np.eye(3) - variance**2 * (K.T @ G @ K)
        weighted = (found.weight[rows][:, None, None] * G).reshape(-1, 9)
        out[:, :, :3, :3] += (weighted.T @ left.reshape(-1, 9)).reshape(3, 3, 3, 3)
    return np.asarray(out.transpose(0, 2, 1, 3).reshape(12, 12)[np.ix_(CONTRACT_ORDER, CONTRACT_ORDER)])


def _reason(seen: Observations, allowed: Form, directions: Array, rank: int, more: str = "") -> str:
    """One sentence: which parameters are open, and which excitation is missing."""
    reach = np.linalg.norm(allowed.basis @ directions, axis=1)
    open_ones = [NAMES[i] for i in np.argsort(-reach, kind="stable") if reach[i] > 0.3 * reach.max()]
    size = allowed.basis.shape[1]
    return f"the run determines {rank} of {size} parameters, not {', '.join(open_ones)}{more}: {_missing(seen)}"


def _missing(seen: Observations) -> str:
    spread = np.sqrt(np.maximum(np.linalg.eigvalsh(np.cov(seen.reading.T)), 0.0))
    if spread[0] < 0.05 * spread[2]:
        return "the readings lie close to one plane; turn the sensor about another body axis as well"
    if np.ptp(seen.magnitude) < 0.05 * seen.magnitude.max():
        return "add a rotation about another body axis or a field of another magnitude"
    return "add a rotation about another body axis, or a field at another angle to the axis"

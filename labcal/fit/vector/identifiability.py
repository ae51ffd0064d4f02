"""What a run determines: the information that excitation gives, apart from what noise induces."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from labcal.fit.vector.observations import Observations
from labcal.fit.vector.solve import ROBUST, Loss, Parameterisation, Solution, solve
from labcal.fit.vector.system import CONTRACT_ORDER, Noise, blocks, evaluate
from labcal.geometry import unit

Array = NDArray[np.float64]
NAMES = (*(f"K_{a}{b}" for a in "xyz" for b in "xyz"), "k_x", "k_y", "k_z")
SIGNAL_OVER_NOISE = 4.0  # a direction counts where excitation gives four times the information that noise induces
CLEAR = 1e4  # … and beyond this much more there is no need to look for a valley
MOST_NAMED = 5
FAR = 8.0  # standard uncertainties at which a valley is looked for
LARGEST_U = 0.05  # of the largest field: beyond it the linear propagation, too, means little
# Where heights are unknown u still is the scatter: models 2 and 5 of Riwanto et al. (tests/papers/test_riwanto.py).
LEAST_OF_PLANES, LARGEST_U_OF_PLANES = 1.0, 0.15


@dataclass(frozen=True, slots=True, eq=False)
class Identifiability:
    """Rank, covariance and the worst uncertainty in the working range."""

    rank: int
    size: int
    covariance: Array  # (12, 12) of the scaled parameters [nT²]; only where `why_not` is None
    worst_u_nT: float
    why_not: str | None


def identify(
    seen: Observations,
    noise: Noise,
    parameterisation: Parameterisation,
    found: Solution,
    loss: Loss = ROBUST,
    scale: float = 1.0,
) -> Identifiability:
    """Decide by rank and by the uncertainty propagated over the working range whether the map is determined.

    The phases are eliminated first. The scaled parameters are all in nT at the rms reading, so that their eigenvalues
    compare. Noise in the readings adds to Σ xᵀGx what it would without any motion; that part is taken off, and the
    covariance is S⁻¹ N S⁻¹ with S the rest (Fuller, Measurement Error Models, 1987, section 2.2), times `scale`².
    """
    q, largest = parameterisation.basis.shape[1], float(seen.magnitude.max())
    N, noise_induced = (
        _without_phases(found.normal, q),
        parameterisation.basis.T @ noise_induced_information(seen, noise, found) @ parameterisation.basis,
    )
    S = N - noise_induced
    values, vectors = np.linalg.eigh(S)
    ratio = values / np.maximum(np.einsum("aj,ab,bj->j", vectors, noise_induced, vectors), 1e-300)
    least, largest_u = (LEAST_OF_PLANES, LARGEST_U_OF_PLANES) if seen.loci else (SIGNAL_OVER_NOISE, LARGEST_U)
    known = (ratio > least) & (values > 1e-10 * values[-1])
    rank = int(known.sum())
    if rank < q:
        why = _reason(seen, parameterisation, vectors[:, ~known], rank)
        return Identifiability(rank, q, np.full((12, 12), np.nan), np.inf, why)
    inverse = vectors @ np.diag(1 / values) @ vectors.T
    own = scale**2 * (inverse @ N @ inverse)
    covariance = parameterisation.basis @ own @ parameterisation.basis.T
    worst = worst_uncertainty(found.theta, covariance, largest)
    weakest = vectors[:, np.argmin(ratio)]
    if worst > largest_u * largest:
        more = f"; the field would be uncertain by {worst:.0f} nT"
    elif ratio.min() < CLEAR and _valley(seen, noise, parameterisation, found, loss, scale, weakest, own):
        more, rank = "; quite another map fits as well", rank - 1
    else:
        return Identifiability(rank, q, covariance, worst, None)
    return Identifiability(rank, q, covariance, worst, _reason(seen, parameterisation, weakest[:, None], rank, more))


def _valley(
    seen: Observations,
    noise: Noise,
    parameterisation: Parameterisation,
    found: Solution,
    loss: Loss,
    scale: float,
    weakest: Array,
    own: Array,
) -> bool:
    """Whether the loss stays low FAR along the weakest direction, where the curvature says that it must have risen.

    Two circles in parallel planes lie on a whole family of ellipsoids: noise chooses one, and its curvature there is
    no measure of the others.
    """
    step = FAR * float(np.sqrt(weakest @ own @ weakest)) * weakest
    across = np.linalg.svd(weakest[:, None])[0][:, 1:]
    q = parameterisation.nearest(found.theta)
    for sign in (-1.0, 1.0):
        shifted = parameterisation.fixed + parameterisation.basis @ (q + sign * step)
        held = Parameterisation(parameterisation.name, shifted, parameterisation.basis @ across)
        there = solve(seen, noise, held, shifted, found.phase, loss, iterations=30)
        if there.loss - found.loss < FAR**2 / 4 * scale**2:
            return True
    return False


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


def noise_induced_information(seen: Observations, noise: Noise, found: Solution) -> Array:
    """Σ w G ⊗ cov(m̂) (12, 12): the information that the noise left in the estimated readings would seem to give.

    cov(m̂) = Σ − Σ Kᵀ G K Σ is linear in G, so the sums of G and of its products serve all rows.
    """
    single, double = np.zeros(9), np.zeros((9, 9))
    for rows, part, part_noise in blocks(seen, noise):
        G = evaluate(part, part_noise, found.theta, found.phase).information
        weighted = found.weight[rows][:, None] * G.reshape(-1, 9)
        single, double = single + weighted.sum(axis=0), double + weighted.T @ G.reshape(-1, 9)
    spread = noise.covariance(seen.scale)
    pulled = spread @ found.theta[:9].reshape(3, 3).T
    out = np.zeros((3, 3, 4, 4))
    out[:, :, :3, :3] = single.reshape(3, 3)[:, :, None, None] * spread
    out[:, :, :3, :3] -= np.einsum("abcd,ic,jd->abij", double.reshape(3, 3, 3, 3), pulled, pulled)
    return np.asarray(out.transpose(0, 2, 1, 3).reshape(12, 12)[np.ix_(CONTRACT_ORDER, CONTRACT_ORDER)])


def _reason(
    seen: Observations, parameterisation: Parameterisation, directions: Array, rank: int, more: str = ""
) -> str:
    """One sentence: which parameters are open, and which excitation is missing."""
    reach = np.linalg.norm(parameterisation.basis @ directions, axis=1)
    open_ones = [NAMES[i] for i in np.argsort(-reach, kind="stable") if reach[i] > 0.3 * reach.max()]
    size, others = parameterisation.basis.shape[1], len(open_ones) - MOST_NAMED
    listed = ", ".join(open_ones[:MOST_NAMED]) + (f" and {others} more" if others > 0 else "")
    if len(open_ones) == size - rank:
        return f"the run determines {rank} of {size} parameters, not {listed}{more}: {_missing(seen)}"
    counted = f"the run determines only {rank} combinations of the {size} parameters"  # in which more of them are bound
    return f"{counted}; open are {listed}{more}: {_missing(seen)}"


def _missing(seen: Observations) -> str:
    spread = np.sqrt(np.maximum(np.linalg.eigvalsh(np.cov(seen.reading.T)), 0.0))
    if spread[0] < 0.05 * spread[2]:
        return "the readings lie close to one plane; turn the sensor about another body axis as well"
    if np.ptp(seen.magnitude) < 0.05 * seen.magnitude.max():
        return "add a rotation about another body axis or a field of another magnitude"
    return "add a rotation about another body axis, or a field at another angle to the axis"

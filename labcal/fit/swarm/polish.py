"""Gauss-Newton from the swarm's best place to the most likely one, with its covariance.

The noise is taken white in the corrected space (Riwanto et al. 2017, (2a)). A row with a rotation axis knows b up to
a turn about that axis, a row without knows |b| alone; the unknown turn is averaged over the circle or the sphere.
With b = h ω + ρ u, u across ω, the density of a reading m is then

    |det K| σ⁻³ exp(−((h − h₀)² + ρ² + ρ₀²) / 2σ²) · I₀(ρ ρ₀ / σ²)      (a scalar row: ω = 0 and sinh(x) / x for I₀)

and its score is that of a least-squares fit to the point p = h₀ ω + ρ₀ A(ρ ρ₀ / σ²) u, where A = I₁ / I₀ (scalar:
coth x − 1/x), less n K⁻ᵀ. The determinant keeps the fit from K → 0, to which plain least squares on magnitudes falls.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Literal

import numpy as np
from numpy.typing import NDArray
from scipy.special import i0e, i1e

from labcal.fit.autocorrelation import variance_inflation
from labcal.fit.swarm.loci import Loci
from labcal.model.affine import jacobian

Array = NDArray[np.float64]
WhiteIn = Literal["reading", "field"]
ROUNDS = 60
LONGEST_STEP = 0.2  # of a gain, and of a bias over the mean field


@dataclass(frozen=True, slots=True, eq=False)
class Polished:
    """The most likely parameters; the heights are those of loci whose `along` is not known."""

    theta: Array  # (12,) K row by row [nT of B per nT of reading], then k [nT]
    heights: Array  # (h,) [nT]
    covariance: Array  # (12, 12) of theta, widened where residuals correlate
    noise_nT: float  # standard deviation of one component in the corrected space
    converged: bool


@dataclass(frozen=True, slots=True, eq=False)
class _Rows:
    """Rows at one set of parameters: e = b − p, the directions the row knows, and d e / d(parameters)."""

    misfit: Array  # (n, 3)
    along: Array  # (n, 3) ω, or zero
    across: Array  # (n, 3) u
    seen: Array  # (n, 2) the misfits h − h₀ and ρ − ρ₀ [nT]
    slope: Array  # (n, 3, 12 + h)

    @property
    def known(self) -> Array:
        """The directions (n, 2, 3) in which the row knows b."""
        return np.stack([self.along, self.across], axis=1)


def symmetric_basis() -> Array:
    """(12, 9): K symmetric, so that a magnitude's nine parameters are all there are."""
    basis = np.zeros((12, 9))
    for column, (i, j) in enumerate([(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)]):
        basis[3 * i + j, column] = basis[3 * j + i, column] = 1.0
    basis[9:, 6:] = np.eye(3)
    return basis


def polish(
    loci: Loci,
    theta: Array,
    *,
    basis: Array | None = None,
    white_in: WhiteIn = "reading",
    reference_noise_nT: float = 0.0,
) -> Polished:
    """Maximise the likelihood from `theta` (12,); noise and unknown heights are estimated with it.

    Raises LinAlgError where the rows do not determine the parameters.

    `basis` (12, q) holds theta in a subspace. `white_in` says where the noise of the covariance is white: in the
    readings, as instruments have it, or in the corrected field, as in (2a).
    """
    unknown = _unknown_heights(loci)
    full = np.concatenate([theta, _heights(loci, theta, unknown)])
    free = _free(np.eye(12) if basis is None else basis, unknown.shape[1])
    sigma, size = 0.0, np.inf
    for _ in range(ROUNDS):
        sigma = _noise(loci, _evaluate(loci, full, unknown, sigma), free.shape[1])
        rows = _evaluate(loci, full, unknown, sigma)
        step = free @ np.linalg.solve(_information(rows, free) / sigma**2, -free.T @ _score(rows, full, sigma))
        size = float(np.max(np.abs(np.concatenate([step[:9], step[9:] / np.mean(loci.magnitude)]))))
        full = full + step * min(1.0, LONGEST_STEP / size)
        if size < 1e-12:
            break
    noise = _Noise(sigma, min(reference_noise_nT / sigma, 1.0), white_in)
    covariance = _covariance(loci, full, unknown, free, noise)[:12, :12]
    covariance *= variance_inflation(_evaluate(loci, full, unknown, sigma).seen, loci.locus)
    return Polished(full[:12], full[12:], covariance, sigma, size < 1e-7)


def singular_values(loci: Loci, theta: Array, basis: Array | None = None) -> Array:
    """The information of the run's geometry about each combination of parameters, largest first; noise takes no part.

    Singular values of d(what a row knows)/d(E, e) for a small change b → E b + e at the points p that `theta` (12,)
    puts in place of the readings, a gain counted by what it does to the mean field, over the root of the number of
    rows. Unknown heights are parameters too. Zero is a combination that no amount of such data determines.
    """
    unknown = _unknown_heights(loci)
    heights = _heights(loci, theta, unknown)
    rows = _evaluate(loci, np.concatenate([theta, heights]), unknown, 0.0)
    point = loci.reading @ theta[:9].reshape(3, 3).T - theta[9:] - np.einsum("ni,nia->na", rows.seen, rows.known)
    identity = np.concatenate([np.eye(3).ravel(), np.zeros(3), heights])
    slopes = np.concatenate(_seen_slopes(_evaluate(replace(loci, reading=point), identity, unknown, 0.0)))
    slopes[:, :9] /= np.mean(loci.magnitude)
    free = _free(np.eye(12) if basis is None else basis, unknown.shape[1])
    values = np.linalg.svd(slopes @ (free / np.linalg.norm(free, axis=0)), compute_uv=False)
    return np.asarray(values / np.sqrt(len(loci)))


def noise_bias_in_sigma(loci: Loci, found: Polished) -> float:
    """How far the fit may be off, in standard uncertainties, where the noise is white in the readings and not in b.

    The noise biases a gain by (σ / |b|)² times what K Kᵀ differs from a multiple of the identity, against an
    uncertainty of σ / |b| √n.
    """
    K = found.theta[:9].reshape(3, 3)
    size = np.linalg.eigvalsh(K @ K.T)
    uneven = float(np.max(np.abs(size / np.mean(size) - 1)))
    return float(found.noise_nT * np.sqrt(np.mean(loci.magnitude**-2.0)) * np.sqrt(len(loci)) * uneven)


def worst_uncertainty_nT(loci: Loci, found: Polished) -> float:
    """The largest standard uncertainty of K m − k along a line of parameters, a gain counted by the mean field."""
    width = np.concatenate([np.full(9, np.mean(loci.magnitude)), np.ones(3)])
    largest = np.linalg.eigvalsh(found.covariance * width * width[:, None])[-1]
    return float(np.sqrt(largest)) if largest >= 0 else np.inf


def _free(basis: Array, heights: int) -> Array:
    out = np.zeros((12 + heights, basis.shape[1] + heights))
    out[:12, : basis.shape[1]], out[12:, basis.shape[1] :] = basis, np.eye(heights)
    return out


def _unknown_heights(loci: Loci) -> Array:
    """Which height (n, h) a row takes part in: one column a locus whose `along` is not known."""
    free = [index for index in range(len(loci.axes)) if not np.isfinite(loci.along[loci.rows(index)]).all()]
    return np.asarray(loci.locus[:, None] == np.array(free, dtype=np.intp), dtype=float)


def _heights(loci: Loci, theta: Array, unknown: Array) -> Array:
    h = np.sum((loci.reading @ theta[:9].reshape(3, 3).T - theta[9:]) * loci.axis, axis=1)
    return np.asarray(h @ unknown / np.maximum(unknown.sum(axis=0), 1))


def _evaluate(loci: Loci, full: Array, unknown: Array, sigma: float) -> _Rows:
    field = loci.reading @ full[:9].reshape(3, 3).T - full[9:12]
    axis = loci.axis
    height = np.where(unknown.any(axis=1), unknown @ full[12:], np.nan_to_num(loci.along))
    radius = np.sqrt(np.maximum(loci.magnitude**2 - height**2, 0.0))
    h = np.sum(field * axis, axis=1)
    off_axis = field - h[:, None] * axis
    rho = np.maximum(np.linalg.norm(off_axis, axis=1), 1e-9)
    across = off_axis / rho[:, None]
    resultant = _resultant(rho * radius / max(sigma, 1e-9) ** 2, circle=loci.locus >= 0)
    misfit = (h - height)[:, None] * axis + (rho - radius * resultant)[:, None] * across
    tilt = height / np.maximum(radius, 1e-9)
    of_height = tilt[:, None] * across - axis
    slope = np.concatenate([jacobian(loci.reading), of_height[:, :, None] * unknown[:, None, :]], axis=2)
    return _Rows(misfit, axis, across, np.stack([h - height, rho - radius], axis=1), slope)


def _resultant(x: Array, circle: NDArray[np.bool_]) -> Array:
    """A(x): the mean of cos over a direction seen with concentration x, on a circle or on the sphere."""
    x = np.clip(x, 1e-6, 1e12)
    return np.where(circle, i1e(x) / i0e(x), 1 / np.tanh(x) - 1 / x)


def _noise(loci: Loci, rows: _Rows, parameters: int) -> float:
    """σ from what the rows know: two numbers a row with an axis, one a row without."""
    numbers = int(np.sum(loci.locus >= 0)) + len(loci)
    return float(np.sqrt(np.sum(rows.seen**2) / max(numbers - parameters, 1))) + 1e-9


def _score(rows: _Rows, full: Array, sigma: float) -> Array:
    """d(−log likelihood)/d(parameters)."""
    score = np.einsum("na,nap->p", rows.misfit, rows.slope) / sigma**2
    score[:9] -= len(rows.misfit) * np.linalg.inv(full[:9].reshape(3, 3)).T.ravel()
    return np.asarray(score)


def _seen_slopes(rows: _Rows) -> tuple[Array, Array]:
    """The slopes (n, p) of the two misfits a row knows, h − h₀ and ρ − ρ₀."""
    along = np.einsum("na,nap->np", rows.along, rows.slope)
    return along, np.einsum("na,nap->np", rows.across, rows.slope)


def _information(rows: _Rows, free: Array) -> Array:
    """Gauss-Newton's normal matrix times σ²."""
    along, across = (slope @ free for slope in _seen_slopes(rows))
    return np.asarray(along.T @ along + across.T @ across)


def _covariance(loci: Loci, full: Array, unknown: Array, free: Array, noise: _Noise) -> Array:
    """A⁻¹ B A⁻¹: A from differences of the score, B the score's variance under the noise as it is.

    The fit weights all directions alike; B says what noise K Σ Kᵀ + Σ_ref really does to it.
    """
    width = np.concatenate([np.full(9, 1e-6), np.full(len(full) - 9, 1e-6 * np.mean(loci.magnitude))])
    A = np.stack([_slope_of_score(loci, full, unknown, noise.sigma, d) for d in np.diag(width)]) / (2 * width[:, None])
    rows = _evaluate(loci, full, unknown, noise.sigma)
    slopes = np.stack(_seen_slopes(rows), axis=1)  # (n, 2, p)
    spread = noise.spread(full[:9].reshape(3, 3), rows.known)
    B = np.einsum("nip,nij,njq->pq", slopes, spread, slopes, optimize=True) / noise.sigma**2
    curvature = free.T @ (A + A.T) / 2 @ free
    np.linalg.cholesky(curvature)  # a saddle is no summit
    inverse = free @ np.linalg.inv(curvature) @ free.T
    return np.asarray(inverse @ B @ inverse)


def _slope_of_score(loci: Loci, full: Array, unknown: Array, sigma: float, step: Array) -> Array:
    high, low = (_score(_evaluate(loci, x, unknown, sigma), x, sigma) for x in (full + step, full - step))
    return high - low


@dataclass(frozen=True, slots=True)
class _Noise:
    """The size `sigma` of the residuals [nT], the reference's part in it, and where the rest is white."""

    sigma: float
    reference_part: float
    white_in: WhiteIn

    def spread(self, K: Array, known: Array) -> Array:
        """Covariance (n, 2, 2) of what each row knows, over σ², for its directions `known` (n, 2, 3)."""
        shape = np.eye(3) if self.white_in == "field" else K @ K.T / np.trace(K @ K.T) * 3
        shape = shape + self.reference_part**2 * (np.eye(3) - shape)
        spread = known @ shape @ known.swapaxes(1, 2)
        return np.asarray(spread * np.sum(known**2) / np.trace(spread, axis1=1, axis2=2).sum())

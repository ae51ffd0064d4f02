"""What each segment of a run adds to a fit of the whole: with it the covariance of a fit to any part is a sum away.

At the solution of the whole run, of the parameters x (map, then phases): N = Σ N_s, the part of it that noise induces
F = Σ F_s, and, for each declared error i of one standard deviation, dg_i = Σ dg_is. With the phases eliminated and
S = N − F a fit to part of the segments has the covariance f S⁻¹ N S⁻¹ + Σ_i (N⁻¹ dg_i)(N⁻¹ dg_i)ᵀ, as that of the whole
has in `labcal.fit.vector.identifiability` and `declared`; f is how far the whole run's residuals widened it.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from labcal.fit.result import Fit
from labcal.fit.vector.identifiability import SIGNAL_OVER_NOISE, noise_induced_information
from labcal.fit.vector.ml import estimate, ml
from labcal.fit.vector.observations import Observations
from labcal.fit.vector.planes import observe_like
from labcal.fit.vector.solve import Solution
from labcal.fit.vector.system import Noise, evaluate, normal
from labcal.model import AffineMap
from labcal.record import Run
from labcal.uncertainty import declared_errors

Array = NDArray[np.float64]
SINGULAR = 1e-10  # smallest over largest eigenvalue, as `identify` takes it


@dataclass(frozen=True, slots=True, eq=False)
class Information:
    """Of s segments, e declared errors, p = 12 + phases parameters, K in units of 1/`scale`."""

    affine: AffineMap  # of the whole run
    normal: Array  # (s, p, p)
    noise_induced: Array  # (s, 12, 12)
    shift: Array  # (s, e, p) change of the gradient by an error of one standard deviation
    widened: float
    scale: float

    def covariance(self, chosen: NDArray[np.bool_]) -> Array:
        """Covariance (m, 12, 12) of K row by row, then k, of fits to the segments `chosen` (m, s).

        Infinite on its diagonal where they do not determine the map.
        """
        sums = (self.normal, self.shift, self.noise_induced)
        N, dg, noise_induced = (np.tensordot(chosen.astype(float), a, 1) for a in sums)
        N, dg = _without_phases(N, dg)
        values, vectors = np.linalg.eigh(N - noise_induced)
        by_noise = np.einsum("maj,mab,mbj->mj", vectors, noise_induced, vectors, optimize=True)
        known = (values > SIGNAL_OVER_NOISE * by_noise) & (values > SINGULAR * values[:, -1:])
        whole = known.all(axis=1)
        out = np.tile(np.diag(np.full(12, np.inf)), (len(chosen), 1, 1))
        inverse = (vectors[whole] / values[whole][:, None, :]) @ vectors[whole].transpose(0, 2, 1)
        moved = np.linalg.solve(N[whole], dg[whole].transpose(0, 2, 1))
        noise = self.widened * inverse @ N[whole] @ inverse
        unit = np.r_[np.full(9, 1 / self.scale), np.ones(3)]
        out[whole] = (noise + moved @ moved.transpose(0, 2, 1)) * np.outer(unit, unit)
        return np.asarray(out)


def _without_phases(N: Array, dg: Array) -> tuple[Array, Array]:
    """N (m, 12, 12) and the gradients (m, e, 12) when the phases are free; those of no chosen segment do not count."""
    phases = np.einsum("mii->mi", N)[:, 12:]
    phases = np.where(phases > 0, phases, 1.0)
    mixed = N[:, :12, 12:] / phases[:, None, :]
    left = N[:, :12, :12] - mixed @ N[:, 12:, :12]
    return left, dg[:, :, :12] - dg[:, :, 12:] @ mixed.transpose(0, 2, 1)


def information(run: Run) -> Information:
    """What each segment of `run` adds. Raises ValueError where the whole run does not determine a map in a frame."""
    whole, found = ml(run), None
    if whole.ok and whole.frame_known and whole.sources is not None:
        found = estimate(run)
    if found is None or found.parameterisation.name != "affine" or found.observations.loci:
        raise ValueError(whole.why_not or "its reference leaves the rotation of the map open")
    seen, noise, solution = found.observations, found.noise, found.solution
    errors = declared_errors(run)
    there = [[observe_like(error.change(run, times), seen) for times in (1.0, -1.0)] for error in errors]
    parts = [np.flatnonzero(seen.segment == s) for s in range(len(run.segments))]
    N = np.stack([_of(seen, noise, solution, rows)[0] for rows in parts])
    noise_induced = np.stack([_noise_induced(seen, noise, solution, rows) for rows in parts])
    moved = [[[_of(way, noise, solution, rows)[1] for way in ways] for ways in there] for rows in parts]
    both = np.array(moved).reshape(len(parts), len(there), 2, N.shape[1])
    shift = (both[:, :, 0] - both[:, :, 1]) / 2
    known = Information(found.affine, N, noise_induced, shift, 1.0, seen.scale)
    return replace(known, widened=_widened(whole, replace(known, shift=0 * shift)))


def _widened(whole: Fit, by_noise: Information) -> float:
    """How far the whole run's residuals widened what its noise leaves uncertain."""
    assert whole.sources is not None
    everything = np.ones((1, len(by_noise.normal)), dtype=np.bool_)
    variance = np.diag(by_noise.covariance(everything)[0])
    return float(np.mean(np.diag(whole.sources.noise.covariance) / variance))


def _of(seen: Observations, noise: Noise, found: Solution, rows: NDArray[np.intp]) -> tuple[Array, Array]:
    part = seen.select(rows)
    at = evaluate(part, noise.select(rows), found.theta, found.phase)
    return normal(part, at, found.weight[rows])


def _noise_induced(seen: Observations, noise: Noise, found: Solution, rows: NDArray[np.intp]) -> Array:
    part = replace(found, weight=found.weight[rows])
    return noise_induced_information(seen.select(rows), noise.select(rows), part)

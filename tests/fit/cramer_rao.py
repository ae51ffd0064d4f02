"""The Cramér-Rao bound: how well any unbiased estimator can do on a run, for each kind of observation.

Of n rows with true readings m̄ and the noise covariance C = K Σ Kᵀ + … the Fisher information on (K, k, phases) is
Σ EᵀGE, with E = d b/d(parameters) at m̄ and G = Pᵀ(P C Pᵀ)⁻¹P, P the directions that the row sees: all three
(vector), u and the axis (axis without angle), u = b/|b| (magnitude). The true readings along the unseen directions are
nuisance parameters; eliminated, they leave just this P. Parameters that the form binds (symmetric K) are bound here.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from labcal.fit.vector.observations import Observations, observe
from labcal.fit.vector.solve import Parameterisation, parameterise
from labcal.fit.vector.system import Noise, evaluate, normal
from labcal.model import AffineMap
from labcal.record import Run

Array = NDArray[np.float64]


def cramer_rao(run: Run, truth: AffineMap, field_nT: Array, noise: Noise, phase_rad: Array | None = None) -> Array:
    """The bound on the covariance (12, 12) of K row by row, then k, in the DUT's unit.

    `truth` and `field_nT` (n, 3) are the true map and field of a simulated `run`, `noise` what it was given. Where all
    rows are magnitudes `truth.K` must be symmetric, and the bound has rank 9. Raises ValueError where the run does not
    determine the map.
    """
    seen = observe(_without_noise(run, truth, field_nT))
    parameterisation = parameterise("symmetric" if (seen.kind == 1).all() else "affine", 1.0)
    theta = np.r_[truth.K.ravel() * seen.scale, truth.k_nT]
    phase = np.zeros(len(seen.phase_names)) if phase_rad is None else phase_rad
    covariance = _inverse(_information(seen, noise, theta, phase), parameterisation)
    unit = np.r_[np.full(9, 1 / seen.scale), np.ones(3)]
    return np.asarray(covariance * np.outer(unit, unit))


def _without_noise(run: Run, truth: AffineMap, field_nT: Array) -> Run:
    reading = np.linalg.solve(truth.K, (field_nT + truth.k_nT).T).T
    return replace(run, reading=np.where(np.isfinite(run.reading), reading, np.nan))


def _information(seen: Observations, noise: Noise, theta: Array, phase: Array) -> Array:
    at = evaluate(seen, noise, theta, phase)
    true_reading = replace(at, columns=np.column_stack([seen.reading, np.full(len(seen), -1.0)]))
    return normal(seen, true_reading, np.ones(len(seen)))[0]


def _inverse(N: Array, parameterisation: Parameterisation) -> Array:
    q = parameterisation.basis.shape[1]
    B = np.zeros((len(N), q + len(N) - 12))
    B[:12, :q], B[12:, q:] = parameterisation.basis, np.eye(len(N) - 12)
    bound = B.T @ N @ B
    scale = np.sqrt(np.diag(bound))
    values, vectors = np.linalg.eigh(bound / np.outer(scale, scale))
    if values[0] < 1e-11 * values[-1]:
        raise ValueError("the run does not determine the map: there is no bound")
    inverse = vectors @ np.diag(1 / values) @ vectors.T / np.outer(scale, scale)
    return np.asarray(parameterisation.basis @ inverse[:q, :q] @ parameterisation.basis.T)

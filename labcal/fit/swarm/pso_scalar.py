"""Particle swarm with the scalar checking objective alone, (8) of Riwanto et al. 2017: nine parameters, K symmetric.

Magnitudes do not see a rotation, so K is held symmetric (and positive definite) instead of triangular.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from labcal.fit.result import Fit
from labcal.fit.swarm.loci import Loci, loci_of, reading_noise_nT
from labcal.fit.swarm.polish import singular_values, symmetric_basis
from labcal.fit.swarm.pso_axis import map_of, polished_fit, refused
from labcal.fit.swarm.search import PUBLISHED, Options, search
from labcal.record import Run

__all__ = ["PUBLISHED", "Options", "pso_scalar"]

Array = NDArray[np.float64]
METHOD = "pso-scalar"


def pso_scalar(run: Run, *, seed: int = 0, options: Options | None = None) -> Fit:
    """Nine parameters from the magnitudes of `run`, repeatable from `seed`; the rotation stays unknown.

    `ok=False` with the reason where the run has no magnitudes or does not determine the parameters.
    """
    options = options or Options()
    try:
        loci = loci_of(run, with_axes=False)
    except ValueError as error:
        return refused(METHOD, str(error))
    basis, noise_nT = symmetric_basis(), reading_noise_nT(run, loci)
    theta = positive_definite(search(loci, noise_nT, options, seed, basis).theta)
    if why_not := _open(loci, theta, basis):
        return refused(METHOD, why_not)
    if not options.polish:
        return Fit(METHOD, ok=True, affine=map_of(run, theta))
    return polished_fit(METHOD, run, loci, theta, basis)


def positive_definite(theta: Array) -> Array:
    """The map (12,) with the same magnitudes whose K is symmetric and positive definite: K = Q P, k → Qᵀ k."""
    left, size, right = np.linalg.svd(theta[:9].reshape(3, 3))
    rotation = left @ right
    return np.concatenate([(right.T @ np.diag(size) @ right).ravel(), rotation.T @ theta[9:]])


def _open(loci: Loci, theta: Array, basis: Array) -> str | None:
    """Directions that excitation does not reach are still reached by noise: by its share of the field."""
    K, k = theta[:9].reshape(3, 3), theta[9:]
    misfit = np.linalg.norm(loci.reading @ K.T - k, axis=1) - loci.magnitude
    by_noise = 1.5 * float(np.std(misfit) / np.mean(loci.magnitude))
    values = singular_values(replace(loci, along=np.full(len(loci), np.nan)), theta, basis)
    rank = int(np.sum(values > max(1e-3, by_noise)))
    if rank == 9:
        return None
    return f"the magnitudes determine {rank} of 9 parameters; rotate about another axis or use another magnitude"

"""What each error that a run declares does to the map that was fitted to it: the shift of the same least squares."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from labcal.fit.vector.observations import SCALAR, Observations, observe
from labcal.fit.vector.solve import Parameterisation, Solution
from labcal.fit.vector.system import Noise, blocks, evaluate, normal
from labcal.record import Run
from labcal.uncertainty import Contribution, declared_errors

Array = NDArray[np.float64]


def declared_contributions(
    run: Run, seen: Observations, noise: Noise, parameterisation: Parameterisation, found: Solution
) -> tuple[Contribution, ...]:
    """A contribution for each declared error; its shift (12,) is of K row by row, then k, in the DUT's unit.

    Another reference or attitude changes the gradient of the loss by dg; least squares with the same weights then
    moves by -N^-1 dg, with the phases free and no more of the error in the map than the form can take up.
    """
    q, unit = parameterisation.basis.shape[1], np.r_[np.full(9, 1 / seen.scale), np.ones(3)]
    as_scalar, here = bool((seen.kind == SCALAR).all()), _gradient(seen, noise, parameterisation, found)
    out = []
    for error in declared_errors(run):
        there = observe(error.change(run), as_scalar=as_scalar)
        step = _solved(found.normal, here - _gradient(there, noise, parameterisation, found))
        shift = unit * (parameterisation.basis @ step[:q])
        out.append(Contribution(error.source, "B", "normal", error.u, error.unit, np.inf, shift))
    return tuple(out)


def _gradient(seen: Observations, noise: Noise, parameterisation: Parameterisation, found: Solution) -> Array:
    """Of the loss at `found`, weights as found (q + phases,)."""
    total = np.zeros(12 + len(found.phase))
    for rows, part, part_noise in blocks(seen, noise):
        at = evaluate(part, part_noise, found.theta, found.phase)
        total += normal(part, at, found.weight[rows])[1]
    return np.concatenate([parameterisation.basis.T @ total[:12], total[12:]])


def _solved(N: Array, g: Array) -> Array:
    """N^-1 g with all parameters at unit length; directions that nothing determines do not move."""
    scale = np.sqrt(np.maximum(np.diag(N), 1e-300))
    return np.asarray(np.linalg.lstsq(N / np.outer(scale, scale), g / scale, rcond=1e-13)[0] / scale)

"""What each error that a run declares does to the map that was fitted to it: the shift of the same least squares."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from labcal.fit.vector.observations import Observations
from labcal.fit.vector.planes import observe_like
from labcal.fit.vector.solve import Parameterisation, Solution
from labcal.fit.vector.system import Noise, blocks, evaluate, normal
from labcal.record import Run
from labcal.uncertainty import Contribution, DeclaredError, declared_errors
from labcal.uncertainty.beside_declared import beside_declared

Array = NDArray[np.float64]


def declared_contributions(
    run: Run, seen: Observations, noise: Noise, parameterisation: Parameterisation, found: Solution
) -> tuple[Contribution, ...]:
    """A contribution for each declared error; its shift (12,) is of K row by row, then k, in the DUT's unit.

    Another reference or attitude changes the gradient of the loss by dg; least squares with the same weights then
    moves by -N^-1 dg, with the phases free and no more of the error in the map than the form can take up.
    """
    q, unit = parameterisation.basis.shape[1], np.r_[np.full(9, 1 / seen.scale), np.ones(3)]
    out = []
    for error, _, _, step in _moved(run, seen, noise, parameterisation, found):
        shift = unit * (parameterisation.basis @ step[:q])
        out.append(Contribution(error.source, "B", "normal", error.u, error.unit, np.inf, shift))
    return tuple(out)


def residual_beside_declared(
    run: Run, seen: Observations, noise: Noise, parameterisation: Parameterisation, found: Solution
) -> tuple[Array, Array]:
    """The weighted residual (n, 3) [nT], and what no declared error, the map fitted beside it, could have left.

    What they left is no noise: it is in the uncertainty as theirs. What a standard deviation of them, or of a sum of
    them, would not show in this noise is not asked: beside a scale of the reference there remains the scale times the
    residual itself, and so it does between two errors that leave nearly the same.
    """
    q, weight = parameterisation.basis.shape[1], np.sqrt(found.weight)[:, None]
    here = weight * _residual(seen, noise, found.theta, found.phase)

    def moved(there: Observations, step: Array) -> Array:
        theta, phase = found.theta + parameterisation.basis @ step[:q], found.phase + step[q:]
        return np.asarray(weight * _residual(there, noise, theta, phase))

    left = [
        (moved(one, step) - moved(other, -step)) / 2
        for _, one, other, step in _moved(run, seen, noise, parameterisation, found)
    ]
    return here, beside_declared(here, np.stack(left, axis=2)) if left else here


def _moved(
    run: Run, seen: Observations, noise: Noise, parameterisation: Parameterisation, found: Solution
) -> Iterator[tuple[DeclaredError, Observations, Observations, Array]]:
    """Each declared error, the rows with it either way, and the step (q + phases,) that the solution takes."""
    for error in declared_errors(run):
        one, other = (observe_like(error.change(run, times), seen) for times in (1.0, -1.0))
        down, up = (_gradient(there, noise, parameterisation, found) for there in (one, other))
        yield error, one, other, _solved(found.normal, (up - down) / 2)


def _residual(seen: Observations, noise: Noise, theta: Array, phase: Array) -> Array:
    return np.concatenate([evaluate(part, of, theta, phase).residual for _, part, of in blocks(seen, noise)])


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

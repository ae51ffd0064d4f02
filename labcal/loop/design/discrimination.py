"""Which experiment separates two explanations, predicted by the fitted model.

For each experiment the run that it would record is made up on this run's geometry. The separation is the distance of
what the accepted effect predicts from the nearest that the base model and the rival, both refitted to old and
new rows together, can do: Mahalanobis' distance, in standard deviations, of the new rows' noise.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from labcal.fit.vector.observations import SCALAR, observe
from labcal.fit.vector.system import map_of
from labcal.loop.candidates.library import Candidate
from labcal.loop.data.base_model import noise_model
from labcal.loop.data.linear_problem import LinearProblem, linearise
from labcal.loop.design.experiments import Experiment, experiments, thinned
from labcal.record import Run

Array = NDArray[np.float64]
CLEAR = 5.0  # standard deviations: a smaller separation decides nothing
NEW_ROWS = 1500  # that a typical experiment records: separations are stated for so many


@dataclass(frozen=True, slots=True)
class Separation:
    """An experiment and how far apart [standard deviations] it would bring two explanations."""

    experiment: Experiment
    sigma: float


def rank_experiments(problem: LinearProblem, chosen: Candidate, rival: Candidate, size: Array) -> list[Separation]:
    """Every experiment that this lab can do, the one that separates most first.

    `size` (p,) are the fitted parameters of `chosen`.
    """
    old, found = _linearised(problem, thinned(problem.run)), list[Separation]()
    if old is None:
        return found
    asked = {chosen.family.id, rival.family.id}
    for experiment in experiments():
        if experiment.concerns and not experiment.concerns & asked:
            continue
        made = experiment.design(problem.run)
        new = None if made is None else _linearised(problem, _predicted_readings(problem, made))
        if new is not None:
            sigma = separation((old, new), chosen, rival, size, dict(experiment.alters))
            found.append(Separation(experiment, sigma))
    return sorted(found, key=lambda s: -s.sigma)


def separation(
    parts: Sequence[LinearProblem], chosen: Candidate, rival: Candidate, size: Array, alters: dict[str, float]
) -> float:
    """The distance over old and new rows together; in the old rows the explanations do not differ."""
    predicted, mimic = [], []
    for place, part in enumerate(parts):
        own, other = (_columns(part, c, alters if place else {}) for c in (chosen, rival))
        predicted.append((own @ size).ravel())
        q = part.y.shape[1] * len(part)
        base = part.T.reshape(q, -1)
        common, phases = base[:, : _shared(part)], base[:, _shared(part) :]
        left = sum(p.T.shape[2] - _shared(p) for p in parts[:place])
        right = sum(p.T.shape[2] - _shared(p) for p in parts[place + 1 :])
        mimic.append(np.hstack([common, np.zeros((q, left)), phases, np.zeros((q, right)), other.reshape(q, -1)]))
    y, A = np.concatenate(predicted), np.vstack(mimic)
    scale = np.linalg.norm(A, axis=0)
    solution = np.linalg.lstsq(A / np.where(scale > 0, scale, 1.0), y, rcond=1e-9)[0]
    left_over = y - A / np.where(scale > 0, scale, 1.0) @ solution
    rows = len(parts[-1]) if len(parts) > 1 else len(parts[0])
    return float(np.linalg.norm(left_over) * np.sqrt(max(NEW_ROWS / rows, 1.0)))


def _shared(part: LinearProblem) -> int:
    return int(part.parameterisation.basis.shape[1])


def _columns(part: LinearProblem, candidate: Candidate, alters: dict[str, float]) -> Array:
    return part.columns(candidate.term) * alters.get(candidate.family.id, 1.0)


def _predicted_readings(problem: LinearProblem, made: Run) -> Run:
    """The run with the readings that the fitted map predicts where its reference is a vector."""
    if made.reference_vector is None:
        return made
    seen = observe(made)
    K, k = map_of(problem.theta, problem.observations.scale)
    reading = made.reading.copy()
    vectors = seen.rows[seen.kind == 3]
    reading[vectors] = np.linalg.solve(K, (seen.target[seen.kind == 3] + k).T).T
    return replace(made, reading=reading)


def _linearised(problem: LinearProblem, made: Run) -> LinearProblem | None:
    """The linear problem of a simulated run about the fitted map; None where it offers no rows of the same kind."""
    scalar = bool((problem.observations.kind == SCALAR).all())
    try:
        seen = observe(made, as_scalar=scalar)
    except ValueError:
        return None
    if not scalar and bool((seen.kind == SCALAR).all()):
        return None
    cut = made.select(seen.rows)
    seen = observe(cut, as_scalar=scalar)
    seen = replace(
        seen, reading=seen.reading * (seen.scale / problem.observations.scale), scale=problem.observations.scale
    )
    noise = replace(noise_model(cut, seen), reading=problem.noise.reading, shape=problem.noise.shape)
    phase = np.zeros(len(seen.phase_names))
    return linearise(cut, seen, noise, problem.base, problem.parameterisation, problem.theta, phase)

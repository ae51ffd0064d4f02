"""The best smooth function of a run's inputs beside what the search accepted, and what evidence there is for it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from labcal.loop import policy
from labcal.loop.candidates.library import Candidate
from labcal.loop.candidates.scorer import CandidateSet, Scored
from labcal.loop.empirical.inputs import Inputs, middle_of, sets_of_inputs
from labcal.loop.empirical.splines import LENGTHS, functions_of_length, splines_of, table
from labcal.loop.noise.bands import cosine_transform
from labcal.loop.noise.coloured import Likelihood, NullModel
from labcal.loop.noise.marginal import Marginal, NullEliminated
from labcal.loop.parallel import parallel_map
from labcal.model.affine import MAP_PARAMETERS
from labcal.model.effects import Scene, Term
from labcal.model.effects.empirical import FAMILY, of_base
from labcal.model.effects.inputs import channels_of, values
from labcal.model.effects.regressors import AXES, per_axis

Array = NDArray[np.float64]
SHORTLIST = 3  # sets of inputs that are scored under every noise
HYPERPARAMETERS = 2  # of a smooth function: its size and its length


@dataclass(frozen=True, slots=True)
class _Ranked:
    inputs: Inputs
    length: float
    marginal: Marginal


@dataclass(frozen=True, slots=True)
class Shortlist:
    """The sets of inputs that are worth scoring, and how many there were."""

    sets: tuple[Inputs, ...]
    trials: int


def shortlist(pool: CandidateSet, accepted: Sequence[Candidate]) -> Shortlist:
    """The sets of inputs with the most evidence under white noise, or under that of the null model."""
    null, sets = pool.null_model(accepted), sets_of_inputs(pool.problem)
    some = sorted({0, null.null.spectrum})
    first = parallel_map(lambda names: _ranked(pool, null, names, some), sets)
    best = sorted(first, key=lambda w: -w.marginal.log)[:SHORTLIST]
    return Shortlist(tuple(w.inputs for w in best), len(sets))


def best_smooth(pool: CandidateSet, accepted: Sequence[Candidate], listed: Shortlist) -> Scored | None:
    """The smooth function with the most evidence, on the rows of `pool`; None where there is not enough of it."""
    if not listed.sets:
        return None
    null = pool.null_model(accepted)
    every = range(len(null.bands.spectra))
    chosen = max((_ranked(pool, null, names, every) for names in listed.sets), key=lambda w: w.marginal.log)
    penalty = 0.5 * HYPERPARAMETERS * np.log(pool.n_data) + np.log(listed.trials)
    gain = chosen.marginal.log - null.null.log
    if gain - penalty < policy.POLICY.min_evidence:
        return None
    candidate = Candidate(FAMILY, _term(pool, chosen), listed.trials)
    drop = _drop(pool, accepted, candidate)
    likelihood = Likelihood(chosen.marginal.log, chosen.marginal.level, chosen.marginal.spectrum, 0.0)
    return Scored(candidate, gain, gain - penalty, drop, len(candidate.term.parameters), likelihood)


def _ranked(pool: CandidateSet, null: NullModel, names: Inputs, spectra: Sequence[int]) -> _Ranked:
    """A function of these inputs at the length that is most likely."""
    reduced = _reduced(pool, null, _plain(pool, names), spectra)
    each = [
        _Ranked(names, length, reduced.best_times(_on_each_axis(functions_of_length(len(names), length))))
        for length in LENGTHS[len(names)]
    ]
    return max(each, key=lambda w: w.marginal.log)


def _on_each_axis(functions: Array) -> Array:
    return np.asarray(np.kron(functions, np.eye(3)))


def _reduced(pool: CandidateSet, null: NullModel, plain: Term, spectra: Sequence[int]) -> NullEliminated:
    """The splines' columns with the null model eliminated; at once for all axes where every row is whitened alike."""
    whole, rows = pool.whole, pool.transformed_rows
    if whole.whiten.strides[0] or pool.problem.declared.shape[2]:
        return NullEliminated.of(null, pool.transformed(pool.problem.columns(plain)), spectra)
    assert plain.basis is not None
    functions = plain.basis.at(list(values(plain.inputs, whole.scene).T))
    functions = functions if pool.problem.bins is None else pool.problem.bins.averaged(functions)
    return NullEliminated.of_product(null, cosine_transform(functions[rows]), whole.whiten[0], spectra)


def _plain(pool: CandidateSet, names: Inputs) -> Term:
    """The splines of these inputs over the range of the whole run, nothing taken off."""
    basis = splines_of(values(names, pool.whole.scene))
    run = pool.whole.run
    parameters = tuple(p for j in range(len(basis.functions)) for p in per_axis(f"s{j}", "nT"))
    return Term(FAMILY.kernel, parameters, channels_of(names), middle_of(run, names), (), names, basis)


def _term(pool: CandidateSet, chosen: _Ranked) -> Term:
    """The form that ships: few functions, orthogonal to the base on these rows, with the prior that is most likely."""
    plain = _plain(pool, chosen.inputs)
    assert plain.basis is not None
    functions = functions_of_length(len(chosen.inputs), chosen.length)
    r, prior = functions.shape[1], chosen.marginal.level * float(np.sqrt(chosen.marginal.ratio))
    bare = replace(
        plain.basis,
        functions=table(functions),
        projection=table(np.zeros((len(MAP_PARAMETERS), 3 * r))),
        prior_nT=prior,
    )
    term = replace(plain, parameters=plain.parameters[: 3 * r], basis=bare)
    return replace(term, basis=replace(bare, projection=table(_projection(pool, term))))


def _projection(pool: CandidateSet, term: Term) -> Array:
    """What each column shares with the base (12, p), by least squares in the noise's metric.

    A magnitude shows no turn of the whole map: of that none is taken off, however large noise would have it.
    """
    onto = replace(term, kernel=_of_base)
    base, own = (pool.problem.columns(t)[pool.rows] for t in (onto, term))
    of_map = _without_turns() if pool.problem.parameterisation.name == "symmetric" else np.eye(len(MAP_PARAMETERS))
    flat = base.reshape(-1, base.shape[2]) @ of_map
    return np.asarray(of_map @ np.linalg.lstsq(flat, own.reshape(len(flat), -1), rcond=1e-9)[0])


def _without_turns() -> Array:
    """What a constant and a symmetric matrix do (12, 9), in the order of `of_base`: 1, a_x, a_y, a_z on each axis."""
    n = len(AXES)
    each = [[(0, i)] for i in range(n)] + [[(1 + i, j), (1 + j, i)] for i in range(n) for j in range(i, n)]
    found = np.zeros((1 + n, n, len(each)))
    for place, both in enumerate(each):
        for what, axis in both:
            found[what, axis, place] = 1.0
    return found.reshape(-1, len(each))


def _of_base(term: Term, scene: Scene) -> Array:
    return of_base(scene)


def _drop(pool: CandidateSet, accepted: Sequence[Candidate], candidate: Candidate) -> float:
    """What it takes off the mean square of the whitened residual."""
    before, after = (pool.residual(chosen)[pool.rows] for chosen in (accepted, [*accepted, candidate]))
    return float((np.mean(before**2) - np.mean(after**2)) / pool.decimation)

"""The final fit alone: the map and the effects that are named, without looking for them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from labcal.errors import InputError
from labcal.fit import Fit
from labcal.fit.vector.observations import SCALAR
from labcal.loop.beginnings import with_beginnings
from labcal.loop.close import prepare
from labcal.loop.data.gaps import unresolved_gaps
from labcal.loop.data.noise_floor import noise_beside_readings
from labcal.loop.data.outliers import hampel_outliers
from labcal.loop.progress_report import Progress
from labcal.loop.selection.joint_fit import JointFit, in_sample_rms, joint_fit
from labcal.loop.selection.unseen_switching import misses_more, ways_of
from labcal.loop.uncertainty import of_the_file, uncertainty_of
from labcal.model import EffectRecord
from labcal.model.effects import BEGINNING, BEGINNING_ON, CARRIED_OFF, LESS_ITSELF, Term, family
from labcal.record import Run

Mask = NDArray[np.bool_]


@dataclass(frozen=True, slots=True, eq=False)
class Refit:
    """The final fit, and of the loop's metrics what it shows: what it leaves of its own rows, before and after.

    What it leaves beside the likeliest errors that the run declares is under `beside_declared_nT`.
    """

    fit: Fit
    metrics: Mapping[str, Mapping[str, float]]


def refit(run: Run, effects: Sequence[EffectRecord], progress: Progress = lambda text: None) -> Fit:
    """Fit `run` with these effects, as `close_loop` does in the end; what is not linear stays as each states it.

    The effects come back with their parameters alone. Raises InputError where no installed package describes one, or
    the run lacks what it rests on.
    """
    return refit_with_metrics(run, effects, progress).fit


def refit_with_metrics(run: Run, effects: Sequence[EffectRecord], progress: Progress = lambda text: None) -> Refit:
    """The same with its metrics."""
    progress("fitting the base model")
    here = run.select(~unresolved_gaps(run, {name for effect in effects for name in effect.channels}))
    problem, _, _ = prepare(here)
    progress("fitting the map with the effects that are named")
    terms = [_term(here, effect) for effect in effects]
    found = joint_fit(problem, terms)
    while (unseen := _switched_unseen(found)).any():
        here = here.select(~np.isin(here.t_s, problem.run.t_s[unseen]))
        problem, _, _ = prepare(here)
        found = joint_fit(problem, terms)
    if (outlying := _outliers(found)).any():
        found = joint_fit(problem, terms, ~outlying)
    found = with_beginnings(found)
    uncertain = uncertainty_of(found)
    parameters = found.parameters(uncertain.covariance)
    of_file = of_the_file(found, uncertain, [effect.belongs_to == "sensor" for effect in effects])
    fit = Fit(
        method="closed-loop",
        ok=True,
        affine=found.problem.affine,
        covariance=of_file.covariance,
        covariance_of=of_file.names,
        sources=of_file.sources,
        frame_known=not bool((problem.observations.kind == SCALAR).all()),
        effects=tuple(replace(e, parameters=found) for e, found in zip(effects, parameters, strict=True)),
        noise_nT=problem.noise.reading * run.dut.nominal_nT_per_unit,
    )
    return Refit(fit, _metrics(joint_fit(problem, [], found.used), found))


def _metrics(before: JointFit, after: JointFit) -> dict[str, dict[str, float]]:
    left = [float(np.sqrt(np.mean(r.problem.length_nT(r.problem.residual_nT)[r.used] ** 2))) for r in (before, after)]
    shown = {
        "train_rms_nT": left[1],
        "beside_declared_nT": in_sample_rms(after),
        "noise_beside_readings_nT": noise_beside_readings(after.problem),
        "holdout_components": 3.0 if after.problem.kind == "vector" else 1.0,
    }
    return {"before": {"train_rms_nT": left[0]}, "after": shown}


def _term(run: Run, effect: EffectRecord) -> Term:
    """The form that `effect` describes, with the grids that this run would be searched on: they tell what has a u."""
    if strangers := sorted(set(effect.channels) - {channel.name for channel in run.channels}):
        raise InputError(f"the run has no channel {strangers[0]}, which {effect.effect} rests on")
    kind = family(effect.effect)
    stated = kind.restore(effect)
    like = [t for t in kind.candidates(run) if t.channels == stated.channels and _shapes(t) == _shapes(stated)]
    grids = {shape.name: shape.grid for term in like[:1] for shape in term.shape}
    searched = {shape.name for shape in stated.shape if shape.kind.found_by not in ("grid", "own secant")}
    shapes = (replace(s, grid=grids.get(s.name) or ((s.value,) if s.name in searched else ())) for s in stated.shape)
    own = next((term for term in like if _alike(term, stated)), stated)  # with its units, and with its own beginnings
    shapes = (own.of(CARRIED_OFF) or s if s.kind is CARRIED_OFF else s for s in shapes)  # as before the run was seen
    return replace(stated, parameters=own.parameters, shape=tuple(shapes), of_beginnings=own.of_beginnings)


def _shapes(term: Term) -> list[str]:
    """The names of what it does not depend on linearly; files of before do not say how loops begin."""
    return [shape.name for shape in term.shape if shape.kind not in (BEGINNING, BEGINNING_ON, LESS_ITSELF)]


def _alike(term: Term, stated: Term) -> bool:
    """Whether what it is made of, but for how segments began, is named alike."""
    return [name for name, _ in term.parameters[: term.lasting]] == [name for name, _ in stated.parameters]


def _switched_unseen(found: JointFit) -> Mask:
    """Rows on ways of a channel between two samples that the fit misses more than the rows beside them."""
    squares, run = np.mean(found.problem.y**2, axis=1), found.problem.run
    ways = [on for on in (ways_of(run, term) for term in found.terms) if on.any() and misses_more(squares, on)]
    return np.any(ways, axis=0) if ways else np.zeros(len(run), dtype=bool)


def _outliers(found: JointFit) -> Mask:
    """Rows that stand out of what the fit leaves."""
    problem = found.problem
    added = sum(
        (problem.columns(term) @ b for term, b in zip(found.terms, found.beta, strict=True)), np.zeros_like(problem.y)
    )
    return hampel_outliers(problem.y, problem.scene.segment, added)

"""A result with its empirical term: shipped where a person asked for it, else proposed."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from labcal.loop.assemble import assemble
from labcal.loop.empirical.description import describe_function, experiment
from labcal.loop.empirical.proof import with_smooth
from labcal.loop.empirical.splines import table
from labcal.loop.result import ClosedLoop
from labcal.loop.selection.final_fit import carries_them, nearest_fit
from labcal.loop.selection.joint_fit import JointFit, in_sample_rms
from labcal.loop.selection.proof import Evidence
from labcal.model import EffectRecord
from labcal.model.effects import Scene, Term
from labcal.model.effects.inputs import values
from labcal.model.smooth import Domain, convex_hull
from labcal.record import Run

OPEN = ("unexplained", "partly-explained")


def with_empirical(
    run: Run, found: Evidence, closed: ClosedLoop, before: JointFit, aside: dict[str, int], *, ship: bool
) -> ClosedLoop:
    """`closed` with the term where structure remains that a smooth function carries; as it is where none does.

    None does either that the fit of map, effects and term together cannot carry.
    """
    if closed.verdict not in OPEN or (more := with_smooth(found)) is None:
        return closed
    after = nearest_fit(before.problem, more)
    if not carries_them(in_sample_rms(after), more):
        return closed
    term = after.terms[-1]
    built = assemble(run, more, before, after, aside)
    chance = min(1.0, float(np.exp(-more.equivalents[-1][0].scored.evidence)))  # Markov's bound on a Bayes factor
    seen = _domain(after.problem.scene.select(found.pool.valid), term)
    record = replace(_described(built, term), p_value=chance, domain=(seen,))
    assert record.basis is not None
    left = after.problem.residual_nT
    described = describe_function(record.basis, np.array(seen.hull), left, after.problem.scene, term.inputs)
    record = replace(record, why=f"{record.why}. {described.says(term.inputs)}")
    proposal = experiment(run, record, described)
    if not ship:
        return replace(closed, proposed=(record,), next_experiment=proposal)
    of = "a function of " + " and ".join(record.inputs)
    summary = built.summary.replace(more.accepted[-1].label, of)
    says = f"{summary} This cause has no name: it is an empirical term, and holds only where it has been seen."
    accepted = (*built.accepted[:-1], record)
    return replace(built, accepted=accepted, summary=says, next_experiment=proposal)


def _described(built: ClosedLoop, term: Term) -> EffectRecord:
    """The record with its basis, the coefficients and their covariance as the joint fit has them."""
    record = built.accepted[-1]
    number = sum(1 for e in built.fit().effects[:-1] if e.belongs_to == "sensor")
    assert term.basis is not None
    assert built.covariance is not None
    place = [built.covariance_of.index(f"{number}:{p.name}") for p in record.parameters]
    basis = replace(
        term.basis,
        coefficients=table(np.array([p.value for p in record.parameters]).reshape(-1, 3)),
        covariance=table(built.covariance[np.ix_(place, place)]),
    )
    return replace(record, inputs=term.inputs, basis=basis)


def _domain(scene: Scene, term: Term) -> Domain:
    """Where the run has been: the ends of one input, the joint hull of two."""
    x = values(term.inputs, scene)
    if x.shape[1] == 1:
        return Domain(term.inputs, ((float(x.min()),), (float(x.max()),)))
    return Domain(term.inputs, table(convex_hull(x)))

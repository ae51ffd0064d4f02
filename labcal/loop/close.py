"""Close the loop on a run: base model, data checks, selection of effects, cross-validation, result."""

from __future__ import annotations

import time
from collections.abc import Sequence
from dataclasses import replace
from functools import partial

import numpy as np

from labcal.fit.vector.observations import Observations
from labcal.fit.wild import wild_rows
from labcal.loop import policy
from labcal.loop.assemble import assemble
from labcal.loop.candidates.library import Candidate, Cause
from labcal.loop.candidates.scorer import CandidateSet, Tell, silent
from labcal.loop.data.base_model import fit_base, least_squares, noise_model, select_rows
from labcal.loop.data.checks import check_data
from labcal.loop.data.gaps import unresolved_gaps
from labcal.loop.data.linear_problem import LinearProblem, linearise
from labcal.loop.data.noise_floor import NoiseFloor, noise_floor
from labcal.loop.data.saturation import at_saturation_limit, beyond_limit
from labcal.loop.empirical_term import with_empirical
from labcal.loop.narrative import of_faulty_data
from labcal.loop.progress_report import NOTHING, Progress, ProgressReport
from labcal.loop.result import ClosedLoop, Finding
from labcal.loop.selection.crossval import block_folds, cross_validate, fixed_choice, rms
from labcal.loop.selection.final_fit import base_fit, final_fit
from labcal.loop.selection.joint_fit import joint_fit
from labcal.loop.selection.members import members_in_place
from labcal.loop.selection.missed_pulses import missed_pulses
from labcal.loop.selection.proof import Evidence, prove, relinearised, without_outliers
from labcal.loop.selection.select import Selection, select, stepwise
from labcal.loop.selection.unseen_switching import switched_unseen
from labcal.loop.uncertainty import wald_p_values
from labcal.model.effects.set_aside import OUTLIERS, SATURATION
from labcal.record import Run

LONG_s = 20.0  # still to go: the person who waits is informed
STILL = 1.5  # times what the first selection took, the rest takes


def close_loop(run: Run, progress: Progress = lambda text: None, *, empirical: bool = False) -> ClosedLoop:
    """Find the residual of `run`, trace it, and say what it is. Raises InputError where the run says too little.

    Readings that no field made are set aside first. Rows in unresolved gaps of a channel that supports a cause are left
    out, and all is decided again on the others.
    Where structure remains that no known effect carries, an empirical term is built and proven: shipped where
    `empirical` asks for it, else proposed. Stopped by Ctrl-C, it tells what it knows so far.
    """
    report = ProgressReport(progress)
    try:
        return _closed(run, report, empirical=empirical)
    except KeyboardInterrupt:
        report.stopped()
        raise


def _closed(run: Run, report: ProgressReport, *, empirical: bool) -> ClosedLoop:
    wild = wild_rows(run)
    run = run.select(~wild) if wild.any() else run
    while True:
        started_s = time.monotonic()
        report.step("fitting the base model")
        problem, level, stuck = prepare(run)
        if (finding := check_data(problem, level)) is not None:
            return without_search(run, problem, level, stuck, finding, int(wild.sum()))
        report.step("scoring every effect")
        base_set = candidates_of(run, problem, tell=partial(_report_trial, report))
        pool = relinearised(base_set)
        report.known = accepted_in_words(pool, stepwise(pool)[0])
        if (left_s := STILL * (time.monotonic() - started_s)) > LONG_s:
            report.step(f"this run takes about {left_s:.0f} s more and may be stopped")
        selection = select(pool, level)
        unseen = switched_unseen(pool, selection) | missed_pulses(pool, selection.accepted)
        gaps = unresolved_gaps(run, _supporting_channels(selection)) | np.isin(run.t_s, problem.run.t_s[unseen])
        if not gaps.any():
            break
        run = run.select(~gaps)
    report.known = accepted_in_words(pool, selection.accepted)
    report.step("holding out blocks of time")
    found = prove(base_set, pool, selection, level)
    found, after = final_fit(problem, found, selection, wald_p_values)
    found = members_in_place(found)
    before = base_fit(problem, found) if found.accepted else after
    aside = {OUTLIERS.id: int(wild.sum()) + int((~found.pool.valid).sum()), SATURATION.id: stuck}
    closed = assemble(run, found, before, after, aside)
    return with_empirical(run, found, closed, before, aside, ship=empirical)


def _report_trial(report: ProgressReport, pool: CandidateSet, accepted: Sequence[Candidate], doing: str) -> None:
    """What a search is doing beside what it has accepted."""
    beside = f" beside {_named(accepted)}" if accepted else ""
    report.scoring(f"scoring {doing}{beside}", accepted_in_words(pool, accepted))


def accepted_in_words(pool: CandidateSet, accepted: Sequence[Candidate]) -> str:
    """What is known before the proof, in words: the effects accepted, and what they leave of the rows searched."""
    if not accepted:
        return NOTHING
    before, after = (rms(pool.residual(some)[pool.rows]) for some in ((), accepted))
    return (
        f"a cause is in sight, not proven yet: what is left over falls from {before:.1f} to {after:.1f} times the "
        f"noise ({_named(accepted)})"
    )


def _named(accepted: Sequence[Candidate]) -> str:
    return " and ".join(c.label for c in accepted)


def _supporting_channels(found: Selection) -> set[str]:
    """The channels of every cause that had the evidence of a name at some step."""
    scored = [s for ranking in found.rankings for s in ranking if s.evidence >= policy.POLICY.min_evidence]
    return {name for s in scored for name in s.candidate.term.channels}


def candidates_of(run: Run, problem: LinearProblem, only: Cause | None = None, tell: Tell = silent) -> CandidateSet:
    """Every candidate, or those of one cause `only`, on the rows that are no outliers."""
    pool = CandidateSet.of(problem, _min_noise_level(run), tell)
    if only is not None:
        pool = pool.restricted_to([c for c in pool.candidates if c.cause == only])
    return without_outliers(pool)


def without_search(
    run: Run, problem: LinearProblem, level: NoiseFloor, stuck: int, finding: Finding, wild: int = 0
) -> ClosedLoop:
    """The result for faulty data: no effect is searched in them."""
    rows = np.ones(len(problem), dtype=bool)
    pool = CandidateSet(problem, [], rows, _min_noise_level(run), rows)
    blocks = block_folds(problem, 0.0)
    cv_error = cross_validate(pool, blocks, fixed_choice(()))
    found = Evidence(pool, pool, (), (), (), cv_error, (), level, blocks, np.zeros(1), {}, 0.0)
    base = joint_fit(problem, [])
    return replace(
        assemble(run, found, base, base, {OUTLIERS.id: wild, SATURATION.id: stuck}), **of_faulty_data(finding)
    )


def prepare(run: Run) -> tuple[LinearProblem, NoiseFloor, int]:
    """The problem about the fitted base model, the noise floor, and how many saturated rows were left out."""
    whole, seen = select_rows(run)
    stuck = at_saturation_limit(whole)
    problem, level = _about_base(whole.select(~stuck))
    if stuck.any() and len(seen.phase_names) == len(problem.phase):
        clipped = beyond_limit(_seen_from(problem, whole, seen), stuck)
        if not clipped[stuck].all():
            stuck = clipped
            problem, level = _about_base(whole.select(~stuck))
    return problem, level, int(stuck.sum())


def _seen_from(problem: LinearProblem, run: Run, seen: Observations) -> LinearProblem:
    """More rows of the same run about the same map."""
    theta = np.r_[problem.affine.K.ravel() * seen.scale, problem.affine.k_nT]
    return linearise(run, seen, noise_model(run, seen), problem.base, problem.parameterisation, theta, problem.phase)


def _about_base(run: Run) -> tuple[LinearProblem, NoiseFloor]:
    cut, seen = select_rows(run)
    base, near = fit_base(cut, seen)
    start = near.solution
    problem = linearise(cut, seen, noise_model(cut, seen), base, near.parameterisation, start.theta, start.phase)
    problem, level = noise_floor(problem)
    found = least_squares(seen, problem.noise, near)
    return linearise(cut, seen, problem.noise, base, near.parameterisation, found.theta, found.phase), level


def _min_noise_level(run: Run) -> float:
    law = policy.POLICY
    return law.min_white_level if run.dut.noise_nT else law.min_white_level_measured

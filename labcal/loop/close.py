"""Close the loop on a run: the residual, its cause, the proof on data that nothing has seen, and the verdict."""

from __future__ import annotations

from collections.abc import Callable, Collection
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from labcal.fit.observations import SCALAR
from labcal.loop import working_range
from labcal.loop.correlation import follows_itself
from labcal.loop.decide import Cause
from labcal.loop.evidence import Choice, Evidence, decided, proved, search_of, settled, without_outliers
from labcal.loop.findings import findings
from labcal.loop.floor import Floor, floor
from labcal.loop.gaps import untold
from labcal.loop.holdout import HeldOut, always, held_out, plan, rms
from labcal.loop.problem import Problem, fit_base, least_squares, linearise, noise_of, usable
from labcal.loop.proposal import next_experiment
from labcal.loop.reference_sanity import doubt
from labcal.loop.refit import Refit, refit
from labcal.loop.result import ClosedLoop, Errors, Finding, Pictures, Verdict
from labcal.loop.rivals import AT_FLOOR, Contender
from labcal.loop.search import NAMED, Search, Weighed
from labcal.loop.setaside import at_rail
from labcal.loop.shape import describe
from labcal.loop.surrogates import p_value
from labcal.loop.twins import twins
from labcal.loop.whiteness import tests as residual_tests
from labcal.loop.words import in_doubt, summary, tested, why, why_not, why_rival
from labcal.model import EffectRecord, Parameter
from labcal.model.calibration import Rival
from labcal.record import Run

Array = NDArray[np.float64]
GROSS = 10.0  # standard deviations: nearer rows may be a detail that an effect's shape lacks
A_FEW = 3  # rows set aside before they are named as a cause
MOST_OUTLIERS = 0.05
UNTOLD = 0.01  # of the rows: fewer in gaps that nothing tells make no name
WHITE_AT_LEAST = 0.85  # of a declared noise; 0.5 of a measured one
Progress = Callable[[str], None]


def close_loop(run: Run, progress: Progress = lambda text: None) -> ClosedLoop:
    """Find the residual of `run`, trace it, and say what it is. Raises InputError where the run says too little.

    Rows that nothing tells of a channel that has weight are left out, and all is decided again on the others.
    """
    progress("fitting the base model")
    problem, level, stuck = prepared(run)
    if (finding := doubt(problem, level)) is not None:
        return doubted(run, problem, level, stuck, finding)
    progress("weighing every effect")
    bare = searched(run, problem)
    search = settled(bare)
    choice = decided(search, level)
    gaps = untold(run, _weighty(choice))
    if np.mean(gaps) > UNTOLD:
        return close_loop(run.select(~gaps), progress)
    progress("holding out blocks of time")
    found = proved(bare, search, choice, level)
    before, after = (refit(problem, [c.form for c in chosen], found.search.good) for chosen in ((), found.accepted))
    aside = {"outliers": int((~found.search.good).sum()), "saturation": stuck}
    return _result(run, found, before, after, aside)


def _weighty(found: Choice) -> set[str]:
    """The channels of every cause that had the weight of a name at some step."""
    heavy = [w.candidate.form for ranking in found.rankings for w in ranking if w.weight >= NAMED]
    return {name for form in heavy for name in form.channels}


def searched(run: Run, problem: Problem, only: Cause | None = None) -> Search:
    """Every candidate, or the looks of one cause `only`, on the rows that do not lie."""
    search = search_of(problem, _lowest(run))
    if only is not None:
        search = search.among([c for c in search.candidates if c.cause == only])
    return without_outliers(search)


def doubted(run: Run, problem: Problem, level: Floor, stuck: int, finding: Finding) -> ClosedLoop:
    """The result where the data are wrong in themselves: no effect is searched in them."""
    rows = np.ones(len(problem), dtype=bool)
    search = Search(problem, [], rows, _lowest(run), rows)
    blocks = plan(problem, 0.0)
    honest = held_out(search, blocks, always(()))
    found = Evidence(search, search, (), (), (), honest, (), level, blocks, np.zeros(1), {}, 0.0)
    base = refit(problem, [])
    return replace(_result(run, found, base, base, {"outliers": 0, "saturation": stuck}), **in_doubt(finding))


def prepared(run: Run) -> tuple[Problem, Floor, int]:
    """The base fitted, readings at a rail left out and counted, the noise known."""
    cut, _ = usable(run)
    stuck = at_rail(cut)
    cut, seen = usable(cut.select(~stuck))
    base, near = fit_base(cut, seen)
    start = near.solution
    problem = linearise(cut, seen, noise_of(cut, seen), base, near.form, start.theta, start.phase)
    problem, level = floor(problem)
    found = least_squares(seen, problem.noise, near)
    return linearise(cut, seen, problem.noise, base, near.form, found.theta, found.phase), level, int(stuck.sum())


def _lowest(run: Run) -> float:
    return WHITE_AT_LEAST if run.dut.noise_nT else 0.5


def _result(run: Run, found: Evidence, before: Refit, after: Refit, aside: dict[str, int]) -> ClosedLoop:
    problem = after.problem
    rows = found.search.good
    in_sample = [rms(r.problem.length_nT(r.problem.residual_nT)[rows]) for r in (before, after)]
    found = replace(found, honest=_as_shipped(found.honest, in_sample[1], added=bool(found.accepted)))
    verdict = _verdict(found, aside, len(problem))
    of_the_data = _of_the_data(aside, problem, verdict, found.far)
    accepted = [*of_the_data, *_records(found, after)]
    unsupported = working_range.unsupported(run, found.accepted, after)
    shipped, errors = _shipped(found, after, unsupported)
    noticed = (*findings(run, problem, found.level), *working_range.findings(run, found.accepted, after))
    tests = {when: residual_tests(fit.problem, rows) for when, fit in (("before", before), ("after", after))}
    left = describe(problem, rows) if verdict in ("unexplained", "partly-explained") else None
    return ClosedLoop(
        run_id=run.run_id,
        residual_kind=problem.kind,
        base=problem.base,
        noise_floor_nT=found.level.nT,
        noise_floor_source=found.level.source,
        before=Errors(in_sample[0], found.honest.before),
        after=Errors(in_sample[1], found.honest.after),
        set_aside=aside,
        accepted=tuple(accepted),
        rejected=tuple(_rejected(found)),
        verdict=verdict,
        summary=summary(found, verdict, aside, left),
        next_experiment=next_experiment(found, verdict, after, left),
        affine=shipped.problem.affine,
        covariance=_covariance(shipped),
        frame_known=not bool((problem.seen.kind == SCALAR).all()),
        noise_nT=problem.noise.reading * run.dut.nominal_nT_per_unit,
        findings=noticed,
        tests=tests,
        shape=left,
        unsupported=frozenset(len(of_the_data) + i for i in unsupported),
        shipped=errors,
        twins=twins(problem, {c.weighed.candidate.family.id for rivals in found.rivals for c in rivals}),
        remarks=(tested(tests["after"]), *(finding.says for finding in noticed)),
        pictures=replace(pictured(before.problem, after.problem), held_out_nT=_both(found.honest)),
    )


def _as_shipped(honest: HeldOut, in_sample: float, *, added: bool = True) -> HeldOut:
    """The held-out error, no smaller than what the map and effects that are shipped leave on the rows of their fit.

    Blocks are foretold by straight lines about the last fit; where an effect bends too far for them, the file is worse.
    Where nothing was `added`, before is what is after.
    """
    shipped = max(honest.after, in_sample)
    after_nT = honest.after_nT * (shipped / honest.after) if honest.after > 0 else honest.after_nT
    return replace(honest, after_nT=after_nT, before_nT=honest.before_nT if added else after_nT)


def _shipped(found: Evidence, after: Refit, unsupported: Collection[int]) -> tuple[Refit, Errors | None]:
    """The map that goes with the effects that are shipped, fitted without the others, and its errors.

    A map fitted beside an effect that the run does not pin down is as uncertain as the effect.
    """
    if not unsupported:
        return after, None
    kept = [chosen for i, chosen in enumerate(found.accepted) if i not in unsupported]
    rows = found.search.good
    fitted = refit(found.search.whole, [c.form for c in kept], rows)
    left = rms(fitted.problem.length_nT(fitted.problem.residual_nT)[rows])
    return fitted, Errors(left, max(held_out(found.search, found.blocks, always(kept)).after, left))


def pictured(before: Problem, after: Problem) -> Pictures:
    """The residual as it was and as it is, for pictures."""
    return Pictures(after.scene.t_s, after.scene.segment, _shown(before), _shown(after))


def _both(honest: HeldOut) -> Array:
    """Held-out lengths before and after (n, 2), NaN on rows that were never held out."""
    lengths = np.full((len(honest.rows), 2), np.nan)
    lengths[honest.rows] = np.column_stack([honest.before_nT, honest.after_nT])
    return lengths


def _shown(problem: Problem) -> Array:
    if problem.kind == "vector":
        return problem.residual_nT
    b = problem.scene.field_nT
    return np.asarray(np.sum(problem.residual_nT * b, axis=1) / np.linalg.norm(b, axis=1))[:, None]


def _covariance(after: Refit) -> Array:
    """Of K row by row [nT per DUT unit], then k [nT]."""
    problem = after.problem
    q = problem.allowed.basis.shape[1]
    B = problem.allowed.basis * np.r_[np.full(9, 1 / problem.seen.scale), np.ones(3)][:, None]
    C = B @ after.covariance[:q, :q] @ B.T
    return np.asarray((C + C.T) / 2)


def _verdict(found: Evidence, aside: dict[str, int], rows: int) -> Verdict:
    reaches = found.honest.after <= AT_FLOOR * found.level.nT
    known = found.level.source != "differences" or not follows_itself(found.search, found.accepted)
    lying = aside["outliers"] > MOST_OUTLIERS * rows
    if any(len(r) > 1 for r in found.rivals):
        return "ambiguous"
    if found.accepted:
        return "explained" if reaches and known and not lying else "partly-explained"
    if lying:
        return "partly-explained"
    if (aside["saturation"] >= A_FEW or (aside["outliers"] >= A_FEW and found.far > GROSS)) and reaches:
        return "explained"
    return "clean" if reaches else "unexplained"


def _records(found: Evidence, after: Refit) -> list[EffectRecord]:
    out = []
    lists = zip(found.accepted, after.forms, after.parameters(), found.steps, found.rivals, strict=True)
    for chosen, form, parameters, step, rivals in lists:
        low, high = step.improvement()
        own, others = rivals[0], rivals[1:]
        out.append(
            EffectRecord(
                effect=chosen.family.id,
                channels=form.channels,
                reference_value=dict(form.reference_value),
                belongs_to=chosen.family.belongs_to,
                parameters=parameters,
                provisional=bool(others),
                holdout_rms_before_nT=step.before,
                holdout_rms_after_nT=step.after,
                improvement_ci95_nT=(low, high),
                p_value=p_value(own.weighed, found.heaviest),
                rivals=tuple(_rival(other) for other in others),
                why=why(step, own.weighed),
            )
        )
    return out


def _rival(contender: Contender) -> Rival:
    form = contender.weighed.candidate.form
    return Rival(contender.weighed.candidate.family.id, form.channels, contender.after_nT)


def _of_the_data(aside: dict[str, int], problem: Problem, verdict: Verdict, far: float) -> list[EffectRecord]:
    """Rows set aside are named as a cause where they are more than chance and the rest is understood."""
    found = []
    for effect, count in aside.items():
        gross = effect != "outliers" or far > GROSS
        if count >= A_FEW and gross and verdict != "unexplained":
            part = count / (len(problem) + count)
            rows = Parameter("rows", float(count), 0.0, "1")
            why = f"{count} rows ({100 * part:.1f} %) set aside"
            found.append(EffectRecord(effect, (), {}, "data", (rows,), why=why))
    return found


def _rejected(found: Evidence) -> list[EffectRecord]:
    """Every cause that was weighed and not taken, at the last step that weighed it."""
    last = {w.candidate.cause: w for ranking in found.rankings for w in ranking}
    taken = {c.cause for c in found.accepted}
    return [_turned_down(found, w) for cause, w in last.items() if cause not in taken]


def _turned_down(found: Evidence, w: Weighed) -> EffectRecord:
    """One of them; with its held-out error where it stood in an accepted one's place, or was taken and given up."""
    form, step = w.candidate.form, found.refused.get(w.candidate.cause)
    before, after, said = (step.before, step.after, why_not(w, step)) if step else (None, None, why_not(w))
    gain = step.improvement() if step else None
    for chosen, proof, rivals in zip(found.accepted, found.steps, found.rivals, strict=True):
        for rival in rivals[1:]:
            if rival.weighed.candidate.cause == w.candidate.cause:
                before, after, gain, said = proof.before, rival.after_nT, None, why_rival(chosen, rival.after_nT)
    return EffectRecord(
        effect=w.candidate.family.id,
        channels=form.channels,
        reference_value=dict(form.reference_value),
        belongs_to=w.candidate.family.belongs_to,
        parameters=(),
        holdout_rms_before_nT=before,
        holdout_rms_after_nT=after,
        improvement_ci95_nT=gain,
        p_value=p_value(w, found.heaviest),
        why=said,
    )

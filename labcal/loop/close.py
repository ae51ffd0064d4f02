"""Close the loop on a run: the residual, its cause, the proof on data that nothing has seen, and the verdict."""

from __future__ import annotations

from collections.abc import Callable, Collection, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from labcal.fit.observations import SCALAR
from labcal.loop.bins import binned
from labcal.loop.correlation import correlation_s, follows_itself
from labcal.loop.decide import Cause, forward, looks, refined
from labcal.loop.findings import findings
from labcal.loop.floor import Floor, floor
from labcal.loop.holdout import HeldOut, Plan, held_out, plan, rms
from labcal.loop.problem import Problem, fit_base, least_squares, linearise, noise_of, usable
from labcal.loop.proposal import next_experiment, twins
from labcal.loop.reference_sanity import doubt
from labcal.loop.refit import Refit, refit
from labcal.loop.result import ClosedLoop, Errors, Finding, Pictures, Verdict
from labcal.loop.search import Candidate, Search, Weighed, expand
from labcal.loop.setaside import at_rail, farness, outliers
from labcal.loop.shape import describe
from labcal.loop.whiteness import tests as residual_tests
from labcal.loop.words import in_doubt, summary, tested, why, why_not
from labcal.model import EffectRecord, Parameter
from labcal.model.calibration import Rival
from labcal.record import Run

Array = NDArray[np.float64]
AT_FLOOR = 1.15  # held-out rms over the floor up to which nothing is left to explain
SHARE_OF_EXCESS = 0.5  # of the mean square above the noise that the effects together have to carry
SECOND = 0.03  # of the fall of the mean square that all bring together: a second effect has to bring as much,
SECOND_OF_NOISE = 0.25  # or this part of the noise's square
GROSS = 10.0  # standard deviations: nearer rows may be a detail that an effect's shape lacks
A_FEW = 3  # rows set aside before they are named as a cause
AS_GOOD = 1.03  # times the held-out rms of the effect that a rival stands in for
CONTENDERS = 4  # rivals that are tried on held-out data
RIVAL = 8.0  # nats: what comes closer does as well
REFUSALS = 6  # causes refused on held-out data before the loop gives up
SHORTLIST = 8  # causes that the folds choose from
MOST_OUTLIERS = 0.05
WHITE_AT_LEAST = 0.85  # of a declared noise; 0.5 of a measured one
Progress = Callable[[str], None]


def close_loop(run: Run, progress: Progress = lambda text: None) -> ClosedLoop:
    """Find the residual of `run`, trace it, and say what it is. Raises InputError where the run says too little."""
    progress("fitting the base model")
    problem, level, stuck = prepared(run)
    if (finding := doubt(problem, level)) is not None:
        return doubted(run, problem, level, stuck, finding)
    progress("weighing every effect")
    search = searched(run, problem)
    progress("holding out blocks of time")
    found = weighed(search, level)
    before, after = (refit(problem, [c.form for c in chosen], found.search.good) for chosen in ((), found.accepted))
    aside = {"outliers": int((~found.search.good).sum()), "saturation": stuck}
    return _result(run, found, before, after, aside)


def searched(run: Run, problem: Problem, only: Cause | None = None) -> Search:
    """Every candidate, or the looks of one cause `only`, on the rows that do not lie."""
    search = _search(problem, _lowest(run))
    if only is not None:
        search = search.among([c for c in search.candidates if c.cause == only])
    return _without_outliers(search)


def doubted(run: Run, problem: Problem, level: Floor, stuck: int, finding: Finding) -> ClosedLoop:
    """The result where the data are wrong in themselves: no effect is searched in them."""
    rows = np.ones(len(problem), dtype=bool)
    search = Search(problem, [], rows, _lowest(run), rows)
    blocks = plan(problem, 0.0)
    honest = held_out(search, blocks, _always(()))
    found = Evidence(search, (), (), (), honest, (), level, blocks, 0.0)
    base = refit(problem, [])
    return replace(_result(run, found, base, base, {"outliers": 0, "saturation": stuck}), **in_doubt(finding))


def weighed(search: Search, level: Floor) -> Evidence:
    """Choose effects, and refuse again those that do not help on data that the fit has not seen."""
    refused: set[Cause] = set()
    for _ in range(REFUSALS):
        accepted, rankings = forward(search, refused=refused)
        accepted = _preferred(search, accepted, refused)
        blocks = plan(search.problem, correlation_s(search, accepted))
        steps = [held_out(search, blocks, _always(accepted[: i + 1]), accepted[:i]) for i in range(len(accepted))]
        idle = next((i for i in range(len(steps)) if not (_helps(steps[i]) and _adds(steps[: i + 1], level))), None)
        if idle is None:
            break
        refused.add(accepted[idle].cause)
        accepted, steps = accepted[:idle], steps[:idle]
    shortlist = _shortlist(search, rankings)
    while True:
        honest = held_out(shortlist, blocks, _choice(len(accepted), refused))
        if not accepted or _carries(honest, level):
            break
        accepted, steps = accepted[:-1], steps[:-1]
    rivals = tuple(tuple(_as_good(search, blocks, accepted, chosen)) for chosen in accepted)
    far = farness(search.everywhere(accepted)[0], search.good)
    return Evidence(search, tuple(accepted), tuple(rankings), rivals, honest, tuple(steps), level, blocks, far)


def _shortlist(search: Search, rankings: Sequence[Sequence[Weighed]]) -> Search:
    """The search among the causes that came out best: what has no weight on all rows has none on four fifths."""
    best = {w.candidate.cause for ranking in rankings for w in ranking[:SHORTLIST]}
    return search.among([c for c in search.candidates if c.cause in best])


def _choice(most: int, refused: Collection[Cause]) -> Callable[[Search], Sequence[Candidate]]:
    return lambda part: forward(part, most, refused)[0]


def _helps(step: HeldOut) -> bool:
    """Whether an effect lowers the held-out error, its whole interval above zero."""
    return step.improvement()[0] > 0


def _adds(steps: Sequence[HeldOut], level: Floor) -> bool:
    """Whether the last of some effects is more than a detail of those before it, on held-out data."""
    fall, total = (step.before**2 - steps[-1].after ** 2 for step in (steps[-1], steps[0]))
    return len(steps) == 1 or fall > min(SECOND * total, SECOND_OF_NOISE * level.nT**2)


def _carries(honest: HeldOut, level: Floor) -> bool:
    """Whether the effects carry most of what lies above the noise: less is no explanation, whatever its name."""
    excess = honest.before**2 - level.nT**2
    return honest.after <= AT_FLOOR * level.nT or honest.before**2 - honest.after**2 > SHARE_OF_EXCESS * excess


def _search(problem: Problem, lowest: float) -> Search:
    """Every candidate on all rows, or on bins of them where there are many."""
    fewer = binned(problem)
    rows, good = (np.ones(len(p), dtype=bool) for p in (fewer, problem))
    return Search(fewer, expand(fewer), rows, lowest, good)


def _without_outliers(search: Search) -> Search:
    """The search on the rows that do not lie, once the effects that the others show are taken off."""
    segment = search.whole.scene.segment
    lying = outliers(search.whole.y, segment)
    for _ in range(2):
        here = search.without(lying)
        accepted, _ = forward(here) if lying.any() else ([], [])
        left, added = here.everywhere(accepted)
        still = outliers(left, segment, added)
        if bool((still == lying).all()):
            break
        lying = still
    return search.without(lying)


@dataclass(frozen=True, slots=True, eq=False)
class Contender:
    """A cause in the place of an accepted one, and the held-out rms that it reaches."""

    weighed: Weighed
    after_nT: float


@dataclass(frozen=True, slots=True, eq=False)
class Evidence:
    """All that the verdict rests on."""

    search: Search
    accepted: tuple[Candidate, ...]
    rankings: tuple[list[Weighed], ...]
    rivals: tuple[tuple[Contender, ...], ...]  # of each accepted effect, itself first
    honest: HeldOut
    steps: tuple[HeldOut, ...]  # of each accepted effect, those before it already in
    level: Floor
    blocks: Plan
    far: float  # how far the rows that were set aside typically lie, in standard deviations of the others


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


def _always(accepted: Sequence[Candidate]) -> Callable[[Search], Sequence[Candidate]]:
    return lambda part: accepted


def _as_good(search: Search, blocks: Plan, accepted: Sequence[Candidate], chosen: Candidate) -> list[Contender]:
    """`chosen`, and the causes that in its place do as well on held-out data too."""
    out: list[Contender] = []
    for w in _rivals(search, accepted, chosen)[: CONTENDERS + 1]:
        mine = chosen if w.candidate.cause == chosen.cause else w.candidate
        swapped = [mine if c is chosen else c for c in accepted]
        after = held_out(search, blocks, _always(swapped)).after
        if not out or after <= AS_GOOD * out[0].after_nT:
            out.append(Contender(w, after))
    return out


def _preferred(search: Search, accepted: list[Candidate], refused: Collection[Cause]) -> list[Candidate]:
    """Of causes that do as well, the one that can be computed from readings alone; a channel without physics last."""
    for place, chosen in enumerate(accepted):
        equals = [w for w in _rivals(search, accepted, chosen) if w.candidate.cause not in refused]
        best = min(equals, key=lambda w: _standing(w.candidate))
        if _standing(best.candidate) < _standing(chosen):
            others = [c for c in accepted if c is not chosen]
            accepted = [*accepted[:place], refined(search, best.candidate, others), *accepted[place + 1 :]]
    return accepted


def _standing(candidate: Candidate) -> tuple[int, int]:
    """Low goes first: what readings alone can correct, then the rig's, then time's; the simpler before the richer."""
    kind = 1 if candidate.family.id == "offset-channel" else 0
    if candidate.family.bound_to_run:
        kind = 3
    elif candidate.family.belongs_to == "rig":
        kind = 2
    return kind, len(candidate.form.parameters)


def _rivals(search: Search, accepted: Sequence[Candidate], chosen: Candidate) -> list[Weighed]:
    """Other causes that would do as well in the place of `chosen`, it first."""
    others = [c for c in accepted if c is not chosen]
    open_to = [c for c in looks(search, others) if all(c.cause != o.cause for o in others)]
    near = _near(search.rank([*open_to, chosen], others), chosen)
    if search.problem.whole is not None and len(near) > 1:
        near = _near(search.unbinned().rank([w.candidate for w in near], others), chosen)
    return near


def _near(ranking: Sequence[Weighed], chosen: Candidate) -> list[Weighed]:
    """`chosen`, and what weighs nearly as much."""
    own = next(w for w in ranking if w.candidate.cause == chosen.cause)
    return [own, *(w for w in ranking if w.candidate.cause != chosen.cause and w.weight > own.weight - RIVAL)]


def _result(run: Run, found: Evidence, before: Refit, after: Refit, aside: dict[str, int]) -> ClosedLoop:
    problem = after.problem
    rows = found.search.good
    in_sample = [rms(r.problem.length_nT(r.problem.residual_nT)[rows]) for r in (before, after)]
    verdict = _verdict(found, aside, len(problem))
    accepted = [*_of_the_data(aside, problem, verdict, found.far), *_records(found, after)]
    affine, noticed = problem.affine, findings(run, problem, found.level)
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
        affine=affine,
        covariance=_covariance(after),
        frame_known=not bool((problem.seen.kind == SCALAR).all()),
        noise_nT=problem.noise.reading * run.dut.nominal_nT_per_unit,
        findings=noticed,
        tests=tests,
        shape=left,
        twins=twins(found),
        remarks=(tested(tests["after"]), *(finding.says for finding in noticed)),
        pictures=pictured(before.problem, after.problem),
    )


def pictured(before: Problem, after: Problem) -> Pictures:
    """The residual as it was and as it is, for pictures."""
    return Pictures(after.scene.t_s, after.scene.segment, _shown(before), _shown(after))


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
                p_value=_p_value(own.weighed, len(found.search.candidates)),
                rivals=tuple(_rival(other) for other in others),
                why=why(step, own.weighed),
            )
        )
    return out


def _rival(contender: Contender) -> Rival:
    form = contender.weighed.candidate.form
    return Rival(contender.weighed.candidate.family.id, form.channels, contender.after_nT)


def _p_value(weighed: Weighed, tried: int) -> float:
    """Chi-squared of the likelihood ratio, times the looks taken (Bonferroni)."""
    from scipy.stats import chi2

    return float(min(1.0, tried * chi2.sf(2 * max(weighed.gain, 0.0), max(weighed.rank, 1))))


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
    out = []
    for cause, w in last.items():
        if cause not in taken:
            form = w.candidate.form
            out.append(
                EffectRecord(
                    effect=w.candidate.family.id,
                    channels=form.channels,
                    reference_value=dict(form.reference_value),
                    belongs_to=w.candidate.family.belongs_to,
                    parameters=(),
                    p_value=_p_value(w, len(found.search.candidates)),
                    why=why_not(w),
                )
            )
    return out

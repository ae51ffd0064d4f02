"""The result of the loop from the evidence: verdict, records of effects, errors, findings."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from labcal.fit.vector.observations import SCALAR
from labcal.loop import policy
from labcal.loop.beginnings import astray_nT, with_beginnings
from labcal.loop.beside_rivals import beside_rivals
from labcal.loop.candidates.scorer import Scored
from labcal.loop.data.linear_problem import LinearProblem
from labcal.loop.data.noise_floor import noise_beside_readings
from labcal.loop.design.proposal import next_experiment
from labcal.loop.findings import working_range
from labcal.loop.findings.confounded import confounded
from labcal.loop.findings.declaration import BEYOND, Declaration, declaration
from labcal.loop.findings.own_colour import coloured_floor
from labcal.loop.findings.residual_shape import describe
from labcal.loop.findings.residual_tests import residual_tests as residual_tests
from labcal.loop.findings.run_findings import findings
from labcal.loop.narrative import (
    summary,
    tests_text,
    why_accepted,
    why_beyond_half,
    why_equivalent,
    why_final_fit_differs,
    why_insignificant,
    why_rejected,
)
from labcal.loop.noise.autocorrelation import serially_correlated
from labcal.loop.result import ClosedLoop, Errors, Pictures, Verdict
from labcal.loop.selection.crossval import HeldOutErrors, cross_validate, fixed_choice, rms
from labcal.loop.selection.equivalents import Equivalent
from labcal.loop.selection.joint_fit import JointFit, beside_declared, in_sample_rms, joint_fit
from labcal.loop.selection.proof import Evidence
from labcal.loop.selection.surrogates import p_value
from labcal.loop.uncertainty import of_the_file, uncertainty_of
from labcal.model import EffectRecord, Parameter
from labcal.model.calibration import k_means
from labcal.model.effects.set_aside import OUTLIERS, SATURATION
from labcal.model.records import Rival
from labcal.record import Run
from labcal.uncertainty import Sources

ROUNDS_EXHAUSTED = (
    "The selection ended without a set of effects that held-out data support whole; what its last round left stands."
)
Array = NDArray[np.float64]


def assemble(run: Run, found: Evidence, before: JointFit, after: JointFit, aside: dict[str, int]) -> ClosedLoop:
    """The result: verdict, accepted and rejected effects, errors before and after, findings and the next experiment."""
    after = with_beginnings(after)
    problem = after.problem
    rows = found.pool.valid
    in_sample = [rms(r.problem.length_nT(r.problem.residual_nT)[rows]) for r in (before, after)]
    found = _no_better_than_fitted(found, after, in_sample[1])
    declared = declaration(after, found.cv_error)
    verdict = verdict_of(found, aside, len(problem), declared)
    of_the_data = _data_effects(aside, problem, verdict, found.outlier_distance)
    uncertain = uncertainty_of(after)
    of_effects = _records(found, after, uncertain)
    unsupported = working_range.unsupported(run, found.accepted, after)
    shipped, errors, beside_nT = _shipped(found, after, unsupported)
    of_shipped = uncertain if shipped is after else uncertainty_of(shipped)
    of_file = of_the_file(
        shipped,
        replace(of_shipped, declared=(*of_shipped.declared, *beside_rivals(found, shipped, unsupported))),
        [c.belongs_to == "sensor" for i, c in enumerate(found.accepted) if i not in unsupported],
    )
    of_declared = declared.finding(found.level) if declared else None
    noticed = (
        *([of_declared] if of_declared else []),
        *findings(run, problem, found.level),
        *working_range.findings(run, found.accepted, after),
    )
    tests = {when: residual_tests(beside_declared(r), rows) for when, r in (("before", before), ("after", after))}
    beyond = of_declared is not None and of_declared.kind == BEYOND
    without_outliers = verdict_of(found, aside | {OUTLIERS.id: 0}, len(problem), declared)
    structure = without_outliers in ("unexplained", "partly-explained") and not beyond
    left = describe(beside_declared(after), rows) if structure else None
    return ClosedLoop(
        run_id=run.run_id,
        residual_kind=problem.kind,
        base=problem.base,
        noise_floor_nT=found.level.nT,
        noise_floor_source=found.level.source,
        before=Errors(in_sample[0], found.cv_error.plain[0]),
        after=Errors(in_sample[1], found.cv_error.plain[1]),
        beside_declared_nT=beside_nT,
        set_aside=aside,
        accepted=(*of_the_data, *of_effects),
        rejected=tuple(_rejected(found)),
        verdict=verdict,
        summary=summary(found, verdict, aside, left, of_declared),
        next_experiment=next_experiment(found, verdict, after, left, beyond_declared=beyond),
        affine=shipped.problem.affine,
        covariance=of_file.covariance,
        covariance_of=of_file.names,
        sources=of_file.sources,
        frame_known=not bool((problem.observations.kind == SCALAR).all()),
        noise_nT=problem.noise.reading * run.dut.nominal_nT_per_unit,
        noise_beside_readings_nT=noise_beside_readings(problem),
        findings=noticed,
        tests=tests,
        shape=left,
        unsupported=frozenset(len(of_the_data) + i for i in unsupported),
        shipped=errors,
        twins=confounded(problem, [c.scored.candidate.family for rivals in found.equivalents for c in rivals]),
        remarks=(
            tests_text(tests["after"], more_than_noise=left is not None),
            *(finding.says for finding in noticed),
            *_remarks(found, after, [one for i, one in enumerate(of_effects) if i not in unsupported]),
        ),
        pictures=replace(residual_pictures(before.problem, after.problem), held_out_nT=_both(found.cv_error)),
    )


def _no_better_than_fitted(found: Evidence, after: JointFit, left_nT: float) -> Evidence:
    """The evidence with an error no smaller than what the last fit leaves in sample, and the floor of its own noise."""
    beside = in_sample_rms(after) if after.problem.declared.shape[2] else left_nT
    found = replace(found, cv_error=as_shipped(found.cv_error, beside, left_nT, added=bool(found.accepted)))
    return replace(found, level=coloured_floor(found, after) or found.level)


def _remarks(found: Evidence, after: JointFit, shipping: Sequence[EffectRecord]) -> list[str]:
    """How the selection ended, what k belongs to beside what is `shipping`, and how far off loops begin elsewhere."""
    ended = [ROUNDS_EXHAUSTED] if found.ending == "rounds exhausted" else []
    means = k_means([effect for effect in shipping if effect.belongs_to == "sensor"])
    return [*ended, *([f"k is the offset {means}."] if means else []), *_beginnings(found, after)]


def _beginnings(found: Evidence, after: JointFit) -> list[str]:
    """What another recording's beginning adds to the error, where it is more than noise: blocks do not hold it."""
    each = [(chosen.label, astray_nT(after, place)) for place, chosen in enumerate(found.accepted)]
    return [
        f"In another recording {label} begins {off:.0f} nT astray (one standard deviation) until the field has wiped "
        "that out: the held-out error does not hold it, u_nT does."
        for label, off in each
        if off > found.level.nT
    ]


def as_shipped(
    cv_error: HeldOutErrors, in_sample: float, plain: float | None = None, *, added: bool = True
) -> HeldOutErrors:
    """The held-out error, no smaller than what the shipped map and effects leave on the rows of their fit.

    Blocks are predicted to first order about the last fit; where an effect is too nonlinear, the file is worse.
    Where nothing was `added`, before is what is after. `plain` is `in_sample` with what declared errors leave.
    """
    after_nT = _no_smaller(cv_error.after_nT, in_sample)
    found = replace(cv_error, after_nT=after_nT, before_nT=cv_error.before_nT if added else after_nT)
    if cv_error.plain_nT is None:
        return found
    before, after = cv_error.plain_nT
    after = _no_smaller(after, in_sample if plain is None else plain)
    return replace(found, plain_nT=(before if added else after, after))


def _no_smaller(lengths: Array, least: float) -> Array:
    """Lengths (n,) with an rms of `least` or more."""
    left = rms(lengths)
    return lengths * (max(left, least) / left) if left > 0 else lengths


def _shipped(found: Evidence, after: JointFit, unsupported: Collection[int]) -> tuple[JointFit, Errors | None, float]:
    """The map that goes with the effects that are shipped, fitted without the others, and its errors.

    The last is the held-out one beside what the run declares.

    A map fitted beside an effect that the run does not pin down is as uncertain as the effect.
    """
    if not unsupported:
        return after, None, found.cv_error.after
    kept = [chosen for i, chosen in enumerate(found.accepted) if i not in unsupported]
    rows = found.pool.valid
    fitted = with_beginnings(joint_fit(found.pool.whole, [c.term for c in kept], rows))
    left = rms(fitted.problem.length_nT(fitted.problem.residual_nT)[rows])
    held = as_shipped(
        cross_validate(found.pool, found.blocks, fixed_choice(kept)), in_sample_rms(fitted), left, added=True
    )
    return fitted, Errors(left, held.plain[1]), held.after


def residual_pictures(before: LinearProblem, after: LinearProblem) -> Pictures:
    """The residual as it was and as it is, for pictures."""
    return Pictures(after.scene.t_s, after.scene.segment, _shown(before), _shown(after))


def _both(cv_error: HeldOutErrors) -> Array:
    """Held-out lengths before and after (n, 2), NaN on rows that were never held out."""
    lengths = np.full((len(cv_error.rows), 2), np.nan)
    lengths[cv_error.rows] = np.column_stack([cv_error.before_nT, cv_error.after_nT])
    return lengths


def _shown(problem: LinearProblem) -> Array:
    if problem.kind == "vector":
        return problem.residual_nT
    b = problem.scene.field_nT
    return np.asarray(np.sum(problem.residual_nT * b, axis=1) / np.linalg.norm(b, axis=1))[:, None]


def verdict_of(found: Evidence, aside: dict[str, int], rows: int, declared: Declaration | None = None) -> Verdict:
    """The verdict that the evidence bears, with so many rows set `aside` by effect, of so many `rows`.

    Beside errors that the run declares, where what is left of them is no larger than `declared`.
    """
    law = policy.POLICY
    reaches = found.cv_error.after <= law.floor_ratio * found.level.nT
    if declared is not None and not declared.holds:
        reaches = reaches and found.cv_error.plain[1] <= law.floor_ratio * found.level.nT
    known = found.level.source != "differences" or found.level.memory_s is not None or not _correlated(found)
    outlying = aside[OUTLIERS.id] > law.max_outlier_share * rows
    if any(len(r) > 1 for r in found.equivalents):
        return "ambiguous"
    if found.accepted:
        return "explained" if reaches and known and not outlying else "partly-explained"
    saturated = aside[SATURATION.id] >= law.min_set_aside
    if outlying or (saturated and not reaches):
        return "partly-explained"
    gross = aside[OUTLIERS.id] >= law.min_set_aside and found.outlier_distance > law.gross_outlier_sigmas
    if reaches:
        return "explained" if saturated or gross else "clean"
    return "unexplained"


def _correlated(found: Evidence) -> bool:
    """Whether what the accepted effects leave of the valid rows still correlates from row to row."""
    left = found.pool.residual_everywhere(found.accepted)[0] * found.pool.valid[:, None]
    return serially_correlated(left, found.pool.whole.scene.segment)


def _records(found: Evidence, after: JointFit, uncertain: Sources) -> list[EffectRecord]:
    out, stated = [], after.parameters(uncertain.covariance)
    lists = zip(found.accepted, after.terms, stated, found.contributions, found.equivalents, strict=True)
    for chosen, term, parameters, step, rivals in lists:
        low, high = step.improvement()
        own, others = rivals[0], rivals[1:]
        out.append(
            EffectRecord(
                effect=chosen.family.id,
                channels=term.channels,
                reference_value=dict(term.reference_value),
                belongs_to=chosen.belongs_to,
                parameters=parameters,
                provisional=bool(others),
                holdout_rms_before_nT=step.before,
                holdout_rms_after_nT=step.after,
                improvement_ci95_nT=(low, high),
                p_value=p_value(own.scored, found.null_distribution),
                rivals=tuple(_rival(other) for other in others),
                why=why_accepted(step, own.scored, chosen.group),
                group=chosen.group,
            )
        )
    return out


def _rival(equivalent: Equivalent) -> Rival:
    term = equivalent.scored.candidate.term
    return Rival(equivalent.scored.candidate.family.id, term.channels, equivalent.after_nT)


def _data_effects(aside: dict[str, int], problem: LinearProblem, verdict: Verdict, far: float) -> list[EffectRecord]:
    """Rows set aside are named as a cause where they are more than chance.

    Outliers only where the rest is understood; a limit that readings pile up at is there whatever the rest is.
    """
    found = []
    law = policy.POLICY
    for effect, count in aside.items():
        gross = effect != OUTLIERS.id or far > law.gross_outlier_sigmas
        if count >= law.min_set_aside and gross and verdict != "unexplained":
            part = count / (len(problem) + count)
            rows = Parameter("rows", float(count), 0.0, "1")
            why = f"{count} rows ({100 * part:.1f} %) set aside"
            found.append(EffectRecord(effect, (), {}, "data", (rows,), why=why))
    return found


def _rejected(found: Evidence) -> list[EffectRecord]:
    """Every cause that was scored and not accepted, at the last step that scored it."""
    last = {w.candidate.cause: w for ranking in found.rankings for w in ranking}
    taken = {c.cause for c in found.accepted}
    return [_rejected_record(found, w) for w in last.values() if not {m.cause for m in w.candidate.parts} <= taken]


def _rejected_record(found: Evidence, w: Scored) -> EffectRecord:
    """Its record; with the held-out error where it is equivalent to an accepted one, or was selected and refused."""
    term, step = w.candidate.term, found.refused.get(w.candidate.cause)
    before, after, said = (step.before, step.after, why_rejected(w, step)) if step else (None, None, why_rejected(w))
    gain = step.improvement() if step else None
    if step and w.candidate.cause in found.beyond_half:
        said = why_beyond_half(step)
    if step and (left := found.not_carried.get(w.candidate.cause)) is not None:
        said = why_final_fit_differs(step, left)
    if step and (chance := found.insignificant.get(w.candidate.cause)) is not None:
        said = why_insignificant(step, chance)
    for chosen, proof, rivals in zip(found.accepted, found.contributions, found.equivalents, strict=True):
        for rival in rivals[1:]:
            if rival.scored.candidate.cause == w.candidate.cause:
                before, after, gain, said = proof.before, rival.after_nT, None, why_equivalent(chosen, rival.after_nT)
    return EffectRecord(
        effect=w.candidate.family.id,
        channels=term.channels,
        reference_value=dict(term.reference_value),
        belongs_to=w.candidate.belongs_to,
        parameters=(),
        holdout_rms_before_nT=before,
        holdout_rms_after_nT=after,
        improvement_ci95_nT=gain,
        p_value=p_value(w, found.null_distribution),
        why=said,
    )

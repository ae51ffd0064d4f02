"""The result in words: one sentence for the technician, and why each cause was accepted or rejected."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from labcal.loop import policy
from labcal.loop.candidates.library import Candidate
from labcal.loop.candidates.scorer import Scored
from labcal.loop.result import Finding, NextExperiment, ResidualShape, ResidualTest, Verdict
from labcal.loop.selection.crossval import HeldOutErrors

if TYPE_CHECKING:
    from labcal.loop.selection.proof import Evidence


def summary(
    found: Evidence,
    verdict: Verdict,
    aside: dict[str, int],
    shape: ResidualShape | None = None,
    declared: Finding | None = None,
) -> str:
    """One sentence for the technician, the shape of what is left, and the rows that were set aside.

    Where errors that the run declares decide the verdict, `declared` says so.
    """
    names = [c.label for c in found.accepted]
    named = " and ".join([", ".join(names[:-1]), names[-1]] if len(names) > 1 else names) or "Rows set aside"
    verb = "explains" if len(names) == 1 else "explain"
    change = (
        f"{found.cv_error.before:.0f} to {found.cv_error.after:.0f} nT held out (noise alone: {found.level.nT:.0f} nT)"
    )
    beside = " beside what the run declares of its reference and mounting" if declared is not None else ""
    rows = ", ".join(f"{n} row{'s' * (n != 1)} set aside as {what}" for what, n in aside.items() if n)
    sentences = {
        "clean": f"The base model reaches the noise{beside}: {change}.",
        "explained": f"{named} {verb} the residual{beside}: {change}.",
        "partly-explained": f"{named} {verb} part of the residual{_share(found)}: {change}.",
        "ambiguous": f"{named} {verb} the residual: {change}; but {_others(found)} as well on this run.",
        "unexplained": f"There is structure that no known effect carries: {change}.",
    }
    if shape is None and declared is None:  # nothing is left but the rows that were set aside
        most = f"{policy.POLICY.max_outlier_share:.0%}".replace("%", " %")
        sentences["partly-explained"] = (
            f"{named} {verb} the residual: {change}; but of a run with more than {most} of its rows set aside as "
            "outliers nothing is called explained."
        )
    left = f" What is left: {shape.says}" if shape is not None else ""
    if declared is not None and verdict == "unexplained":
        return declared.says + (f" {rows}." if rows else "")
    if not names and shape is not None and verdict == "partly-explained":
        return f"Beside the rows set aside there is structure that no known effect carries: {change}.{left} {rows}."
    return sentences[verdict] + left + (f" {rows}." if rows else "")


def _share(found: Evidence) -> str:
    """How much of what lies above the noise the named effects carry on held-out data."""
    excess = found.cv_error.before**2 - found.level.nT**2
    carried = found.cv_error.before**2 - found.cv_error.after**2
    return (
        f", {100 * min(carried / excess, 1.0):.0f} % of its square above the noise"
        if found.accepted and excess > 0
        else ""
    )


def _others(found: Evidence) -> str:
    """The equivalents of what is accepted."""
    names = dict.fromkeys(c.scored.candidate.label for rivals in found.equivalents for c in rivals[1:])
    return f"{' and '.join(names)} {'does' if len(names) == 1 else 'do'}"


def of_faulty_data(finding: Finding) -> dict[str, Any]:
    """What a result says where the data themselves are wrong."""
    return {
        "verdict": "unexplained",
        "summary": f"{finding.says} No effect was searched in such data.",
        "next_experiment": _remedy(finding),
        "findings": (finding,),
        "remarks": (finding.says,),
    }


def _remedy(finding: Finding) -> NextExperiment:
    if finding.kind == "excitation":
        why, do = "the run does not determine the whole map", "turn about all three body axes, in two fields at least"
        return NextExperiment(why, do, "preflight")
    why = "an effect found in such data would be wrong"
    return NextExperiment(why, "put the bundle or the wiring right, and close the loop again")


def of_other_judgements() -> list[str]:
    """A remark where somebody's own policy decides; none where labcal's does."""
    stated = policy.judgements()
    each = [f"{name} {value:g} ({stated[name].value:g})" for name, value in policy.moved().items()]
    return [f"Decided by other judgements than labcal's own: {', '.join(each)}."] if each else []


def why_accepted(step: HeldOutErrors, own: Scored, group: str = "") -> str:
    """Why an effect was accepted, as one of a `group` where it was."""
    change = f"the held-out rms falls from {step.before:.1f} to {step.after:.1f} nT"
    beside = f"with the others of {group} in, " if group else ""
    return f"{beside}{change}; evidence over a slow wander without a name: {_nats(own.evidence)}"


def why_rejected(w: Scored, step: HeldOutErrors | None = None) -> str:
    """Why a scored cause is not named; `step` is its contribution where held-out data did not support it."""
    if step is not None:
        return _why_refused(step)
    if w.evidence < 0:
        return f"no better than chance or a slow wander: evidence {_nats(w.evidence)}"
    if w.evidence < policy.POLICY.min_evidence:
        return f"too little evidence: {_nats(w.evidence)}"
    taken = f"takes {w.drop:.2g} times the noise's square off the residual"
    if w.drop < policy.POLICY.material_share:
        return f"{taken}: not worth its parameters"
    return f"{taken} in sample, but other forms of what is accepted take as much"


def why_final_fit_differs(step: HeldOutErrors, left_nT: float) -> str:
    """Why a cause is not named that the last fit of map and effects together cannot carry."""
    return (
        f"taken to first order ({step.before:.1f} to {step.after:.1f} nT held out), and given up: fitted in full, map "
        f"and effects together leave {left_nT:.1f} nT"
    )


def why_beyond_half(step: HeldOutErrors) -> str:
    """Why a cause is not named that is too large for a lab."""
    return (
        f"taken ({step.before:.1f} to {step.after:.1f} nT held out), and given up: it would be more than half of the "
        "field, and the others would undo it"
    )


def why_insignificant(step: HeldOutErrors, chance: float) -> str:
    """Why a cause is not named that is no larger than its uncertainty."""
    return (
        f"taken ({step.before:.1f} to {step.after:.1f} nT held out), and given up: it is no larger than its "
        f"uncertainty, declared errors included; what is not there would seem as large in {100 * chance:.0f} % of runs"
    )


def why_equivalent(accepted: Candidate, after_nT: float) -> str:
    """Why an equivalent cause is not named in the place of the accepted one."""
    return f"does as well as {accepted.label} in its place ({after_nT:.1f} nT held out): a rival, neither is sure"


def _why_refused(step: HeldOutErrors) -> str:
    low, high = step.improvement()
    change = f"taken, and given up on held-out blocks: {step.before:.1f} to {step.after:.1f} nT"
    if low <= 0:
        return f"{change}, a gain of {_signed(low)} to {_signed(high)} nT that may be none"
    return f"{change}, but it is a detail beside others, or too much is left for its name to be sure"


def _nats(evidence: float) -> str:
    return f"{_signed(evidence)} nats, {policy.POLICY.min_evidence:.0f} needed"


def _signed(value: float) -> str:
    return f"{value:.1f}".replace("-", "−")


def tests_text(tests: Sequence[ResidualTest], *, more_than_noise: bool) -> str:
    """One sentence on the tests of a residual; all passed says nothing against a residual that is `more_than_noise`."""
    failed = [test.says for test in tests if not test.passes]
    if not failed and more_than_noise:
        return (
            "What is left is more than noise, though no single test (white in each segment, independent of every "
            "channel, of field, angle and time) finds of what shape."
        )
    if not failed:
        return (
            "What is left shows no material structure: white in each segment, independent of every channel, of field, "
            "angle and time."
        )
    more = [f"{len(failed) - 3} more tests fail"] if len(failed) > 3 else []
    return f"What is left {'; '.join([*failed[:3], *more])}."

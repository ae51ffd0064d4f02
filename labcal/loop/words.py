"""The words of the verdict: for the technician in one sentence, for each cause why or why not, and what to do next."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from labcal.loop.decide import MATERIAL
from labcal.loop.holdout import HeldOut
from labcal.loop.result import Finding, NextExperiment, ResidualTest, Shape, Verdict
from labcal.loop.search import NAMED, Candidate, Weighed

if TYPE_CHECKING:
    from labcal.loop.evidence import Evidence


def summary(found: Evidence, verdict: Verdict, aside: dict[str, int], shape: Shape | None = None) -> str:
    """One sentence for the technician, what is left over looks like, and the rows that were set aside."""
    names = [name(c) for c in found.accepted]
    named = " and ".join([", ".join(names[:-1]), names[-1]] if len(names) > 1 else names) or "Rows that lie"
    verb = "explains" if len(names) == 1 else "explain"
    change = f"{found.honest.before:.0f} to {found.honest.after:.0f} nT held out (noise alone: {found.level.nT:.0f} nT)"
    rows = ", ".join(f"{n} rows set aside as {what}" for what, n in aside.items() if n)
    sentences = {
        "clean": f"The base model reaches the noise: {change}.",
        "explained": f"{named} {verb} the residual: {change}.",
        "partly-explained": f"{named} {verb} part of the residual: {change}.",
        "ambiguous": f"{named} {verb} the residual: {change}; but other effects do as well on this run.",
        "unexplained": f"There is structure that no known effect carries: {change}.",
    }
    left = f" What is left: {shape.says}" if shape is not None else ""
    return sentences[verdict] + left + (f" {rows}." if rows else "")


def in_doubt(finding: Finding) -> dict[str, Any]:
    """What a result says where the data themselves are wrong."""
    return {
        "verdict": "unexplained",
        "summary": f"{finding.says} No effect was searched in such data.",
        "next_experiment": _mending(finding),
        "findings": (finding,),
        "remarks": (finding.says,),
    }


def _mending(finding: Finding) -> NextExperiment:
    if finding.kind == "excitation":
        return NextExperiment(finding.says, "turn about all three body axes, in two fields at least", "preflight")
    return NextExperiment(finding.says, "put the bundle or the wiring right, and close the loop again")


def why(step: HeldOut, own: Weighed) -> str:
    """Why an effect was accepted."""
    change = f"the held-out rms falls from {step.before:.1f} to {step.after:.1f} nT"
    return f"{change}; evidence over a slow wander without a name {own.weight:.0f}, {NAMED:.0f} needed"


def why_not(w: Weighed) -> str:
    """Why a cause that was weighed is not named."""
    if w.weight < 0:
        return f"no better than chance or a slow wander: evidence {w.weight:.1f}, {NAMED:.0f} needed"
    if w.weight < NAMED:
        return f"too little evidence: {w.weight:.1f}, {NAMED:.0f} needed"
    taken = f"takes {100 * w.drop:.1f} % of the noise's square off the residual"
    if w.drop < MATERIAL:
        return f"{taken}: not worth its parameters"
    return f"{taken} in sample, but is a detail of what is accepted or does not hold on blocks it was not fitted to"


def tested(tests: Sequence[ResidualTest]) -> str:
    """One sentence on the tests of a residual."""
    failed = [test.says for test in tests if not test.passes]
    if not failed:
        return (
            "What is left shows no material structure: white in each segment, independent of every channel, of field, "
            "angle and time."
        )
    more = [f"{len(failed) - 3} more tests fail"] if len(failed) > 3 else []
    return f"What is left {'; '.join([*failed[:3], *more])}."


def name(candidate: Candidate) -> str:
    """What is named: the effect and its channels."""
    channels = ", ".join(candidate.form.channels)
    return candidate.family.id + (f" ({channels})" if channels else "")

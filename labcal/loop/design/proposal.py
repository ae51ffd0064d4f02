"""What to measure next: what would separate equivalent explanations, or show what the structure belongs to."""

from __future__ import annotations

from typing import TYPE_CHECKING

from labcal.loop.candidates.library import Candidate
from labcal.loop.design.discrimination import CLEAR, Separation, rank_experiments
from labcal.loop.result import NextExperiment, Ranked, ResidualShape, Verdict
from labcal.loop.selection.joint_fit import JointFit

if TYPE_CHECKING:
    from labcal.loop.selection.proof import Evidence

LISTED = 4  # experiments that the result ranks
AMPLE = 4 * CLEAR  # standard deviations: of experiments that separate farther the automatic one goes first
BY_SHAPE = {  # do, procedure
    "line": ("record at rest with the coils off, then switch what runs at that period off one by one", "ambient"),
    "step": ("repeat the run unchanged and note what is switched: a step that does not come back was an event",
             "repeat"),
    "telegraph": ("switch every load and mode on and off at one attitude, and look for the two levels",
                  "current-coupling"),
    "random-walk": ("record for an hour at rest: a wander of the sensor goes on, one of the rig does not", "repeat"),
    "wander": ("turn at half and at twice the rate: what belongs to angle or field comes again",
               "rate-sweep"),
    "noise": ("record at rest with the coils off: the noise that remains is the sensor's own", "ambient"),
}  # fmt: skip
OF_THE_DECLARED = NextExperiment(
    "what is left has the shape of errors that the run declares of its reference and mounting, and is larger",
    "compare the reference with a second one in two fields, mount the device anew, and repeat",
)
OF_THE_ROWS = NextExperiment(
    "more rows are set aside as outliers than a run may have that is called explained",
    "look at the link and its wiring, and repeat",
)
BY_ANGLE = ("turn once forwards and once backwards: what stays at its angles belongs to the rig", "reverse")
BY_FIELD = ("step the field up and down along each axis: what grows with the field shows its shape", "linearity")


def next_experiment(
    found: Evidence, verdict: Verdict, after: JointFit, shape: ResidualShape | None, *, beyond_declared: bool = False
) -> NextExperiment | None:
    """The proposal; None where nothing is open."""
    if verdict == "ambiguous":
        return _between_equivalents(found, after)
    if beyond_declared:
        return OF_THE_DECLARED
    if shape is None:
        return OF_THE_ROWS if verdict == "partly-explained" else None
    do, procedure = BY_SHAPE[shape.kind]
    if shape.angle_deg is not None:
        do, procedure = BY_ANGLE
    elif shape.field_nT is not None and shape.kind not in ("step", "line"):
        do, procedure = BY_FIELD
    return NextExperiment(f"structure remains that no known effect carries: {shape.says.rstrip('.')}", do, procedure)


def _between_equivalents(found: Evidence, after: JointFit) -> NextExperiment:
    """Each experiment counts by the pair of explanations that it separates least (maximin)."""
    place, equivalents = next((i, r) for i, r in enumerate(found.equivalents) if len(r) > 1)
    chosen = Candidate(found.accepted[place].family, after.terms[place])
    rivals = [equivalent.scored.candidate for equivalent in equivalents[1:]]
    tables = [rank_experiments(after.problem, chosen, rival, after.beta[place]) for rival in rivals]
    order = _worst_case(tables)
    names = " and ".join(c.label for c in (chosen, *rivals))
    equal = f"{names} do as well as each other on this run"
    if not order or order[0].sigma < CLEAR:
        why = (
            f"{equal}, and nothing that this lab's procedures do would separate them by {CLEAR:.0f} standard deviations"
        )
        return NextExperiment(why, chosen.family.experiment or "repeat with another reference", None)
    best = order[0]
    why = f"{equal}; the experiment would bring them {best.sigma:.0f} standard deviations apart, as the fit predicts"
    clear = [s for s in order[:LISTED] if s.sigma >= CLEAR]
    run = after.problem.run
    listed = tuple(
        Ranked(s.experiment.do, s.experiment.procedure, round(s.sigma, 1), s.experiment.settings(run)) for s in clear
    )
    settings = best.experiment.settings(run)
    return NextExperiment(why, best.experiment.do, best.experiment.procedure, listed, settings)


def _worst_case(tables: list[list[Separation]]) -> list[Separation]:
    """Each experiment with its smallest separation from any rival, the largest first; at a tie what is automatic."""
    least = {
        s.experiment.do: min((t for table in tables for t in table if t.experiment.do == s.experiment.do),
                             key=lambda t: t.sigma)
        for s in tables[0]
    }  # fmt: skip
    return sorted(least.values(), key=lambda s: (-min(s.sigma, AMPLE), s.experiment.procedure is None, -s.sigma))

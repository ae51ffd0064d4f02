"""The proof of a smooth function: built again without each held-out fold, it has to predict what it has not seen."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from labcal.loop import policy
from labcal.loop.candidates.library import Candidate
from labcal.loop.candidates.scorer import CandidateSet, Scored
from labcal.loop.empirical.build import Shortlist, best_smooth, shortlist
from labcal.loop.selection.crossval import HeldOutErrors, cross_validate
from labcal.loop.selection.equivalents import Equivalent
from labcal.loop.selection.heldout_rules import improves
from labcal.loop.selection.proof import Evidence, in_play, nested_selection


def with_smooth(found: Evidence) -> Evidence | None:
    """The evidence with a smooth function beside what is accepted; None where none has enough, or held-out data refuse.

    Of the inputs on the shortlist it is those with the most evidence that held-out data support. Nothing that is
    accepted changes: a known effect is never displaced.
    """
    listed = shortlist(found.pool, found.accepted)
    while (scored := best_smooth(found.pool, found.accepted, listed)) is not None:
        tried = scored.candidate.term.inputs
        if (proven := proven_with(found, scored, replace(listed, sets=(tried,)))) is not None:
            return proven
        listed = replace(listed, sets=tuple(inputs for inputs in listed.sets if inputs != tried))
    return None


def proven_with(found: Evidence, scored: Scored, inputs: Shortlist) -> Evidence | None:
    """The evidence with a function of these inputs, built again without each fold; None where held-out blocks refuse.

    A function that only steps between segments has evidence for the jumps there, and predicts no segment that it has
    not seen: then the next inputs are tried.
    """
    if scored.drop < policy.POLICY.material_share:
        return None
    pool, accepted = found.pool, found.accepted
    own = cross_validate(pool, found.blocks, lambda part: [*accepted, *_built(part, accepted, inputs)], accepted)
    if not improves(own) or not _is_worth_it(own, found):
        return None
    return replace(
        found,
        accepted=(*accepted, scored.candidate),
        contributions=(*found.contributions, own),
        equivalents=(*found.equivalents, (Equivalent(scored, own.after),)),
        cv_error=_held_out(found, own, inputs),
    )


def _built(part: CandidateSet, accepted: Sequence[Candidate], listed: Shortlist) -> list[Candidate]:
    scored = best_smooth(part, accepted, listed)
    return [] if scored is None else [scored.candidate]


def _is_worth_it(own: HeldOutErrors, found: Evidence) -> bool:
    """Whether it takes off as much of what is above the noise as a second cause has to."""
    excess = own.before**2 - found.level.nT**2
    return own.before**2 - own.after**2 > policy.POLICY.min_share_of_excess * excess


def _held_out(found: Evidence, own: HeldOutErrors, inputs: Shortlist) -> HeldOutErrors:
    """The error of all that was chosen, chosen again without each fold but for its inputs; before it, the base's."""
    after, known = own, found.accepted
    if known:
        offered = in_play(found.pool, known, found.rankings)
        nested = nested_selection(found.level, found.blocks, len(known), offered=offered)

        def again(part: CandidateSet) -> list[Candidate]:
            chosen = nested(part)
            return [*chosen, *_built(part, chosen, inputs)]

        after = cross_validate(found.pool, found.blocks, again)
    both = after.rows & found.cv_error.rows
    return after.on(both).against(found.cv_error.on(both))

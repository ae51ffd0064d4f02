"""Each cause that was chosen in steps, or the one that is far likelier in its place now that the others are there.

What comes first takes most alone, and may be a form of many parameters that holds a part of several causes. Once the
others are there it is compared anew with what led beside it (sequential replacement: Miller, Subset Selection in
Regression, 2nd ed. 2002, section 3.4).
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence

from labcal.loop import policy
from labcal.loop.candidates.library import Candidate, Cause
from labcal.loop.candidates.refine import refined
from labcal.loop.candidates.scorer import CandidateSet, Scored
from labcal.loop.selection.crossval import BlockFolds, cross_validate, fixed_choice
from labcal.loop.selection.equivalents import lead_of, not_worse
from labcal.loop.selection.stepwise import is_same_source

MAX_TRIED = 8  # causes, the likeliest of any step


def exchanged(
    pool: CandidateSet,
    blocks: BlockFolds,
    accepted: list[Candidate],
    rankings: Sequence[Sequence[Scored]],
    refused: Collection[Cause],
) -> list[Candidate]:
    """The same with what is far likelier in a place, and no worse on held-out data."""
    tried = [c for c in _likeliest(rankings) if c.cause not in refused]
    for place, one in enumerate(accepted):
        others = [c for c in accepted if c is not one]
        for other in _likelier(pool, others, one, tried) if others and not one.members else ():
            swapped = [*accepted[:place], refined(pool, other, others), *accepted[place + 1 :]]
            if not_worse(cross_validate(pool, blocks, fixed_choice(swapped), accepted)):
                accepted = swapped
                break
    return accepted


def _likeliest(rankings: Sequence[Sequence[Scored]]) -> list[Candidate]:
    """The causes that led at some step, each in the form in which it did."""
    best = dict[Cause, Candidate]()
    for one in sorted((w for ranking in rankings for w in ranking), key=lambda w: -w.evidence):
        if one.evidence > policy.POLICY.min_evidence:
            best.setdefault(one.candidate.cause, one.candidate)
    return list(best.values())[:MAX_TRIED]


def _likelier(
    pool: CandidateSet, others: Sequence[Candidate], one: Candidate, tried: Sequence[Candidate]
) -> Iterator[Candidate]:
    """Those of another cause that lead over `one` beside the others by more than what counts as alike, best first."""
    open_to = [c for c in tried if c.cause != one.cause and not any(is_same_source(o, c) for o in others)]
    own, *rest = pool.score_each([one, *open_to], pool.null_model(others))
    leads = sorted(((lead_of(w, own), w.candidate) for w in rest), key=lambda pair: -pair[0])
    yield from (c for nats, c in leads if nats > policy.POLICY.equivalent_nats)

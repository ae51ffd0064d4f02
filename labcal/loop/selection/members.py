"""The members of accepted sets, each with its own held-out proof, and what could stand in their places."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from labcal.loop import policy
from labcal.loop.candidates.library import Candidate
from labcal.loop.candidates.scorer import CandidateSet
from labcal.loop.selection.crossval import HeldOutErrors, cross_validate, fixed_choice, own_proof
from labcal.loop.selection.equivalents import Equivalent
from labcal.loop.selection.proof import Evidence
from labcal.loop.selection.sets import offered_for, together

Stand = dict[Candidate, list[Candidate]]  # a channel left out: the members in whose place it does as well


def members_in_place(found: Evidence) -> Evidence:
    """The same evidence with the members of each set in its place."""
    accepted, contributions, equivalents = list[Candidate](), list[HeldOutErrors](), list[tuple[Equivalent, ...]]()
    for chosen, step, rivals in zip(found.accepted, found.contributions, found.equivalents, strict=True):
        if not chosen.members:
            accepted.append(chosen)
            contributions.append(step)
            equivalents.append(rivals)
            continue
        others = [c for c in found.accepted if c is not chosen]
        stand = _stand_ins(found.pool, others, chosen)
        named = _name(chosen, stand)
        for one in chosen.members:
            accepted.append(replace(one, group=named))
            contributions.append(own_proof(found.pool, found.blocks, others, chosen.members, one))
            own = _alone(found, others, chosen, one, one)
            swaps = [_alone(found, others, chosen, one, other) for other, places in stand.items() if places == [one]]
            equivalents.append((own, *swaps, *rivals[1:]))
    return replace(found, accepted=tuple(accepted), contributions=tuple(contributions), equivalents=tuple(equivalents))


def _alone(
    found: Evidence, others: Sequence[Candidate], chosen: Candidate, one: Candidate, by: Candidate
) -> Equivalent:
    """What `by` brings in the place of `one` beside the rest of its set."""
    rest = [*others, *(m for m in chosen.members if m is not one)]
    after = cross_validate(found.pool, found.blocks, fixed_choice([*rest, by])).after
    return Equivalent(found.pool.score(by, found.pool.null_model(rest)), after)


def _stand_ins(pool: CandidateSet, others: Sequence[Candidate], chosen: Candidate) -> Stand:
    """Channels that were left out and do as well in the place of members: the others' sum, or nearly the same."""
    null_model = pool.null_model(others)
    offered = offered_for(pool, [*others, chosen], chosen.family.id)
    count = len(offered) + len(chosen.members)
    least = pool.score(together(pool, chosen.members, count), null_model).evidence - policy.POLICY.equivalent_nats
    found: Stand = {}
    for other in offered:
        swapped = ([other if m is one else m for m in chosen.members] for one in chosen.members)
        weights = [pool.score(together(pool, some, count), null_model).evidence for some in swapped]
        found[other] = [m for m, weight in zip(chosen.members, weights, strict=True) if weight >= least]
    return {other: places for other, places in found.items() if places}


def _name(chosen: Candidate, stand: Stand) -> str:
    """The set in words: its channels, those that depend on each other as `any 2 of a, b, c`."""
    free = [m.term.channels[0] for m in chosen.members]
    parts = list[str]()
    for other, places in stand.items():
        bound = [m.term.channels[0] for m in places]
        if len(places) > 1 and set(bound) <= set(free):
            free = [name for name in free if name not in bound]
            parts.append(f"any {len(bound)} of {', '.join([*bound, other.term.channels[0]])}")
    return " + ".join([*free, *parts])

"""Several channels that act at once: scored whole with the penalty for all their parameters, and pruned backward.

Of four loads or panels none carries half, and each alone leaves too much to be sure of (Springmann & Cutler 2011 have
five). A set begins with every channel of its kind and loses the weakest until each member left has the evidence of a
name beside all others; it is judged by what it leaves. Inside the search a set is one candidate; in the end its members
are reported one by one (`members`).
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from functools import partial
from math import comb, prod

import numpy as np
from numpy.typing import NDArray

from labcal.loop import policy
from labcal.loop.candidates.delay_scan import delay_scan
from labcal.loop.candidates.library import Candidate, Cause, Span
from labcal.loop.candidates.refine import refined
from labcal.loop.candidates.scorer import CandidateSet, Scored
from labcal.loop.noise.coloured import NullModel
from labcal.loop.noise.nuisance import MIN_NEW_SHARE, explained_squares
from labcal.loop.noise.whitening import WhitenedNull
from labcal.loop.parallel import parallel_map
from labcal.loop.selection.admission import material_beside
from labcal.loop.selection.related import related_columns
from labcal.model.effects import Scene, Term

Array = NDArray[np.float64]


def together(pool: CandidateSet, members: Sequence[Candidate], offered: int) -> Candidate:
    """One candidate of several `members`, chosen among so many `offered`; a single one is itself."""
    if len(members) == 1:
        return members[0]

    def made() -> Candidate:
        trials = prod(one.trials for one in members) * comb(max(offered, len(members)), len(members))
        return Candidate(members[0].family, _joined([one.term for one in members]), trials, tuple(members))

    return pool.cached(("together", offered), members, made)


def _joined(terms: Sequence[Term]) -> Term:
    parameters = tuple((f"{term.channels[0]} {name}", unit) for term in terms for name, unit in term.parameters)
    channels = tuple(name for term in terms for name in term.channels)
    zeros = {name: value for term in terms for name, value in term.reference_value.items()}
    return Term(partial(_side_by_side, tuple(terms)), parameters, channels, zeros)


def _side_by_side(terms: Sequence[Term], term: Term, scene: Scene) -> Array:
    return np.concatenate([one.columns(scene) for one in terms], axis=2)


def best_set(pool: CandidateSet, accepted: Sequence[Candidate], refused: Collection[Cause] = ()) -> Scored | None:
    """The set of most evidence beside what is accepted, two members at least; None where there is none."""
    closed = {effect for effect, channels in refused if len(channels) > 1}
    adding = {c.family.id for c in pool.candidates if c.family.adds_up} - closed
    found = [s for effect in sorted(adding) if (s := _set_of(pool, accepted, effect)) is not None]
    return max(found, key=lambda s: s.evidence, default=None)


def _set_of(pool: CandidateSet, accepted: Sequence[Candidate], effect: str) -> Scored | None:
    def made() -> Scored | None:
        offered = offered_for(pool, accepted, effect)
        if len(offered) < 2:
            return None
        null_model = pool.null_model(accepted, related_columns(pool, accepted))
        members = _pruned(pool, null_model, offered)
        if len(members) > 1:
            members = earning(pool, accepted, _in_best_form(pool, accepted, members))
        return pool.score(together(pool, members, len(offered)), null_model) if len(members) > 1 else None

    return pool.cached(("set of", effect), accepted, made)


def offered_for(pool: CandidateSet, accepted: Sequence[Candidate], effect: str) -> list[Candidate]:
    """The plainest candidate of each channel of this effect that nothing accepted follows yet."""
    taken = {part.term.channels for c in accepted for part in c.parts}
    smallest = dict[Cause, Candidate]()
    for c in pool.candidates:
        known = smallest.get(c.cause)
        if c.family.id == effect and c.term.channels not in taken and (known is None or c.size < known.size):
            smallest[c.cause] = c
    return list(smallest.values())


def _pruned(pool: CandidateSet, null_model: NullModel, offered: Sequence[Candidate]) -> list[Candidate]:
    """Those that have the evidence of a name beside each other, under the noise that all together leave."""
    columns = [pool.transformed_columns(c) for c in offered]
    X = np.concatenate(columns, axis=2)
    whole, _ = null_model.with_columns(X)
    schur, xty = WhitenedNull.of(null_model, whole.spectrum).normal_equations(X)
    per_square = 0.5 * (null_model.null.level / whole.level) ** 2
    ends = np.cumsum([0, *(part.shape[2] for part in columns)])
    kept = list(range(len(offered)))

    def gain(some: Sequence[int]) -> float:
        at = np.concatenate([np.arange(ends[i], ends[i + 1]) for i in some])
        return per_square * float(explained_squares(schur[np.ix_(at, at)], xty[at], MIN_NEW_SHARE)[0][0])

    while len(kept) > 1:
        all_of_them = gain(kept)
        penalties = [pool.penalty(offered[i], columns[i].shape[2]) for i in kept]
        own = [all_of_them - gain([j for j in kept if j != i]) - p for i, p in zip(kept, penalties, strict=True)]
        if min(own) >= policy.POLICY.min_evidence:
            break
        del kept[int(np.argmin(own))]
    return [offered[i] for i in kept]


def _in_best_form(pool: CandidateSet, accepted: Sequence[Candidate], members: Sequence[Candidate]) -> list[Candidate]:
    """Each at its best form beside the others: at once, behind, late."""
    formed = list(members)
    for place, one in enumerate(members):
        others = [*accepted, *formed[:place], *formed[place + 1 :]]
        forms = [c for c in (*pool.candidates, *delay_scan(pool, others)) if c.cause == one.cause]
        formed[place] = refined(pool, pool.rank(forms, others)[0].candidate, others)
    return formed


def earning(pool: CandidateSet, accepted: Sequence[Candidate], members: Sequence[Candidate]) -> list[Candidate]:
    """The members that are material and have the evidence of a name beside the others.

    All forms of what is accepted and of the strongest other member stand beside each: a remainder of its form is no
    other member's. All forms of all members would together follow whatever any of them does.
    """
    kept = list(members)
    while len(kept) > 1:
        each = parallel_map(partial(_evidence_beside, pool, accepted, kept, _two_strongest(pool, accepted, kept)), kept)
        failing = [(evidence, i) for i, (evidence, enough) in enumerate(each) if not enough]
        if not failing:
            break
        del kept[min(failing)[1]]
    return kept


def _two_strongest(
    pool: CandidateSet, accepted: Sequence[Candidate], kept: Sequence[Candidate]
) -> tuple[Candidate, Candidate]:
    """The members that take most off the residual beside the others, the strongest first."""
    first, second, *_ = sorted(kept, key=lambda one: -_beside(pool, accepted, kept, one, ()).drop)
    return first, second


def _beside(
    pool: CandidateSet, accepted: Sequence[Candidate], kept: Sequence[Candidate], one: Candidate, spans: Sequence[Span]
) -> Scored:
    """One of the members beside all others."""
    others = [*accepted, *(m for m in kept if m is not one)]
    return pool.score(one, pool.null_model(others, spans))


def _evidence_beside(
    pool: CandidateSet,
    accepted: Sequence[Candidate],
    kept: Sequence[Candidate],
    strongest: tuple[Candidate, Candidate],
    one: Candidate,
) -> tuple[float, bool]:
    """The evidence for a member, and whether it is enough."""
    spans = related_columns(pool, [*accepted, strongest[one is strongest[0]]])
    found = _beside(pool, accepted, kept, one, spans)
    others = [*accepted, *(m for m in kept if m is not one)]
    least = material_beside(pool, pool.null_model(others, spans))
    return found.evidence, found.evidence >= policy.POLICY.min_evidence and found.drop >= least


def pruned_beside(pool: CandidateSet, others: Sequence[Candidate], chosen: Candidate) -> Candidate:
    """A set without the members that no longer earn their place beside the `others`; itself where all do."""
    if not chosen.members:
        return chosen
    kept = earning(pool, others, chosen.members)
    return chosen if len(kept) == len(chosen.members) else together(pool, kept, len(chosen.members))

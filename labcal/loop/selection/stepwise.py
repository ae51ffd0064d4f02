"""Stepwise selection: an effect is added, and those already accepted are tested again beside it.

A second cause has to explain what a more flexible version of the first one cannot: beside every accepted effect stand
all other candidates of its family on the same channels. So the misfit of a form that is not quite the device's own is
not given another name.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import replace

import numpy as np

from labcal.loop import policy
from labcal.loop.candidates.available import all_candidates
from labcal.loop.candidates.library import Candidate, Cause
from labcal.loop.candidates.refine import refined
from labcal.loop.candidates.scorer import CandidateSet, Scored
from labcal.loop.parallel import parallel_map
from labcal.loop.selection.admission import (
    earns_its_extension,
    evidence_beside_likely_forms,
    evidence_of_its_own,
    is_its_own,
    material_beside,
    min_material_drop,
    plain_evidence,
)
from labcal.loop.selection.misfit import gain_of
from labcal.loop.selection.pairs import score_pairs
from labcal.loop.selection.related import related_columns
from labcal.loop.selection.sets import best_set, pruned_beside
from labcal.loop.selection.time_or_channel import is_of_time

MAX_EFFECTS = 3  # effects accepted at most
NEAREST = 8  # causes that are scored beside what the accepted effects' forms are likely to do
NEARLY_WHITE = 1.5  # times the white level: no frequency of the noise left has more


def stepwise_forward(
    pool: CandidateSet, most: int = MAX_EFFECTS, refused: Collection[Cause] = (), later: Collection[Cause] = ()
) -> tuple[list[Candidate], list[list[Scored]]]:
    """The causes accepted, in order, and the ranking at each step.

    Those `refused` are not taken, and those `later` not as the first.
    """
    accepted: list[Candidate] = []
    rankings: list[list[Scored]] = []
    out_of_play, left = set(refused), set[Cause]()
    while len(accepted) < most:
        pool.tell(pool, accepted, "every effect")
        open_to = [c for c in all_candidates(pool, accepted) if not _already_accepted(c, accepted)]
        if accepted and _is_white(pool, accepted) and not _is_likely(at_last := pool.rank(open_to, accepted)):
            rankings.append(at_last)
            break
        ranking = pool.rank(open_to, accepted, related_columns(pool, accepted))
        rankings.append(ranking)
        barred = out_of_play if accepted else {*out_of_play, *later}
        best = best_admissible(pool, accepted, [w for w in ranking if w.candidate.cause not in barred])
        best = best or best_beside_likely_forms(pool, accepted, [c for c in open_to if c.cause not in barred])
        whole = best_set(pool, accepted, barred)
        if whole is not None and whole.evidence > max(best.evidence if best else 0.0, policy.POLICY.min_evidence):
            best, rankings[-1] = whole, [whole, *ranking]
        if best is None:
            both = _material_pair(pool, accepted, ranking, out_of_play) if len(accepted) + 2 <= most else []
            accepted = [*accepted, *both]
            if not both:
                break
            continue
        chosen = refined(pool, best.candidate, accepted)
        kept = backward_check(pool, [*accepted, chosen])
        if chosen in kept:
            gone = {c.cause for c in accepted if c not in kept}
            out_of_play |= gone & left  # what leaves for the second time would alternate for ever
            accepted, left = kept, left | gone
        else:
            out_of_play.add(best.candidate.cause)
    return accepted, rankings


def _is_white(pool: CandidateSet, accepted: Sequence[Candidate]) -> bool:
    """Whether the accepted effects leave nearly white noise."""
    null_model = pool.null_model(accepted)
    return float(null_model.bands.spectra[null_model.null.spectrum].max()) < NEARLY_WHITE


def _is_likely(ranking: Sequence[Scored]) -> bool:
    """Whether the first has half the evidence of a name."""
    return ranking[0].evidence >= policy.POLICY.min_evidence / 2


def _material_pair(
    pool: CandidateSet,
    accepted: Sequence[Candidate],
    ranking: Sequence[Scored],
    refused: Collection[Cause],
) -> list[Candidate]:
    """Two causes that are material together, each earning its place beside the other; none where no two do."""
    pool.tell(pool, accepted, "pairs that hide each other")
    null_model = pool.null_model(accepted, related_columns(pool, accepted))
    open_to = [w for w in ranking if not _already_accepted(w.candidate, accepted)]
    for pair in score_pairs(pool, null_model, open_to, {*refused, *(c.cause for c in accepted)}):
        if pair.evidence < policy.POLICY.min_evidence or pair.drop < min_material_drop(pool, accepted):
            continue
        one = refined(pool, pair.one, [*accepted, pair.other])
        both = [one, refined(pool, pair.other, [*accepted, one])]
        each = (plain_evidence(pool, [*accepted, *(o for o in both if o is not c)], c) for c in both)
        if any(nats < policy.POLICY.min_evidence for nats in each):
            continue
        if backward_check(pool, [*accepted, *both])[-2:] == both:
            return both
    return []


def best_admissible(pool: CandidateSet, accepted: Sequence[Candidate], ranking: list[Scored]) -> Scored | None:
    """The best that is material and earns its place."""
    least = min_material_drop(pool, accepted)
    fit = (w for w in ranking if w.drop >= least and w.evidence >= policy.POLICY.min_evidence)
    earning = (w if earns_its_extension(pool, accepted, w) else _begun_where_it_is(pool, accepted, w) for w in fit)
    own = (w for w in earning if w is not None and w.drop >= least and is_its_own(pool, accepted, w))
    return next((w for w in own if is_of_time(pool, accepted, w.candidate)), None)


def best_beside_likely_forms(
    pool: CandidateSet, accepted: Sequence[Candidate], open_to: Sequence[Candidate]
) -> Scored | None:
    """The best that is material and earns its place where the accepted effects have likely forms, not any at all.

    It has to lead by the evidence of a name over what these forms may still do beside it: else they may be what it is.
    """
    forms = related_columns(pool, accepted, common=True)
    if not forms:
        return None
    least, law = material_beside(pool, pool.null_model(accepted)), policy.POLICY
    near = [w for w in pool.rank(open_to, accepted)[:NEAREST] if w.evidence >= law.min_evidence and w.drop >= least]
    own = [replace(w, evidence=evidence_beside_likely_forms(pool, accepted, w.candidate)) for w in near]
    sure = sorted((w for w in own if w.evidence >= law.min_evidence), key=lambda w: -w.evidence)
    leads = (
        w for w in sure if gain_of(pool.null_model([*accepted, w.candidate]), forms) <= w.evidence - law.min_evidence
    )
    earning = (w for w in leads if earns_its_extension(pool, accepted, w) and is_its_own(pool, accepted, w))
    return next((w for w in earning if is_of_time(pool, accepted, w.candidate)), None)


def _begun_where_it_is(pool: CandidateSet, accepted: Sequence[Candidate], found: Scored) -> Scored | None:
    """The best form of the same cause that may not begin anywhere in each segment; None where that is no name.

    A cause is not refused because a form of it explains what only differs from segment to segment.
    """
    if not found.candidate.term.of_beginnings:
        return None
    alike = [c for c in pool.candidates if c.cause == found.candidate.cause and not c.term.of_beginnings]
    best = pool.rank(alike, accepted, related_columns(pool, accepted))[:1]
    sure = (w for w in best if w.evidence >= policy.POLICY.min_evidence and earns_its_extension(pool, accepted, w))
    return next(sure, None)


def _already_accepted(candidate: Candidate, accepted: Sequence[Candidate]) -> bool:
    """The same cause twice; steps and periods may come twice, at another time or frequency."""
    return not candidate.family.repeats and any(is_same_source(c, candidate) for c in accepted)


def is_same_source(one: Candidate, other: Candidate) -> bool:
    """Whether `other` is the same cause as `one`, or its current or square: a detail of the same load."""
    return any(
        b.term.channels == a.term.channels and b.family.id in (a.family.id, *a.family.related)
        for a in one.parts
        for b in other.parts
    )


def backward_check(pool: CandidateSet, accepted: list[Candidate]) -> list[Candidate]:
    """Those that still have the evidence of a name beside the others and all that their forms may miss.

    Of sets the members that have.
    """

    def evidence(chosen: Candidate) -> float:
        return evidence_of_its_own(pool, [c for c in accepted if c is not chosen], chosen)

    if len(accepted) > 1 and any(c.members for c in accepted):
        accepted = [pruned_beside(pool, [o for o in accepted if o is not c], c) for c in accepted]
    while len(accepted) > 1:
        each = parallel_map(evidence, accepted)
        weakest = int(np.argmin(each))
        if each[weakest] >= policy.POLICY.min_evidence:
            break
        accepted = [c for i, c in enumerate(accepted) if i != weakest]
    return accepted

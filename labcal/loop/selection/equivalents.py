"""Equivalent models: which other causes explain the run as well in the place of an accepted one."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import dataclass, replace

import numpy as np

from labcal.loop import policy
from labcal.loop.candidates.available import all_candidates, related_candidates
from labcal.loop.candidates.library import Candidate, Cause
from labcal.loop.candidates.refine import refined
from labcal.loop.candidates.scorer import CandidateSet, Scored
from labcal.loop.noise.nuisance import orthonormal, squares_beside
from labcal.loop.selection.admission import earns_its_extension
from labcal.loop.selection.crossval import BlockFolds, HeldOutErrors, cross_validate, fixed_choice
from labcal.loop.selection.misfit import evidence_beside_misfit, mistimed
from labcal.loop.selection.related import related_columns
from labcal.loop.selection.stepwise import is_same_source

MAX_TRIED = 4  # causes that are tried on held-out data


@dataclass(frozen=True, slots=True, eq=False)
class Equivalent:
    """A cause in the place of an accepted one, and the held-out rms that it reaches."""

    scored: Scored
    after_nT: float


def equivalent_models(
    pool: CandidateSet, blocks: BlockFolds, accepted: Sequence[Candidate], chosen: Candidate
) -> list[Equivalent]:
    """`chosen`, and the causes that are not worse in its place on held-out data either."""
    out: list[Equivalent] = []
    others = [c for c in accepted if c is not chosen]
    first, *rest = equally_likely(pool, accepted, chosen)
    apart = [w for w in rest if not is_the_same_here(pool, others, chosen, w.candidate)]
    for w in [first, *apart][: MAX_TRIED + 1]:
        mine = chosen if w.candidate.cause == chosen.cause else w.candidate
        swapped = in_place_of(accepted, chosen, mine)
        either = cross_validate(pool, blocks, fixed_choice(swapped), accepted)
        if not out or not_worse(either):
            out.append(Equivalent(w, either.after))
    return out


def in_place_of(accepted: Sequence[Candidate], chosen: Candidate, other: Candidate) -> list[Candidate]:
    """The effects with `other` for `chosen`, or beside it where it extends that."""
    if chosen.family.id in other.family.extends:
        return [*accepted, other]
    return [other if one is chosen else one for one in accepted]


def is_the_same_here(pool: CandidateSet, others: Sequence[Candidate], chosen: Candidate, other: Candidate) -> bool:
    """Whether a related form in the same channels does what `chosen` does on these rows, but for a detail.

    A load that is on or off has no square of its own: with the device's offset it is the load, whatever the noise.
    """
    if other.term.channels != chosen.term.channels or other.family.id not in chosen.family.related:
        return False
    beside = [pool.base, *(pool.transformed_columns(c) for c in others)]
    with_chosen = [*beside, pool.transformed_columns(chosen)]
    own = pool.transformed_columns(other)
    whole, left = (squares_beside(orthonormal(np.concatenate(s, axis=2)), own) for s in (beside, with_chosen))
    return left < policy.POLICY.material_share * whole


def not_worse(either: HeldOutErrors) -> bool:
    """Whether the effects after are as good as those before, or better on some bootstrap draws of the blocks."""
    return either.after <= policy.POLICY.equivalent_rms * either.before or either.improvement()[1] > 0


def equally_likely(pool: CandidateSet, accepted: Sequence[Candidate], chosen: Candidate) -> list[Scored]:
    """`chosen`, and the causes that are as likely in its place."""
    about = [chosen, *accepted]
    return pool.cached("equally likely", about, lambda: _equally_likely(pool, accepted, chosen))


def _equally_likely(pool: CandidateSet, accepted: Sequence[Candidate], chosen: Candidate) -> list[Scored]:
    others = [c for c in accepted if c is not chosen]
    open_to = _open_to(pool, others)
    related = [refined(pool, c, others) for c in _same_response(open_to, chosen)]
    lead = {c.cause: nats for c, nats in leads_over_relatives(pool, others, chosen)}
    inseparable = {cause for cause, nats in lead.items() if nats < policy.POLICY.equivalent_nats}
    near = within_reach(pool.rank([*open_to, *related, chosen], others), chosen, inseparable)
    if pool.problem.whole is not None and len(near) > 1:
        near = within_reach(pool.undecimated().rank([w.candidate for w in near], others), chosen, inseparable)
    apart = [
        w
        for w in near[1:]
        if not merely_contains(pool, others, chosen, w.candidate)
        or gives_another_map(pool, others, chosen, w.candidate)
    ]
    earning = [w for w in apart if earns_its_extension(pool, others, w)]
    known = {w.candidate.cause for w in earning}
    extensions = [w for w in plausible_extensions(pool, accepted, chosen) if w.candidate.cause not in known]
    return [near[0], *earning, *extensions]


def done_by_readings(pool: CandidateSet, others: Sequence[Candidate], chosen: Candidate) -> list[Candidate]:
    """Of those that take nearly all that one bound to the run's time does, who leave no more.

    Whatever leads: telemetry is rounded, held and late, and the clock is nothing of it. No more is what the noise would
    not be declared more closely for.
    """
    null = pool.null_model(others)
    at_most = policy.POLICY.equivalent_rms**2 * pool.score(chosen, null).likelihood.rss
    nearly = nearly_done_by_readings(pool, others, chosen)
    return [c for c in nearly if pool.score(c, null).likelihood.rss <= at_most]


def nearly_done_by_readings(pool: CandidateSet, others: Sequence[Candidate], chosen: Candidate) -> list[Candidate]:
    """The sensor's causes that follow a channel and take all that one bound to the run's time does, but for a detail.

    By no more parameters, for with enough of them anything does what a step does; a detail is no material share of what
    is taken. What a drift does better then, it may do because telemetry is rounded, held and late.
    """
    if not chosen.family.bound_to_run:
        return []

    def made() -> list[Candidate]:
        null = pool.null_model(others)
        enough = (1 - policy.POLICY.material_share) * pool.score(chosen, null).drop
        channels = [c for c in _open_to(pool, others) if _is_of_readings(c) and c.size <= chosen.size]
        ranked = sorted(pool.rank(channels, others), key=lambda w: -w.drop)[:MAX_TRIED]
        found = (refined(pool, w.candidate, others) for w in ranked)
        return [c for c in found if pool.score(c, null).drop >= enough]

    return pool.cached("readings", [chosen, *others], made)


def _is_of_readings(one: Candidate) -> bool:
    return bool(one.term.channels) and not one.family.bound_to_run and one.belongs_to != "rig"


def _open_to(pool: CandidateSet, others: Sequence[Candidate]) -> list[Candidate]:
    """All candidates but those of a source that is accepted already."""
    return [c for c in all_candidates(pool, others) if not any(is_same_source(o, c) for o in others)]


def leads_over_relatives(
    pool: CandidateSet, others: Sequence[Candidate], chosen: Candidate
) -> list[tuple[Candidate, float]]:
    """Causes of a related form in the same channels, at their best, and how far `chosen` leads over each [nats].

    Beside what both may miss in time: a form that fits a little better because it takes some of the other's delay has
    no lead by that.
    """

    def made() -> list[tuple[Candidate, float]]:
        found = [refined(pool, c, others) for c in best_relatives(pool, others, chosen)]
        return [(c, lead_beside_misfit(pool, others, chosen, c)) for c in found]

    return pool.cached("relatives", [chosen, *others], made)


def lead_beside_misfit(pool: CandidateSet, others: Sequence[Candidate], chosen: Candidate, other: Candidate) -> float:
    """How much more evidence `chosen` has than `other` where either may come earlier, later or smeared [nats].

    Not bent in its channels: that would make the one of the other, and which of the two it is, is what is asked.
    """
    missed = mistimed(pool, [chosen, other])
    one, two = (evidence_beside_misfit(pool, others, c, missed) for c in (chosen, other))
    return one - two


def best_relatives(pool: CandidateSet, others: Sequence[Candidate], chosen: Candidate) -> list[Candidate]:
    """Causes of a related form in the same channels, the likeliest first."""
    related = related_candidates(pool, others, chosen)
    return [w.candidate for w in pool.rank(related, others)] if related else []


def merely_contains(pool: CandidateSet, others: Sequence[Candidate], chosen: Candidate, larger: Candidate) -> bool:
    """Whether `larger` can do all that `chosen` does, and has no evidence for what else it can.

    Iron that answers by any tensor turns the field as a tilted axis does: what is a turn alone is no iron.
    """
    if pool.score(chosen, pool.null_model([*others, larger])).rank:
        return False
    more = pool.score(larger, pool.null_model([*others, chosen]))
    return more.rank > 0 and more.evidence < policy.POLICY.min_evidence


def gives_another_map(pool: CandidateSet, others: Sequence[Candidate], chosen: Candidate, other: Candidate) -> bool:
    """Whether the sensor's map beside `other` is off from that beside `chosen` by what no longer counts as noise.

    Then it matters which of the two it is, however little a run tells them apart.
    """
    of_the_map = pool.problem.T[:, :, : pool.problem.T.shape[2] - len(pool.problem.phase_groups)]
    either = (pool.coefficients([*others, c])[: of_the_map.shape[2]] for c in (chosen, other))
    one, two = (of_the_map[pool.rows] @ x for x in either)
    left = pool.residual([*others, chosen])[pool.rows]
    return bool(np.mean((one - two) ** 2) > (policy.POLICY.floor_ratio**2 - 1) * np.mean(left**2))


def plausible_extensions(pool: CandidateSet, accepted: Sequence[Candidate], chosen: Candidate) -> list[Scored]:
    """Causes that extend `chosen` and whose own part is more probable than not; a certain one must be material."""
    larger = [c for c in pool.candidates if chosen.family.id in c.family.extends]
    causes = {c.cause for c in accepted}
    beside = pool.rank(larger, accepted, related_columns(pool, accepted)) if larger else []
    open_to = [w for w in beside if w.candidate.cause not in causes]
    law = policy.POLICY
    return [w for w in open_to if w.evidence > 0 and (w.evidence < law.min_evidence or w.drop >= law.material_share)]


def _same_response(candidates: Sequence[Candidate], chosen: Candidate) -> list[Candidate]:
    """Of a current or its square that acts slowly, the other one, to be refined from the same time constant."""
    shape = {s.name: s.value for s in chosen.term.shape}
    related = [
        c for c in candidates if c.family.id in chosen.family.related and c.term.channels == chosen.term.channels
    ]
    alike = {len(c.term.parameters): c for c in related if shape and {s.name for s in c.term.shape} == shape.keys()}
    return [replace(c, term=c.term.with_values(**shape)) for c in alike.values()]


def within_reach(ranking: Sequence[Scored], chosen: Candidate, inseparable: Collection[Cause]) -> list[Scored]:
    """`chosen`, what has nearly its evidence, and causes that count as near `inseparable`."""
    own = next(w for w in ranking if w.candidate.cause == chosen.cause)
    others = (w for w in ranking if w.candidate.cause != chosen.cause)
    least = _g_prior_evidence(own) - policy.POLICY.equivalent_nats
    return [own, *(w for w in others if _g_prior_evidence(w) > least or w.candidate.cause in inseparable)]


def lead_of(one: Scored, other: Scored) -> float:
    """How much more evidence one model has than another of unlike size [nats]."""
    return _g_prior_evidence(one) - _g_prior_evidence(other)


def _g_prior_evidence(w: Scored) -> float:
    """Gain less a penalty for comparing models of unlike size [nats].

    Schwarz's penalty, one row's information for each parameter, would give a weak effect to the smaller of two models
    that fit as well. A g-prior at its likeliest g (Liang et al., JASA 103, 410, 2008, section 2.4) goes by the effect's
    own size.
    """
    size = w.rank + w.candidate.size - len(w.candidate.term.parameters)
    each = max(2 * w.gain / max(size, 1), 1.0)
    return float(w.gain - 0.5 * size * (1 + np.log(each)) - np.log(w.candidate.trials))

"""Selection of effects: stepwise, simplified, and refused again where held-out data do not support them."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Literal

from labcal.loop import policy
from labcal.loop.candidates.library import Candidate, Cause
from labcal.loop.candidates.refine import refined
from labcal.loop.candidates.scorer import CandidateSet, Scored
from labcal.loop.data.noise_floor import NoiseFloor
from labcal.loop.noise.autocorrelation import correlation_time_s
from labcal.loop.selection.crossval import (
    BlockFolds,
    HeldOutErrors,
    block_folds,
    cross_validate,
    fixed_choice,
    own_proof,
)
from labcal.loop.selection.equivalents import (
    best_relatives,
    done_by_readings,
    equally_likely,
    is_the_same_here,
    lead_of,
    leads_over_relatives,
    not_worse,
)
from labcal.loop.selection.exchanged import exchanged
from labcal.loop.selection.heldout_rules import first_unsupported, improves, is_sure_first
from labcal.loop.selection.sets import together
from labcal.loop.selection.stepwise import MAX_EFFECTS, backward_check, stepwise_forward

OUT_OF_REACH = 3.0  # times the rms that another candidate leaves: more is no matter of refinement
MAX_ROUNDS = 6  # of selection and refusal
RoundOutcome = Literal["supported", "displaced", "broken", "not first", "unsupported", "one too many"]  # of one round
SelectionEnding = Literal["supported", "rounds exhausted"]


@dataclass(frozen=True, slots=True, eq=False)
class Selection:
    """Effects that some rows show, and what each brings on blocks held out of those rows."""

    accepted: tuple[Candidate, ...]
    rankings: tuple[list[Scored], ...]
    contributions: tuple[HeldOutErrors, ...]  # of each accepted effect, those before it already in
    blocks: BlockFolds
    refused: Mapping[Cause, HeldOutErrors]  # causes that held-out data did not support, with their contributions
    ending: SelectionEnding
    barred: frozenset[Cause] = frozenset()  # causes that were not offered


@dataclass(frozen=True, slots=True, eq=False)
class _Round:
    """One pass of stepwise selection, simplified, with the contributions that it is judged by."""

    accepted: list[Candidate]
    rankings: list[list[Scored]]
    contributions: list[HeldOutErrors]
    blocks: BlockFolds
    displaced: set[Cause]  # selected, but without enough evidence in their simplest form; of sets no member is left
    broken: set[Cause]  # the first, where it is a set of which held-out blocks support some members only, or none

    def first(self, count: int) -> _Round:
        """The same with the first effects alone."""
        return replace(self, accepted=self.accepted[:count], contributions=self.contributions[:count])


def select(
    pool: CandidateSet,
    level: NoiseFloor,
    blocks: BlockFolds | None = None,
    most: int = MAX_EFFECTS,
    barred: frozenset[Cause] = frozenset(),
) -> Selection:
    """Select effects on the rows of `pool`, none of those `barred`, and refuse what blocks held out do not support.

    Each round has an outcome: `supported` ends the selection; `displaced` and `unsupported` causes are refused in
    the next round; of a cause that is there already `one too many` is cut off; a set that came first and is `broken` by
    held-out blocks may come again, but beside another cause; so may a first cause that another could take the place of,
    `not first`: beside that one it may have another form. When the rounds are exhausted, what the last one left stands;
    the members that were left of a broken set do where they are supported and no later round leaves less.
    """
    refused, unsupported, later = set(barred), dict[Cause, HeldOutErrors](), set[Cause]()
    ending: SelectionEnding = "rounds exhausted"
    members: _Round | None = None
    for _ in range(MAX_ROUNDS):
        last = _select_once(pool, blocks, most, refused, later)
        outcome, place = _judge(pool, last, level, later)
        if outcome == "supported":
            ending = "supported"
            break
        if outcome == "displaced":
            refused |= last.displaced
            continue
        if outcome == "one too many":
            most = place
        elif outcome == "broken":
            later |= last.broken
            members = last if members is None and place else members
        elif outcome == "not first":
            later.add(last.accepted[0].cause)
        else:
            refused.add(last.accepted[place].cause)
            unsupported[last.accepted[place].cause] = last.contributions[place]
        last = last.first(place)
    if members is not None and _left_nT(pool, members) < _left_nT(pool, last):
        last, ending = members, "supported"
    effects, rankings, contributions = tuple(last.accepted), tuple(last.rankings), tuple(last.contributions)
    return Selection(effects, rankings, contributions, last.blocks, unsupported, ending, barred)


def _select_once(
    pool: CandidateSet, blocks: BlockFolds | None, most: int, refused: Collection[Cause], later: Collection[Cause]
) -> _Round:
    accepted, rankings = stepwise(pool, most, refused, later)
    blocks = blocks or block_folds(pool.problem, correlation_time_s(pool.problem.scene.t_s, pool.residual(accepted)))
    accepted = exchanged(pool, blocks, accepted, rankings, refused)
    likelier = likelier_forms(pool, likeliest_own_forms(pool, accepted), refused)
    simple = _simplest(pool, blocks, prefer_computable(pool, blocks, likelier, refused))
    kept = _proven_members(pool, blocks, backward_check(pool, list(simple)))
    contributions = [contribution(pool, blocks, kept, i) for i in range(len(kept))]
    lost = {c.cause for c in simple} - {c.cause for c in kept}
    left = {part for c in kept for part in c.parts}
    displaced = lost - {c.cause for c in simple if c.members and not left.isdisjoint(c.parts)}
    broken = {c.cause for c in simple[:1] if c.members} & lost
    return _Round(kept, rankings, contributions, blocks, displaced, broken)


def _proven_members(pool: CandidateSet, blocks: BlockFolds, accepted: list[Candidate]) -> list[Candidate]:
    """The same with those members of sets alone that blocks held out support, the other members in."""
    out = []
    for chosen in accepted:
        others = [c for c in accepted if c is not chosen]
        good = [m for m in chosen.members if improves(own_proof(pool, blocks, others, chosen.members, m))]
        whole = len(good) == len(chosen.members)
        out += [chosen] if whole else [together(pool, good, len(chosen.members))] if good else []
    return out


def _left_nT(pool: CandidateSet, last: _Round) -> float:
    """What the effects of a round leave of held-out blocks."""
    return cross_validate(pool, last.blocks, fixed_choice(last.accepted)).after


def _judge(pool: CandidateSet, last: _Round, level: NoiseFloor, later: Collection[Cause]) -> tuple[RoundOutcome, int]:
    """What a round comes to, and the place of the effect that it fails at; of a broken set how many effects stand."""
    accepted, contributions = last.accepted, last.contributions
    place = first_unsupported(pool, accepted, contributions, level)
    if place is None and not is_sure_first(pool, last.blocks, accepted, contributions, level):
        if accepted[0].cause not in later:
            return "not first", 0
        place = 0
    if last.broken.difference(later) and not place:
        return "broken", 0 if place is not None else len(accepted)
    if place is None:
        return ("displaced" if last.displaced else "supported"), len(accepted)
    again = accepted[place].cause in {c.cause for c in accepted[:place]}
    return ("one too many" if again else "unsupported"), place


def stepwise(
    pool: CandidateSet, most: int = MAX_EFFECTS, refused: Collection[Cause] = (), later: Collection[Cause] = ()
) -> tuple[list[Candidate], list[list[Scored]]]:
    """Stepwise selection on these rows, done once."""
    key = "forward", most, frozenset(refused), frozenset(later)
    return pool.cached(key, (), lambda: stepwise_forward(pool, most, refused, later))


def contribution(pool: CandidateSet, blocks: BlockFolds, accepted: Sequence[Candidate], place: int) -> HeldOutErrors:
    """Held-out errors without and with one effect, those before it in; with more after it where only all improve.

    Of effects that hide each other none brings anything without the others.
    """
    before, rest = list(accepted[:place]), list(accepted[place + 1 :])
    alone = cross_validate(pool, blocks, fixed_choice([*before, accepted[place]]), before)
    if improves(alone):
        return alone
    for count in range(1, len(rest) + 1):
        also = rest[:count]
        beside = cross_validate(pool, blocks, fixed_choice([*before, accepted[place], *also]), [*before, *also])
        if improves(beside):
            return beside
    return alone


def likeliest_own_forms(pool: CandidateSet, accepted: list[Candidate]) -> list[Candidate]:
    """Each effect by the form of the same cause that leads beside the others, which were not all there when it came."""
    for place, chosen in enumerate(accepted):
        others = [*accepted[:place], *accepted[place + 1 :]]
        own = [c for c in pool.candidates if c.cause == chosen.cause] if others and not chosen.members else []
        if not own:
            continue
        null_model = pool.null_model(others)
        best = max(pool.score_each(own, null_model), key=lambda w: w.evidence).candidate
        best = refined(pool, best, others)
        one, two = (pool.score(c, null_model).evidence for c in (best, chosen))
        if one > two + policy.POLICY.equivalent_nats:
            accepted = [*accepted[:place], best, *accepted[place + 1 :]]
    return accepted


def likelier_forms(pool: CandidateSet, accepted: list[Candidate], refused: Collection[Cause]) -> list[Candidate]:
    """Each effect, or a related form in the same channels that leads over it beside what the forms of both may miss.

    A member of a set for which another form does so leaves it, for the two are no longer of one kind.
    """
    for one in accepted:
        for part in one.parts:
            whole = next(c for c in accepted if part in c.parts)
            rest = [p for p in whole.parts if p is not part]
            left = [together(pool, rest, len(whole.parts))] if rest else []
            place = accepted.index(whole)
            others = [*accepted[:place], *left, *accepted[place + 1 :]]
            leads = [(c, nats) for c, nats in leads_over_relatives(pool, others, part) if c.cause not in refused]
            other, nats = min(leads, key=lambda pair: pair[1], default=(part, 0.0))
            if nats < -policy.POLICY.equivalent_nats:
                accepted = [*accepted[:place], *left, other, *accepted[place + 1 :]]
    return accepted


def prefer_computable(
    pool: CandidateSet, blocks: BlockFolds, accepted: list[Candidate], refused: Collection[Cause]
) -> list[Candidate]:
    """Of equivalent causes, on held-out data too, the one that can be computed from readings alone.

    A channel without a physical mechanism goes last; what extends a cause goes after it. Equivalent is as well what is
    the same here: a few rows between the levels of a load do not make it the load's square, nor do rounded readings of
    a channel make a drift of what follows it. What is far likelier goes before the rig, and before what follows time.
    """
    for place, one in enumerate(accepted):
        if not (any(_preference(one)) or one.family.extends):
            continue  # nothing goes before it: what does as well need not be known
        others = [c for c in accepted if c is not one]
        own, *rest = equally_likely(pool, accepted, one)
        ahead = sorted(((lead_of(w, own), w.candidate) for w in rest), key=lambda pair: -pair[0])
        likelier = [c for nats, c in ahead if nats > policy.POLICY.equivalent_nats and _preference(one)[0]]
        equals = [w.candidate for w in rest]
        equals += [c for c in best_relatives(pool, others, one) if is_the_same_here(pool, others, one, c)]
        equals += done_by_readings(pool, others, one)
        before = [c for c in equals if _goes_before(c, one)]
        for other in (*likelier, *sorted(before, key=_preference)):
            if other.cause in refused:
                continue
            swapped = [*accepted[:place], refined(pool, other, others), *accepted[place + 1 :]]
            if not_worse(cross_validate(pool, blocks, fixed_choice(swapped), accepted)):
                accepted = swapped
                break
    return accepted


def _simplest(pool: CandidateSet, blocks: BlockFolds, accepted: list[Candidate]) -> list[Candidate]:
    """Each cause by its simplest candidate that is not worse on held-out data: a detail of this run alone misleads.

    Nor worse than the next larger one, which may be better than both.
    """
    for place, chosen in enumerate(accepted):
        others = [c for c in accepted if c is not chosen]
        rms_nT, found = float("inf"), accepted
        for candidate in _simpler_candidates(pool, chosen, others):
            simple = [*accepted[:place], candidate, *accepted[place + 1 :]]
            richer = cross_validate(pool, blocks, fixed_choice(accepted), simple)
            not_worse_than = richer.after if found is accepted else rms_nT / policy.POLICY.equivalent_rms**2
            if richer.before <= policy.POLICY.equivalent_rms * not_worse_than:
                rms_nT, found = richer.before, simple
            elif found is not accepted:
                break
        accepted = found
    return accepted


def _simpler_candidates(pool: CandidateSet, chosen: Candidate, others: Sequence[Candidate]) -> Iterator[Candidate]:
    """The best candidate of the same cause of each smaller size, smallest first; none that fits far worse."""
    smaller = [c for c in pool.candidates if c.cause == chosen.cause and c.size < chosen.size]
    smaller += _as_fitted(pool, chosen, others)
    null_model = pool.null_model(others)
    enough = pool.score(chosen, null_model).likelihood.rss * OUT_OF_REACH**2
    for size in sorted({c.size for c in smaller}):
        best = max(pool.score_each([c for c in smaller if c.size == size], null_model), key=lambda w: w.evidence)
        if best.likelihood.rss < enough:
            yield refined(pool, best.candidate, others)


def _as_fitted(pool: CandidateSet, chosen: Candidate, others: Sequence[Candidate]) -> list[Candidate]:
    """The smaller form that the fitted parameters come to: a grid may have no point near it."""
    fitted = pool.coefficients([*others, chosen])[-len(chosen.term.parameters) :]
    term = chosen.family.simpler(chosen.term, fitted)
    if term is None:
        return []
    alike = [c for c in pool.candidates if c.cause == chosen.cause and c.term.parameters == term.parameters]
    near = next((c for c in alike if len(c.term.shape) == len(term.shape)), None)
    if near is None:
        return []
    grids = {shape.name: shape.grid for shape in near.term.shape}
    shapes = tuple(replace(shape, grid=grids[shape.name]) for shape in term.shape)
    return [replace(near, term=replace(term, shape=shapes))]


def _goes_before(other: Candidate, one: Candidate) -> bool:
    """Whether `other` is preferred to `one`: also the special case of it, which needs less of the run's past."""
    by_kind, own = _preference(other), _preference(one)
    return by_kind < own or (by_kind == own and other.family.id in one.family.extends)


def _preference(candidate: Candidate) -> tuple[int, bool]:
    """Low goes first: what readings alone correct, then channels without a mechanism, then the rig's and time's."""
    kind = 1 if candidate.family.generic else 0
    if candidate.family.bound_to_run or candidate.belongs_to == "rig":
        kind = 2  # neither is in what the device reads later: the likelier of two
    return kind, candidate.family.second_order

"""Which effects are accepted, what proves each on held-out data, and which others would do as well."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from labcal.loop.bins import binned
from labcal.loop.correlation import correlation_s
from labcal.loop.decide import MATERIAL, MOST, Cause, forward, looks, reexamined, refined
from labcal.loop.floor import Floor
from labcal.loop.holdout import HeldOut, Plan, always, held_out, plan
from labcal.loop.problem import Problem
from labcal.loop.refit import refit
from labcal.loop.rivals import AS_GOOD, AT_FLOOR, Contender, as_good, as_well, rivals_of
from labcal.loop.search import Candidate, Search, Weighed, expand
from labcal.loop.setaside import farness, outliers
from labcal.loop.surrogates import by_chance
from labcal.model.effects.regressors import WEATHER, stretches

Array = NDArray[np.float64]
SHARE_OF_EXCESS = 0.75  # of the mean square above the noise that the effects together have to carry,
SHARE_WITH_CHANNELS = 0.5  # and where each of them follows a channel that somebody switches
REMAINS = 0.03  # of what all effects took away: as much left is an unnamed process, not a drift, a step or a mode,
HARMONICS = 0.1  # and as much is no line with its harmonics
REST = 1 / 3  # and as much of what a later cause took away shows that it took misfit of an earlier one's form
SECOND = 0.03  # of the fall of the mean square that all bring together: a second effect has to bring as much,
SECOND_OF_NOISE = 0.25  # or this part of the noise's square
NEAREST = 2  # causes of other physics that a doubtful one is held against
OUT_OF_REACH = 3.0  # times the rms that another look leaves: more is no matter of refinement
ANSWERS = 3  # names that an answer may hold in place of one
REFUSALS = 6  # causes refused on held-out data before the loop gives up


@dataclass(frozen=True, slots=True, eq=False)
class Choice:
    """Effects that the rows of one search show, and the proof of each on blocks held out of those rows."""

    accepted: tuple[Candidate, ...]
    rankings: tuple[list[Weighed], ...]
    steps: tuple[HeldOut, ...]  # of each accepted effect, those before it already in
    blocks: Plan
    refused: Mapping[Cause, HeldOut]  # proofs of those that were taken and given up


@dataclass(frozen=True, slots=True, eq=False)
class Evidence:
    """All that the verdict rests on."""

    search: Search
    bare: Search  # about the base's own map
    accepted: tuple[Candidate, ...]
    rankings: tuple[list[Weighed], ...]
    rivals: tuple[tuple[Contender, ...], ...]  # of each accepted effect, itself first
    honest: HeldOut
    steps: tuple[HeldOut, ...]  # of each accepted effect, those before it already in
    level: Floor
    blocks: Plan
    heaviest: Array  # of all candidates, on surrogates of what is left (sorted) [nats]
    refused: Mapping[Cause, HeldOut]  # proofs of causes that were taken and given up on held-out data
    far: float  # how far the rows that were set aside typically lie, in standard deviations of the others


def weighed(search: Search, level: Floor) -> Evidence:
    """Choose effects about the map that goes with them, and prove them."""
    around = settled(search)
    return proved(search, around, decided(around, level), level)


def proved(bare: Search, search: Search, choice: Choice, level: Floor) -> Evidence:
    """The proof of a choice: its error is told by choices that were made again without each held-out fold."""
    accepted, blocks = choice.accepted, choice.blocks
    while True:
        honest = held_out(search, blocks, repeated(level, blocks, len(accepted)))
        rivals = tuple(tuple(as_good(search, blocks, accepted, one)) for one in accepted)
        told = _told(search, honest, level, accepted, rivals)
        if told == len(accepted):
            break
        accepted = accepted[:told]
    honest = from_the_base(bare, search, blocks, honest)
    steps = choice.steps[: len(accepted)]
    far = farness(search.everywhere(accepted)[0], search.good)
    chance = by_chance(search, accepted)
    gone = {c.cause: step for c, step in zip(choice.accepted, choice.steps, strict=True)}
    refused = {**choice.refused, **gone}
    return Evidence(search, bare, accepted, choice.rankings, rivals, honest, steps, level, blocks, chance, refused, far)


def from_the_base(bare: Search, search: Search, blocks: Plan, honest: HeldOut) -> HeldOut:
    """The same held-out error, before which stands the base's own on the same rows, about its own map.

    About the map that goes with the effects the base would seem better than it is.
    """
    if search is bare or len(search.problem) != len(bare.problem):
        return honest
    own, before = held_out(bare.without(~search.good), blocks, always(())), np.zeros(len(honest.rows))
    before[own.rows] = own.before_nT
    return replace(honest, before_nT=before[honest.rows])


def decided(search: Search, level: Floor, blocks: Plan | None = None, most: int = MOST) -> Choice:
    """Choose effects on the rows of `search`, and refuse again those that do not help on blocks held out of them."""
    refused, proofs = set[Cause](), dict[Cause, HeldOut]()
    for _ in range(REFUSALS):
        accepted, rankings = _chosen(search, most, refused)
        apart = blocks or plan(search.problem, correlation_s(search, accepted))
        accepted = _preferred(search, apart, accepted, refused)
        plain = _plainer(search, apart, accepted)
        accepted = reexamined(search, list(plain))
        gone = {c.cause for c in plain} - {c.cause for c in accepted}
        steps = [_proof(search, apart, accepted, i) for i in range(len(accepted))]
        idle = _idle(search, accepted, steps, level)
        idle = _in_doubt(search, apart, accepted, steps, level) if idle is None else idle
        if idle is None and not gone:
            break
        if idle is None:  # what brings nothing in its plainer look gives its place to another
            refused |= gone
            continue
        if accepted[idle].cause in {c.cause for c in accepted[:idle]}:
            most = idle  # one more line or step of those there are: they stay
        else:
            refused.add(accepted[idle].cause)
            proofs[accepted[idle].cause] = steps[idle]
        accepted, steps = accepted[:idle], steps[:idle]
    return Choice(tuple(accepted), tuple(rankings), tuple(steps), apart, proofs)


def _chosen(
    search: Search, most: int = MOST, refused: Collection[Cause] = ()
) -> tuple[list[Candidate], list[list[Weighed]]]:
    return search.once(("forward", most, frozenset(refused)), (), lambda: forward(search, most, refused))


def repeated(level: Floor, blocks: Plan, most: int = MOST) -> Callable[[Search], Sequence[Candidate]]:
    """The whole choice again on a part of the rows, its own proofs on the blocks that are left."""
    return lambda part: decided(part, level, blocks.among(part.rows), most).accepted


def settled(search: Search) -> Search:
    """The search about the map that goes with the effects it finds, where the problem is not linear in the map.

    A magnitude is not: fitted without a strong effect, K and k are so far off that what is left of them looks like an
    effect of the field. Vectors are, but for the phases and the field that an effect follows.
    """
    accepted, _ = _chosen(search)
    if not accepted or (search.problem.kind == "vector" and not _bends(search, accepted)):
        return search
    around = refit(search.whole, [c.form for c in accepted], search.good)
    return without_outliers(search_of(around.uncorrected(), search.lowest), None if search.good.all() else ~search.good)


def _bends(search: Search, accepted: Sequence[Candidate]) -> bool:
    """Whether the effects, turned or grown as the base moves beside them, change by more than is worth a name."""
    whole, x = search.whole, search.solved(accepted)
    field = np.einsum("nqj,nj->nq", whole.whiten, whole.scene.field_nT)
    moved, added = whole.T @ x[: whole.T.shape[2]], search.everywhere(accepted)[1]
    return bool(np.mean(moved**2) * np.mean(added**2) > MATERIAL * np.mean(field**2))


def _proof(search: Search, blocks: Plan, accepted: Sequence[Candidate], place: int) -> HeldOut:
    """Held out without and with one effect, those before it in; the next one too where only both together help."""
    before, also = list(accepted[:place]), list(accepted[place + 1 : place + 2])
    step = held_out(search, blocks, always([*before, accepted[place]]), before)
    if _helps(step) or not also:
        return step
    return held_out(search, blocks, always([*before, accepted[place], *also]), [*before, *also])


def _idle(search: Search, accepted: Sequence[Candidate], steps: Sequence[HeldOut], level: Floor) -> int | None:
    """The first of the accepted effects that does not earn its name on held-out data; None where all do."""
    for i, step in enumerate(steps):
        if not (_helps(step) and _adds(steps[: i + 1], level)):
            return i
    for i, chosen in reversed(list(enumerate(accepted))):
        share = HARMONICS if chosen.family.harmonics else REMAINS
        mine = steps if level.source == "differences" else steps[_begins(accepted, i) :]
        if _vague(search, chosen) and _remains(mine, level, share):
            return i
    if level.source == "differences":
        return None
    later = ((i, _begins(accepted, i)) for i in range(len(steps) - 1, 0, -1))
    return next((i for i, begins in later if begins and _remains(steps[begins:], level, REST)), None)


def _begins(accepted: Sequence[Candidate], place: int) -> int:
    """Where the lines or steps begin of which this is one more: harmonics of one wave are one cause."""
    return next(i for i in range(place, -1, -1) if i == 0 or accepted[i - 1].cause != accepted[place].cause)


def _in_doubt(
    search: Search, blocks: Plan, accepted: Sequence[Candidate], steps: Sequence[HeldOut], level: Floor
) -> int | None:
    """The first accepted effect whose lead over other physics is smaller than what its own form misses; else None.

    Where no form reaches the noise, the one that comes nearest may do so by the accident of its shape.
    """
    missed = steps[-1].after ** 2 - level.nT**2 if steps else 0.0
    if not steps or level.source == "differences" or steps[-1].after <= AT_FLOOR * level.nT:
        return None
    for i, chosen in enumerate(accepted):
        for other in _other_physics(search, accepted, chosen) if _begins(accepted, i) == i else ():
            swapped = [other if c is chosen else c for c in accepted if c is chosen or c.cause != chosen.cause]
            if held_out(search, blocks, always(swapped)).after ** 2 - steps[-1].after ** 2 < missed:
                return i
    return None


def _other_physics(search: Search, accepted: Sequence[Candidate], chosen: Candidate) -> list[Candidate]:
    """The causes of other families that would take most off the residual in the place of `chosen`.

    Its rivals are none of them: they are named beside it.
    """
    others = [c for c in accepted if c is not chosen]
    named = {o.cause for o in others} | {w.candidate.cause for w in rivals_of(search, accepted, chosen)}
    kin = (chosen.family.id, *chosen.family.extends, *chosen.family.akin)
    strange = [
        c
        for c in looks(search, others)
        if c.family.id not in kin and chosen.family.id not in c.family.extends and c.cause not in named
    ]
    return [w.candidate for w in sorted(search.rank(strange, others), key=lambda w: -w.drop)[:NEAREST]]


def _vague(search: Search, chosen: Candidate) -> bool:
    """Whether any process in time, or a jump at each change of segment, would have some of the effect's shape."""
    scene = search.whole.scene
    if chosen.family.bound_to_run:
        return True
    columns = chosen.form.columns(scene)
    return not any(bool(np.ptp(columns[part], axis=0).any()) for part in stretches(scene.segment))


def _remains(steps: Sequence[HeldOut], level: Floor, share: float) -> bool:
    """Whether what is left after all effects is this share of what they took away, and more than noise."""
    before, after = steps[0].before, steps[-1].after
    return after > AT_FLOOR * level.nT and after**2 - level.nT**2 > share * (before**2 - after**2)


def _helps(step: HeldOut) -> bool:
    """Whether an effect lowers the held-out error, its whole interval above zero."""
    return step.improvement()[0] > 0


def _adds(steps: Sequence[HeldOut], level: Floor) -> bool:
    """Whether the last of some effects is more than a detail of those before it, on held-out data."""
    fall, total = (step.before**2 - steps[-1].after ** 2 for step in (steps[-1], steps[0]))
    return len(steps) == 1 or fall > min(SECOND * total, SECOND_OF_NOISE * level.nT**2)


def _carries(search: Search, honest: HeldOut, level: Floor, accepted: Sequence[Candidate]) -> bool:
    """Whether the effects carry most of what lies above the noise: less is no explanation, whatever its name.

    What is held up by channels alone may leave more: a form of another cause may look like a curve or a drift, or like
    the weather, but not like a load that somebody switches.
    """
    excess = honest.before**2 - level.nT**2
    share = SHARE_WITH_CHANNELS if all(_switched(search, c) for c in accepted) else SHARE_OF_EXCESS
    return honest.after <= AT_FLOOR * level.nT or honest.before**2 - honest.after**2 > share * excess


def _switched(search: Search, candidate: Candidate) -> bool:
    """Whether the effect follows a channel, and none that moves slowly of itself."""
    names, run = candidate.form.channels, search.whole.run
    return bool(names) and all(run.channel(name).quantity not in WEATHER for name in names)


def _told(
    search: Search,
    honest: HeldOut,
    level: Floor,
    accepted: Sequence[Candidate],
    rivals: Sequence[Sequence[Contender]],
) -> int:
    """How many of the accepted effects, from the first on, may be named.

    Not the last where they carry too little; nor, where they miss the noise, one that as many others stand in for as
    are no answer: whatever takes some of an unknown shape does as well there.
    """
    if not accepted or honest.after <= AT_FLOOR * level.nT:
        return len(accepted)
    if not _carries(search, honest, level, accepted):
        return len(accepted) - 1
    if level.source == "differences":
        return len(accepted)
    return next((i for i, contenders in enumerate(rivals) if len(contenders) > ANSWERS), len(accepted))


def search_of(problem: Problem, lowest: float) -> Search:
    """Every candidate on all rows, or on bins of them where there are many."""
    fewer = binned(problem)
    rows, good = (np.ones(len(p), dtype=bool) for p in (fewer, problem))
    return Search(fewer, expand(fewer), rows, lowest, good)


def without_outliers(search: Search, known: NDArray[np.bool_] | None = None) -> Search:
    """The search on the rows that do not lie, once the effects that the others show are taken off.

    The first look is without rows `known` to lie (N,), or without those that seem to before any effect is.
    """
    segment = search.whole.scene.segment
    first = outliers(search.whole.y, segment) if known is None else known
    tried = [search, search.without(first)]
    for _ in range(2):
        here = tried[-1]
        accepted = [] if here.good.all() else _chosen(here)[0]
        left, added = here.everywhere(accepted)
        lying = outliers(left, segment, added)
        same = [one for one in tried if bool((one.good == ~lying).all())]
        tried.append(same[-1] if same else here.without(lying))
        if tried[-1] is here:
            break
    return tried[-1]


def _preferred(search: Search, blocks: Plan, accepted: list[Candidate], refused: Collection[Cause]) -> list[Candidate]:
    """Of causes that do as well, held out too, the one that can be computed from readings alone.

    A channel without physics goes last.
    """
    for place, one in enumerate(accepted):
        equals = [w.candidate for w in rivals_of(search, accepted, one) if w.candidate.cause not in refused]
        for other in sorted(equals, key=_standing):
            if _standing(other) >= _standing(one):
                break
            others = [c for c in accepted if c is not one]
            swapped = [*accepted[:place], refined(search, other, others), *accepted[place + 1 :]]
            if as_well(held_out(search, blocks, always(swapped), accepted)):
                accepted = swapped
                break
    return accepted


def _plainer(search: Search, blocks: Plan, accepted: list[Candidate]) -> list[Candidate]:
    """Each cause in its simplest look that is not worse on held-out data: a detail that fits the run alone misleads."""
    for place, chosen in enumerate(accepted):
        others = [c for c in accepted if c is not chosen]
        for look in _simpler(search, chosen, others):
            simple = [*accepted[:place], look, *accepted[place + 1 :]]
            richer = held_out(search, blocks, always(accepted), simple)
            if richer.before <= AS_GOOD * richer.after:
                accepted = simple
                break
    return accepted


def _simpler(search: Search, chosen: Candidate, others: Sequence[Candidate]) -> Iterator[Candidate]:
    """The best look of the same cause of each smaller size, the smallest first; none that is far out of reach."""
    kin = [c for c in search.candidates if c.cause == chosen.cause and c.size < chosen.size]
    stage = search.stage(others)
    enough = search.weigh(chosen, stage).likelihood.rss * OUT_OF_REACH**2
    for size in sorted({c.size for c in kin}):
        best = max(search.weigh_each([c for c in kin if c.size == size], stage), key=lambda w: w.weight)
        if best.likelihood.rss < enough:
            yield refined(search, best.candidate, others)


def _standing(candidate: Candidate) -> tuple[int, bool]:
    """Low goes first: what readings alone can correct, a channel without physics after, then the rig's, then time's."""
    kind = 1 if candidate.family.generic else 0
    if candidate.family.bound_to_run:
        kind = 3
    elif candidate.family.belongs_to == "rig":
        kind = 2
    return kind, candidate.family.second_order

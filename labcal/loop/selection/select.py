"""Which effects are accepted, and what each brings on held-out data."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass

from labcal.loop.candidates.library import Candidate, Cause
from labcal.loop.candidates.refine import refined
from labcal.loop.candidates.scorer import Search, Weighed
from labcal.loop.data.noise_floor import Floor
from labcal.loop.noise.autocorrelation import correlation_time_s
from labcal.loop.selection.crossval import HeldOut, Plan, always, held_out, plan
from labcal.loop.selection.equivalents import AS_GOOD, as_well, rivals_of
from labcal.loop.selection.heldout_rules import _helps, _idle, _in_doubt
from labcal.loop.selection.stepwise import MOST, forward, reexamined

OUT_OF_REACH = 3.0  # times the rms that another look leaves: more is no matter of refinement
REFUSALS = 6  # causes refused on held-out data before the loop gives up


@dataclass(frozen=True, slots=True, eq=False)
class Choice:
    """Effects that the rows of one search show, and the proof of each on blocks held out of those rows."""

    accepted: tuple[Candidate, ...]
    rankings: tuple[list[Weighed], ...]
    steps: tuple[HeldOut, ...]  # of each accepted effect, those before it already in
    blocks: Plan
    refused: Mapping[Cause, HeldOut]  # proofs of those that were taken and given up


def decided(search: Search, level: Floor, blocks: Plan | None = None, most: int = MOST) -> Choice:
    """Choose effects on the rows of `search`, and refuse again those that do not help on blocks held out of them."""
    refused, proofs = set[Cause](), dict[Cause, HeldOut]()
    for _ in range(REFUSALS):
        accepted, rankings = _chosen(search, most, refused)
        apart = blocks or plan(search.problem, correlation_time_s(search.problem.scene.t_s, search.residual(accepted)))
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


def _proof(search: Search, blocks: Plan, accepted: Sequence[Candidate], place: int) -> HeldOut:
    """Held out without and with one effect, those before it in; the next one too where only both together help."""
    before, also = list(accepted[:place]), list(accepted[place + 1 : place + 2])
    step = held_out(search, blocks, always([*before, accepted[place]]), before)
    if _helps(step) or not also:
        return step
    return held_out(search, blocks, always([*before, accepted[place], *also]), [*before, *also])


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

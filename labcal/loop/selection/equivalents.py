"""Which other causes would do as well in the place of an accepted one."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import dataclass, replace

import numpy as np

from labcal.loop.candidates.available import looks
from labcal.loop.candidates.library import Candidate, Cause
from labcal.loop.candidates.refine import refined
from labcal.loop.candidates.scorer import Search, Weighed
from labcal.loop.selection.admission import MATERIAL, NAMED, earned
from labcal.loop.selection.crossval import HeldOut, Plan, always, held_out
from labcal.loop.selection.related import neighbourhood
from labcal.loop.selection.stepwise import covers

AT_FLOOR = 1.15  # held-out rms over the floor up to which nothing is left to explain
AS_GOOD = 1.03  # times the held-out rms of the effect that a rival stands in for
CONTENDERS = 4  # rivals that are tried on held-out data
RIVAL = 8.0  # nats: what comes closer does as well


@dataclass(frozen=True, slots=True, eq=False)
class Contender:
    """A cause in the place of an accepted one, and the held-out rms that it reaches."""

    weighed: Weighed
    after_nT: float


def as_good(search: Search, blocks: Plan, accepted: Sequence[Candidate], chosen: Candidate) -> list[Contender]:
    """`chosen`, and the causes that in its place do as well on held-out data too."""
    out: list[Contender] = []
    for w in rivals_of(search, accepted, chosen)[: CONTENDERS + 1]:
        mine = chosen if w.candidate.cause == chosen.cause else w.candidate
        swapped = [mine if c is chosen else c for c in accepted]
        if chosen.family.id in mine.family.extends:
            swapped = [*accepted, mine]
        either = held_out(search, blocks, always(swapped), accepted)
        if not out or as_well(either):
            out.append(Contender(w, either.after))
    return out


def as_well(either: HeldOut) -> bool:
    """Whether what stands after does as well as what stood before, or better on some draws of the blocks."""
    return either.after <= AS_GOOD * either.before or either.improvement()[1] > 0


def rivals_of(search: Search, accepted: Sequence[Candidate], chosen: Candidate) -> list[Weighed]:
    """Other causes that would do as well in the place of `chosen`, it first."""
    about = [c.form for c in (chosen, *accepted)]
    return search.once("rivals", about, lambda: _as_heavy(search, accepted, chosen))


def _as_heavy(search: Search, accepted: Sequence[Candidate], chosen: Candidate) -> list[Weighed]:
    others = [c for c in accepted if c is not chosen]
    open_to = [c for c in looks(search, others) if not any(covers(o, c) for o in others)]
    kin = [refined(search, c, others) for c in _alike(open_to, chosen)]
    misfit = float(np.mean(search.residual(accepted)[search.rows] ** 2)) > AT_FLOOR**2
    always = {c.cause for c in kin if misfit and chosen.family.second_order}
    near = _near(search.rank([*open_to, *kin, chosen], others), chosen, always)
    if search.problem.whole is not None and len(near) > 1:
        near = _near(search.unbinned().rank([w.candidate for w in near], others), chosen, always)
    earning = [w for w in near[1:] if earned(search, others, w)]
    return [near[0], *earning, *_larger(search, accepted, chosen)]


def _larger(search: Search, accepted: Sequence[Candidate], chosen: Candidate) -> list[Weighed]:
    """Causes that extend `chosen` and whose own part is more likely at work than not: a sure one is no mere detail."""
    larger = [c for c in search.candidates if chosen.family.id in c.family.extends]
    causes = {c.cause for c in accepted}
    beside = search.rank(larger, accepted, neighbourhood(search, accepted)) if larger else []
    open_to = [w for w in beside if w.candidate.cause not in causes]
    return [w for w in open_to if w.weight > 0 and (w.weight < NAMED or w.drop >= MATERIAL)]


def _alike(candidates: Sequence[Candidate], chosen: Candidate) -> list[Candidate]:
    """Of a current or its square that acts slowly, the other one, to be refined from the same shape."""
    shape = {s.name: s.value for s in chosen.form.shape}
    kin = [c for c in candidates if c.family.id in chosen.family.akin and c.form.channels == chosen.form.channels]
    alike = {len(c.form.parameters): c for c in kin if shape and {s.name for s in c.form.shape} == shape.keys()}
    return [replace(c, form=c.form.reshaped(**shape)) for c in alike.values()]


def _near(ranking: Sequence[Weighed], chosen: Candidate, always: Collection[Cause]) -> list[Weighed]:
    """`chosen`, what weighs nearly as much, and causes that are near whatever they weigh."""
    own = next(w for w in ranking if w.candidate.cause == chosen.cause)
    others = (w for w in ranking if w.candidate.cause != chosen.cause)
    return [own, *(w for w in others if _odds(w) > _odds(own) - RIVAL or w.candidate.cause in always)]


def _odds(w: Weighed) -> float:
    """Its gain less the price that parameters of unlike number have beside each other [nats].

    The weight's price, one row's information for each, would give a weak effect to the smaller of two models that do
    as well. A g-prior at its likeliest g (Liang et al., JASA 103, 410, 2008, section 2.4) asks by the effect's size.
    """
    size = w.rank + w.candidate.size - len(w.candidate.form.parameters)
    each = max(2 * w.gain / max(size, 1), 1.0)
    return float(w.gain - 0.5 * size * (1 + np.log(each)) - np.log(w.candidate.looks))

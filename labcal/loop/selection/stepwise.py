"""Forward choice with re-examination: an effect comes in, and those already in have to earn their place again.

A second cause has to explain what a more flexible version of the first one cannot: beside every accepted effect stand
all other looks of its family on the same channels. So the remainder of a shape that is not quite ours is not given
another name.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence

import numpy as np

from labcal.loop.candidates.available import looks
from labcal.loop.candidates.library import Candidate, Cause
from labcal.loop.candidates.refine import refined
from labcal.loop.candidates.scorer import Search, Weighed
from labcal.loop.parallel import each
from labcal.loop.selection.admission import NAMED, _material, earned
from labcal.loop.selection.pairs import pairs
from labcal.loop.selection.related import neighbourhood

MOST = 3  # effects accepted at most
COMPANION = 0.7  # of the drop of the heaviest
ALL_BUT_WHITE = 1.5  # times the white level: no frequency of the noise left has more


def forward(
    search: Search, most: int = MOST, refused: Collection[Cause] = ()
) -> tuple[list[Candidate], list[list[Weighed]]]:
    """The causes accepted, in order, and the ranking at each step; those `refused` are not taken."""
    accepted: list[Candidate] = []
    rankings: list[list[Weighed]] = []
    total, out_of_play, left = 0.0, set(refused), set[Cause]()
    while len(accepted) < most:
        open_to = [c for c in looks(search, accepted) if not _same(c, accepted)]
        ranking = search.rank(open_to, accepted)
        if accepted and _nothing_left(search, accepted, ranking):
            rankings.append(ranking)
            break
        if accepted:
            ranking = search.rank(open_to, accepted, neighbourhood(search, accepted))
        rankings.append(ranking)
        best = _best(search, accepted, [w for w in ranking if w.candidate.cause not in out_of_play], total)
        if best is None:
            both = _pair(search, accepted, ranking, out_of_play, total) if len(accepted) + 2 <= most else []
            accepted = [*accepted, *both]
            if not both:
                break
            continue
        chosen = refined(search, best.candidate, accepted)
        kept = reexamined(search, [*accepted, chosen])
        if chosen in kept:
            gone = {c.cause for c in accepted if c not in kept}
            out_of_play |= gone & left  # what leaves for the second time would come and go for ever
            accepted, total, left = kept, total + best.drop, left | gone
        else:
            out_of_play.add(best.candidate.cause)
    return accepted, rankings


def _nothing_left(search: Search, accepted: Sequence[Candidate], ranking: Sequence[Weighed]) -> bool:
    """Whether the accepted effects leave noise that is all but white, and nothing in it weighs half of a name."""
    stage = search.stage(accepted)
    return bool(stage.bands.spectra[stage.null.tried].max() < ALL_BUT_WHITE) and ranking[0].weight < NAMED / 2


def _pair(
    search: Search,
    accepted: Sequence[Candidate],
    ranking: Sequence[Weighed],
    refused: Collection[Cause],
    total: float,
) -> list[Candidate]:
    """Two causes that are material together, each earning its place beside the other; none where no two do."""
    stage = search.stage(accepted, neighbourhood(search, accepted))
    open_to = [w for w in ranking if not _same(w.candidate, accepted)]
    for pair in pairs(search, stage, open_to, {*refused, *(c.cause for c in accepted)}):
        if pair.weight < NAMED or pair.drop < _material(search, accepted, total):
            continue
        one = refined(search, pair.one, [*accepted, pair.other])
        both = [one, refined(search, pair.other, [*accepted, one])]
        if reexamined(search, [*accepted, *both])[-2:] == both:
            return both
    return []


def _best(search: Search, accepted: Sequence[Candidate], ranking: list[Weighed], total: float) -> Weighed | None:
    """The heaviest that is material; a companion on a channel already at work goes before a little better stranger."""
    least = _material(search, accepted, total)
    fit = [w for w in ranking if w.drop >= least and w.weight >= NAMED]
    used = {name for c in accepted for name in c.form.channels}
    companions = [w for w in fit if used & set(w.candidate.form.channels) and w.drop >= COMPANION * fit[0].drop]
    return next((w for w in [*companions, *fit] if earned(search, accepted, w)), None)


def _same(candidate: Candidate, accepted: Sequence[Candidate]) -> bool:
    """The same cause twice; steps and periods may come twice, at another time or frequency."""
    return candidate.family.sought == "grid" and any(covers(c, candidate) for c in accepted)


def covers(one: Candidate, other: Candidate) -> bool:
    """Whether `other` is the same cause as `one`, or its current or square: a detail of the same load."""
    return other.form.channels == one.form.channels and other.family.id in (one.family.id, *one.family.akin)


def reexamined(search: Search, accepted: list[Candidate]) -> list[Candidate]:
    """Those that still earn their place beside the others."""

    def weight(chosen: Candidate) -> float:
        others = [c for c in accepted if c is not chosen]
        return search.weigh(chosen, search.stage(others, neighbourhood(search, others))).weight

    while len(accepted) > 1:
        weights = each(weight, accepted)
        weakest = int(np.argmin(weights))
        if weights[weakest] >= NAMED:
            break
        accepted = [c for i, c in enumerate(accepted) if i != weakest]
    return accepted

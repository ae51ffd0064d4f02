"""Which accepted effects held-out data support, and how many of them may be reported."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from labcal.loop.candidates.available import looks
from labcal.loop.candidates.library import Candidate
from labcal.loop.candidates.scorer import Search
from labcal.loop.data.noise_floor import Floor
from labcal.loop.selection.crossval import HeldOut, Plan, always, held_out
from labcal.loop.selection.equivalents import AT_FLOOR, Contender, rivals_of
from labcal.model.effects.regressors import WEATHER, stretches

SHARE_OF_EXCESS = 0.75  # of the mean square above the noise that the effects together have to carry,
SHARE_WITH_CHANNELS = 0.5  # and where each of them follows a channel that somebody switches
REMAINS = 0.03  # of what all effects took away: as much left is an unnamed process, not a drift, a step or a mode,
HARMONICS = 0.1  # and as much is no line with its harmonics
REST = 1 / 3  # and as much of what a later cause took away shows that it took misfit of an earlier one's form
SECOND = 0.03  # of the fall of the mean square that all bring together: a second effect has to bring as much,
SECOND_OF_NOISE = 0.25  # or this part of the noise's square
NEAREST = 2  # causes of other physics that a doubtful one is held against
ANSWERS = 3  # names that an answer may hold in place of one


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

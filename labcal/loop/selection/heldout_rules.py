"""Which accepted effects held-out data support, and how many of them may be reported."""

from __future__ import annotations

import itertools
from collections.abc import Sequence

import numpy as np

from labcal.loop import policy
from labcal.loop.candidates.available import all_candidates
from labcal.loop.candidates.library import Candidate
from labcal.loop.candidates.scorer import CandidateSet, Scored
from labcal.loop.data.noise_floor import NoiseFloor
from labcal.loop.selection.crossval import (
    BlockFolds,
    HeldOutErrors,
    cross_validate,
    fixed_choice,
    residual_lengths,
    rms,
)
from labcal.loop.selection.discrepancy import stands_beside_discrepancy
from labcal.loop.selection.equivalents import Equivalent, equally_likely, merely_contains
from labcal.model.effects.regressors import WEATHER, stretches

ALTERNATIVES = 2  # causes of other families that a doubtful one is compared with


def first_unsupported(
    pool: CandidateSet, accepted: Sequence[Candidate], steps: Sequence[HeldOutErrors], level: NoiseFloor
) -> int | None:
    """The place of the first accepted effect that held-out data do not support; None where they support all."""
    for i, step in enumerate(steps):
        if not (improves(step) and is_more_than_detail(steps[: i + 1], level)):
            return i
    for i, chosen in reversed(list(enumerate(accepted))):
        share = policy.POLICY.max_misfit_of_a_line if chosen.family.harmonics else policy.POLICY.material_share
        mine = steps if level.source == "differences" else steps[_first_of_its_cause(accepted, i) :]
        of_time = is_time_bound(pool, chosen) and misfit_remains(mine, level, share)
        if of_time and not stands_beside_discrepancy(pool, accepted, chosen):
            return i
    if level.source == "differences":
        return None
    for i in range(len(steps) - 1, 0, -1):
        begins = _first_of_its_cause(accepted, i)
        remains = begins and misfit_remains(steps[begins:], level, policy.POLICY.max_misfit_of_later)
        remains = remains and not reaches_the_noise(pool, accepted, level)
        if remains and not stands_beside_discrepancy(pool, accepted, accepted[i]):
            return i
    return None


def _first_of_its_cause(accepted: Sequence[Candidate], place: int) -> int:
    """The first of the consecutive effects of one cause: harmonics of one wave are judged together."""
    return next(i for i in range(place, -1, -1) if i == 0 or accepted[i - 1].cause != accepted[place].cause)


def is_sure_first(
    pool: CandidateSet,
    blocks: BlockFolds,
    accepted: Sequence[Candidate],
    steps: Sequence[HeldOutErrors],
    level: NoiseFloor,
) -> bool:
    """Whether the first cause leads every other family by more than what its own form misses; true where none is.

    Where no form reaches the noise, the nearest one may be so by coincidence; not where it leads beside a discrepancy,
    unless another leaves less of held-out rows in its place: evidence is of these rows, and where all forms miss more
    than the noise the one with most parameters may lead by what it fits of them alone. What later causes leave is the
    first one's misfit as well: who is led by less than that is their rival.
    """
    if not steps or steps[-1].after <= policy.POLICY.floor_ratio * level.nT:
        return True
    if _another_leaves_less(pool, blocks, accepted):
        return False
    if not alternatives_within_misfit(pool, blocks, accepted, accepted[0], steps[-1].after, level):
        return True
    return stands_beside_discrepancy(pool, accepted, accepted[0])


def _another_leaves_less(pool: CandidateSet, blocks: BlockFolds, accepted: Sequence[Candidate]) -> bool:
    """Whether a cause of another family, in the place of the first, leaves less on 95 % of the draws of blocks."""
    first = accepted[0]
    for other in _other_explanations(pool, accepted, first):
        swapped = fixed_choice(_in_the_place(accepted, first, other.candidate))
        if cross_validate(pool, blocks, swapped, accepted).improvement()[0] > 0:
            return True
    return False


def _in_the_place(accepted: Sequence[Candidate], chosen: Candidate, other: Candidate) -> list[Candidate]:
    return [other if c is chosen else c for c in accepted if c is chosen or c.cause != chosen.cause]


def alternatives_within_misfit(
    pool: CandidateSet,
    blocks: BlockFolds,
    accepted: Sequence[Candidate],
    chosen: Candidate,
    after_nT: float,
    level: NoiseFloor,
) -> list[Equivalent]:
    """Causes of other families that in the place of `chosen` leave little more of held-out rows.

    By less than what all leave above the noise; none where they reach it.
    """
    if level.source == "differences" or after_nT <= policy.POLICY.floor_ratio * level.nT:
        return []
    near, missed = list[Equivalent](), after_nT**2 - level.nT**2
    for other in _other_explanations(pool, accepted, chosen):
        swapped = _in_the_place(accepted, chosen, other.candidate)
        left_nT = cross_validate(pool, blocks, fixed_choice(swapped)).after
        if left_nT**2 - after_nT**2 < missed:
            near.append(Equivalent(other, left_nT))
    return near


def _other_explanations(pool: CandidateSet, accepted: Sequence[Candidate], chosen: Candidate) -> list[Scored]:
    """The causes of other families that would take most off the residual in the place of `chosen`.

    Its equivalents are not among them: they are named beside it; nor a larger form that contains it and needs no more.
    """
    others = [c for c in accepted if c is not chosen]
    named = {o.cause for o in others} | {w.candidate.cause for w in equally_likely(pool, accepted, chosen)}
    related = (chosen.family.id, *chosen.family.extends, *chosen.family.related)
    unrelated = [
        c
        for c in all_candidates(pool, others)
        if c.family.id not in related and chosen.family.id not in c.family.extends and c.cause not in named
    ]
    nearest = sorted(pool.rank(unrelated, others), key=lambda w: -w.drop)
    apart = (w for w in nearest if not merely_contains(pool, others, chosen, w.candidate))
    return list(itertools.islice(apart, ALTERNATIVES))


def is_time_bound(pool: CandidateSet, chosen: Candidate) -> bool:
    """Whether it depends on time or segment alone: any process in time would resemble it."""
    scene = pool.whole.scene
    if chosen.family.bound_to_run:
        return True
    columns = chosen.term.columns(scene)
    return not any(bool(np.ptp(columns[part], axis=0).any()) for part in stretches(scene.segment))


def misfit_remains(steps: Sequence[HeldOutErrors], level: NoiseFloor, share: float) -> bool:
    """Whether what all effects leave above the noise exceeds this share of what they took off."""
    before, after = steps[0].before, steps[-1].after
    return after > policy.POLICY.floor_ratio * level.nT and after**2 - level.nT**2 > share * (before**2 - after**2)


def reaches_the_noise(pool: CandidateSet, accepted: Sequence[Candidate], level: NoiseFloor) -> bool:
    """Whether the effects leave no more than noise of the rows that they are fitted to, their parameters counted.

    What held-out blocks then leave above it is no misfit of a form: the other blocks do not pin its parameters down.
    """
    left = pool.residual_everywhere(accepted)[0][pool.valid]
    open_to = left.size - pool.whole.T.shape[2] - sum(c.size for c in accepted)
    spread = rms(residual_lengths(pool.whole, left, pool.valid)) * np.sqrt(left.size / max(open_to, 1))
    return bool(spread <= policy.POLICY.floor_ratio * level.nT)


def improves(step: HeldOutErrors) -> bool:
    """Whether the held-out error falls, with its whole 95 % interval."""
    return step.improvement()[0] > 0


def is_more_than_detail(steps: Sequence[HeldOutErrors], level: NoiseFloor) -> bool:
    """Whether the last of some effects takes off more than a detail of the others would, on held-out data."""
    fall, total = (step.before**2 - steps[-1].after ** 2 for step in (steps[-1], steps[0]))
    law = policy.POLICY
    return len(steps) == 1 or fall > min(law.material_share * total, law.clear_share * level.nT**2)


def explains_excess(
    pool: CandidateSet, cv_error: HeldOutErrors, level: NoiseFloor, accepted: Sequence[Candidate]
) -> bool:
    """Whether the effects explain most of what lies above the noise: less is no explanation.

    Effects that follow switched channels may leave more: misfit of another cause may resemble a curve, a drift or the
    weather, but not a load that somebody switches.
    """
    excess = cv_error.before**2 - level.nT**2
    law, switched = policy.POLICY, all(follows_a_switch(pool, c) for c in accepted)
    share = law.min_explained_by_switches if switched else law.min_explained
    return cv_error.after <= law.floor_ratio * level.nT or cv_error.before**2 - cv_error.after**2 > share * excess


def follows_a_switch(pool: CandidateSet, candidate: Candidate) -> bool:
    """Whether the effect follows channels, none of them one that moves slowly by itself."""
    names, run = candidate.term.channels, pool.whole.run
    return bool(names) and all(run.channel(name).quantity not in WEATHER for name in names)


def n_reportable(
    pool: CandidateSet,
    cv_error: HeldOutErrors,
    level: NoiseFloor,
    accepted: Sequence[Candidate],
    models: Sequence[Sequence[Equivalent]],
) -> int:
    """How many of the accepted effects, from the first on, may be named; `models` are the equivalents of each.

    Not the last where together they explain too little; nor, where they do not reach the noise, one with too many
    equivalents: whatever resembles an unknown shape a little is equivalent there.
    """
    if not accepted or cv_error.after <= policy.POLICY.floor_ratio * level.nT:
        return len(accepted)
    if not explains_excess(pool, cv_error, level, accepted):
        sure = all(stands_beside_discrepancy(pool, accepted, c) for c in accepted)
        return len(accepted) - (0 if sure and improves(cv_error) else 1)
    if level.source == "differences":
        return len(accepted)
    most = policy.POLICY.max_equivalents
    return next((i for i, equivalents in enumerate(models) if len(equivalents) > most), len(accepted))

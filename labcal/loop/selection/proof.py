"""The proof of a selection: cross-validated error, equivalent models, null distribution."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace

import numpy as np
from numpy.typing import NDArray

from labcal.loop import policy
from labcal.loop.candidates.library import Candidate, Cause
from labcal.loop.candidates.scorer import CandidateSet, Scored
from labcal.loop.data.noise_floor import NoiseFloor
from labcal.loop.data.outliers import hampel_outliers, outlier_distance
from labcal.loop.parallel import parallel_map
from labcal.loop.selection.crossval import NEVER, BlockFolds, HeldOutErrors, cross_validate, fixed_choice
from labcal.loop.selection.equivalents import Equivalent, equivalent_models, nearly_done_by_readings
from labcal.loop.selection.heldout_rules import alternatives_within_misfit, n_reportable
from labcal.loop.selection.joint_fit import information, joint_fit
from labcal.loop.selection.select import Selection, SelectionEnding, select, stepwise
from labcal.loop.selection.stepwise import MAX_EFFECTS
from labcal.loop.selection.surrogates import null_distribution

Array = NDArray[np.float64]
PLAYS = 0.5  # of the evidence of what was taken, or of a name: a fifth of the rows less makes no more of it


@dataclass(frozen=True, slots=True, eq=False)
class Evidence:
    """All that the verdict rests on."""

    pool: CandidateSet
    base_set: CandidateSet  # about the base's own map
    accepted: tuple[Candidate, ...]
    rankings: tuple[list[Scored], ...]
    equivalents: tuple[tuple[Equivalent, ...], ...]  # of each accepted effect, itself first
    cv_error: HeldOutErrors
    contributions: tuple[HeldOutErrors, ...]  # of each accepted effect, those before it already in
    level: NoiseFloor
    blocks: BlockFolds
    null_distribution: Array  # of all candidates, on surrogates of what is left (sorted) [nats]
    refused: Mapping[Cause, HeldOutErrors]  # causes that held-out data did not support, with their contributions
    outlier_distance: float  # of the rows set aside, in standard deviations of the others
    ending: SelectionEnding = "supported"
    beyond_half: frozenset[Cause] = frozenset()  # that final fits make larger than half of the field
    not_carried: Mapping[Cause, float] = field(default_factory=dict)  # what final fits with these leave [nT]
    insignificant: Mapping[Cause, float] = field(default_factory=dict)  # p-values (Wald)


def select_and_prove(pool: CandidateSet, level: NoiseFloor) -> Evidence:
    """Select effects about the map that goes with them, and cross-validate them."""
    around = relinearised(pool)
    return prove(pool, around, select(around, level), level)


def prove(base_set: CandidateSet, pool: CandidateSet, selection: Selection, level: NoiseFloor) -> Evidence:
    """Cross-validate a selection: its error is that of selections repeated without each held-out fold."""
    accepted, blocks = selection.accepted, selection.blocks
    while True:
        pool.tell(pool, accepted, "the selection on each part of the blocks")
        offered = in_play(pool, selection.accepted, selection.rankings)
        choose = nested_selection(level, blocks, len(accepted), selection.barred, offered)
        cv_error = cross_validate(pool, blocks, choose)
        own = against_own_base(base_set, pool, blocks, cv_error)
        if accepted and own.after > policy.POLICY.equivalent_rms * own.before:
            return _of_the_base_alone(base_set, pool, selection, level)
        pool.tell(pool, accepted, "what does as well")
        every = (equivalent_models(pool, blocks, accepted, one) for one in accepted)
        beside = _led_by_little(pool, blocks, accepted, level)
        readings = (_nearly_as_much(pool, blocks, accepted, one) for one in accepted)
        equivalents = tuple(
            tuple(e for e in _each_once([*some, *more, *read]) if e.scored.candidate.cause not in selection.barred)
            for some, more, read in zip(every, beside, readings, strict=True)
        )
        judged = _of_this_choice(pool, blocks, accepted, cv_error, choose)
        reportable = n_reportable(pool, judged, level, accepted, equivalents)
        if reportable == len(accepted):
            break
        accepted = accepted[:reportable]
    contributions = {c.cause: held for c, held in zip(selection.accepted, selection.contributions, strict=True)}
    return Evidence(
        pool=pool,
        base_set=base_set,
        accepted=accepted,
        rankings=selection.rankings,
        equivalents=equivalents,
        cv_error=own,
        contributions=selection.contributions[: len(accepted)],
        level=level,
        blocks=blocks,
        null_distribution=null_distribution(pool, accepted),
        refused={**selection.refused, **contributions},
        outlier_distance=outlier_distance(pool.residual_everywhere(accepted)[0], pool.valid),
        ending=selection.ending,
    )


def _nearly_as_much(
    pool: CandidateSet, blocks: BlockFolds, accepted: Sequence[Candidate], one: Candidate
) -> list[Equivalent]:
    """The channels that take all but a detail of what one bound to the run's time does, by no more parameters."""
    others, out = [c for c in accepted if c is not one], list[Equivalent]()
    for channel in nearly_done_by_readings(pool, others, one):
        swapped = [channel if c is one else c for c in accepted]
        left_nT = cross_validate(pool, blocks, fixed_choice(swapped)).after
        out.append(Equivalent(pool.score(channel, pool.null_model(others)), left_nT))
    return out


def _led_by_little(
    pool: CandidateSet, blocks: BlockFolds, accepted: Sequence[Candidate], level: NoiseFloor
) -> list[list[Equivalent]]:
    """For each effect of a later cause who is led by less than what all of them leave above the noise.

    That may be the misfit of the first cause: it does not refuse a later one, but does not make it sure either.
    """
    after_nT = cross_validate(pool, blocks, fixed_choice(accepted)).after
    return [
        alternatives_within_misfit(pool, blocks, accepted, one, after_nT, level) if one.cause != first.cause else []
        for first, one in ((accepted[0], one) for one in accepted)
    ]


def _each_once(models: Sequence[Equivalent]) -> list[Equivalent]:
    return list({e.scored.candidate.cause: e for e in reversed(models)}.values())[::-1]


def _of_the_base_alone(base_set: CandidateSet, pool: CandidateSet, selection: Selection, level: NoiseFloor) -> Evidence:
    """The evidence where the effects are worse than the base about its own map, on rows that neither saw: none is."""
    given_up = {c.cause: held for c, held in zip(selection.accepted, selection.contributions, strict=True)}
    none = replace(selection, accepted=(), contributions=(), refused={**selection.refused, **given_up})
    alone = base_set.without_rows(~pool.valid)
    return prove(alone, alone, none, level)


def against_own_base(
    base_set: CandidateSet, pool: CandidateSet, blocks: BlockFolds, cv_error: HeldOutErrors
) -> HeldOutErrors:
    """The same held-out error, compared with the base model's own on the same rows, about the base's own map.

    About the map that goes with the effects the base would seem better than it is.
    """
    if pool is base_set or len(pool.problem) != len(base_set.problem):
        return cv_error
    return cv_error.against(cross_validate(base_set.without_rows(~pool.valid), blocks, fixed_choice(())))


def _of_this_choice(
    pool: CandidateSet,
    blocks: BlockFolds,
    accepted: Sequence[Candidate],
    nested: HeldOutErrors,
    choose: Callable[[CandidateSet], Sequence[Candidate]],
) -> HeldOutErrors:
    """The held-out error by which names are judged: of this very choice, where most folds choose the same causes.

    A fold that finds less in its rows makes the error of the procedure larger, and says nothing of these names.
    """
    causes = {c.cause for c in accepted}
    numbers = np.unique(blocks.fold[blocks.fold != NEVER]).tolist()
    parts = [pool.on(blocks.training(pool.problem.scene.t_s, fold) & pool.rows) for fold in numbers]
    same = sum({c.cause for c in choose(part)} == causes for part in parts)
    return cross_validate(pool, blocks, fixed_choice(accepted)) if 2 * same > len(parts) else nested


def in_play(
    pool: CandidateSet, chosen: Sequence[Candidate], rankings: Sequence[Sequence[Scored]]
) -> tuple[Candidate, ...]:
    """The candidates that a selection on four fifths of the rows might take, in their order.

    Of causes that by the rankings of one on all rows had at some step half the evidence of the one taken there, or of a
    name; of relatives in the same channels, which stand for what a form misses; and what is bound to the run.
    """
    known, causes = {part.cause for c in chosen for part in c.parts}, set[Cause]()
    for ranking in rankings:
        taken = (s.evidence for s in ranking if any(part.cause in known for part in s.candidate.parts))
        least = PLAYS * max([policy.POLICY.min_evidence, *taken])
        causes |= {part.cause for s in ranking if s.evidence >= least for part in s.candidate.parts}
    causes |= known
    some = (c for c in pool.candidates if c.cause in causes)
    causes |= {(other, c.term.channels) for c in some for other in (*c.family.related, *c.family.extends)}
    return tuple(c for c in pool.candidates if c.cause in causes or c.family.bound_to_run)


def nested_selection(
    level: NoiseFloor,
    blocks: BlockFolds,
    most: int = MAX_EFFECTS,
    barred: frozenset[Cause] = frozenset(),
    offered: tuple[Candidate, ...] | None = None,
) -> Callable[[CandidateSet], Sequence[Candidate]]:
    """The whole selection again on a part of the rows, tested on the blocks that are left (nested cross-validation).

    Of all candidates, or of those `offered`.
    """

    def choose(part: CandidateSet) -> Sequence[Candidate]:
        inner = blocks.restricted_to(part.rows)

        def made() -> Sequence[Candidate]:
            here = part if offered is None else part.among(offered)
            accepted = select(here, level, inner, most, barred).accepted
            here.forget_columns()
            return accepted

        return part.cached(("nested", most, barred, offered, inner.guard_s, inner.fold.tobytes()), (), made)

    return choose


def relinearised(pool: CandidateSet, barred: frozenset[Cause] = frozenset()) -> CandidateSet:
    """The candidates about the map that goes with the effects they show, where the problem is not linear in the map.

    None of those effects is `barred`.

    A magnitude is not: fitted without a strong effect, K and k are so far off that what is left of them looks like an
    effect of the field. Vectors are, but for the phases and the field that an effect follows.
    """
    accepted, rankings = stepwise(pool, refused=barred)
    if not accepted or (pool.problem.kind == "vector" and not _is_nonlinear(pool, accepted)):
        return pool
    tried = [accepted, *_smaller(pool, rankings[0], accepted, barred)]
    fits = parallel_map(lambda some: joint_fit(pool.whole, [c.term for c in some], pool.valid), tried)
    around = min(fits, key=information)
    pool.forget_columns()
    again = CandidateSet.of(around.uncorrected(), pool.min_noise_level, pool.tell)
    return without_outliers(again, None if pool.valid.all() else ~pool.valid)


def _smaller(
    pool: CandidateSet, ranking: Sequence[Scored], accepted: Sequence[Candidate], barred: frozenset[Cause]
) -> list[list[Candidate]]:
    """The smallest form of each cause that has the evidence of a name: far from its own map it may fit worse."""
    size = sum(c.size for c in accepted)
    causes = [one.candidate.cause for one in ranking if one.evidence >= policy.POLICY.min_evidence]
    forms = ([c for c in pool.candidates if c.cause == cause] for cause in causes if cause not in barred)
    smallest = (min(some, key=lambda c: c.size) for some in forms if some)
    return [[one] for one in smallest if one.size < size]


def _is_nonlinear(pool: CandidateSet, accepted: Sequence[Candidate]) -> bool:
    """Whether the effects, turned or grown as the base moves beside them, change by more than is worth a name."""
    whole, x = pool.whole, pool.coefficients(accepted)
    field = np.einsum("nqj,nj->nq", whole.whiten, whole.scene.field_nT)
    moved, added = whole.T @ x[: whole.T.shape[2]], pool.residual_everywhere(accepted)[1]
    return bool(np.mean(moved**2) * np.mean(added**2) > policy.POLICY.material_share * np.mean(field**2))


def without_outliers(pool: CandidateSet, known: NDArray[np.bool_] | None = None) -> CandidateSet:
    """The candidates on the rows that are no outliers, once the effects that the other rows show are subtracted.

    The first selection is without the rows `known` as outliers (N,), or without those that seem so before any effect.
    """
    segment = pool.whole.scene.segment
    first = hampel_outliers(pool.whole.y, segment) if known is None else known
    tried = [pool, pool.without_rows(first)]
    for _ in range(2):
        here = tried[-1]
        accepted = [] if here.valid.all() else stepwise(here)[0]
        left, added = here.residual_everywhere(accepted)
        outlying = hampel_outliers(left, segment, added)
        same = [one for one in tried if bool((one.valid == ~outlying).all())]
        tried.append(same[-1] if same else here.without_rows(outlying))
        if tried[-1] is here:
            break
    return tried[-1]

"""The proof of a selection: cross-validated error, equivalent models, null distribution."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from labcal.loop.candidates.library import Candidate, Cause, expand
from labcal.loop.candidates.scorer import Search, Weighed
from labcal.loop.data.decimate import binned
from labcal.loop.data.linear_problem import Problem
from labcal.loop.data.noise_floor import Floor
from labcal.loop.data.outliers import farness, outliers
from labcal.loop.selection.admission import MATERIAL
from labcal.loop.selection.crossval import HeldOut, Plan, always, held_out
from labcal.loop.selection.equivalents import Contender, as_good
from labcal.loop.selection.heldout_rules import _told
from labcal.loop.selection.joint_fit import refit
from labcal.loop.selection.select import Choice, _chosen, decided
from labcal.loop.selection.stepwise import MOST
from labcal.loop.selection.surrogates import by_chance

Array = NDArray[np.float64]


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

"""What related candidates of an accepted effect span: a remainder of its form must not become another cause's name."""

from __future__ import annotations

import itertools
from collections.abc import Collection, Sequence
from dataclasses import replace
from functools import partial

import numpy as np
from numpy.typing import NDArray

from labcal.loop.candidates.columns import ColumnGroup
from labcal.loop.candidates.library import Candidate, Span
from labcal.loop.candidates.scorer import CandidateSet
from labcal.loop.noise.nuisance import principal_span, span_of_combinations
from labcal.model.effects import TIME_CONSTANT

Array = NDArray[np.float64]
Distinct = tuple[Candidate, NDArray[np.intp], Array]  # a candidate, places of its columns, how often each occurs
RANDOM_DIRECTIONS = 3  # on which columns are projected to be compared,
TINY, COMMON = 1e-8, 1e-5  # of the squares of the largest direction: smaller ones are left out of a span
DECIMALS = 9  # and to how many they are the same


def other_forms(pool: CandidateSet, accepted: Sequence[Candidate]) -> list[Candidate]:
    """All other candidates of the accepted causes and of related families."""
    parts = (part for one in accepted for part in one.parts)
    return [c for part in parts for c in related(pool, part, _ids_of_forms(part))]


def _ids_of_forms(chosen: Candidate) -> tuple[str, ...]:
    return chosen.family.id, *chosen.family.extends, *chosen.family.related


def related_columns(pool: CandidateSet, accepted: Sequence[Candidate], *, common: bool = False) -> list[Span]:
    """All other candidates of the accepted causes and of related families, as a few columns that span them.

    Directions are of length one, or as long as they are `common` among candidates of length one.
    """
    parts = []
    for chosen in (part for one in accepted for part in one.parts):
        parts += span_of_related(pool, chosen, _ids_of_forms(chosen), common=common)
        parts += initial_state_columns(pool, chosen)
    return parts


def initial_state_columns(pool: CandidateSet, chosen: Candidate) -> list[Span]:
    """The transient of a slow response's unknown initial state: it decays with the response's own time constant."""
    of_the_run = ((c, c.term.of(TIME_CONSTANT)) for c in pool.candidates if c.family.bound_to_run)
    found = next(((c, own) for c, own in of_the_run if own is not None), None)
    if found is None:
        return []
    settling, own = found

    def made(tau_s: float) -> Span:
        columns = pool.problem.columns(settling.term.with_shape(replace(own, value=tau_s)))
        columns = pool.transformed(columns)
        return Span(columns / np.maximum(np.sqrt(np.einsum("nqc,nqc->c", columns, columns)), 1e-300))

    taus = [tau_s for tau_s in chosen.family.time_constants(chosen.term) if tau_s > 0]
    return [pool.cached(("initial state", tau_s), (settling,), partial(made, tau_s)) for tau_s in taus]


def beginnings(pool: CandidateSet, chosen: Candidate) -> list[Span]:
    """What a candidate's freedom to begin anywhere in each segment spans; empty where it has none."""

    def made() -> Span:
        return Span(pool.transformed_columns(chosen)[:, :, chosen.term.lasting :])

    return [pool.cached("beginnings", (chosen,), made)] if chosen.term.of_beginnings else []


def related(pool: CandidateSet, chosen: Candidate, ids: Collection[str]) -> list[Candidate]:
    """The candidates of these families on the channels of `chosen`."""
    return [
        c
        for c in pool.candidates
        if c.family.id in ids and c.term.channels == chosen.term.channels and _may_be_missed(chosen, c)
    ]


def span_of_related(pool: CandidateSet, chosen: Candidate, ids: Collection[str], *, common: bool = False) -> list[Span]:
    """The span of all of them; empty where there is none."""
    some = related(pool, chosen, ids)

    def made() -> Span:
        distinct = pool.store.memo.get("distinct", some, lambda: _distinct_columns(pool, some))
        return Span(_span(pool, distinct, common=common))

    return [pool.cached(("span", common), some, made)] if some else []


def _may_be_missed(chosen: Candidate, other: Candidate) -> bool:
    return other.family.id != chosen.family.id or chosen.family.may_be_missed(chosen.term, other.term)


def _span(pool: CandidateSet, distinct: Sequence[Distinct], *, common: bool) -> Array:
    """The span of these columns; of those that are made of fewer, by what they are made of."""
    smallest = COMMON if common else TINY
    mixes: dict[ColumnGroup, list[Array]] = {}
    counted: dict[ColumnGroup, list[Array]] = {}
    parts, alone = list[Array](), list[Array]()
    for candidate, places, times in distinct:
        home = pool.store.home(candidate)
        if home is None or home[0].whitened.mix is None:
            parts.append(pool.transformed_columns(candidate)[:, :, places])
            alone.append(times)
        else:
            mixes.setdefault(home[0], []).append(home[0].whitened.mix[:, home[1], places])
            counted.setdefault(home[0], []).append(times)
    if not mixes:
        return principal_span(np.concatenate(parts, axis=2), np.concatenate(alone), smallest, common=common)
    from scipy.linalg import block_diag

    columns = np.concatenate([*parts, *(pool.transformed_group(group).made_of for group in mixes)], axis=2)
    each = [np.eye(sum(map(len, alone))), *(np.concatenate(mix, axis=1) for mix in mixes.values())]
    times = np.concatenate([*alone, *itertools.chain(*counted.values())])
    return span_of_combinations(columns, block_diag(*each), times, smallest, common=common)


def _distinct_columns(pool: CandidateSet, related: Sequence[Candidate]) -> list[Distinct]:
    """The places of columns that occur for the first time, and how often each occurs: a curve's are in every loop's.

    Columns are the same where their projections on a few random directions are, at unit length.
    """
    some = np.concatenate([pool.columns(c) for c in related], axis=2)
    some = some.reshape(-1, some.shape[2])
    drawn = np.random.default_rng(0).normal(size=(RANDOM_DIRECTIONS, len(some))) @ some
    some = np.round(drawn / np.maximum(np.sqrt(np.einsum("nc,nc->c", some, some)), 1e-300), DECIMALS)
    _, first, times = np.unique(some, axis=1, return_index=True, return_counts=True)
    order, ends = np.argsort(first), np.cumsum([0, *(len(c.term.parameters) for c in related)])
    first, times = first[order], times[order].astype(float)
    lasting = [a + c.term.lasting for a, c in zip(ends[:-1], related, strict=True)]
    inside = [(first >= a) & (first < b) for a, b in zip(ends[:-1], lasting, strict=True)]
    found = zip(related, ends[:-1].tolist(), inside, strict=True)
    return [(c, first[here] - start, times[here]) for c, start, here in found if here.any()]

"""What related candidates of an accepted effect span: a remainder of its form must not become another cause's name."""

from __future__ import annotations

import itertools
from collections.abc import Collection, Sequence
from dataclasses import replace
from functools import partial

import numpy as np
from numpy.typing import NDArray

from labcal.loop.candidates.library import Candidate, Span
from labcal.loop.candidates.scorer import CandidateSet
from labcal.loop.noise.bands import cosine_transform
from labcal.loop.noise.nuisance import principal_span
from labcal.model.effects import TIME_CONSTANT

Array = NDArray[np.float64]
RANDOM_DIRECTIONS = 3  # on which columns are projected to be compared,
DECIMALS = 9  # and to how many they are the same


def related_columns(pool: CandidateSet, accepted: Sequence[Candidate]) -> list[Span]:
    """All other candidates of the accepted causes and of related families, as a few columns that span them."""
    parts = []
    for chosen in (part for one in accepted for part in one.parts):
        parts += span_of_related(pool, chosen, (chosen.family.id, *chosen.family.extends, *chosen.family.related))
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
        return Span(cosine_transform(columns[pool.transformed_rows]))

    taus = [tau_s for tau_s in chosen.family.time_constants(chosen.term) if tau_s > 0]
    return [pool.cached(("initial state", tau_s), (settling,), partial(made, tau_s)) for tau_s in taus]


def span_of_related(pool: CandidateSet, chosen: Candidate, ids: Collection[str]) -> list[Span]:
    """The span of all candidates of these families on the channels of `chosen`; empty where there is none."""
    related = [c for c in pool.candidates if c.family.id in ids and c.term.channels == chosen.term.channels]

    def made() -> Span:
        distinct = pool.store.memo.get("distinct", related, lambda: _distinct_columns(pool, related))
        parts = [pool.transformed_columns(c)[:, :, places] for c, places, _ in distinct]
        times = np.concatenate([times for _, _, times in distinct])
        return Span(principal_span(np.concatenate(parts, axis=2), times))

    return [pool.cached("span", related, made)] if related else []


def _distinct_columns(
    pool: CandidateSet, related: Sequence[Candidate]
) -> list[tuple[Candidate, NDArray[np.intp], Array]]:
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
    inside = [(first >= a) & (first < b) for a, b in itertools.pairwise(ends)]
    found = zip(related, ends[:-1].tolist(), inside, strict=True)
    return [(c, first[here] - start, times[here]) for c, start, here in found if here.any()]

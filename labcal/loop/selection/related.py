"""What related candidates of an accepted effect span: a remainder of its form must not become another cause's name."""

from __future__ import annotations

import itertools
from collections.abc import Collection, Sequence
from functools import partial

import numpy as np
from numpy.typing import NDArray

from labcal.loop.candidates.library import Candidate
from labcal.loop.candidates.refine import _names
from labcal.loop.candidates.scorer import Search
from labcal.loop.noise.bands import transformed
from labcal.loop.noise.nuisance import spanning
from labcal.model.effects.following import time_constants

Array = NDArray[np.float64]
DIRECTIONS = 3  # in which columns are compared


def neighbourhood(search: Search, accepted: Sequence[Candidate]) -> list[Array]:
    """All other looks of the accepted causes, as a few transformed columns that span them."""
    parts = []
    for chosen in accepted:
        parts += _spanned(search, chosen, (chosen.family.id, *chosen.family.extends, *chosen.family.akin))
        parts += _starts(search, chosen)
    return parts


def _starts(search: Search, chosen: Candidate) -> list[Array]:
    """What the unknown state that a slow response starts from leaves: it dies out with the response's own tau_s."""
    settling = next((c.form for c in search.candidates if c.family.bound_to_run and "tau_s" in _names(c.form)), None)
    if settling is None:
        return []

    def made(tau_s: float) -> Array:
        return transformed(search.problem.columns(settling.reshaped(tau_s=tau_s))[search.moving])

    taus = [tau_s for tau_s in time_constants(chosen.form) if tau_s > 0]
    return [search.once(("starts", tau_s), (settling,), partial(made, tau_s)) for tau_s in taus]


def _spanned(search: Search, chosen: Candidate, ids: Collection[str]) -> list[Array]:
    """All looks of these families on the channels of `chosen`, spanned; nothing where there is none."""
    kin = [c for c in search.candidates if c.family.id in ids and c.form.channels == chosen.form.channels]

    forms = [c.form for c in kin]

    def made() -> Array:
        distinct = search.once("distinct", forms, lambda: _distinct(search, kin), everywhere=True)
        parts = [search.moved(c)[:, :, places] for c, places, _ in distinct]
        return spanning(np.concatenate(parts, axis=2), np.concatenate([times for _, _, times in distinct]))

    return [search.once("spanned", forms, made)] if kin else []


def _distinct(search: Search, kin: Sequence[Candidate]) -> list[tuple[Candidate, NDArray[np.intp], Array]]:
    """Where columns that the looks have in common stand first, and how often each comes: a curve's are in every loop's.

    Columns are the same where they are, at unit length, in a few directions drawn at random.
    """
    some = np.concatenate([search.columns(c) for c in kin], axis=2)
    some = some.reshape(-1, some.shape[2])
    drawn = np.random.default_rng(0).normal(size=(DIRECTIONS, len(some))) @ some
    some = np.round(drawn / np.maximum(np.sqrt(np.einsum("nc,nc->c", some, some)), 1e-300), 9)
    _, first, times = np.unique(some, axis=1, return_index=True, return_counts=True)
    order, ends = np.argsort(first), np.cumsum([0, *(len(c.form.parameters) for c in kin)])
    first, times = first[order], times[order].astype(float)
    inside = [(first >= a) & (first < b) for a, b in itertools.pairwise(ends)]
    found = zip(kin, ends[:-1].tolist(), inside, strict=True)
    return [(c, first[here] - start, times[here]) for c, start, here in found if here.any()]

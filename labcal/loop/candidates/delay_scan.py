"""Delays of a channel: every delay is tried, by least squares in one sweep.

A switched load whose time is wrong by a tenth of its period explains hardly more than any slow response, so a coarse
grid of delays would miss it. The columns of an offset that follows a channel q are q times those of a constant offset:
their Gram matrices with everything else are sums over rows, and the drops at all delays are one matrix product.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import partial

import numpy as np
from numpy.typing import NDArray

from labcal.loop.candidates.library import Candidate, is_observable
from labcal.loop.candidates.scorer import CandidateSet
from labcal.loop.data.linear_problem import LinearProblem
from labcal.loop.noise.nuisance import explained_by_each, gram_pinv
from labcal.model.effects import Shape, families
from labcal.model.effects.regressors import delayed

Array = NDArray[np.float64]


def delay_scan(pool: CandidateSet, accepted: Sequence[Candidate]) -> list[Candidate]:
    """Each effect that a delay could shift, at the delay that takes most off the residual that the accepted leave."""
    causes = {c.cause for c in pool.candidates}
    able = pool.store.memo.get("delayable", (), lambda: _delayable(pool.problem))
    able = [one for one in able if one.alone or one.candidate.cause in causes]
    if not able:
        return []
    explained = _explained(pool, accepted)
    found = []
    for candidate, delay in ((one.candidate, one.delay) for one in able):
        drives = pool.store.memo.get("delayed", (candidate,), partial(_delayed_drives, pool.problem, candidate, delay))
        best = int(np.argmax(explained(drives[:, pool.rows])))
        term = candidate.term.with_shape(replace(delay, value=delay.grid[best]))
        found.append(Candidate(candidate.family, term, len(delay.grid)))
    return found


@dataclass(frozen=True, slots=True, eq=False)
class _Delayed:
    """A term that has a delay, and the delay; `alone` where its cause takes no form without one."""

    candidate: Candidate
    delay: Shape
    alone: bool


def _delayable(problem: LinearProblem) -> list[_Delayed]:
    """Every term that has a delay."""
    able = [family for family in families() if family.found_by("delay scan") and is_observable(problem, family)]
    every = [Candidate(family, term) for family in able for term in family.candidates(problem.run)]
    found = [(candidate, candidate.term.found_by("delay scan")) for candidate in every]
    prompt = {candidate.cause for candidate, delay in found if delay is None}
    return [_Delayed(c, delay, c.cause not in prompt) for c, delay in found if delay is not None]


def _delayed_drives(problem: LinearProblem, candidate: Candidate, delay: Shape) -> Array:
    """The channel (delays, n) after each delay."""
    scene = problem.scene
    drive = candidate.term.drive(scene)
    return np.stack([delayed(scene.t_s, scene.segment, drive, by) for by in delay.grid])


def _explained(pool: CandidateSet, accepted: Sequence[Candidate]) -> partial[Array]:
    """A function of drives (k, n): what each takes off the sum of squares (k,), beside base and accepted effects."""
    rows, E = pool.rows, pool.problem.whiten[pool.rows]  # E: the columns of a constant offset along each axis
    A = np.concatenate([pool.problem.T, *(pool.columns(c) for c in accepted)], axis=2)[rows]
    left = pool.residual(accepted)[rows][:, :, None]
    per_row = [np.einsum("nqa,nqp->nap", E, part) for part in (E, A, left)]
    return partial(_explained_by_drives, per_row, gram_pinv(A.reshape(-1, A.shape[2])))


def _explained_by_drives(per_row: Sequence[Array], inverse: Array, drives: Array) -> Array:
    gram, cross, xty = (
        np.tensordot(weight, part, axes=1) for weight, part in zip((drives**2, drives, drives), per_row, strict=True)
    )
    return explained_by_each(gram, cross, xty[:, :, 0], inverse)

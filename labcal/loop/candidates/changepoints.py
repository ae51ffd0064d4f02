"""Changepoints: every moment at which an offset or the cage's field may have stepped, by least squares in one sweep.

A step half a minute off its moment explains no more than any slow wandering, so a grid of times would miss it. The
columns of a step at row k are those of a constant from row k on: their Gram matrices with everything else are sums over
the rows that follow, and the drop of the sum of squares at all k costs one pass.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from labcal.loop.candidates.library import Candidate, is_observable
from labcal.loop.candidates.scorer import CandidateSet
from labcal.loop.noise.nuisance import explained_by_each, gram_pinv
from labcal.model.effects import Family, Shape, Term, families

Array = NDArray[np.float64]
PEAKS = 3  # moments that become candidates
EDGE = 0.03  # of the rows at either end cannot show a step
APART = 60  # peaks lie at least the run's length over this apart


def changepoints(pool: CandidateSet, accepted: Sequence[Candidate]) -> list[Candidate]:
    """Steps at the moments where they take most off the residual that the accepted effects leave."""
    found: list[Candidate] = []
    for family in families():
        for term in family.candidates(pool.problem.run) if is_observable(pool.problem, family) else ():
            if (moment := term.found_by("changepoints")) is not None:
                found += _at_peaks(pool, family, term, moment, explained_by_step(pool, accepted, term))
    return found


def _at_peaks(pool: CandidateSet, family: Family, term: Term, moment: Shape, drop: Array) -> list[Candidate]:
    t = pool.problem.scene.t_s[pool.rows]
    found: list[Candidate] = []
    for _ in range(PEAKS):
        row = int(np.argmax(drop))
        if drop[row] <= 0:
            break
        grid = (float(t[row - 1]), float(t[row - 1] + t[row]) / 2, float(t[row]))
        at = replace(moment, value=grid[1], grid=grid)
        found.append(Candidate(family, term.with_shape(at), len(t)))
        drop[max(row - len(t) // APART, 0) : row + len(t) // APART + 1] = 0.0
    return found


def explained_by_step(pool: CandidateSet, accepted: Sequence[Candidate], term: Term) -> Array:
    """What the step of this term from each row on takes off the sum of squares (n,); zero near the ends."""
    problem, rows = pool.problem, pool.rows
    E = problem.columns(term.stepped())[rows]  # (n, q, 3)
    A = np.concatenate([problem.T, *(pool.columns(c) for c in accepted)], axis=2)[rows]
    drop = explained_from_each_row(E, A, pool.residual(accepted)[rows])
    edge = max(int(EDGE * len(drop)), 2)
    drop[:edge] = drop[-edge:] = 0.0
    return drop


def explained_from_each_row(E: Array, A: Array, left: Array) -> Array:
    """What columns E (n, q, 3), zero before a row, take off the squares of `left` (n, q) beside A (n, q, p): (n,)."""
    right = np.concatenate([E, A, left[:, :, None]], axis=2)
    sums = _sum_from_row(np.einsum("nqa,nqp->nap", E, right))
    return explained_by_each(sums[:, :, :3], sums[:, :, 3:-1], sums[:, :, -1], gram_pinv(A.reshape(-1, A.shape[2])))


def _sum_from_row(values: Array) -> Array:
    """The sum (n, ...) over each row and all that follow."""
    return np.asarray(np.cumsum(values[::-1], axis=0)[::-1])

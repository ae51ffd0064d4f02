"""The columns of a fine grid as combinations of few: those of a place are polynomials in its coordinates.

Where each row speaks for itself, a few rows tell which points of the grid are enough, and how all others follow from
them (an interpolative decomposition: Cheng, Gimbutas, Martinsson & Rokhlin, SIAM J. Sci. Comput. 26, 1389, 2005).
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from labcal.loop.candidates.library import Candidate
from labcal.loop.data.credible import not_credible
from labcal.loop.data.linear_problem import LinearProblem
from labcal.loop.noise.column_sets import ColumnSets

Array = NDArray[np.float64]
ROWS = 100  # that tell
NOT_NEW = 1e-10  # of the largest: a column that is no more than this beside the others follows from them
EXACT = 1e-8  # of a column: how far a combination may be off on all rows


def interpolated(problem: LinearProblem, grid: Sequence[Candidate]) -> ColumnSets | None:
    """The whitened columns of one form at the points of its grid; None where they are not made of half as many."""
    first = grid[0]
    if first.family.reach_s(first.term) is not None:
        return None
    scene = (problem.whole or problem).scene
    few = scene.select(np.unique(np.linspace(0, len(scene) - 1, ROWS).astype(np.intp)))
    seen = np.stack([c.term.columns(few).reshape(-1, len(c.term.parameters)) for c in grid])  # (c, 3 rows, p)
    if not np.isfinite(seen).all() or not seen.any():
        return None
    size = np.maximum(np.abs(seen).max(axis=(0, 1)), 1e-300)
    nodes = _independent((seen / size).reshape(len(grid), -1).T)
    if 2 * len(nodes) > len(grid):
        return None
    columns = np.stack([problem.all_columns(grid[k].term) for k in nodes], axis=3)  # (n, q, p, nodes)
    parts, mixes = [], []
    for j in range(seen.shape[2]):
        at = seen[:, :, j].T
        own = _independent(at[:, nodes])
        parts.append(columns[:, :, j, own])
        mixes.append(np.linalg.lstsq(at[:, nodes[own]], at, rcond=None)[0])
    mix = np.zeros((sum(map(len, mixes)), len(grid), len(mixes)))
    ends = np.cumsum([0, *map(len, mixes)])
    for j, part in enumerate(mixes):
        mix[ends[j] : ends[j + 1], :, j] = part
    sets = ColumnSets(np.concatenate(parts, axis=2), len(grid), mix)
    off = next(k for k in range(len(grid)) if k not in nodes)
    if not _is_exact(sets.columns(off), problem.all_columns(grid[off].term)):
        return None
    _keep_credible(problem, first, sets)
    return sets


def _independent(columns: Array) -> NDArray[np.intp]:
    """The places of columns (m, c) that all others are combinations of."""
    from scipy.linalg import qr

    triangle, order = qr(columns, mode="r", pivoting=True)
    size = np.abs(np.diag(triangle))
    return np.asarray(order[: len(size)][size > NOT_NEW * size[0]])


def _is_exact(made: Array, columns: Array) -> bool:
    return bool(np.linalg.norm(made - columns) <= EXACT * np.linalg.norm(columns))


def _keep_credible(problem: LinearProblem, first: Candidate, sets: ColumnSets) -> None:
    """Take out of every set what is not credible, as `problem.columns` does."""
    share = problem.credible_share(first.term)
    if share is None or sets.mix is None:
        return
    flat = sets.made_of.reshape(-1, sets.made_of.shape[2])
    gram, onto = flat.T @ flat, problem.base_directions.reshape(len(flat), -1).T @ flat
    for place in range(sets.count):
        mix = sets.mix[:, place]
        out = not_credible(mix.T @ gram @ mix, onto @ mix, share)
        if out is not None:
            mix -= mix @ out

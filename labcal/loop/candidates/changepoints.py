"""Where an offset or the cage's field may have stepped: every moment is looked at, by plain least squares in one sweep.

A step half a minute off its moment is no better than any slow wandering, so a grid of times would miss it. The columns
of a step at row k are those of a constant from row k on: their Gram matrices with everything else are sums over
the rows that follow, and the drop of the sum of squares at all k costs one pass.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from labcal.loop.candidates.library import Candidate, at_home
from labcal.loop.candidates.scorer import Search
from labcal.loop.noise.nuisance import SEEN
from labcal.model.effects import Family, Form, families

Array = NDArray[np.float64]
PEAKS = 3  # moments that are weighed
EDGE = 0.03  # of the rows at either end cannot show a step
APART = 60  # peaks lie at least the run's length over this apart


def steps(search: Search, accepted: Sequence[Candidate]) -> list[Candidate]:
    """The step at the moments where it takes most off the residual that the accepted effects leave."""
    found: list[Candidate] = []
    for family in families():
        for form in family.candidates(search.problem.run) if at_home(search.problem, family) else ():
            if any(shape.name == "t_step_s" for shape in form.shape):
                found += _at_peaks(search, family, form, drops(search, accepted, form))
    return found


def _at_peaks(search: Search, family: Family, form: Form, drop: Array) -> list[Candidate]:
    t = search.problem.scene.t_s[search.rows]
    found: list[Candidate] = []
    for _ in range(PEAKS):
        row = int(np.argmax(drop))
        if drop[row] <= 0:
            break
        grid = (float(t[row - 1]), float(t[row - 1] + t[row]) / 2, float(t[row]))
        at = replace(form.shape[0], value=grid[1], grid=grid)
        found.append(Candidate(family, replace(form, shape=(at,)), len(t)))
        drop[max(row - len(t) // APART, 0) : row + len(t) // APART + 1] = 0.0
    return found


def drops(search: Search, accepted: Sequence[Candidate], form: Form) -> Array:
    """What the step of this form from each row on takes off the sum of squares (n,); nought at the ends."""
    problem, rows = search.problem, search.rows
    E = problem.columns(form.reshaped(t_step_s=-np.inf))[rows]  # (n, q, 3) as if it had come before the run
    A = np.concatenate([problem.T, *(search.columns(c) for c in accepted)], axis=2)[rows]
    flat = A.reshape(-1, A.shape[2])
    inverse = np.linalg.pinv(flat.T @ flat, hermitian=True)
    after = _following(np.concatenate([E, A, search.residual(accepted)[rows][:, :, None]], axis=2), E)
    own, cross, pull = after[:, :, :3], after[:, :, 3:-1], after[:, :, -1]
    values, vectors = np.linalg.eigh(own - cross @ inverse @ np.swapaxes(cross, 1, 2))
    usable = values > SEEN * np.trace(own, axis1=1, axis2=2)[:, None]
    along = np.einsum("nak,na->nk", vectors, pull)
    drop = np.sum(np.where(usable, along**2 / np.where(usable, values, 1.0), 0.0), axis=1)
    edge = max(int(EDGE * len(drop)), 2)
    drop[:edge] = drop[-edge:] = 0.0
    return np.asarray(drop)


def _following(right: Array, left: Array) -> Array:
    """Σ leftᵀ right over each row and all that follow (n, 3, p)."""
    each = np.einsum("nqa,nqp->nap", left, right)
    return np.asarray(np.cumsum(each[::-1], axis=0)[::-1])

"""How late a channel may be: every delay is looked at, by plain least squares in one sweep.

A switched load that is wrong in time by a tenth of its period is hardly better than any slow response, so that a coarse
grid of delays would miss it. The columns of an offset that follows a channel q are q times those of a constant offset:
their Gram matrices with everything else are sums over rows, and the drops at all delays are one product of matrices.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial

import numpy as np
from numpy.typing import NDArray

from labcal.loop.candidates.library import Candidate
from labcal.loop.candidates.scorer import Search
from labcal.loop.data.linear_problem import Problem
from labcal.loop.noise.nuisance import SEEN
from labcal.model.effects import Family, Form, families
from labcal.model.effects.regressors import delayed

Array = NDArray[np.float64]


def delays(search: Search, accepted: Sequence[Candidate]) -> list[Candidate]:
    """Each effect that a delay could shift, at the delay that takes most off the residual that the accepted leave."""
    causes = {c.cause for c in search.candidates}
    able = search.once("late", (), lambda: _late(search.problem), everywhere=True)
    late = [(family, form) for family, form in able if (family.id, form.channels) in causes]
    found = list[Candidate]()
    if not late:
        return found
    sums = _Sums.of(search, accepted)
    for family, form in late:
        grid = next(s.grid for s in form.shape if s.name == "delay_s")
        drives = search.once("drives", (form,), partial(_drives, search.problem, form, grid), everywhere=True)
        best = int(np.argmax(sums.drops(drives[:, search.rows])))
        found.append(Candidate(family, form.reshaped(delay_s=grid[best]), len(grid)))
    return found


def _late(problem: Problem) -> list[tuple[Family, Form]]:
    """Every form that has a delay."""
    able = [family for family in families() if "delay_s" in family.shapes]
    forms = [(family, form) for family in able for form in family.candidates(problem.run)]
    return [(family, form) for family, form in forms if any(s.name == "delay_s" for s in form.shape)]


def _drives(problem: Problem, form: Form, grid: Sequence[float]) -> Array:
    """The channel (delays, n) after each delay."""
    scene = problem.scene
    drive = form.drive(scene)
    return np.stack([delayed(scene.t_s, scene.segment, drive, by) for by in grid])


class _Sums:
    """What every row adds to the Gram matrices of a constant offset along each axis."""

    def __init__(self, own: Array, cross: Array, pull: Array, inverse: Array) -> None:
        self.own, self.cross, self.pull, self.inverse = own, cross, pull, inverse

    @classmethod
    def of(cls, search: Search, accepted: Sequence[Candidate]) -> _Sums:
        """Beside the base and the accepted effects."""
        rows, E = search.rows, search.problem.whiten[search.rows]
        A = np.concatenate([search.problem.T, *(search.columns(c) for c in accepted)], axis=2)[rows]
        flat = A.reshape(-1, A.shape[2])
        left = search.residual(accepted)[rows][:, :, None]
        own, cross, pull = (np.einsum("nqa,nqp->nap", E, part) for part in (E, A, left))
        return cls(own, cross, pull, np.linalg.pinv(flat.T @ flat, hermitian=True))

    def drops(self, drives: Array) -> Array:
        """What each drive (k, n) takes off the sum of squares (k,)."""
        own, cross, pull = (np.tensordot(w, part, axes=1) for w, part in (
            (drives**2, self.own), (drives, self.cross), (drives, self.pull)))  # fmt: skip
        values, vectors = np.linalg.eigh(own - cross @ self.inverse @ np.swapaxes(cross, 1, 2))
        usable = values > SEEN * np.trace(own, axis1=1, axis2=2)[:, None]
        along = np.einsum("kab,ka->kb", vectors, pull[:, :, 0])
        return np.asarray(np.sum(np.where(usable, along**2 / np.where(usable, values, 1.0), 0.0), axis=1))

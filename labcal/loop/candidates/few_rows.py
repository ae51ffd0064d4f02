"""Forms of many columns and several nonlinear parameters: where they stand is read off a few rows.

A device off the centre of the coils stands at a place with three angles, each form there has some thirty columns: a
grid of it over all rows would cost more than all other candidates. On a few hundred rows every grid point is one small
least-squares problem beside base and accepted effects; from the best one on the place is found by variable projection
(Golub & Pereyra, SIAM J. Numer. Anal. 10, 413, 1973). A form that could not have the evidence of a name is not made.
"""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from dataclasses import dataclass, replace
from math import prod

import numpy as np
from numpy.typing import NDArray

from labcal.loop.candidates.library import Candidate, is_observable
from labcal.loop.candidates.scorer import CandidateSet
from labcal.loop.noise.nuisance import explained_by_each, gram_pinv
from labcal.model.effects import Family, Term, families

Array = NDArray[np.float64]
ROWS = 250  # about so many are looked at
BEST = 2  # grid points that are refined
EVALUATIONS = 12  # of the residual's derivatives, at most
NEARLY = 2.0  # times its gain at a grid point a form may gain at its best


def few_rows(pool: CandidateSet, accepted: Sequence[Candidate]) -> list[Candidate]:
    """Forms with such parameters where they take most off the residual that the accepted effects leave."""
    taken = {c.family.id for one in accepted for c in one.parts}
    found: list[Candidate] = []
    for family, forms in pool.store.memo.get("few rows", (), lambda: _forms(pool)):
        if family.id not in taken:
            found += _at_their_best(_Rows.of(pool, accepted), family, forms)
    return found


def _forms(pool: CandidateSet) -> list[tuple[Family, list[Term]]]:
    """The forms of each family that are searched here, smallest first: all stand at the place of the first."""
    able = [family for family in families() if family.found_by("few rows") and is_observable(pool.problem, family)]
    found = [(f, [t for t in f.candidates(pool.problem.run) if t.found_by("few rows")]) for f in able]
    return [(f, sorted(forms, key=lambda t: len(t.parameters))) for f, forms in found if forms]


@dataclass(frozen=True, slots=True, eq=False)
class _Rows:
    """A few rows of a set, with what the base and the accepted effects span there and what they leave."""

    pool: CandidateSet
    number: NDArray[np.intp]  # of the rows, in the problem
    taken: Array  # (m q, b) columns of base and accepted effects
    left: Array  # (m q,)

    @classmethod
    def of(cls, pool: CandidateSet, accepted: Sequence[Candidate]) -> _Rows:
        number = np.arange(0, len(pool.problem), max(len(pool.problem) // ROWS, 1))
        number = number[pool.rows[number]]
        A = np.concatenate([pool.problem.T[number], *(pool.columns(c)[number] for c in accepted)], axis=2)
        return cls(pool, number, A.reshape(-1, A.shape[2]), pool.residual(accepted)[number].ravel())

    def columns(self, term: Term) -> Array:
        """The whitened columns (m q, p) of a term on these rows."""
        problem = self.pool.problem
        made = problem.whiten[self.number] @ term.columns(problem.scene.select(self.number))
        return np.asarray(made.reshape(-1, made.shape[2]))

    def gain(self, taken_off: float) -> float:
        """The log-likelihood that goes with a fall of the sum of squares, as if all rows were white noise."""
        whole = float(self.left @ self.left)
        return -0.5 * self.pool.n_data * float(np.log(max(1 - taken_off / whole, 1e-12)))


def _at_their_best(rows: _Rows, family: Family, forms: Sequence[Term]) -> list[Candidate]:
    """The forms of a family at the place that suits the first best; none where it could not be likely."""
    first, trials = forms[0], prod(len(shape.grid) for shape in forms[0].shape)
    points, falls = _on_grid(rows, first)
    best = np.argsort(-falls)[:BEST]
    needs = rows.pool.penalty(Candidate(family, first, trials), len(first.parameters))
    if NEARLY * rows.gain(float(falls[best[0]])) < needs:
        return []
    at = max((_refined(rows, points[i]) for i in best), key=lambda found: found[1])[0]
    return [Candidate(family, replace(form, shape=at.shape), trials) for form in forms]


def _on_grid(rows: _Rows, term: Term) -> tuple[list[Term], Array]:
    """The term at each grid point, and what it takes off the sum of squares there."""
    grids = itertools.product(*(shape.grid for shape in term.shape))
    points = [term.with_values(**dict(zip([s.name for s in term.shape], at, strict=True))) for at in grids]
    each = np.stack([_columns_of(rows, point) for point in points])
    gram, cross = np.swapaxes(each, 1, 2) @ each, np.swapaxes(each, 1, 2) @ rows.taken
    return points, explained_by_each(gram, cross, rows.left @ each, gram_pinv(rows.taken))


def _columns_of(rows: _Rows, point: Term) -> Array:
    """Its columns on these rows at unit length."""
    found = rows.columns(point)
    return found / np.maximum(np.linalg.norm(found, axis=0), 1e-300)


def _refined(rows: _Rows, point: Term) -> tuple[Term, float]:
    """The term at its best near a grid point, and what it takes off the sum of squares there."""
    from scipy.optimize import least_squares

    basis = np.linalg.qr(rows.taken)[0]
    names = [shape.name for shape in point.shape]

    def at(values: Array) -> Term:
        return point.with_values(**dict(zip(names, values.tolist(), strict=True)))

    def left(values: Array) -> Array:
        columns = _columns_of(rows, at(values))
        new = columns - basis @ (basis.T @ columns)
        return np.asarray(rows.left - new @ np.linalg.lstsq(new, rows.left, rcond=1e-6)[0])

    start = np.array([shape.value for shape in point.shape])
    found = least_squares(left, start, diff_step=1e-3, x_scale=30.0, max_nfev=EVALUATIONS)
    return at(found.x), float(rows.left @ rows.left - 2 * found.cost)

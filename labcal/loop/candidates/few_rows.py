"""Forms of many columns and several nonlinear parameters: where they stand is read off a few rows.

A device off the centre of the coils stands at a place with three angles, each form there has some thirty columns: a
grid of it over all rows would cost more than all other candidates. On a few hundred rows every grid point is one small
least-squares problem beside base and accepted effects; from the best ones on the place is found by variable projection
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
from labcal.loop.noise.nuisance import MIN_NEW_SHARE, explained_by_each
from labcal.model.effects import Family, Scene, Term, families

Array = NDArray[np.float64]
ROWS = 250  # about so many are looked at
ROUNDS = ((8, 2), (2, 8))  # so many of the best points are refined by so many steps; then of those the best
HALVINGS = 4  # of a step that takes off less
SETTLED = 1e-4  # of the sum of squares: a step that takes off no more ends it
SLOPE_STEP = 0.01  # of a grid step, over which a derivative is taken
NEARLY = 2.0  # times its gain at a grid point a form may gain at its best


def few_rows(pool: CandidateSet, accepted: Sequence[Candidate]) -> list[Candidate]:
    """Forms with such parameters where they take most off the residual that the accepted effects leave."""
    taken = {part.family.id for one in accepted for part in one.parts}
    open_to = [f for f in pool.store.memo.get("few rows", (), lambda: _searched(pool)) if f.family.id not in taken]
    if not open_to:
        return []
    rows = _Rows.of(pool, accepted)
    return [candidate for forms in open_to for candidate in _at_their_best(rows, forms)]


@dataclass(frozen=True, slots=True, eq=False)
class _Forms:
    """The forms of a family that are searched here, smallest first: all stand at the place of the first."""

    family: Family
    terms: tuple[Term, ...]
    points: tuple[Term, ...]  # the first of them, all over its grid
    columns: Array  # (points, m, q, p) whitened, on few rows


def _searched(pool: CandidateSet) -> list[_Forms]:
    """Every family that has such forms on this problem."""
    found, number = [], _numbers(pool)
    for family in (f for f in families() if f.found_by("few rows") and is_observable(pool.problem, f)):
        terms = [term for term in family.candidates(pool.problem.run) if term.found_by("few rows")]
        if terms:
            terms.sort(key=lambda term: len(term.parameters))
            grids = itertools.product(*(shape.grid for shape in terms[0].shape))
            points = tuple(_at(terms[0], np.array(values)) for values in grids)
            scene, whiten = pool.problem.scene.select(number), pool.problem.whiten[number]
            columns = np.stack([whiten @ point.columns(scene) for point in points])
            found.append(_Forms(family, tuple(terms), points, columns))
    return found


def _numbers(pool: CandidateSet) -> NDArray[np.intp]:
    """The numbers of a few rows of the problem."""
    return np.arange(0, len(pool.problem), max(len(pool.problem) // ROWS, 1))


def _at(term: Term, values: Array) -> Term:
    return term.with_values(**dict(zip([s.name for s in term.shape], values.tolist(), strict=True)))


@dataclass(frozen=True, slots=True, eq=False)
class _Rows:
    """A few rows of a set, with what the base and the accepted effects span there and what they leave."""

    pool: CandidateSet
    scene: Scene
    whiten: Array  # (m, q, 3)
    taken: Array  # (m q, b) orthonormal columns of base and accepted effects
    left: Array  # (m q,)

    @classmethod
    def of(cls, pool: CandidateSet, accepted: Sequence[Candidate]) -> _Rows:
        number = _numbers(pool)
        number = number[pool.rows[number]]
        A = np.concatenate([pool.problem.T[number], *(pool.columns(c)[number] for c in accepted)], axis=2)
        A = A.reshape(-1, A.shape[2])
        basis = np.linalg.svd(A / np.maximum(np.linalg.norm(A, axis=0), 1e-300), full_matrices=False)[0]
        y = pool.problem.y[number].ravel()
        scene, whiten = pool.problem.scene.select(number), pool.problem.whiten[number]
        return cls(pool, scene, whiten, basis, y - basis @ (basis.T @ y))

    def beside(self, term: Term) -> Array:
        """What a term leaves too (m q,)."""
        columns = (self.whiten @ term.columns(self.scene)).reshape(len(self.left), -1)
        new = columns - self.taken @ (self.taken.T @ columns)
        new = new / np.maximum(np.linalg.norm(columns, axis=0), 1e-300)
        values, vectors = np.linalg.eigh(new.T @ new)
        kept = vectors[:, values > MIN_NEW_SHARE]
        along = kept.T @ (new.T @ self.left) / values[values > MIN_NEW_SHARE]
        return np.asarray(self.left - new @ (kept @ along))

    def gain(self, taken_off: float) -> float:
        """The log-likelihood that goes with a fall of the sum of squares, as if all rows were white noise."""
        whole = float(self.left @ self.left)
        return -0.5 * self.pool.n_data * float(np.log(max(1 - taken_off / whole, 1e-12)))


def _at_their_best(rows: _Rows, forms: _Forms) -> list[Candidate]:
    """The forms of a family at the place that suits the first best; none where they could not be likely."""
    falls = _on_grid(rows, forms)
    first = Candidate(forms.family, forms.terms[0], prod(len(shape.grid) for shape in forms.terms[0].shape))
    if NEARLY * rows.gain(float(falls.max())) < rows.pool.penalty(first, len(first.term.parameters)):
        return []
    found = [(forms.points[i], float(falls[i])) for i in np.argsort(-falls)]
    for count, steps in ROUNDS:
        found = sorted((_refined(rows, point, steps) for point, _ in found[:count]), key=lambda one: -one[1])
    return [replace(first, term=replace(term, shape=found[0][0].shape)) for term in forms.terms]


def _on_grid(rows: _Rows, forms: _Forms) -> Array:
    """What the first form takes off the sum of squares at each grid point (points,)."""
    seen = rows.pool.rows[_numbers(rows.pool)]
    each = forms.columns[:, seen].reshape(len(forms.points), len(rows.left), -1)
    across = np.swapaxes(each, 1, 2)
    return explained_by_each(across @ each, across @ rows.taken, rows.left @ each, np.eye(rows.taken.shape[1]))


def _refined(rows: _Rows, point: Term, steps: int) -> tuple[Term, float]:
    """The term some Gauss-Newton steps from a point, and what it takes off the sum of squares there."""
    t_s = rows.pool.problem.scene.t_s
    values = np.array([shape.value for shape in point.shape])
    small = SLOPE_STEP * np.array([high - low for low, high in (shape.bracket(t_s) for shape in point.shape)])
    left = rows.beside(point)
    for _ in range(steps):
        slopes = [(rows.beside(_at(point, values + step)) - left) / step.max() for step in np.diag(small)]
        there, then = _stepped(
            rows, point, values, np.linalg.lstsq(np.column_stack(slopes), -left, rcond=None)[0], left
        )
        gained, values, left = float(left @ left - then @ then), there, then
        if gained <= SETTLED * float(left @ left):
            break
    return _at(point, values), float(rows.left @ rows.left - left @ left)


def _stepped(rows: _Rows, point: Term, values: Array, step: Array, left: Array) -> tuple[Array, Array]:
    """The values a step on, or a part of it that leaves less than `left`, and what they leave; else the same."""
    for _ in range(HALVINGS):
        then = rows.beside(_at(point, values + step))
        if then @ then < left @ left:
            return values + step, then
        step = step / 2
    return values, left

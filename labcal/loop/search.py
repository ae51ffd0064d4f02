"""Every effect that could be at work, weighed against an unnamed process on the same rows.

The weight of a candidate is the gain in log-likelihood over the model without it, noise process and all, less half the
logarithm of the number of data for each parameter (Schwarz 1978) and less the logarithm of the number of looks that its
family took (time constants, step times, frequencies). Above zero it is more probable than not; NAMED is far above.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field, replace

import numpy as np
from numpy.typing import NDArray

from labcal.loop.periods import periodogram, usual
from labcal.loop.problem import Problem
from labcal.loop.spectrum import Bands, Likelihood, Stage, bands_of, transformed
from labcal.model.effects import Family, Form, families

Array = NDArray[np.float64]
NAMED = 12.0  # nats of weight below which nothing is named: odds of 1.6e5 to one
PEAKS = 3  # frequencies that a periodic effect is tried at
SEEN = 1e-4  # of a column's square must be new to the base
NOTHING = 1e-10  # of the largest eigenvalue: directions below carry no information
CYCLES = 3.0  # a period must fit this often into a median segment: what a turn forth and back repeats, fits twice


@dataclass(frozen=True, slots=True, eq=False)
class Candidate:
    """A form of a family at fixed shape, and how many looks the family took to find it."""

    family: Family
    form: Form
    looks: int = 1

    @property
    def cause(self) -> tuple[str, tuple[str, ...]]:
        """What is named: the effect's id and its channels."""
        return self.family.id, self.form.channels

    @property
    def size(self) -> int:
        """Parameters that were fitted: the linear ones, and the shapes that were searched."""
        return len(self.form.parameters) + sum(1 for s in self.form.shape if s.grid)


@dataclass(frozen=True, slots=True, eq=False)
class Weighed:
    """A candidate with its evidence."""

    candidate: Candidate
    gain: float  # log-likelihood over the model without it
    weight: float  # gain less its price
    drop: float  # of the mean square of the whitened residual, plain least squares
    rank: int  # columns that the base does not already have
    likelihood: Likelihood


def expand(problem: Problem) -> list[Candidate]:
    """Every form of every family at every point of its grid; those that need no residual to look at."""
    found = []
    for family in families():
        if family.sought == "grid" and _at_home(problem, family):
            at_once = [form for form in family.candidates(problem.run) if not _delayed(form)]
            for points in map(_points, at_once):
                found += [Candidate(family, point, len(points)) for point in points]
    return found


def _delayed(form: Form) -> bool:
    return any(shape.name == "delay_s" for shape in form.shape)


def _at_home(problem: Problem, family: Family) -> bool:
    """Whether this problem can show the family at all.

    Effects of the rig need to know where the cage is. So does a lag: shifting noisy readings averages them, which
    lowers a magnitude's residual with no lag at work. Effects of the field need a base that knows the gains.
    """
    if family.of_field and problem.base != "affine":
        return False
    return not (family.belongs_to == "rig" or family.from_vectors) or problem.scene.rig is not None


def _points(form: Form) -> list[Form]:
    searched = [s for s in form.shape if s.grid]
    return [
        form.reshaped(**dict(zip([s.name for s in searched], values, strict=True)))
        for values in itertools.product(*(s.grid for s in searched))
    ]


def periodic(problem: Problem, residual: Array) -> list[Candidate]:
    """What shows as a line, at the highest peaks against their neighbourhood, for a residual (n, q).

    What is transformed is the score of an offset along each body axis: a magnitude alone would show the line split by
    the turning of the field.
    """
    forms = [(f, form) for f in families() if f.sought == "lines" for form in f.candidates(problem.run)]
    if not forms:
        return []
    offsets = np.einsum("nqj,nq->nj", problem.whiten, residual)
    frequency, power = periodogram(problem.scene.t_s, offsets)
    t, segment = problem.scene.t_s, problem.scene.segment
    lengths = [float(np.ptp(t[segment == s])) for s in np.unique(segment)]
    low = CYCLES / max(float(np.median(lengths)), 1e-9)
    contrast = np.where((frequency > low) & (frequency < 0.98 * frequency[-1]), power / usual(power), 0.0)
    found: list[Candidate] = []
    for _ in range(PEAKS):
        peak = int(np.argmax(contrast))
        if contrast[peak] <= 0:
            break
        for family, form in forms:
            at = replace(form.shape[0], value=float(frequency[peak]), grid=(0.0,))
            found.append(Candidate(family, replace(form, shape=(at,)), len(frequency)))
        contrast[max(peak - 8, 0) : peak + 9] = 0.0
    return found


@dataclass(eq=False)
class Search:
    """The candidates' columns on the rows of a problem, or on some of them, in the frequency domain."""

    problem: Problem
    candidates: list[Candidate]
    rows: NDArray[np.bool_]
    lowest: float  # of the white noise, in whitened units
    good: NDArray[np.bool_]  # (N,) rows of the whole problem that do not lie
    bands: Bands = field(init=False)
    base: Array = field(init=False)  # (n, q, t) transformed tangent
    y: Array = field(init=False)  # (n, q, 1)
    whitened: dict[int, tuple[Form, Array]] = field(default_factory=dict)  # shared between folds: columns on all rows
    _moved: dict[int, tuple[Form, Array]] = field(default_factory=dict)  # a kept form keeps its id to itself

    def __post_init__(self) -> None:
        self.bands = bands_of(int(self.rows.sum()))
        self.base = transformed(self.problem.T[self.rows])
        self.y = transformed(self.problem.y[self.rows])[:, :, None]

    @property
    def data(self) -> int:
        """Numbers that are fitted."""
        return int(self.y.size)

    @property
    def whole(self) -> Problem:
        """The problem with all its rows, where this search looks at bins of them."""
        return self.problem.whole or self.problem

    @property
    def rows_each(self) -> float:
        """Rows of the whole problem for each row of this one."""
        return len(self.whole) / len(self.problem)

    def on(self, rows: NDArray[np.bool_]) -> Search:
        """The same search on fewer rows."""
        return Search(self.problem, self.candidates, rows, self.lowest, self.good, whitened=self.whitened)

    def unbinned(self) -> Search:
        """The same search on every row of the whole problem."""
        return Search(self.whole, self.candidates, self.good, self.lowest, self.good)

    def without(self, lying: NDArray[np.bool_]) -> Search:
        """The same search without these rows (N,) of the whole problem, and without the bins that hold one."""
        bins = self.problem.bins
        here = ~lying if bins is None else ~bins.any(lying)
        return Search(self.problem, self.candidates, here, self.lowest, ~lying, whitened=self.whitened)

    def among(self, candidates: list[Candidate]) -> Search:
        """The same search among fewer candidates."""
        return Search(self.problem, candidates, self.rows, self.lowest, self.good, whitened=self.whitened)

    def columns(self, candidate: Candidate) -> Array:
        """Its whitened columns on all rows (n, q, p)."""
        key = id(candidate.form)
        if key not in self.whitened:
            self.whitened[key] = candidate.form, self.problem.columns(candidate.form)
        return self.whitened[key][1]

    def moved(self, candidate: Candidate) -> Array:
        """Its columns on these rows, transformed."""
        key = id(candidate.form)
        if key not in self._moved:
            self._moved[key] = candidate.form, transformed(self.columns(candidate)[self.rows])
        return self._moved[key][1]

    def stage(self, accepted: Sequence[Candidate] = (), beside: Sequence[Array] = ()) -> Stage:
        """The base, what is accepted and other transformed columns, ready for candidates to stand beside."""
        columns = self.base
        for part in (*(self.moved(c) for c in accepted), *beside):
            columns = np.concatenate([columns, new_to(columns, part)], axis=2)
        return Stage.of(columns, self.y, self.bands, self.lowest)

    def weigh(self, candidate: Candidate, stage: Stage) -> Weighed:
        """The evidence for a candidate beside what the stage holds."""
        found, rank = stage.beside(self.moved(candidate))
        gain = found.log - stage.null.log
        weight = gain - self.price(candidate, rank)
        drop = (stage.null.rss - found.rss) / (self.data * self.rows_each)
        return Weighed(candidate, gain, weight, drop, rank, found)

    def price(self, candidate: Candidate, rank: int) -> float:
        """What a candidate has to gain before it weighs anything [nats], where `rank` of its columns are new."""
        size = rank + candidate.size - len(candidate.form.parameters)
        return float(0.5 * size * np.log(self.data) + np.log(candidate.looks))

    def rank(
        self, candidates: Iterable[Candidate], accepted: Sequence[Candidate] = (), beside: Sequence[Array] = ()
    ) -> list[Weighed]:
        """The best look of each cause beside what is accepted and `beside`, heaviest first."""
        stage = self.stage(accepted, beside)
        best: dict[tuple[str, tuple[str, ...]], Weighed] = {}
        for candidate in candidates:
            found = self.weigh(candidate, stage)
            if candidate.cause not in best or found.weight > best[candidate.cause].weight:
                best[candidate.cause] = found
        return sorted(best.values(), key=lambda w: -w.weight)

    def residual(self, accepted: Sequence[Candidate]) -> Array:
        """What plain least squares on these rows leaves of all rows of the problem (n, q)."""
        A = np.concatenate([self.problem.T, *(self.columns(c) for c in accepted)], axis=2)
        return np.asarray(self.problem.y - A @ self.solved(accepted))

    def solved(self, accepted: Sequence[Candidate]) -> Array:
        """The base's steps and the effects' parameters by plain least squares on these rows."""
        T, y, rows = self.problem.T, self.problem.y, self.rows
        A = np.concatenate([T[rows], *(self.columns(c)[rows] for c in accepted)], axis=2)
        return minimise(A, y[rows], T.shape[2])

    def everywhere(self, accepted: Sequence[Candidate]) -> tuple[Array, Array]:
        """Of every row of the whole problem (N, q): what that leaves, and what the accepted effects add."""
        whole, x = self.whole, self.solved(accepted)
        base = whole.T.shape[2]
        added = np.zeros_like(whole.y)
        for columns in map(self.whole_columns, accepted):
            added += columns @ x[base : base + columns.shape[2]]
            base += columns.shape[2]
        return np.asarray(whole.y - whole.T @ x[: whole.T.shape[2]] - added), added

    def whole_columns(self, candidate: Candidate) -> Array:
        """Its whitened columns on every row of the whole problem (N, q, p)."""
        return self.columns(candidate) if self.problem.whole is None else self.whole.columns(candidate.form)


def new_to(columns: Array, part: Array) -> Array:
    """Combinations of `part` (n, q, p) of which more than SEEN of the square is new to `columns` (n, q, b)."""
    X, own = (
        a.reshape(-1, a.shape[2]) / np.maximum(np.sqrt(np.sum(a**2, axis=(0, 1))), 1e-300) for a in (columns, part)
    )
    cross = X.T @ own
    left = own.T @ own - cross.T @ np.linalg.pinv(X.T @ X, rcond=NOTHING, hermitian=True) @ cross
    values, vectors = np.linalg.eigh(left)
    return np.asarray((own @ vectors[:, values > SEEN]).reshape(*part.shape[:2], -1))


def minimise(A: Array, y: Array, base: int) -> Array:
    """The x of least |A x − y|² for A (n, q, p), of which the first `base` columns are the base model's.

    Directions of the others that the base nearly contains (to SEEN of their square) stay at zero: a large effect that
    the base undoes is no finding, and nothing that the data support.
    """
    n, q, p = A.shape
    flat = A.reshape(n * q, p)
    scale = np.linalg.norm(flat, axis=0)
    scale = np.where(scale > 0, scale, 1.0)
    gram, pull = (flat / scale).T @ (flat / scale), flat.T @ y.ravel() / scale
    inverse = np.linalg.pinv(gram[:base, :base], rcond=NOTHING, hermitian=True)
    carried = inverse @ gram[:base, base:]
    values, vectors = np.linalg.eigh(gram[base:, base:] - gram[base:, :base] @ carried)
    kept = np.where(values > SEEN, 1 / np.maximum(values, 1e-300), 0.0)
    x = vectors @ (kept * (vectors.T @ (pull[base:] - carried.T @ pull[:base])))
    return np.asarray(np.concatenate([inverse @ (pull[:base] - gram[:base, base:] @ x), x]) / scale)

"""Every effect that could be at work, weighed against an unnamed process on the same rows.

The weight of a candidate is the gain in log-likelihood over the model without it, noise process and all, less half the
logarithm of the number of data for each parameter (Schwarz 1978) and less the logarithm of the number of looks that its
family took (time constants, step times, frequencies). Above zero it is more probable than not; NAMED is far above.
"""

from __future__ import annotations

from collections.abc import Callable, Hashable, Iterable, Sequence
from dataclasses import dataclass, field
from functools import partial
from typing import Any, TypeVar

import numpy as np
from numpy.typing import NDArray

from labcal.loop.candidates.library import Candidate
from labcal.loop.data.linear_problem import Problem
from labcal.loop.noise.bands import Bands, bands_of, fast, transformed
from labcal.loop.noise.coloured import Grams, Likelihood, Stage
from labcal.loop.noise.nuisance import minimise, new_to, orthonormal
from labcal.loop.parallel import each

Array = NDArray[np.float64]
Kept = TypeVar("Kept")
AT_ONCE = 64  # columns that are weighed together
LONG = 5000  # rows from which any at the end are not looked at, for a length that is fast to transform;
PRIMES = 2 * 3 * 5 * 7 * 11 * 13  # that a length of fewer rows may have: mostly none is dropped, or one in a hundred
KEPT_NUMBERS = 12_000_000  # of transformed columns of all candidates: more are transformed anew each time


@dataclass(frozen=True, slots=True, eq=False)
class Weighed:
    """A candidate with its evidence."""

    candidate: Candidate
    gain: float  # log-likelihood over the model without it
    weight: float  # gain less its price
    drop: float  # of the mean square of the whitened residual, plain least squares
    rank: int  # columns that the base does not already have
    likelihood: Likelihood


@dataclass(frozen=True, slots=True, eq=False)
class Columns:
    """Candidates with equally many columns, side by side: what is done to one is done to all at the price of few."""

    candidates: tuple[Candidate, ...]
    whitened: Array  # (n, q, candidates, p) on all rows


@dataclass(eq=False)
class Search:
    """The candidates' columns on the rows of a problem, or on some of them, in the frequency domain."""

    problem: Problem
    candidates: list[Candidate]
    rows: NDArray[np.bool_]
    lowest: float  # of the white noise, in whitened units
    good: NDArray[np.bool_]  # (N,) rows of the whole problem that do not lie
    bands: Bands = field(init=False)
    base: Array = field(init=False)  # (n, q, t) orthonormal, spans the transformed tangent
    y: Array = field(init=False)  # (n, q, 1)
    part: bool = False  # of the rows of another search
    moving: NDArray[np.intp] = field(init=False)  # numbers of the rows that are transformed
    shared: dict[Any, Any] = field(default_factory=dict)  # with the same search on other rows
    _own: dict[Any, Any] = field(default_factory=dict)

    def __post_init__(self) -> None:
        self.moving = np.flatnonzero(self.rows)
        few = len(self.moving) <= LONG and not self.part
        length = fast(len(self.moving), PRIMES) if few else fast(len(self.moving))
        self.moving = self.moving[:length]
        self.bands = bands_of(len(self.moving))
        self.base = orthonormal(transformed(self.problem.T[self.moving]))
        self.y = transformed(self.problem.y[self.moving])[:, :, None]

    def once(
        self, what: Hashable, about: Sequence[object], make: Callable[[], Kept], *, everywhere: bool = False
    ) -> Kept:
        """What `make` gives, made once for `what` and these very objects; `everywhere`: whatever the rows.

        Two threads that ask at once may both make it; either gets the same.
        """
        kept = self.shared if everywhere else self._own
        key = (what, *map(id, about))
        if key not in kept:
            kept.setdefault(key, (make(), tuple(about)))  # which keep their ids to themselves
        found: Kept = kept[key][0]
        return found

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

        def made() -> Search:
            return Search(self.problem, self.candidates, rows, self.lowest, self.good, part=True, shared=self.shared)

        return self.once(("on", rows.tobytes()), (), made)

    def unbinned(self) -> Search:
        """A search on every row behind these, among whatever it is asked about."""
        bins = self.problem.bins
        rows = self.good & (self.rows if bins is None else bins.spread(self.rows))
        return Search(self.whole, [], rows, self.lowest, self.good)

    def without(self, lying: NDArray[np.bool_]) -> Search:
        """The same search without these rows (N,) of the whole problem, and without the bins that hold one."""
        if bool((lying == ~self.good).all()):
            return self
        bins = self.problem.bins
        here = ~lying if bins is None else ~bins.any(lying)
        return Search(self.problem, self.candidates, here, self.lowest, ~lying, shared=self.shared)

    def among(self, candidates: list[Candidate]) -> Search:
        """The same search among fewer candidates."""
        return Search(self.problem, candidates, self.rows, self.lowest, self.good)

    @property
    def standing(self) -> list[Columns]:
        """A family's candidates in groups of as many columns, few enough at a time to stay in the processor's cache."""
        return self.once("standing", (), self._grouped, everywhere=True)

    def _grouped(self) -> list[Columns]:
        alike: dict[tuple[str, int], list[Candidate]] = {}
        for candidate in self.candidates:
            alike.setdefault((candidate.family.id, len(candidate.form.parameters)), []).append(candidate)
        some = []
        for (_, size), group in alike.items():
            count = max(AT_ONCE // size, 1)
            some += [group[k : k + count] for k in range(0, len(group), count)]
        return each(self._side_by_side, some)

    def _side_by_side(self, some: Sequence[Candidate]) -> Columns:
        n, q = self.problem.y.shape
        whitened = np.empty((n, q, len(some), len(some[0].form.parameters)))
        for place, candidate in enumerate(some):
            whitened[:, :, place] = self.problem.columns(candidate.form)
        group = Columns(tuple(some), whitened)
        for place, candidate in enumerate(some):
            self.shared["home", id(candidate.form)] = (group, place), (candidate.form,)
        return group

    def columns(self, candidate: Candidate) -> Array:
        """Its whitened columns on all rows (n, q, p)."""
        form, home = candidate.form, self._home(candidate)
        if home is not None:
            return home[0].whitened[:, :, home[1]]
        return self.once("columns", (form,), lambda: self.problem.columns(form), everywhere=True)

    def _home(self, candidate: Candidate) -> tuple[Columns, int] | None:
        """The group that has its columns, and its place there."""
        found: tuple[tuple[Columns, int], object] | None = self.shared.get(("home", id(candidate.form)))
        return None if found is None else found[0]

    def moved(self, candidate: Candidate) -> Array:
        """Its columns on these rows, transformed."""
        home = self._home(candidate)
        if home is not None and self._may_keep():
            return self.moved_each(home[0])[:, :, home[1]]
        return self.once("moved", (candidate.form,), lambda: transformed(self.columns(candidate)[self.moving]))

    def moved_each(self, group: Columns) -> Array:
        """The columns of a group on these rows, transformed (n, q, candidates, p); kept where that is not too much."""

        def made() -> Array:
            return transformed(group.whitened[self.moving])

        return self.once("moved", (group,), made) if self._may_keep() else made()

    def _may_keep(self) -> bool:
        def counted() -> int:
            return sum(len(c.form.parameters) for c in self.candidates)

        return self.y.size * self.once("parameters", (), counted, everywhere=True) < KEPT_NUMBERS

    def _ground(self, group: Columns) -> Grams:
        """The Gram matrices of a group with the base and with y."""

        def made() -> Grams:
            right = np.concatenate([self.base, self.y], axis=2)
            return Grams.of(self.moved_each(group), right.reshape(self.data, -1), self.bands)

        return self.once("ground", (group,), made)

    def stage(self, accepted: Sequence[Candidate] = (), beside: Sequence[Array] = ()) -> Stage:
        """The base, what is accepted and other transformed columns, ready for candidates to stand beside."""

        def made() -> Stage:
            columns = self.base
            for part in (*(self.moved(c) for c in accepted), *beside):
                columns = np.concatenate([columns, new_to(columns, part)], axis=2)
            return Stage.of(columns, self.y, self.bands, self.lowest)

        return self.once("stage", [*(c.form for c in accepted), *beside], made)

    def weigh(self, candidate: Candidate, stage: Stage) -> Weighed:
        """The evidence for a candidate beside what the stage holds."""
        return self.weigh_each([candidate], stage)[0]

    def weigh_each(self, candidates: Sequence[Candidate], stage: Stage) -> list[Weighed]:
        """The evidence for each, beside what the stage holds."""
        found = self.once("weighed", (stage,), lambda: dict[int, Weighed]())
        open_to = {id(c) for c in candidates} - found.keys()
        groups = [g for g in self.standing if 4 * sum(id(c) in open_to for c in g.candidates) > len(g.candidates)]
        for group, evidence in zip(groups, each(partial(self._beside, stage), groups), strict=True):
            found |= {id(c): self._weighed(c, stage, *e) for c, e in zip(group.candidates, evidence, strict=True)}
        for candidate in candidates:
            if id(candidate) not in found:
                found[id(candidate)] = self._weighed(candidate, stage, *stage.beside(self.moved(candidate)))
        return [found[id(c)] for c in candidates]

    def _beside(self, stage: Stage, group: Columns) -> list[tuple[Likelihood, int]]:
        return stage.beside_each(self.moved_each(group), self._ground(group))

    def _weighed(self, candidate: Candidate, stage: Stage, found: Likelihood, rank: int) -> Weighed:
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
        best: dict[tuple[str, tuple[str, ...]], Weighed] = {}
        for found in self.weigh_each(list(candidates), self.stage(accepted, beside)):
            cause = found.candidate.cause
            if cause not in best or found.weight > best[cause].weight:
                best[cause] = found
        return sorted(best.values(), key=lambda w: -w.weight)

    def residual(self, accepted: Sequence[Candidate]) -> Array:
        """What plain least squares on these rows leaves of all rows of the problem (n, q)."""
        A = np.concatenate([self.problem.T, *(self.columns(c) for c in accepted)], axis=2)
        return np.asarray(self.problem.y - A @ self.solved(accepted))

    def solved(self, accepted: Sequence[Candidate]) -> Array:
        """The base's steps and the effects' parameters by plain least squares on these rows."""

        def made() -> Array:
            T, y, rows = self.problem.T, self.problem.y, self.rows
            A = np.concatenate([T[rows], *(self.columns(c)[rows] for c in accepted)], axis=2)
            return minimise(A, y[rows], T.shape[2])

        return self.once("solved", [c.form for c in accepted], made)

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

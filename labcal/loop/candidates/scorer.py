"""Scores of candidates: the evidence of each beside the base model, accepted effects and coloured noise.

The evidence is the gain in log-likelihood over the null model less a penalty: half the logarithm of the number of data
for each parameter (Schwarz, Ann. Statist. 6, 461, 1978), and the logarithm of the trials of its family (time constants,
step times, frequencies). Above zero a candidate is more probable than not.
"""

from __future__ import annotations

import itertools
from collections.abc import Callable, Hashable, Iterable, Sequence
from dataclasses import dataclass, field
from functools import partial
from typing import Any

import numpy as np
from numpy.typing import NDArray

from labcal.loop.candidates.columns import ColumnGroup, ColumnStore, Kept, Memo
from labcal.loop.candidates.library import Candidate, Cause, Span, expand_library
from labcal.loop.candidates.prior import as_data
from labcal.loop.data.decimate import decimate
from labcal.loop.data.linear_problem import LinearProblem
from labcal.loop.noise.bands import Bands, bands_of, cosine_transform, fast_length
from labcal.loop.noise.coloured import Grams, Likelihood, NullModel
from labcal.loop.noise.column_sets import ColumnSets
from labcal.loop.noise.declared_directions import DeclaredDirections
from labcal.loop.noise.nuisance import ols_with_nuisance, orthogonal_complement, orthonormal
from labcal.loop.parallel import parallel_map

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]
GROUP_SHARE = 0.25  # of a group has to be asked for before all of it is scored
LONG_RUN = 5000  # rows: fewer may have more prime factors, so that mostly none is dropped for a fast transform
PRIMES = 2 * 3 * 5 * 7 * 11 * 13  # of the length of a short run
CACHE_NUMBERS = 20_000_000  # in all transformed columns: more are not kept


Tell = Callable[["CandidateSet", Sequence[Candidate], str], None]  # what is scored beside what is accepted


def silent(pool: CandidateSet, accepted: Sequence[Candidate], doing: str) -> None:
    """Tell nobody."""


@dataclass(frozen=True, slots=True, eq=False)
class Scored:
    """A candidate with its evidence."""

    candidate: Candidate
    gain: float  # in log-likelihood over the null model [nats]
    evidence: float  # gain less penalty [nats]
    drop: float  # of the mean square of the whitened residual, by ordinary least squares
    rank: int  # directions that the null model does not have
    likelihood: Likelihood


@dataclass(eq=False)
class CandidateSet:
    """Candidates on the rows of a problem, or on some of them, ready to be scored in the frequency domain."""

    problem: LinearProblem
    candidates: list[Candidate]
    rows: Mask
    min_noise_level: float  # of the white noise, in whitened units
    valid: Mask  # (N,) rows of the full problem that are no outliers
    part: bool = False  # whether its rows are a part of another set's
    shared: ColumnStore | None = None  # the columns, where another set has them
    tell: Tell = silent  # a person who waits
    store: ColumnStore = field(init=False)
    bands: Bands = field(init=False)
    base: Array = field(init=False)  # (n, q, t) orthonormal, spans the transformed tangent
    y: Array = field(init=False)  # (n, q, 1)
    transformed_rows: NDArray[np.intp] = field(init=False)  # numbers of the rows that are transformed
    _memo: Memo = field(init=False, default_factory=Memo)

    def __post_init__(self) -> None:
        self.store = self.shared or ColumnStore(self.problem, self.candidates)
        rows = np.flatnonzero(self.rows)
        short = len(rows) <= LONG_RUN and not self.part
        self.transformed_rows = rows[: fast_length(len(rows), PRIMES) if short else fast_length(len(rows))]
        self.bands = bands_of(len(self.transformed_rows))
        self.base = orthonormal(self.transformed(self.problem.T))
        self.y = self.transformed(self.problem.y[:, :, None])

    @classmethod
    def of(cls, problem: LinearProblem, min_noise_level: float, tell: Tell = silent) -> CandidateSet:
        """The whole library on all rows, or on means of them where there are many."""
        fewer = decimate(problem)
        rows, valid = (np.ones(len(p), dtype=bool) for p in (fewer, problem))
        return cls(fewer, expand_library(fewer), rows, min_noise_level, valid, tell=tell)

    def cached(self, what: Hashable, about: Sequence[Hashable], make: Callable[[], Kept]) -> Kept:
        """What `make` gives on these rows, made once for `what` and these very objects."""
        return self._memo.get(what, about, make)

    @property
    def n_data(self) -> int:
        """Numbers that are fitted."""
        return int(self.y.size)

    @property
    def whole(self) -> LinearProblem:
        """The problem with all its rows, where this set works on means of them."""
        return self.problem.whole or self.problem

    @property
    def decimation(self) -> float:
        """Rows of the whole problem for each row of this one."""
        return len(self.whole) / len(self.problem)

    def on(self, rows: Mask) -> CandidateSet:
        """The same candidates on fewer rows."""

        def made() -> CandidateSet:
            return CandidateSet(
                self.problem, self.candidates, rows, self.min_noise_level, self.valid, part=True, shared=self.store
            )

        return self.cached(("on", rows.tobytes()), (), made)

    def undecimated(self) -> CandidateSet:
        """A set without candidates of its own, on every row behind these."""
        bins = self.problem.bins
        rows = self.valid & (self.rows if bins is None else bins.spread(self.rows))
        return CandidateSet(self.whole, [], rows, self.min_noise_level, self.valid)

    def without_rows(self, outlying: Mask) -> CandidateSet:
        """The same candidates without these rows (N,) of the whole problem, and without the bins that hold one."""
        if bool((outlying == ~self.valid).all()):
            return self
        bins = self.problem.bins
        rows = ~outlying if bins is None else ~bins.any(outlying)
        shared: dict[str, Any] = {"shared": self.store, "tell": self.tell}
        return CandidateSet(self.problem, self.candidates, rows, self.min_noise_level, ~outlying, **shared)

    def among(self, candidates: tuple[Candidate, ...]) -> CandidateSet:
        """Some of these candidates on the same rows, with the columns that are known."""

        def made() -> CandidateSet:
            few: dict[str, Any] = {"part": self.part, "shared": self.store, "tell": self.tell}
            return CandidateSet(self.problem, list(candidates), self.rows, self.min_noise_level, self.valid, **few)

        return self if len(candidates) == len(self.candidates) else self.cached("among", candidates, made)

    def restricted_to(self, candidates: list[Candidate]) -> CandidateSet:
        """Fewer candidates on the same rows."""
        return CandidateSet(self.problem, candidates, self.rows, self.min_noise_level, self.valid)

    def transformed(self, columns: Array) -> Array:
        """Columns (n, q, p) of all rows as the likelihood has them (rows, q, p): on these rows, cosine-transformed.

        In white noise the errors that the run declares are no evidence: they are integrated over their prior.
        """
        rows = self.transformed_rows
        whole = int(rows[-1] - rows[0]) == len(rows) - 1  # no row is left out between them: a view
        part = columns[rows[0] : rows[-1] + 1] if whole else columns[rows]
        return cosine_transform(self._declared(rows).whitened(part))

    def _declared(self, rows: NDArray[np.intp]) -> DeclaredDirections:
        """What errors that the run declares move on some rows."""
        of_all = self.problem.declared
        return self.cached(("declared", len(rows)), (), lambda: DeclaredDirections.of(of_all[rows]))

    def columns(self, candidate: Candidate) -> Array:
        """Its whitened columns on all rows of the problem (n, q, p)."""
        return self.store.columns(candidate)

    def transformed_columns(self, candidate: Candidate) -> Array:
        """Its columns on these rows, cosine-transformed (n, q, p)."""
        home = self.store.home(candidate)
        if home is not None and self._fits_in_memory:
            return self.transformed_group(home[0]).columns(home[1])
        return self.cached("transformed", (candidate,), lambda: self.transformed(self.columns(candidate)))

    def transformed_group(self, group: ColumnGroup) -> ColumnSets:
        """The columns of a group on these rows, transformed; kept where that is not too much."""

        def made() -> ColumnSets:
            return group.whitened.like(self.transformed(group.whitened.made_of))

        return self.cached("transformed", (group,), made) if self._fits_in_memory else made()

    def forget_columns(self) -> None:
        """Give back the memory of the transformed columns: nothing more is searched on these rows."""
        self._memo.forget("transformed")

    @property
    def _fits_in_memory(self) -> bool:
        return self.y.size * self.store.n_columns < CACHE_NUMBERS

    def _base_grams(self, group: ColumnGroup) -> Grams:
        """The Gram matrices of a group with the base and with y."""

        def made() -> Grams:
            right = np.concatenate([self.base, self.y], axis=2)
            return Grams.of(self.transformed_group(group), right.reshape(self.n_data, -1), self.bands)

        return self.cached("base grams", (group,), made)

    def null_model(self, accepted: Sequence[Candidate] = (), beside: Sequence[Span] = ()) -> NullModel:
        """The base, the accepted effects and other columns: what a candidate is scored against."""

        def made() -> NullModel:
            columns = self.base
            for part in (*(self.transformed_columns(c) for c in accepted), *(span.columns for span in beside)):
                columns = np.concatenate([columns, orthogonal_complement(columns, part)], axis=2)
            return NullModel.of(columns, self.y, self.bands, self.min_noise_level)

        return self.cached("null model", (*accepted, *beside), made)

    def score(self, candidate: Candidate, null_model: NullModel) -> Scored:
        """The evidence for a candidate beside the null model."""
        return self.score_each([candidate], null_model)[0]

    def score_each(self, candidates: Sequence[Candidate], null_model: NullModel) -> list[Scored]:
        """The evidence for each beside the null model; by groups where at least a quarter of a group is asked for."""
        found = self.cached("scores", (null_model,), lambda: dict[Candidate, Scored]())
        missing = set(candidates) - found.keys()
        groups = [g for g in self.store.groups if np.mean([c in missing for c in g.candidates]) > GROUP_SHARE]
        for group, scores in zip(groups, parallel_map(partial(self._with_group, null_model), groups), strict=True):
            found |= {c: self._scored(c, null_model, *s) for c, s in zip(group.candidates, scores, strict=True)}
        for candidate in candidates:
            if candidate not in found:
                likelihood = null_model.with_columns(self.transformed_columns(candidate))
                found[candidate] = self._scored(candidate, null_model, *likelihood)
        return [found[c] for c in candidates]

    def _with_group(self, null_model: NullModel, group: ColumnGroup) -> list[tuple[Likelihood, int]]:
        grams = self._base_grams(group)
        more = null_model.columns_and_y[:, self.base.shape[2] : -1]
        if more.shape[1]:
            grams = grams.with_columns(self.transformed_group(group), more, self.bands)
        return null_model.with_each(grams)

    def _scored(self, candidate: Candidate, null_model: NullModel, found: Likelihood, rank: int) -> Scored:
        gain = found.log - null_model.null.log
        evidence = gain - self.penalty(candidate, rank)
        drop = (null_model.null.rss - found.rss) / (self.n_data * self.decimation)
        return Scored(candidate, gain, evidence, drop, rank, found)

    def penalty(self, candidate: Candidate, rank: int) -> float:
        """What a candidate has to gain before it has any evidence [nats], where `rank` of its columns are new."""
        size = rank + candidate.size - len(candidate.term.parameters)
        return float(0.5 * size * np.log(self.n_data) + np.log(candidate.trials))

    def rank(
        self, candidates: Iterable[Candidate], accepted: Sequence[Candidate] = (), beside: Sequence[Span] = ()
    ) -> list[Scored]:
        """The best candidate of each cause beside what is accepted and `beside`, most evidence first."""
        best: dict[Cause, Scored] = {}
        for found in self.score_each(list(candidates), self.null_model(accepted, beside)):
            cause = found.candidate.cause
            if cause not in best or found.evidence > best[cause].evidence:
                best[cause] = found
        return sorted(best.values(), key=lambda s: -s.evidence)

    def residual(self, accepted: Sequence[Candidate]) -> Array:
        """What least squares on these rows leaves of all rows (n, q), beside errors that the run declares."""
        A = np.concatenate([self.problem.T, *(self.columns(c) for c in accepted)], axis=2)
        left = self.problem.y - A @ self.coefficients(accepted)
        return np.asarray(left - self.problem.declared @ self.declared_errors(accepted))

    def coefficients(self, accepted: Sequence[Candidate]) -> Array:
        """The base's steps and the effects' parameters by ordinary least squares on these rows."""

        def made() -> Array:
            A, y = self._on_these_rows(accepted)
            taken, start = self._declared(np.flatnonzero(self.rows)), self.problem.T.shape[2]
            A, y = taken.whitened(A), taken.whitened(y[:, :, None])[:, :, 0]
            terms = [c.term for c in accepted]

            def solved(beta: Sequence[Array] | None) -> Array:
                known, _ = as_data(terms, beta, start, y.shape[1])
                none = np.zeros((len(known), y.shape[1]))
                return ols_with_nuisance(np.concatenate([A, known]), np.concatenate([y, none]), start)

            x = solved(None)
            if any(term.of_beginnings for term in terms):  # only then is it known how far off they may have begun
                ends = np.cumsum([start, *(len(term.parameters) for term in terms)])
                x = solved([x[a:b] for a, b in itertools.pairwise(ends)])
            return x

        return self.cached("coefficients", accepted, made)

    def declared_errors(self, accepted: Sequence[Candidate]) -> Array:
        """The likeliest errors of those that the run declares (r,), by these rows, in standard deviations of each."""

        def made() -> Array:
            A, y = self._on_these_rows(accepted)
            return self._declared(np.flatnonzero(self.rows)).likeliest(y - A @ self.coefficients(accepted))

        return self.cached("declared errors", accepted, made)

    def _on_these_rows(self, accepted: Sequence[Candidate]) -> tuple[Array, Array]:
        T, y, rows = self.problem.T, self.problem.y, self.rows
        return np.concatenate([T[rows], *(self.columns(c)[rows] for c in accepted)], axis=2), y[rows]

    def residual_everywhere(self, accepted: Sequence[Candidate]) -> tuple[Array, Array]:
        """Of every row of the whole problem (N, q): what that leaves, and what the accepted effects add.

        Beside the likeliest errors of those that the run declares.
        """
        whole, x = self.whole, self.coefficients(accepted)
        start = whole.T.shape[2]
        added = np.zeros_like(whole.y)
        for columns in map(self.full_columns, accepted):
            added += columns @ x[start : start + columns.shape[2]]
            start += columns.shape[2]
        left = whole.y - whole.T @ x[: whole.T.shape[2]] - whole.declared @ self.declared_errors(accepted)
        return np.asarray(left - added), added

    def full_columns(self, candidate: Candidate) -> Array:
        """Its whitened columns on every row of the whole problem (N, q, p)."""
        return self.columns(candidate) if self.problem.whole is None else self.whole.columns(candidate.term)

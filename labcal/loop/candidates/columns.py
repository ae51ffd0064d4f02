"""Whitened columns of candidates on every row of a problem: computed once, shared by all subsets of its rows."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Sequence
from dataclasses import dataclass
from typing import Any, TypeVar

import numpy as np
from numpy.typing import NDArray

from labcal.loop.candidates.interpolated import interpolated
from labcal.loop.candidates.library import Candidate
from labcal.loop.data.linear_problem import LinearProblem
from labcal.loop.noise.column_sets import ColumnSets
from labcal.loop.parallel import parallel_map

Array = NDArray[np.float64]
Kept = TypeVar("Kept")
GROUP_COLUMNS = 64  # columns that are scored together: few enough to stay in the processor's cache


class Memo:
    """Results by a name and the objects they belong to, which are compared by identity and kept alive."""

    def __init__(self) -> None:
        self._kept: dict[tuple[Hashable, ...], Any] = {}

    def get(self, what: Hashable, about: Sequence[Hashable], make: Callable[[], Kept]) -> Kept:
        """What `make` gives, made once. Two threads that ask at once may both make it; either gets the same."""
        key = (what, *about)
        if key not in self._kept:
            self._kept.setdefault(key, make())
        found: Kept = self._kept[key]
        return found

    def forget(self, what: Hashable) -> None:
        """Keep no longer what goes by this name."""
        for key in [key for key in self._kept if key[0] == what]:
            del self._kept[key]


@dataclass(frozen=True, slots=True, eq=False)
class ColumnGroup:
    """Candidates of one family with equally many columns: scored in one matrix product."""

    candidates: tuple[Candidate, ...]
    whitened: ColumnSets  # on all rows, one set for each


class ColumnStore:
    """The columns of some candidates, and of whatever candidate else is asked for."""

    def __init__(self, problem: LinearProblem, candidates: Sequence[Candidate]) -> None:
        self.problem, self.candidates, self.memo = problem, candidates, Memo()
        self._home: dict[Candidate, tuple[ColumnGroup, int]] = {}

    @property
    def groups(self) -> list[ColumnGroup]:
        """The candidates, grouped by family and number of columns."""
        return self.memo.get("groups", (), self._grouped)

    @property
    def n_columns(self) -> int:
        """Columns that all candidates are made of."""
        return sum(int(group.whitened.made_of.shape[2]) for group in self.groups)

    def columns(self, candidate: Candidate) -> Array:
        """The whitened columns (n, q, p) of a candidate."""
        home = self.home(candidate)
        if home is not None:
            return home[0].whitened.columns(home[1])
        return self.memo.get("columns", (candidate,), lambda: self.problem.columns(candidate.term))

    def home(self, candidate: Candidate) -> tuple[ColumnGroup, int] | None:
        """The group that holds its columns, and its place there; None where it is in no group yet."""
        return self._home.get(candidate)

    def _grouped(self) -> list[ColumnGroup]:
        grids: dict[Hashable, list[Candidate]] = {}
        for candidate in self.candidates:
            grids.setdefault((candidate.cause, candidate.term.parameters), []).append(candidate)
        large = [grid for grid in grids.values() if len(grid) * len(grid[0].term.parameters) > GROUP_COLUMNS]
        groups = [group for group in parallel_map(self._of_grid, large) if group is not None]
        alike: dict[tuple[str, int], list[Candidate]] = {}
        for candidate in self.candidates:
            if candidate not in self._home:
                alike.setdefault((candidate.family.id, len(candidate.term.parameters)), []).append(candidate)
        parts = []
        for (_, size), group in alike.items():
            count = max(GROUP_COLUMNS // size, 1)
            parts += [group[k : k + count] for k in range(0, len(group), count)]
        return [*groups, *parallel_map(self._side_by_side, parts)]

    def _of_grid(self, grid: Sequence[Candidate]) -> ColumnGroup | None:
        """The points of a grid whose columns are made of few; None where they are not."""
        found = interpolated(self.problem, grid)
        return None if found is None else self._at_home(grid, found)

    def _side_by_side(self, some: Sequence[Candidate]) -> ColumnGroup:
        n, q = self.problem.y.shape
        whitened = np.empty((n, q, len(some), len(some[0].term.parameters)))
        for place, candidate in enumerate(some):
            whitened[:, :, place] = self.problem.columns(candidate.term)
        return self._at_home(some, ColumnSets(whitened.reshape(n, q, -1), len(some)))

    def _at_home(self, some: Sequence[Candidate], whitened: ColumnSets) -> ColumnGroup:
        group = ColumnGroup(tuple(some), whitened)
        self._home |= {candidate: (group, place) for place, candidate in enumerate(some)}
        return group

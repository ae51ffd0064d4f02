"""The library of candidates: every term of every installed effect family, at every point of its grid."""

from __future__ import annotations

import itertools
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from labcal.loop.data.linear_problem import LinearProblem
from labcal.model.effects import Family, Term, families
from labcal.model.records import Owner

Array = NDArray[np.float64]
Cause = tuple[str, tuple[str, ...]]  # an effect's id and its channels: what a result names


@dataclass(frozen=True, slots=True, eq=False)
class Candidate:
    """A term of a family at fixed nonlinear parameters; compared by identity."""

    family: Family
    term: Term
    trials: int = 1  # points that were tried to find it: its multiplicity
    members: tuple[Candidate, ...] = ()  # of a set: what it is made of
    group: str = ""  # the set that it was accepted with

    @property
    def cause(self) -> Cause:
        """What would be named."""
        return self.family.id, self.term.channels

    @property
    def belongs_to(self) -> Owner:
        """Whose it is."""
        return self.family.owner(self.term)

    @property
    def size(self) -> int:
        """Parameters that were fitted: the linear ones, and the nonlinear ones that were searched."""
        return len(self.term.parameters) + sum(1 for part in self.parts for s in part.term.shape if s.grid)

    @property
    def parts(self) -> tuple[Candidate, ...]:
        """The members of a set; itself, where it is none."""
        return self.members or (self,)

    @property
    def label(self) -> str:
        """The effect and its channels, for people."""
        return self.family.id + (f" ({', '.join(self.term.channels)})" if self.term.channels else "")


@dataclass(frozen=True, slots=True, eq=False)
class Span:
    """Transformed columns (n, q, few) that span some candidates; compared by identity."""

    columns: Array


def expand_library(problem: LinearProblem) -> list[Candidate]:
    """Every term of every observable family at every grid point; without those that a residual has to suggest."""
    found = []
    for family in families():
        if is_observable(problem, family):
            terms = [term for term in family.candidates(problem.run) if not _needs_residual(term)]
            for points in map(_grid_points, terms):
                found += [Candidate(family, point, len(points)) for point in points]
    return found


def _needs_residual(term: Term) -> bool:
    """Whether a parameter of it, a delay, a moment or a frequency, is read off a residual."""
    return any(shape.kind.found_by not in ("grid", "own secant") for shape in term.shape)


def is_observable(problem: LinearProblem, family: Family) -> bool:
    """Whether this problem can show the family at all.

    Effects of the rig need the reference in the cage's frame. So does a lag: shifting noisy readings averages them,
    which lowers a magnitude's residual without any lag. Effects of the field need a base that knows the gains.
    """
    if family.of_field and problem.base != "affine":
        return False
    return not (family.belongs_to == "rig" or family.from_vectors) or problem.scene.rig is not None


def _grid_points(term: Term) -> list[Term]:
    searched = [s for s in term.shape if s.grid]
    return [
        term.with_values(**dict(zip([s.name for s in searched], values, strict=True)))
        for values in itertools.product(*(s.grid for s in searched))
    ]

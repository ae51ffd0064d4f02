"""Candidates: every form of every installed effect family, at every point of its grid of nonlinear parameters."""

from __future__ import annotations

import itertools
from dataclasses import dataclass

from labcal.loop.data.linear_problem import Problem
from labcal.model.effects import Family, Form, families

Cause = tuple[str, tuple[str, ...]]


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


def expand(problem: Problem) -> list[Candidate]:
    """Every form of every family at every point of its grid; those that need no residual to look at."""
    found = []
    for family in families():
        if family.sought == "grid" and at_home(problem, family):
            at_once = [form for form in family.candidates(problem.run) if not _of_a_residual(form)]
            for points in map(_points, at_once):
                found += [Candidate(family, point, len(points)) for point in points]
    return found


def _of_a_residual(form: Form) -> bool:
    """Whether its delay or moment is read off a residual."""
    return any(shape.name in ("delay_s", "t_step_s") for shape in form.shape)


def at_home(problem: Problem, family: Family) -> bool:
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


def name(candidate: Candidate) -> str:
    """What is named: the effect and its channels."""
    channels = ", ".join(candidate.form.channels)
    return candidate.family.id + (f" ({channels})" if channels else "")

"""What is left of a run beside what it declares of its reference and its mounting: explained by that, or larger.

A reference that is off by its own uncertainty leaves structure that no effect of the library makes, and that is as it
was declared. It is so where the residual along the directions of declared errors is no larger than they are said to be:
Σ z² of r standardised directions is χ² with r degrees of freedom.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from labcal.loop import policy
from labcal.loop.data.declared_moves import moves, residual_of
from labcal.loop.data.noise_floor import NoiseFloor
from labcal.loop.noise.declared_directions import DeclaredDirections
from labcal.loop.result import Finding
from labcal.loop.selection.crossval import HeldOutErrors, residual_lengths, rms
from labcal.loop.selection.joint_fit import JointFit, beside_fit, declared_beside

Array = NDArray[np.float64]
MOST_NAMED = 3  # errors that a finding lists, those that carry most first
WORTH_NAMING = 0.1  # of the square of the one that carries most
WITHIN, BEYOND = "within-declared", "beyond-declared"


@dataclass(frozen=True, slots=True)
class Declaration:
    """How a residual compares with what errors may leave that the run declares."""

    chance: float  # of as much along their directions where they are as declared
    plain_nT: float  # held out
    beside_nT: float  # held out, their likeliest values taken off, as large as they may be
    across_nT: float  # in sample, taken off however large
    carried: tuple[tuple[str, float], ...]  # errors in words, and what each is likeliest to have left [nT]

    @property
    def holds(self) -> bool:
        """Whether what is left along the directions of declared errors is as declared."""
        return self.chance >= policy.POLICY.significance

    def finding(self, level: NoiseFloor) -> Finding | None:
        """The finding, where declared errors decide whether the noise is reached; else None."""
        reached = policy.POLICY.floor_ratio * level.nT
        beside = self.beside_nT if self.holds else self.across_nT
        if not beside <= reached < self.plain_nT:
            return None
        of = ", ".join(f"{words} {nT:.3g} nT" for words, nT in self.carried)
        figures = f"{self.plain_nT:.3g} nT held out, {beside:.3g} beside it (noise alone: {level.nT:.3g} nT)"
        chance = f"Declared errors leave as much or more in {100 * self.chance:.2g} % of runs"
        if self.holds:
            says = f"What is left is within what the run declares: {figures}. Likeliest: {of}. {chance}."
            return Finding(WITHIN, "rig", says)
        says = (
            f"What is left has the shape of what the run declares, and is larger: {figures}. Likeliest: {of}. {chance}"
        )
        return Finding(BEYOND, "rig", f"{says}: check these, or declare them as large as they are.")


def declaration(after: JointFit, held: HeldOutErrors) -> Declaration | None:
    """The residual of a fit beside what the run declares; None where it declares nothing that would show."""
    if not after.problem.declared.shape[2]:
        return None
    left, y = declared_beside(after)[after.used], after.problem.y[after.used]
    found = DeclaredDirections.of(left)
    across = residual_lengths(after.problem, y - left @ found.likeliest(y, np.inf), after.used)
    return Declaration(_chance(*found.surprise(y)), held.plain[1], held.after, rms(across), _carried(after))


def _chance(square: float, directions: int) -> float:
    from scipy.special import chdtrc

    return float(chdtrc(directions, square)) if directions else 1.0


def _carried(after: JointFit) -> tuple[tuple[str, float], ...]:
    """The errors of one kind together, and the rms of what they are likeliest to have left [nT], largest first."""
    p, used = after.problem, after.used
    errors, changes = moves(p.run, residual_of(p.observations, p.noise, p.theta, p.phase, after.effects(p.scene)))
    left = beside_fit(after, p.whiten @ changes)[used]
    each = left * DeclaredDirections.of(left).likeliest(p.y[used], np.inf)
    kinds: dict[str, Array] = {}
    for error, part in zip(errors, np.moveaxis(each, 2, 0), strict=True):
        kind = f"{_kind(error.source)} ({error.u:.3g} {error.unit})"
        kinds[kind] = kinds.get(kind, np.zeros_like(part)) + part
    sizes = [(words, rms(residual_lengths(p, part, used))) for words, part in kinds.items()]
    largest = sorted(sizes, key=lambda pair: -pair[1])[:MOST_NAMED]
    return tuple((words, nT) for words, nT in largest if nT**2 >= WORTH_NAMING * largest[0][1] ** 2)


def _kind(source: str) -> str:
    """The source of an error without its axis."""
    words = source.split(" ")
    return " ".join(words[:-1]).removesuffix(" about") if words[-1] in ("x", "y", "z") else source

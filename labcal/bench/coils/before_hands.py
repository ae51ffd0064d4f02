"""What the ambient field of before hands were at the DUT still excludes while they mount: a current that matters.

At the coils' zero the reference sees the ambient field and what was brought or taken. Where what it sees has changed by
less than `LIMIT_NT`, no coil makes more than `LIMIT_NT` + `MOUNTING_NT`: a larger field would have to be hidden by a
change of the same size against it. That is worth saying only where it is less than `MATTERS` of the current limit makes
at any axis, at the least of all directions (the smallest singular value of M diag(I)), a tenth of which the reference
may miss beside the centre. A tenth of the limit heats a coil by a hundredth of what it bears. What changed by more says
nothing for a zero; what no mounting does (`found` beyond the sum of both) says that something is on, or very magnetic.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
MOUNTING_NT = 2500.0  # mu0 m / (2 pi r^3) of 0.1 A m2, as of a steel tool or a DUT with its harness, at 0.2 m
MATTERS = 0.1  # of the current limit
DRIFT_NT_PER_H = 100.0  # Earth's day is a tenth of it; a storm, and a room that warms, are as much


@dataclass(frozen=True, slots=True)
class BeforeHands:
    """The ambient field (3,) [nT, C] that was measured at `measured_s`, before hands were at the DUT."""

    field_nT: Array
    measured_s: float

    def apart_nT(self, seen_nT: Array) -> float:
        """How far what is seen now (3,) is from it."""
        return float(np.linalg.norm(seen_nT - self.field_nT))

    def limit_nT(self, limit_nT: float, now_s: float) -> float:
        """What may differ at `now_s` without any mounting: `limit_nT`, and what a place wanders."""
        return limit_nT + DRIFT_NT_PER_H * max(0.0, now_s - self.measured_s) / 3600

    def most_hidden_nT(self, limit_nT: float, now_s: float) -> float:
        """The largest field that coils may make unseen, behind a mounting."""
        return self.limit_nT(limit_nT, now_s) + MOUNTING_NT


def least_that_matters_nT(matrix_nT_per_A: Array, limit_A: Array, missed: float) -> float:
    """The smallest field at the reference of coils of which one has `MATTERS` of its current limit (3,) [A] or more.

    `missed`: the part of it that the reference does not see beside the centre.
    """
    smallest = float(np.linalg.svd(matrix_nT_per_A * limit_A, compute_uv=False)[-1])
    return MATTERS * smallest * (1.0 - missed)

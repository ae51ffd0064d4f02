"""Which rotations reach an accuracy in the least lab time: every choice is looked at, the quickest first.

A choice is a set of rotations out of those that were recorded. Its lab time is what is done once, plus the mounting of
each axis that it needs, plus its rotations. Accuracy only grows with rotations and so does time: the first choice that
is accurate enough is the quickest there is, and none is left out.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from labcal.fit.vector.information import Information
from labcal.study.accuracy import direction_U_deg, sensitivities

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]
MOST = 18  # rotations to choose from: 262 143 choices
TOGETHER = 2048  # choices that are worked out at once


@dataclass(frozen=True, slots=True, eq=False)
class LabTime:
    """What a choice costs [s]: `once`, `mounting` (mountings,), `turn` (rotations,), and whose mounting each needs."""

    once_s: float
    mounting_s: Array
    turn_s: Array
    mounting_of: NDArray[np.intp]  # (rotations,)

    def of(self, chosen: Mask) -> Array:
        """Lab time (m,) of the choices (m, rotations)."""
        used = np.stack([chosen[:, self.mounting_of == g].any(axis=1) for g in range(len(self.mounting_s))], axis=1)
        return np.asarray(self.once_s + used @ self.mounting_s + chosen @ self.turn_s)


def quickest_first(known: Information, time: LabTime, field_nT: float) -> Iterator[tuple[Mask, float, float]]:
    """Every choice (rotations,) with its lab time [s] and U of the direction [deg], in the order of lab time."""
    n = len(time.turn_s)
    choices = (np.arange(1, 1 << n)[:, None] >> np.arange(n)) & 1 == 1
    lab_s = time.of(choices)
    order = np.argsort(lab_s, kind="stable")
    sensitivity = sensitivities(known.affine, field_nT)
    for start in range(0, len(order), TOGETHER):
        some = order[start : start + TOGETHER]
        U = _worst(sensitivity, known.covariance(choices[some]))
        yield from zip(choices[some], lab_s[some].tolist(), U.tolist(), strict=True)


def _worst(sensitivity: Array, covariance: Array) -> Array:
    """U (m,), infinite where the choice does not determine the map."""
    known = np.isfinite(covariance).all(axis=(1, 2)) & np.isfinite(np.einsum("mii->mi", covariance)).all(axis=1)
    U = np.full(len(covariance), np.inf)
    U[known] = direction_U_deg(sensitivity, covariance[known])
    return U

"""Effects of the data: rows that say nothing of the sensor. They are set aside and counted, never modelled."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from labcal.model.effects.protocol import Array, Family
from labcal.model.effects.scene import Scene
from labcal.model.effects.term import Term
from labcal.model.records import EffectRecord, Parameter
from labcal.record import Run


def nothing(term: Term, scene: Scene) -> Array:
    """No columns."""
    return np.zeros((len(scene), 3, 0))


def no_candidates(run: Run) -> list[Term]:
    """None: `labcal.loop` finds these rows before any effect is tried."""
    return []


def saturation_record(limits: Sequence[Parameter]) -> EffectRecord:
    """The finding: the values `upper_x`, `lower_x` … that an axis stops at, in the DUT's unit."""
    where = ", ".join(f"{p.name} at {p.value:g} {p.unit}" for p in limits)
    why = f"readings stop at the end of the range: {where}"
    return EffectRecord(SATURATION.id, (), {}, SATURATION.belongs_to, tuple(limits), why=why)


def beyond_limits(findings: Sequence[EffectRecord], reading: Array) -> NDArray[np.bool_]:
    """Rows (n,) of readings (n, 3) at or beyond a limit of the finding `saturation`, where it is among these."""
    out = np.zeros(len(reading), dtype=bool)
    for axis, sign, limit in limits_of(findings):
        out |= reading[:, axis] >= limit if sign == ">=" else reading[:, axis] <= limit
    return out


def limits_of(findings: Sequence[EffectRecord]) -> list[tuple[int, str, float]]:
    """The limits of the finding `saturation` where it is among these: the axis, ">=" or "<=", and the value."""
    limits = {p.name: p.value for found in findings if found.effect == SATURATION.id for p in found.parameters}
    ends = ((axis, side, sign) for axis in range(3) for side, sign in (("upper", ">="), ("lower", "<=")))
    return [(a, sign, limits[name]) for a, side, sign in ends if (name := f"{side}_{'xyz'[a]}") in limits]


OUTLIERS = Family(
    "outliers",
    "data",
    nothing,
    no_candidates,
    phrase="single readings lie far off",
    experiment="repeat the segment and look at the link",
)
SATURATION = Family(
    "saturation",
    "data",
    nothing,
    no_candidates,
    phrase="readings are at the end of their range",
    experiment="repeat at half the field",
)

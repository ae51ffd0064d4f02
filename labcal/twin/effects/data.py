"""Effects of the data and of the geometry: readings that are not the field's, clocks and axes other than stated."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Rng = np.random.Generator
Three = Sequence[float]


@dataclass(frozen=True, slots=True)
class ReadingFault:
    """What one such effect changes: the time a reading belongs to, the axis, the range, or single readings."""

    late_s: float = 0.0  # the reading stamped t belongs to the field at t - late_s
    tilt_cage_deg: tuple[float, ...] = (0.0, 0.0, 0.0)  # rotation vector that turns the platform axis
    tilt_body_deg: tuple[float, ...] = (0.0, 0.0, 0.0)  # rotation vector between the stated and the true mounting
    range_nT: float = np.inf
    corrupt: Callable[[Array], Array] = lambda reading_nT: reading_nT


def lag(_: Rng, late_s: float = 0.3) -> ReadingFault:
    """The DUT's stamps are late, or its filter is: the reading belongs to an earlier field."""
    return ReadingFault(late_s=late_s)


def axis_tilt(_: Rng, cage_deg: Three = (1.2, -0.8, 0.0), body_deg: Three = (0.0, 0.0, 0.0)) -> ReadingFault:
    """The platform axis is not where it was declared, in C or in B."""
    return ReadingFault(tilt_cage_deg=tuple(cage_deg), tilt_body_deg=tuple(body_deg))


def saturation(_: Rng, range_nT: float = 40_000.0) -> ReadingFault:
    """The converter ends early."""
    return ReadingFault(range_nT=range_nT)


def outliers(rng: Rng, share: float = 0.005, size_nT: float = 8000.0) -> ReadingFault:
    """Single readings are hit by something else."""

    def corrupt(reading_nT: Array) -> Array:
        draw = rng.uniform(size=(len(reading_nT), 4))
        hit = draw[:, 0] < share
        return np.where(hit[:, None], reading_nT + size_nT * (2 * draw[:, 1:] - 1), reading_nT)

    return ReadingFault(corrupt=corrupt)


DATA: dict[str, Callable[..., ReadingFault]] = {
    "lag": lag,
    "axis-tilt": axis_tilt,
    "saturation": saturation,
    "outliers": outliers,
}

"""A contribution to the uncertainty of fitted parameters, and the covariance that contributions make (GUM, 5.2)."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


@dataclass(frozen=True, slots=True, eq=False)
class Contribution:
    """One source: what is known of it, and what one standard deviation of it does to the parameters.

    Each is independent of the others (GUM, 5.1.2), so that an error of three axes is three contributions.
    """

    source: str
    type: Literal["A", "B"]
    distribution: str
    u: float  # standard uncertainty, in `unit`
    unit: str
    dof: float  # degrees of freedom of u; infinite where it is taken as known
    shift: Array  # (p,) of the parameters, in their units


def covariance_of(contributions: Sequence[Contribution], size: int) -> Array:
    """Σ g gᵀ (size, size) over the shifts g; zero without contributions."""
    shifts = np.array([one.shift for one in contributions]).reshape(-1, size)
    return np.asarray(shifts.T @ shifts)

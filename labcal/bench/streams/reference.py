"""What a reference can tell of the coils, and its readings in the cage's axes."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from labcal.bench.config import ReferenceConfig


def blind(reference: ReferenceConfig) -> str:
    """Why this reference cannot tell whether the coils are at zero; "" where it can."""
    sees = reference.kind == "vector" and reference.place not in ("remote", "computed")
    return "" if sees else "no vector reference stands at the DUT"


def into_cage(values: ArrayLike, reference: ReferenceConfig) -> NDArray[np.float64]:
    """Readings (n, 3) [nT] of the reference, zero taken off, from its own axes into C."""
    return np.asarray((np.asarray(values) - reference.offset_nT) @ np.array(reference.cage_from_sensor).T)

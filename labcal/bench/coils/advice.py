"""What a person can do about a current that the reference sees and no order ends: at which supply, and how."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import ArrayLike, NDArray

AT_ITS_PANEL = "open the output of {} at its panel, or switch it off at its mains"
AT_ITS_MAINS = "switch off {} at its mains (no command opens its output)"


def as_if(difference_nT: ArrayLike, matrix_nT_per_A: NDArray[np.float64], least_nT: float) -> dict[str, float]:
    """The currents [A] by coil that would make this difference (3,): those that make `least_nT`, or else the most."""
    currents = np.linalg.solve(matrix_nT_per_A, np.asarray(difference_nT, dtype=float))
    makes = np.abs(currents) * np.linalg.norm(matrix_nT_per_A, axis=0)
    found = makes >= min(least_nT, float(makes.max()))
    return {axis: float(currents[i]) for i, axis in enumerate("xyz") if found[i]}


def by_hand(as_if_A: Mapping[str, float], supplies: Mapping[str, tuple[str, bool]]) -> str:
    """What is done by hand about these currents. `supplies`: what each coil's is called, and whether it can open."""
    said = []
    for axis, current in as_if_A.items():
        where, can_open = supplies[axis]
        do = (AT_ITS_PANEL if can_open else AT_ITS_MAINS).format(where)
        said.append(f"It is as if {current:+.2f} A flowed in coil {axis}: {do}")
    return ". ".join(said)

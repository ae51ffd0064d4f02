"""The lab at a row of times, as an effect sees it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


@dataclass(frozen=True, slots=True)
class Moment:
    """All arrays have n rows. `field_cage` [nT] at the DUT's place; `body_from_cage` (n, 3, 3) the true attitude."""

    t_s: Array
    angle_deg: Array
    field_cage: Array
    body_from_cage: Array
    currents_A: Array  # (n, 3) of the coils
    motor_on: Array
    channels: Mapping[str, Array]
    mode: NDArray[np.str_]
    dut_there: NDArray[np.bool_]  # on the platform, and not taken away

    def into_body(self, v_cage: Array) -> Array:
        """Vectors (n, 3) of C in the DUT's axes (n, 3)."""
        return np.asarray(np.einsum("nij,nj->ni", self.body_from_cage, v_cage))

    def into_cage(self, v_body: Array) -> Array:
        """A vector (3,) fixed in the DUT, in C (n, 3)."""
        return np.asarray(np.einsum("nji,j->ni", self.body_from_cage, v_body))

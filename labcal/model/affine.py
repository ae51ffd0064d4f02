"""The base model b = K m − k: scale, non-orthogonality, misalignment and bias in twelve numbers."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

Array = NDArray[np.float64]
MAP_PARAMETERS = (*(f"K_{a}{b}" for a in "xyz" for b in "xyz"), "k_x", "k_y", "k_z")  # in their order


@dataclass(frozen=True, slots=True, eq=False)
class AffineMap:
    """`K` (3, 3) [nT per DUT unit] and `k_nT` (3,) [nT of B] (Riwanto et al. 2017, (2b))."""

    K: Array
    k_nT: Array

    @classmethod
    def nominal(cls, nT_per_unit: float = 1.0) -> AffineMap:
        """The map of a perfect sensor."""
        return cls(np.eye(3) * nT_per_unit, np.zeros(3))

    @classmethod
    def from_parameters(cls, theta: ArrayLike) -> AffineMap:
        """From the twelve parameters (12,): K row by row, then k."""
        theta = np.asarray(theta, dtype=float)
        return cls(theta[:9].reshape(3, 3), theta[9:12])

    @property
    def parameters(self) -> Array:
        """The twelve parameters (12,): K row by row, then k."""
        return np.concatenate([self.K.ravel(), self.k_nT])

    def apply(self, reading: ArrayLike) -> Array:
        """The field (n, 3) [nT, B] for readings (n, 3) in the DUT's unit."""
        return np.asarray(np.asarray(reading, dtype=float) @ self.K.T - self.k_nT)


def jacobian(reading: ArrayLike) -> Array:
    """d(K m − k)/d(parameters), (n, 3, 12), for readings (n, 3)."""
    m = np.asarray(reading, dtype=float)
    out = np.zeros((len(m), 3, 12))
    for axis in range(3):
        out[:, axis, 3 * axis : 3 * axis + 3] = m
        out[:, axis, 9 + axis] = -1.0
    return out

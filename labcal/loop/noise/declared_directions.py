"""Errors that a run declares as a part of what is random: rows that they move together, and by how much.

With D the whitened changes of the residual by one standard deviation of each of e independent errors, rows have the
covariance I + D Dᵀ. Least squares on rows and columns times (I + D Dᵀ)^-½ is the generalised one, those errors
integrated over their normal prior; their likeliest values beside a residual r are ĉ = Dᵀ (I + D Dᵀ)⁻¹ r (best linear
unbiased prediction; Robinson, Statist. Sci. 6, 15, 1991).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from labcal.uncertainty.beside_declared import LARGEST

Array = NDArray[np.float64]
SHOWS = 1.0  # of the noise's variance: a direction that one standard deviation moves less tells nothing of its error


@dataclass(frozen=True, slots=True, eq=False)
class DeclaredDirections:
    """The directions of rows (n, q) that e declared errors move, and by how much."""

    along: Array  # (n q, r) orthonormal
    size: Array  # (r,) standard deviations, in those of the noise
    of_errors: Array  # (r, e) which errors move each

    @classmethod
    def of(cls, moved: Array) -> DeclaredDirections:
        """By what one standard deviation of each error moves: D (n, q, e), whitened."""
        U, size, Vt = np.linalg.svd(moved.reshape(moved.shape[0] * moved.shape[1], -1), full_matrices=False)
        return cls(U, size, Vt)

    def whitened(self, columns: Array) -> Array:
        """(I + D Dᵀ)^-½ times columns (n, q, p)."""
        if not len(self.size):
            return columns
        flat = columns.reshape(len(self.along), -1)
        less = self.along @ ((1 / np.sqrt(1 + self.size**2) - 1)[:, None] * (self.along.T @ flat))
        less += flat
        return np.asarray(less.reshape(columns.shape))

    def likeliest(self, left: Array, most: float = LARGEST) -> Array:
        """The errors (e,) that a residual (n, q) is likeliest to have, in standard deviations of each.

        Along no direction more than `most`: what is larger than declared errors are is something else.
        """
        along = self.size / (1 + self.size**2) * (self.along.T @ left.ravel())
        return np.asarray(self.of_errors.T @ np.clip(along, -most, most))

    def surprise(self, left: Array) -> tuple[float, int]:
        """Σ z² of a residual (n, q) along the directions that show, and how many they are: χ² where it is declared."""
        shows = self.size**2 > SHOWS
        along = self.along[:, shows].T @ left.ravel()
        return float(np.sum(along**2 / (1 + self.size[shows] ** 2))), int(shows.sum())


def principal(moved: Array) -> Array:
    """As few columns (n, q, r) as move rows like the given ones (n, q, e), of those directions that show."""
    found = DeclaredDirections.of(moved)
    shows = found.size**2 > SHOWS
    return np.asarray((found.along[:, shows] * found.size[shows]).reshape(*moved.shape[:2], int(shows.sum())))

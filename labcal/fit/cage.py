"""The cage's current-to-field matrix and offset from set currents and measured fields, with covariance."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

Array = NDArray[np.float64]


@dataclass(frozen=True, slots=True, eq=False)
class CageFit:
    """b = M I + b0. `covariance` (12, 12) orders M row by row, then b0; `residual_nT` (n, 3) is b − M I − b0."""

    matrix_nT_per_A: Array  # (3, 3), columns are the coil axes in C
    offset_nT: Array  # (3,) the field with the coils at zero
    covariance: Array
    residual_nT: Array

    @property
    def u_matrix_nT_per_A(self) -> Array:
        """Standard uncertainty (3, 3) of the matrix's elements."""
        return np.sqrt(np.diag(self.covariance)[:9]).reshape(3, 3)

    @property
    def u_offset_nT(self) -> Array:
        """Standard uncertainty (3,) of the offset."""
        return np.sqrt(np.diag(self.covariance)[9:])

    def field_nT(self, currents_A: ArrayLike) -> Array:
        """The field (n, 3) [nT, C] that currents (n, 3) make."""
        return np.asarray(np.asarray(currents_A) @ self.matrix_nT_per_A.T + self.offset_nT)

    def u_field_nT(self, currents_A: ArrayLike) -> Array:
        """Standard uncertainty (n, 3) of `field_nT`."""
        A = _design(np.asarray(currents_A, dtype=float))
        per_axis = [np.einsum("ni,ij,nj->n", A, self._of_axis(axis), A) for axis in range(3)]
        return np.asarray(np.sqrt(np.column_stack(per_axis)))

    def _of_axis(self, axis: int) -> Array:
        places = [3 * axis, 3 * axis + 1, 3 * axis + 2, 9 + axis]
        return np.asarray(self.covariance[np.ix_(places, places)])


def fit_cage(currents_A: ArrayLike, fields_nT: ArrayLike) -> CageFit:
    """Linear least squares of fields (n, 3) [nT, C] on currents (n, 3), each field component by itself.

    cov of one component = s² (AᵀA)⁻¹ with A = [I, 1] (n, 4) and s² = Σ r² / (n − 4) of that component (Gauss-Markov).
    Raises ValueError where n < 5 or the currents do not span all three coils.
    """
    A, b = _design(np.asarray(currents_A, dtype=float)), np.asarray(fields_nT, dtype=float)
    if len(A) < 5 or np.linalg.matrix_rank(A) < 4:
        raise ValueError("the currents do not span all three coils: step each coil at two currents at least")
    solution, _, _, _ = np.linalg.lstsq(A, b, rcond=None)
    residual = b - A @ solution
    unit = np.linalg.inv(A.T @ A)
    covariance = np.zeros((12, 12))
    for axis, variance in enumerate(np.sum(residual**2, axis=0) / (len(A) - 4)):
        places = [3 * axis, 3 * axis + 1, 3 * axis + 2, 9 + axis]
        covariance[np.ix_(places, places)] = variance * unit
    return CageFit(solution[:3].T, solution[3], covariance, residual)


def _design(currents_A: Array) -> Array:
    return np.column_stack([currents_A, np.ones(len(currents_A))])

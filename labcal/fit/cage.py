"""The cage's current-to-field matrix and offset from set currents and measured fields, with covariance."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

Array = NDArray[np.float64]
UNKNOWNS = 3  # of one coil: constant, offset, drift


@dataclass(frozen=True, slots=True, eq=False)
class CageFit:
    """b = M I + b0. `covariance` (12, 12) orders M row by row, then b0; `residual_nT` (n, 3) is what the fit leaves."""

    matrix_nT_per_A: Array  # (3, 3), columns are the coil axes in C
    offset_nT: Array  # (3,) the field with the coils at zero, in the middle of the sweep
    covariance: Array
    residual_nT: Array
    drift_nT_per_s: Array  # (3,) of the offset

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


def fit_cage(currents_A: ArrayLike, fields_nT: ArrayLike, coil: ArrayLike, t_s: ArrayLike) -> CageFit:
    """Least squares of fields (n, 3) [nT, C] on the current of the one coil `coil` (n,) that was stepped at `t_s` (n,).

    One coil j by itself: b = m_j I_j + b_j + d_j (t − t̄_j) with A = [I, 1, t − t̄] (n_j, 3), so that neither a drift
    of the place nor the noise of another coil's current enters. Its residuals' covariance S = RᵀR / (n_j − 3) (3, 3)
    gives cov = S ⊗ (AᵀA)⁻¹ (Gauss-Markov, several responses). The offset is the mean of the three b_j.
    Raises ValueError where a coil was stepped fewer than 5 times, or not to two currents at least.
    """
    I, b = np.asarray(currents_A, dtype=float), np.asarray(fields_nT, dtype=float)  # noqa: E741
    which, t = np.asarray(coil), np.asarray(t_s, dtype=float)
    matrix, offsets, drifts = np.zeros((3, 3)), np.zeros((3, 3)), np.zeros((3, 3))
    covariance, residual = np.zeros((12, 12)), np.zeros_like(b)
    for j in range(3):
        rows = which == j
        A = _design(I[rows, j], t[rows])
        solution = np.linalg.lstsq(A, b[rows], rcond=None)[0]
        matrix[:, j], offsets[j], drifts[j] = solution
        residual[rows] = b[rows] - A @ solution
        scatter = residual[rows].T @ residual[rows] / (len(A) - UNKNOWNS)
        covariance += _placed(scatter, np.asarray(np.linalg.inv(A.T @ A)), j)
    return CageFit(matrix, offsets.mean(axis=0), covariance, residual, drifts.mean(axis=0))


def _design(current_A: Array, t_s: Array) -> Array:
    """[I, 1, t − t̄] (n, 3). Raises ValueError where it does not determine its three unknowns with room to spare."""
    if len(current_A) < UNKNOWNS + 2 or np.ptp(current_A) == 0:
        raise ValueError("the currents do not span all three coils: step each coil at two currents at least")
    return np.column_stack([current_A, np.ones_like(current_A), t_s - t_s.mean()])


def _placed(scatter: Array, unit: Array, j: int) -> Array:
    """The share (12, 12) of coil `j` in the covariance of [M row by row, mean of the three offsets]."""
    to_all = np.zeros((12, 6))  # from (m_j, b_j), component by component
    for component in range(3):
        to_all[3 * component + j, 2 * component] = 1.0
        to_all[9 + component, 2 * component + 1] = 1 / 3
    return np.asarray(to_all @ np.kron(scatter, unit[:2, :2]) @ to_all.T)

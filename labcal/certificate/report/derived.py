"""What a magnetometer person compares from year to year: scale factors, zero readings, angles between the axes."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from labcal.certificate.report.page import Table
from labcal.certificate.report.style import decimals_for, number
from labcal.model import AffineMap, Calibration

Array = NDArray[np.float64]
PAIRS = ((0, 1), (1, 2), (2, 0))


def sensor_figures(calibration: Calibration, coverage: float) -> Table:
    """Scale factor, zero reading and nonorthogonality of each sensitive axis, with U = `coverage` times u."""
    theta, unit = calibration.affine.parameters, calibration.dut.unit
    values = _figures(theta).reshape(3, 3)
    U = np.full((3, 3), np.nan)
    if calibration.covariance is not None:
        J = _jacobian(theta)
        U = coverage * np.sqrt(np.maximum(np.einsum("ij,jk,ik->i", J, calibration.covariance[:12, :12], J), 0)).reshape(
            3, 3
        )
    decimals = [decimals_for(row, most) for row, most in zip(U, (7, 3, 4), strict=True)]
    rows = []
    for i, (axis, pair) in enumerate(zip("xyz", ("x–y", "y–z", "z–x"), strict=True)):
        cells = [(number(values[j, i], decimals[j]), number(U[j, i], decimals[j])) for j in range(3)]
        rows.append((axis, *cells[0], *cells[1], pair, *cells[2]))
    header = ("Axis", f"Scale (nT/{unit})", "U", f"Zero reading ({unit})", "U", "Axes", "Off 90° (°)", "U")
    note = "The same calibration as figures of the sensor: m = K⁻¹ (b + k)."
    return Table(header, tuple(rows), frozenset({1, 2, 3, 4, 6, 7}), note)


def _figures(theta: Array) -> Array:
    """(9,): 1/|rows of K⁻¹| [nT per unit], K⁻¹ k [unit], 90° minus the angles of the axes x–y, y–z, z–x [deg]."""
    affine = AffineMap.from_parameters(theta)
    inverse = np.linalg.inv(affine.K)
    length = np.linalg.norm(inverse, axis=1)
    axes = inverse / length[:, None]
    off_square = [np.degrees(np.arcsin(np.clip(axes[a] @ axes[b], -1, 1))) for a, b in PAIRS]
    return np.concatenate([1 / length, inverse @ affine.k_nT, off_square])


def _jacobian(theta: Array) -> Array:
    """d(figures)/d(theta), (9, 12), by central differences."""
    step = np.r_[np.full(9, 1e-6 * np.abs(theta[:9]).max()), np.full(3, 1e-3 * max(1.0, np.abs(theta[9:]).max()))]
    columns = [(_figures(theta + e) - _figures(theta - e)) / (2 * e.max()) for e in np.diag(step)]
    return np.column_stack(columns)

"""What a magnetometer person compares from year to year: scale factors, zero readings, angles between the axes."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from labcal.model.affine import AffineMap

Array = NDArray[np.float64]
PAIRS = ((0, 1), (1, 2), (2, 0))


def sensor_figures(theta: Array) -> Array:
    """(9,): 1/|rows of K⁻¹| [nT per unit], K⁻¹ k [unit], 90° minus the angles of the axes x–y, y–z, z–x [deg].

    Of the parameters `theta` (12,), K row by row, then k: m = K⁻¹ (b + k). A turn of the sensor changes none of them.
    """
    affine = AffineMap.from_parameters(theta)
    inverse = np.linalg.inv(affine.K)
    length = np.linalg.norm(inverse, axis=1)
    axes = inverse / length[:, None]
    off_square = [np.degrees(np.arcsin(np.clip(axes[a] @ axes[b], -1, 1))) for a, b in PAIRS]
    return np.concatenate([1 / length, inverse @ affine.k_nT, off_square])


def figures_jacobian(theta: Array) -> Array:
    """d(figures)/d(theta), (9, 12), by central differences."""
    step = np.r_[np.full(9, 1e-6 * np.abs(theta[:9]).max()), np.full(3, 1e-3 * max(1.0, np.abs(theta[9:]).max()))]
    columns = [(sensor_figures(theta + e) - sensor_figures(theta - e)) / (2 * e.max()) for e in np.diag(step)]
    return np.column_stack(columns)


def figures_covariance(theta: Array, covariance: Array | None) -> Array:
    """Covariance (9, 9) of the figures from that of the parameters, (12, 12) or larger (GUM, F.1.2.3); else NaN."""
    if covariance is None:
        return np.full((9, 9), np.nan)
    J = figures_jacobian(theta)
    return np.asarray(J @ covariance[:12, :12] @ J.T)

"""What a magnetometer person compares from year to year: scale factors, zero readings, angles between the axes.

The same map as figures of the sensor: m = K⁻¹ (b + k).
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from labcal.model.affine import AffineMap

Array = NDArray[np.float64]
PAIRS = ((0, 1), (1, 2), (2, 0))
NAMES = (
    *(f"scale {axis}" for axis in "xyz"),
    *(f"zero reading {axis}" for axis in "xyz"),
    *(f"off 90° {'xyz'[a]}–{'xyz'[b]}" for a, b in PAIRS),
)


def units(unit: str) -> tuple[str, ...]:
    """The units of the figures, for readings in `unit`."""
    return (*("1" if unit == "nT" else f"nT/{unit}",) * 3, *(unit,) * 3, *("deg",) * 3)


def figures_of(theta: Array) -> Array:
    """(9,): 1/|rows of K⁻¹| [nT per unit], K⁻¹ k [unit], 90° minus the angles of the axes x–y, y–z, z–x [deg].

    `theta` (12,) is K row by row, then k.
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
    columns = [(figures_of(theta + e) - figures_of(theta - e)) / (2 * e.max()) for e in np.diag(step)]
    return np.column_stack(columns)

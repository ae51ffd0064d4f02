"""What an affine map does not hold, by degree: a residual on a thin shell of one magnitude in spherical harmonics.

A map b = K m − k takes up degree 0 (the bias) and degree 1 (the matrix) of each component on every shell. Degree 2 is
what two components of the field do together (cross-field), degree 3 a sensor's cubic: the thin-shell analysis of
Risbo et al., Meas. Sci. Technol. 14 (2003) 674, there of magnitudes, here of vectors.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import scipy  # its parts load where they are used: labcal starts a fifth sooner
from numpy.typing import ArrayLike, NDArray

from labcal.geometry import unit
from labcal.record import Run

Array = NDArray[np.float64]
DEGREES = (0, 1, 2, 3)
OF_DEGREE = tuple(slice(degree**2, (degree + 1) ** 2) for degree in DEGREES)
FEWEST = 24  # directions of a shell: sixteen harmonics and some to spare
LARGEST_CONDITION = 4.0  # beyond it the directions do not go all round
SAME_SHELL = 0.05  # of the magnitude


@dataclass(frozen=True, slots=True, eq=False)
class Shell:
    """The residual on one shell. Rms are over all directions, of the vector's length [nT]."""

    magnitude_nT: float
    coefficients_nT: Array  # (16, 3): harmonic, component
    rms_nT: Array  # (4,) of each degree
    noise_nT: Array  # (4,) what the scatter beyond degree 3 alone would give
    p: Array  # (4,) the chance that the scatter gives as much
    beyond_nT: float  # rms of one component beyond degree 3, degrees of freedom taken off


def real_harmonics(directions: ArrayLike) -> Array:
    """The sixteen real harmonics (n, 16) of degree 0 to 3 at unit vectors (n, 3), of mean square 1 over the sphere.

    Degree by degree, order −l to l; the usual ones times √4π.
    """
    x, y, z = np.asarray(directions, dtype=float).T
    columns = [
        np.ones_like(x),
        np.sqrt(3) * y,
        np.sqrt(3) * z,
        np.sqrt(3) * x,
        np.sqrt(15) * x * y,
        np.sqrt(15) * y * z,
        np.sqrt(5) / 2 * (3 * z**2 - 1),
        np.sqrt(15) * x * z,
        np.sqrt(15) / 2 * (x**2 - y**2),
        np.sqrt(35 / 8) * y * (3 * x**2 - y**2),
        np.sqrt(105) * x * y * z,
        np.sqrt(21 / 8) * y * (5 * z**2 - 1),
        np.sqrt(7) / 2 * z * (5 * z**2 - 3),
        np.sqrt(21 / 8) * x * (5 * z**2 - 1),
        np.sqrt(105) / 2 * z * (x**2 - y**2),
        np.sqrt(35 / 8) * x * (x**2 - 3 * y**2),
    ]
    return np.column_stack(columns)


def shells(field_nT: ArrayLike, residual_nT: ArrayLike) -> tuple[Shell, ...]:
    """The shells among fields (n, 3), by magnitude, that go all round, each with its residual (n, 3) by degree.

    Magnitudes within `SAME_SHELL` of each other are one shell; one with fewer than `FEWEST` directions, or with
    directions on one side only, is none.
    """
    b, r = np.asarray(field_nT, dtype=float), np.asarray(residual_nT, dtype=float)
    size = np.linalg.norm(b, axis=1)
    there = np.flatnonzero(np.isfinite(size) & np.isfinite(r).all(axis=1) & (size > 0))
    order = there[np.argsort(size[there])]
    cuts = np.flatnonzero(np.diff(np.log(size[order])) > SAME_SHELL / 2) + 1
    found = [_shell(b[rows], r[rows]) for rows in np.split(order, cuts)]
    return tuple(shell for shell in found if shell is not None)


def shells_of_standstills(run: Run, residual: Array) -> tuple[Shell, ...]:
    """The shells of a run at rest in many fields, by the mean of each standstill's residual (n, 3) [nT]."""
    if residual.shape[1] != 3 or run.reference_vector is None:
        return ()
    rows = [run.rows(k) for k, segment in enumerate(run.segments) if segment.kind == "static"]
    there = np.asarray(np.isfinite(np.hstack([residual, run.reference_vector])).all(axis=1))
    used = [r[there[r]] for r in rows if there[r].any()]
    fields = np.array([run.reference_vector[r].mean(axis=0) for r in used]).reshape(-1, 3)
    return shells(fields, np.array([residual[r].mean(axis=0) for r in used]).reshape(-1, 3))


def _shell(b: Array, r: Array) -> Shell | None:
    size = np.linalg.norm(b, axis=1)
    if len(b) < FEWEST or np.ptp(size) > SAME_SHELL * size.mean():
        return None
    Y = real_harmonics(unit(b))
    if np.linalg.cond(Y) > LARGEST_CONDITION:
        return None
    c: Array = np.asarray(np.linalg.lstsq(Y, r, rcond=None)[0], dtype=float)
    left, spare = r - Y @ c, len(b) - Y.shape[1]
    scatter = left.T @ left / spare  # (3, 3)
    inverse: Array = np.asarray(np.linalg.inv(Y.T @ Y), dtype=float)
    variance = float(np.trace(scatter)) / 3
    power = np.array([np.sum(c[rows] ** 2) for rows in OF_DEGREE])
    noise = np.array([3 * variance * np.trace(inverse[rows, rows]) for rows in OF_DEGREE])
    p = np.array([_chance(c[rows], inverse[rows, rows], variance, spare) for rows in OF_DEGREE])
    return Shell(float(size.mean()), c, np.sqrt(power), np.sqrt(noise), p, float(np.sqrt(variance)))


def _chance(c: Array, inverse: Array, variance: float, spare: int) -> float:
    """That coefficients (q, 3) as large come of the scatter: F = cᵀ (inverse)⁻¹ c / (3 q variance), (3 q, 3 spare)."""
    if variance == 0:
        return float(not np.any(c))
    F = float(np.sum(c * np.linalg.solve(inverse, c))) / (c.size * variance)
    return float(scipy.special.fdtrc(c.size, 3 * spare, F))

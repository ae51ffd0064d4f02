"""What no run can see and only a declaration can cover: a turn common to all mountings, the reference's own errors."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from labcal.geometry import skew, unit
from labcal.model import AffineMap
from labcal.record import Run
from labcal.uncertainty import Contribution, conditions, declared_errors

Array = NDArray[np.float64]
SYMMETRIC = np.zeros((12, 9))  # K row by row, then k, from the six elements of a symmetric K, then k
for _column, (_a, _b) in enumerate(((0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2))):
    SYMMETRIC[[3 * _a + _b, 3 * _b + _a], _column] = 1.0
SYMMETRIC[9:, 6:] = np.eye(3)


def contributions(run: Run, affine: AffineMap, *, frame_known: bool) -> tuple[Contribution, ...]:
    """What each error that `run` declares does to K and k (12,), one source each (contract: u_axis_*, u_…).

    A common turn by w changes K by [w]× K and k by [w]× k, a scale of the reference both in proportion, its zero k
    alone. Where the frame is not known a turn says nothing, and magnitudes move the map by least squares. What is not
    declared is not covered. (Where vectors are fitted, `labcal.fit.vector.declared` asks the fit itself.)
    """
    return _of_vectors(run, affine) if frame_known else _of_magnitudes(run, affine)


def _of_vectors(run: Run, affine: AffineMap) -> tuple[Contribution, ...]:
    """What each declared error does to K and k (12,), where the fields that are fitted are the reference's vectors.

    What changes through the run counts by its root mean square, a factor of one axis for all of them.
    """
    reference, found = run.reference, list[Contribution]()
    if ppm := reference.u_scale_ppm:
        found.append(_known("reference scale", ppm, "ppm", 1e-6 * ppm * affine.parameters))
    if zero := reference.u_offset_nT:
        found += _zeros("reference zero", zero, "nT", zero)
    for source, u, unit_of, by in conditions.zeros(run):
        found += _zeros(source, u, unit_of, _rms(by))
    for source, u, unit_of, by in conditions.factors(run):
        found.append(_known(source, u, unit_of, _rms(np.abs(by).max(axis=1)) * affine.parameters))
    u = float(np.hypot(mounting_rad(run), np.radians(reference.u_align_deg or 0.0)))
    for name, turn in zip("xyz", skew(u * np.eye(3)) if u else (), strict=False):
        step = np.concatenate([(turn @ affine.K).ravel(), turn @ affine.k_nT])
        found.append(_known(f"alignment about {name}", float(np.degrees(u)), "deg", step))
    return tuple(found)


def _zeros(source: str, u: float, unit_of: str, by_nT: float) -> list[Contribution]:
    """One for each axis."""
    return [
        _known(f"{source} {name}", u, unit_of, by_nT * axis) for name, axis in zip("xyz", np.eye(12)[9:], strict=True)
    ]


def _rms(values: Array) -> float:
    return float(np.sqrt(np.mean(values**2)))


def _known(source: str, u: float, unit: str, shift: Array) -> Contribution:
    return Contribution(source, "B", "normal", u, unit, np.inf, shift)


def _of_magnitudes(run: Run, affine: AffineMap) -> tuple[Contribution, ...]:
    """What each declared error does to K, symmetric, and k by |K m − k| = |ref|: d|b| = u · (dK m − dk), u = b/|b|."""
    b, magnitude = affine.apply(run.reading), run.magnitude_nT
    rows = np.isfinite(b).all(axis=1) & np.isfinite(magnitude)
    u = unit(b[rows])
    A = np.concatenate([(u[:, :, None] * run.reading[rows][:, None, :]).reshape(-1, 9), -u], axis=1) @ SYMMETRIC
    size = np.maximum(np.linalg.norm(A, axis=0), 1e-300)
    found = []
    for error in declared_errors(run):
        moved = np.nan_to_num(error.moves(run, lambda there: there.magnitude_nT)[rows])
        shift = SYMMETRIC @ (np.linalg.lstsq(A / size, moved, rcond=1e-9)[0] / size)
        found.append(Contribution(error.source, "B", "normal", error.u, error.unit, np.inf, shift))
    return tuple(found)


def mounting_rad(run: Run) -> float:
    """Root mean square of the declared uncertainties of the rotation axes [rad], body's and cage's together."""
    stated = [(s.u_axis_body_deg or 0.0) ** 2 + (s.u_axis_cage_deg or 0.0) ** 2 for s in run.segments]
    stated = [s for s in stated if s > 0]
    return float(np.radians(np.sqrt(np.mean(stated)))) if stated else 0.0

"""How good a fit is: magnitude residual, held-out blocks, and where the rotation axes come to lie."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from labcal.fit.result import Fit
from labcal.geometry import plane_normal
from labcal.model import AffineMap
from labcal.model.effects import Scene, load
from labcal.record import Run, carry

Array = NDArray[np.float64]
FOLDS = 5


def scalar_residual(run: Run, found: Fit) -> Array:
    """|K m − k − effects| − |ref| (n,) [nT], NaN where either is missing; zero references leave NaN throughout."""
    if found.affine is None or run.reference.kind == "none":
        return np.full(len(run), np.nan)
    field = found.affine.apply(run.reading)
    if found.effects:
        channels = {c.name: c.values for c in run.channels}
        scene = Scene(run.t_s, run.segment_index, field, channels, run.mode)
        field = field - sum(load(effect).predict(scene) for effect in found.effects)
    return np.asarray(np.linalg.norm(field, axis=1) - run.magnitude_nT)


def vector_residual(run: Run, found: Fit) -> Array | None:
    """Calibrated readings less the reference carried into B (n, 3) [nT]; None where a row offers no vector."""
    if found.affine is None or run.reference.kind == "none":
        return None
    carried = carry(run)
    if (carried.observation != "vector").any() or (found.phase_rad is None and carried.phase_names):
        return None
    phases = np.zeros(0) if found.phase_rad is None else found.phase_rad
    return np.asarray(found.affine.apply(run.reading) - carried.prediction(phases))


def reading_bias_nT(run: Run, affine: AffineMap) -> Array:
    """The reading at zero field (3,), times the nominal nT per unit: K⁻¹ k."""
    return np.asarray(np.linalg.solve(affine.K, affine.k_nT) * run.dut.nominal_nT_per_unit)


def folds(run: Run, count: int = FOLDS) -> Iterator[tuple[NDArray[np.bool_], NDArray[np.bool_]]]:
    """Masks (training, test) (n,): each fold holds out one contiguous block of every segment's time.

    A run that has one stretch a rotation axis would lose an axis were whole stretches held out.
    """
    block = _block_of_row(run, count)
    for index in range(count):
        test = block == index
        if test.any() and not test.all():
            yield ~test, test


def _block_of_row(run: Run, count: int) -> NDArray[np.intp]:
    block = np.zeros(len(run), dtype=np.intp)
    for index in range(len(run.segments)):
        rows = run.rows(index)
        block[rows] = (np.arange(len(rows)) * count // max(len(rows), 1) + index) % count
    return block


def axis_errors_deg(run: Run, affine: AffineMap) -> tuple[float, ...] | None:
    """Angle between each rotation segment's declared `axis_body` and the normal of its calibrated locus' plane.

    None where no rotation segment states its axis, or one has too few rows for a plane.
    """
    errors = []
    for index, segment in enumerate(run.segments):
        if segment.kind != "rotation" or segment.axis_body is None:
            continue
        field = affine.apply(run.reading[run.rows(index)])
        field = field[np.isfinite(field).all(axis=1)]
        if len(field) < 3:
            return None
        normal, _ = plane_normal(field)
        errors.append(_angle_deg(normal, np.asarray(segment.axis_body)))
    return tuple(errors) or None


def _angle_deg(a: Array, b: Array) -> float:
    """The acute angle between two lines; exact for small ones."""
    return float(np.degrees(np.arctan2(np.linalg.norm(np.cross(a, b)), abs(a @ b))))

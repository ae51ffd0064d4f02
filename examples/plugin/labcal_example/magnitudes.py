"""Least squares on magnitudes: K symmetric and k so that |K m − k| is the reference's magnitude, row by row."""

from __future__ import annotations

from functools import partial

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import least_squares

from labcal.fit.result import Fit
from labcal.model import AffineMap
from labcal.record import Run

Array = NDArray[np.float64]
METHOD = "example-magnitudes"
WHERE = ((0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2))  # the six free elements of K
PERFECT = np.array([1.0, 0, 0, 1, 0, 1, 0, 0, 0])
FEWEST, DETERMINED = 30, 0.05  # rows; standard uncertainty of an element of K, relative
NOT_DETERMINED = "the magnitudes do not determine gains and offsets: turn about three axes, or in two fields"


def magnitudes(run: Run) -> Fit:
    """Calibrate `run` from magnitudes; the rotation stays open, so K is symmetric and the covariance of rank 9."""
    if run.reference.kind == "none":
        return Fit(METHOD, ok=False, why_not="without a reference nothing states the scale")
    known = np.isfinite(run.reading).all(axis=1) & np.isfinite(run.magnitude_nT)
    if known.sum() < FEWEST:
        return Fit(METHOD, ok=False, why_not=f"{known.sum()} rows are complete, at least {FEWEST} are needed")
    unit = run.dut.nominal_nT_per_unit
    return _fitted(run.reading_nT[known], run.magnitude_nT[known], unit)


def _fitted(m: Array, magnitude: Array, unit: float) -> Fit:
    size = float(np.sqrt(np.mean(magnitude**2)))
    m, magnitude = m / size, magnitude / size
    found = least_squares(partial(_residual, m, magnitude), PERFECT, jac=partial(_slopes, m))
    jac = _slopes(m, found.x)
    if not found.success or np.linalg.matrix_rank(jac, 1e-9 * len(m)) < len(found.x):
        return Fit(METHOD, ok=False, why_not=NOT_DETERMINED)
    variance = 2 * found.cost / (len(m) - len(found.x))
    covariance = variance * np.linalg.inv(jac.T @ jac)
    if np.sqrt(np.diag(covariance)[:6].max()) > DETERMINED:
        return Fit(METHOD, ok=False, why_not=NOT_DETERMINED)
    spread = np.diag(np.r_[np.full(9, unit), np.full(3, size)]) @ SPREAD
    affine = AffineMap.from_parameters(spread @ found.x)
    return Fit(METHOD, True, None, affine, spread @ covariance @ spread.T, noise_nT=size * float(np.sqrt(variance)))


def _spread() -> Array:
    """From the nine free parameters to K row by row and k (12, 9)."""
    out = np.zeros((12, 9))
    for number, (i, j) in enumerate(WHERE):
        out[3 * i + j, number] = out[3 * j + i, number] = 1.0
    out[9:, 6:] = np.eye(3)
    return out


SPREAD = _spread()


def _field(m: Array, x: Array) -> Array:
    return AffineMap.from_parameters(SPREAD @ x).apply(m)


def _residual(m: Array, magnitude: Array, x: Array) -> Array:
    return np.asarray(np.linalg.norm(_field(m, x), axis=1) - magnitude)


def _slopes(m: Array, x: Array) -> Array:
    """The derivative (n, 9) of the residual by the parameters."""
    b = _field(m, x)
    along = b / np.linalg.norm(b, axis=1, keepdims=True)
    whole = np.column_stack([(along[:, :, None] * m[:, None, :]).reshape(-1, 9), -along])
    return np.asarray(whole @ SPREAD)

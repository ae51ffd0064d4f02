"""`twostep`: the centred estimate, then Gauss-Newton with the centre term (Alonso & Shuster's TWOSTEP).

As Crassidis, Lai & Harman 2003 use it below (22): the loss of (3b) is the sum of the centred loss, which is quadratic,
and of one term for the means, (z̄ − μ̄ − L̄ θ' + |b|²)² / σ̄². A step costs the same however long the run is.
"""

from __future__ import annotations

from math import sqrt

import numpy as np
from numpy.typing import NDArray
from scipy.linalg.lapack import dgesv

from labcal.fit import scalar_check
from labcal.fit.moments import Moments, determined, moments, weighted
from labcal.fit.result import Fit
from labcal.fit.scalar_check import MISSING, Estimate
from labcal.fit.scalar_run import fit_scalar
from labcal.record import Run

Array = NDArray[np.float64]
STEPS, ROUGH, SETTLED = 50, 1.0, 1e-5  # steps; their size at the end, in standard uncertainties
ROUNDING = 1e-10  # of a step, where the field's magnitude is one
RIDGE = 10.0  # of the start, in units of what the noise alone seems to tell


def twostep(run: Run) -> Fit:
    """Calibrate `run` from magnitudes; a constant magnitude serves where three axes were turned in it."""
    return fit_scalar(run, "twostep", estimate)


def estimate(
    reading: Array,
    magnitude: Array,
    noise: Array,
    reference_noise: float = 0.0,
    *,
    unbiased: bool = True,
    near: Estimate | None = None,
) -> Estimate:
    """Bias and D from readings (n, 3) and field magnitudes (n,), in one unit; the arguments as in `centered.estimate`.

    Raises ArithmeticError where the iteration finds no minimum.
    """
    unit = sqrt(magnitude @ magnitude / len(magnitude))
    L, magnitude = scalar_check.regressor(reading / unit), magnitude / unit
    noise, reference_noise = noise / unit**2, reference_noise / unit
    c_E = rough(L, magnitude, noise) if near is None else scalar_check.to_c_E(near.bias / unit, near.D)
    found = moments(L, magnitude, c_E, noise, reference_noise)  # the weights depend on the parameters, (5b)
    c_E = descend(found, c_E, unbiased=unbiased)
    return scalar_check.from_c_E(c_E, covariance(found, c_E, unbiased=unbiased)).in_unit(unit)


def rough(L: Array, magnitude: Array, noise: Array) -> Array:
    """(c, E) (9,) near enough to weigh the rows by: a few steps with all weights alike."""
    z = scalar_check.observation(L, magnitude) - scalar_check.noise_mean(np.zeros(9), noise)
    alike = weighted(L, z, np.full(len(L), 4 * np.trace(noise) / 3), noise)
    return descend(alike, start(alike), settled=ROUGH)


def start(found: Moments) -> Array:
    """The centred estimate (9,), held near a perfect sensor in what the centred data do not determine."""
    return np.asarray(np.linalg.solve(found.information + RIDGE * found.noise_information, found.projection))


def descend(found: Moments, c_E: Array, *, unbiased: bool = True, settled: float = SETTLED) -> Array:
    """(c, E) (9,) at the minimum of the full loss, from moments alone; the last step is `settled` uncertainties long.

    Raises ArithmeticError where the iteration does not settle.
    """
    projection, centred = less_noise(found, unbiased=unbiased)
    for _ in range(STEPS):
        square, slope = scalar_check.bias_square(c_E)
        row = found.L - slope
        off_centre = (found.z - float(found.L @ c_E) + square) / found.variance
        curvature = centred + (row / found.variance)[:, None] * row
        *_, step, singular = dgesv(curvature, projection - centred @ c_E + off_centre * row)
        if singular:
            break
        c_E = c_E + step
        if abs(step @ curvature @ step) < settled**2 or np.abs(step).max() < ROUNDING:
            return c_E
    raise ArithmeticError(f"Gauss-Newton does not settle, so the magnitudes hardly determine the parameters: {MISSING}")


def less_noise(found: Moments, *, unbiased: bool) -> tuple[Array, Array]:
    """The projection (9,) and the information (9, 9) of the centred data, the noise's share taken off."""
    if not unbiased:
        return found.projection, found.information
    return found.projection - found.noise_gradient, found.information - found.noise_information


def covariance(found: Moments, c_E: Array, *, unbiased: bool = True) -> Array:
    """The covariance (9, 9) of (c, E) at the minimum. Raises ArithmeticError where the noise seems to determine it."""
    row = found.L - scalar_check.bias_square(c_E)[1]
    information = found.information + np.outer(row, row) / found.variance
    if not unbiased:
        return np.asarray(np.linalg.inv(information))
    determined(information, found.noise_information)
    back = np.linalg.inv(information - found.noise_information)
    return back @ information @ back.T

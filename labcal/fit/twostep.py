"""`twostep`: the centred estimate, then Gauss-Newton with the centre term (Alonso & Shuster's TWOSTEP).

As Crassidis, Lai & Harman 2003 use it below (22): the loss of (3b) is the sum of the centred loss, which is quadratic,
and of one term for the means, (z̄ − μ̄ − L̄ θ' + |b|²)² / σ̄². A step costs the same however long the run is.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from labcal.fit import scalar_check
from labcal.fit.moments import Moments, determined, moments
from labcal.fit.result import Fit
from labcal.fit.scalar_check import MISSING, Estimate
from labcal.fit.scalar_run import fit_scalar
from labcal.record import Run

Array = NDArray[np.float64]
STEPS, ROUGH, SETTLED = 50, 1e-4, 1e-9
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
    unit = float(np.sqrt(np.mean(magnitude**2)))
    reading, magnitude = reading / unit, magnitude / unit
    noise, reference_noise = noise / unit**2, reference_noise / unit
    if near is None:
        first = moments(reading, magnitude, np.zeros(9), noise, reference_noise)
        c_E, _ = descend(first, start(first), unbiased=unbiased, settled=ROUGH)
    else:
        c_E = scalar_check.to_c_E(near.bias / unit, near.D)
    found = moments(reading, magnitude, c_E, noise, reference_noise)  # the weights depend on the parameters, (5b)
    return scalar_check.from_c_E(*descend(found, c_E, unbiased=unbiased)).in_unit(unit)


def start(found: Moments) -> Array:
    """The centred estimate (9,), held near a perfect sensor in what the centred data do not determine."""
    return np.asarray(np.linalg.solve(found.information + RIDGE * found.noise_information, found.projection))


def descend(found: Moments, c_E: Array, *, unbiased: bool = True, settled: float = SETTLED) -> tuple[Array, Array]:
    """(c, E) (9,) at the minimum of the full loss, and its covariance (9, 9), from moments alone.

    `settled` is the step at which it ends. Raises ArithmeticError where the iteration does not settle.
    """
    for _ in range(STEPS):
        square, slope = scalar_check.bias_square(c_E)
        row = found.L - slope
        information = found.information + np.outer(row, row) / found.variance
        gradient = found.projection - found.information @ c_E
        gradient += (found.z - found.L @ c_E + square) / found.variance * row
        curvature = information
        if unbiased:
            gradient -= found.noise_gradient - found.noise_information @ c_E
            curvature = information - found.noise_information
        step = np.linalg.solve(curvature, gradient)
        c_E = c_E + step
        if np.abs(step).max() < settled:
            if unbiased:
                determined(information, found.noise_information)
            back = np.linalg.inv(curvature)
            return c_E, back @ information @ back.T
    raise ArithmeticError(f"Gauss-Newton does not settle, so the magnitudes hardly determine the parameters: {MISSING}")

"""`centered`: linear least squares after subtracting the weighted means (Crassidis, Lai & Harman 2003, (15) to (18)).

The term |b|² of (3b), the same for all samples, drops out with the means, and what is left is linear in (c, E).
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from labcal.fit.result import Fit
from labcal.fit.scalar import scalar_check
from labcal.fit.scalar.moments import Moments, determined, moments
from labcal.fit.scalar.scalar_check import Estimate
from labcal.fit.scalar.scalar_run import fit_scalar
from labcal.record import Run

Array = NDArray[np.float64]
PASSES = 3  # the weights depend on the parameters, (5b)


def centered(run: Run) -> Fit:
    """Calibrate `run` from magnitudes. A constant magnitude leaves the scale open and is refused."""
    return fit_scalar(run, "centered", estimate)


def estimate(
    reading: Array,
    magnitude: Array,
    noise: Array,
    reference_noise: float = 0.0,
    *,
    unbiased: bool = True,
    near: Estimate | None = None,
) -> Estimate:
    """Bias and D from readings (n, 3) and field magnitudes (n,), in one unit.

    `noise` (3, 3) is the covariance of a reading, `reference_noise` the standard deviation of a magnitude. With
    `unbiased` False the noise's share of the moments stays in, as published; an estimate `near` the solution spares
    passes. Raises ArithmeticError where the readings do not determine nine parameters (unless published).
    """
    unit = float(np.sqrt(np.mean(magnitude**2)))
    rows, square = scalar_check.regressors(reading.T / unit), (magnitude / unit) ** 2
    c_E = np.zeros(9) if near is None else scalar_check.to_c_E(near.bias / unit, near.D)
    for _ in range(PASSES if near is None else 1):
        found = moments(rows, square, c_E, noise / unit**2, reference_noise / unit)
        c_E, covariance = solve(found, unbiased=unbiased)
    return answer(c_E, covariance).in_unit(unit)


def answer(c_E: Array, covariance: Array) -> Estimate:
    """Bias and D of (c, E) (9,), marked as what left the mean out."""
    return replace(scalar_check.from_c_E(c_E, covariance), centred=True)


def solve(found: Moments, *, unbiased: bool = True) -> tuple[Array, Array]:
    """(c, E) (9,) and its covariance (9, 9) from moments, (18)."""
    if not unbiased:
        covariance = np.linalg.inv(found.information)
        return covariance @ found.projection, np.asarray(covariance)
    signal = found.information - found.noise_information
    determined(signal, found.noise_information)
    back = np.linalg.inv(signal)
    return back @ (found.projection - found.noise_gradient), back @ found.information @ back.T

"""`twostep`: the centred estimate, then Gauss-Newton with the centre term (Alonso & Shuster's TWOSTEP).

As Crassidis, Lai & Harman 2003 use it below (22). Of (3), with M = I + E, only |b|² is not linear in the parameters:
v = |b|² − |H|² − L (c, M), and by (27) |b|² = ∂|b|²/∂(c, M) (c, M). A step is therefore linear least squares with the
regressors L − ∂|b|²/∂(c, M), of whose sums the centred loss and the term of the means are two parts, and costs the same
however long the run is.
"""

from __future__ import annotations

from math import sqrt

import numpy as np
from numpy.typing import NDArray
from scipy.linalg.lapack import dgesv, dgetrs

from labcal.fit import scalar_check
from labcal.fit.moments import Sums, determined, row_covariance, weighted
from labcal.fit.result import Fit
from labcal.fit.scalar_check import MISSING, PERFECT, Estimate
from labcal.fit.scalar_run import fit_scalar
from labcal.record import Run

Array = NDArray[np.float64]
STEPS, ROUGH, SETTLED = 50, 1e-2, 1e-5  # steps; their size at the end, in standard uncertainties
ROUNDING = 1e-10  # of a step, where the field's magnitude is one
RIDGE = 10.0  # of the start, in units of what the noise alone seems to tell
EYE, NINE_OF_TEN = np.eye(3), np.eye(10, 9)


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
    unit = sqrt(magnitude.dot(magnitude) / len(magnitude))
    B, square = np.ascontiguousarray(reading.T) / unit, (magnitude / unit) ** 2
    noise, reference_noise = noise / unit**2, reference_noise / unit
    centre = np.add.reduce(B, axis=1) / len(square)
    B -= centre[:, None]  # products of readings far from nought would lose digits
    rows, covariance = scalar_check.regressors(B), row_covariance(noise)
    c_E = rough(rows, square, covariance, noise, -centre) if near is None else near.in_unit(1 / unit).moved(-centre).c_E
    of_row = rows / scalar_check.noise_variance(rows, square, c_E, noise, reference_noise)  # (5b), by the parameters
    found = weighted(of_row, rows, square + scalar_check.noise_mean(c_E, noise), covariance)
    share = found.noise if unbiased else np.zeros((10, 10))
    c_E, signal = descend(found, c_E, share)
    if unbiased:
        determined(signal, share[:9, :9])
    return scalar_check.lazily(c_E, lambda: sandwich(signal, share[:9, :9])).moved(centre).in_unit(unit)


def rough(rows: Array, square: Array, covariance: Array, noise: Array, bias: Array) -> Array:
    """(c, E) (9,) near enough to weigh the rows by: the estimate with all weights alike, from about `bias` (3,)."""
    mean = float(np.vdot(noise, EYE))
    alike = weighted(rows, rows, square + mean, covariance)
    return descend(alike, start(alike, bias), alike.noise, settled=ROUGH * sqrt(4 * mean / 3))[0]


def start(found: Sums, bias: Array) -> Array:
    """The centred estimate (9,), held near D = 0 and a `bias` (3,) in what the centred data do not determine.

    |b|² is a tenth parameter here, which is the same as subtracting the means, (17).
    """
    ridge, perfect = RIDGE * found.noise, PERFECT.copy()
    perfect[:3] = bias
    *_, free, singular = dgesv(found.products + ridge, found.pull + ridge[:, :9].dot(perfect))
    if singular:
        raise ArithmeticError(f"the magnitudes do not determine all nine parameters: {MISSING}")
    return np.asarray(free[:9] - PERFECT)


def descend(found: Sums, c_E: Array, share: Array, *, settled: float = SETTLED) -> tuple[Array, Array]:
    """(c, E) (9,) at the minimum of the full loss and its curvature (9, 9), the noise's `share` (10, 10) taken off.

    `settled` is the size of the last step in uncertainties. Raises ArithmeticError where the iteration does not settle.
    """
    signal, slopes = found.products - share, NINE_OF_TEN.copy()
    slopes[9] = -scalar_check.bias_square(c_E)[1]
    for _ in range(STEPS):
        curvature = slopes.T.dot(signal).dot(slopes)
        factors, pivots, c_M, singular = dgesv(curvature, slopes.T.dot(found.pull))
        if singular:
            break
        slopes[9] = -scalar_check.bias_square(c_M - PERFECT)[1]
        gradient = slopes.T.dot(found.pull - signal.dot(slopes.dot(c_M)))
        step, _ = dgetrs(factors, pivots, gradient)
        if abs(gradient.dot(step)) < settled**2 or np.abs(step).max() < ROUNDING:
            return c_M + step - PERFECT, curvature
    raise ArithmeticError(f"Gauss-Newton does not settle, so the magnitudes hardly determine the parameters: {MISSING}")


def sandwich(signal: Array, share: Array) -> Array:
    """The covariance (9, 9) of (c, E) at the minimum, from the `signal`'s information and the noise's share of it."""
    back = np.linalg.inv(signal)
    return np.asarray(back @ (signal + share) @ back.T)

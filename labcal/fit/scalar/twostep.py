"""`twostep`: the centred estimate, then Gauss-Newton with the centre term (Alonso & Shuster's TWOSTEP).

As Crassidis, Lai & Harman 2003 use it below (22). Of (3), with M = I + E, only |b|² is not linear in the parameters:
v = |b|² − |H|² − L (c, M), and by (27) |b|² = ∂|b|²/∂(c, M) (c, M). A step is therefore linear least squares with the
regressors L − ∂|b|²/∂(c, M), of whose sums the centred loss and the term of the means are two parts, and costs the same
however long the run is.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray
from scipy.linalg.lapack import dgesv, dgetrs

from labcal.fit.result import Fit
from labcal.fit.scalar import scalar_check
from labcal.fit.scalar.moments import Sums, determined, row_covariance, weighted
from labcal.fit.scalar.scalar_check import MISSING, PERFECT, Estimate
from labcal.fit.scalar.scalar_run import fit_scalar
from labcal.record import Run

Array = NDArray[np.float64]
STEPS, SETTLED = 50, 1e-5  # steps; their size at the end, in standard uncertainties
ROUNDING = 1e-10  # of a step, relative to the answer
NEAR = 1e-4  # of |H|²: what the rough step may leave of |b|²
RIDGE = 10.0  # of the start, in units of the information that noise alone seems to give
UNSETTLED = f"Gauss-Newton does not settle, so the magnitudes hardly determine the parameters: {MISSING}"
NINE_OF_TEN = np.eye(10, 9)


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
    rows, centre = about_mean(reading, magnitude)
    covariance = row_covariance(noise)
    if near is None:
        c_M, along = rough(rows, covariance, noise, -centre)
    else:
        c_M = near.moved(-centre).c_E + PERFECT
        along = slopes(c_M)
    x = along.dot(c_M)
    weight = 1 / scalar_check.variance_at(rows[:10], rows[10], x, noise, reference_noise)  # (5b)
    found = weighted(rows[3:] * weight, rows, scalar_check.mean_at(x, noise), covariance)
    share = found.noise if unbiased else np.zeros((10, 10))
    c_M, signal = descend(found, along, share)
    if unbiased:
        determined(signal, share[:9, :9])
    return scalar_check.lazily(c_M - PERFECT, lambda: sandwich(signal, share[:9, :9])).moved(centre)


def about_mean(reading: Array, magnitude: Array) -> tuple[Array, Array]:
    """The rows (L, 1, |H|²) (11, n) of the readings less their mean, and that mean (3,).

    Products of readings far from zero would lose digits.
    """
    rows = np.empty((11, len(reading)))
    np.multiply(magnitude, magnitude, out=rows[10])
    rows[9] = 1 / len(reading)
    centre = rows[9].dot(reading)
    scalar_check.regressors(np.subtract(reading.T, centre[:, None], order="C"), out=rows[:10])
    return rows, centre


def rough(rows: Array, covariance: Array, noise: Array, bias: Array) -> tuple[Array, Array]:
    """(c, M) (9,) near enough to weight the rows by, from about `bias` (3,) with all weights alike, and its `slopes`.

    One step is enough unless it leaves of |b|² what counts beside |H|². Raises ArithmeticError as `descend` does.
    """
    alike = weighted(rows[3:], rows, noise.trace(), covariance)
    signal, along = alike.products - alike.noise, slopes(start(alike, bias))
    for _ in range(STEPS):
        c_M, *_ = step(signal, alike.cross_products, along)
        expected, along = along[9].dot(c_M), slopes(c_M)
        if abs(along[9].dot(c_M) - expected) * signal[9, 9] < -NEAR * alike.cross_products[9]:
            return c_M, along
    raise ArithmeticError(UNSETTLED)


def start(found: Sums, bias: Array) -> Array:
    """The centred estimate (9,), held near D = 0 and a `bias` (3,) in what the centred data do not determine.

    |b|² is a tenth parameter here, which is the same as subtracting the means, (17).
    """
    ridge, perfect = RIDGE * found.noise, PERFECT.copy()
    perfect[:3] = bias
    *_, free, singular = dgesv(found.products + ridge, found.cross_products + ridge[:, :9].dot(perfect))
    if singular:
        raise ArithmeticError(f"the magnitudes do not determine all nine parameters: {MISSING}")
    return np.asarray(free[:9])


def descend(found: Sums, along: Array, share: Array) -> tuple[Array, Array]:
    """(c, M) (9,) at the minimum of the full loss and its curvature (9, 9), the noise's `share` (10, 10) taken off.

    Raises ArithmeticError where the iteration does not settle.
    """
    signal, cross_products = found.products - share, found.cross_products
    for _ in range(STEPS):
        c_M, curvature, solve = step(signal, cross_products, along)
        along = slopes(c_M)
        gradient = along.T.dot(cross_products - signal.dot(along.dot(c_M)))
        last = solve(gradient)
        size = abs(gradient.dot(last))
        if size < SETTLED**2 or size < ROUNDING**2 * c_M.dot(curvature).dot(c_M):
            return c_M + last, curvature
    raise ArithmeticError(UNSETTLED)


def slopes(c_M: Array) -> Array:
    """The slopes (10, 9) of (c, M, −|b|²), by which the sums' rows (L, 1) become the regressors of a step."""
    out = NINE_OF_TEN.copy()
    out[9] = [-slope for slope in scalar_check.bias_square_at(c_M)[1]]
    return out


def step(signal: Array, cross_products: Array, along: Array) -> tuple[Array, Array, Callable[[Array], Array]]:
    """(c, M) (9,) after a step with the `along` (10, 9) of `slopes`, the curvature (9, 9) and what solves it again."""
    curvature = along.T.dot(signal).dot(along)
    factors, pivots, c_M, singular = dgesv(curvature, along.T.dot(cross_products))
    if singular:
        raise ArithmeticError(f"the magnitudes do not determine all nine parameters: {MISSING}")
    return c_M, curvature, lambda right: dgetrs(factors, pivots, right)[0]


def sandwich(signal: Array, share: Array) -> Array:
    """Covariance (9, 9) of the (c, E) at the minimum: the noise's `share` (9, 9) between the signal's."""
    back = np.linalg.inv(signal)
    return np.asarray(back @ (signal + share) @ back.T)

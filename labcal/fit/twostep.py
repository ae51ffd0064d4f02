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

from labcal.fit import scalar_check
from labcal.fit.moments import Sums, determined, row_covariance, weighted
from labcal.fit.result import Fit
from labcal.fit.scalar_check import MISSING, PERFECT, Estimate
from labcal.fit.scalar_run import fit_scalar
from labcal.record import Run

Array = NDArray[np.float64]
STEPS, SETTLED = 50, 1e-5  # steps; their size at the end, in standard uncertainties
ROUNDING = 1e-10  # of a step, relative to the answer
RIDGE = 10.0  # of the start, in units of what the noise alone seems to tell
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
    B, square = np.array(reading.T, order="C"), magnitude * magnitude
    centre = np.add.reduce(B, axis=1) / len(square)
    B -= centre[:, None]  # products of readings far from nought would lose digits
    rows, covariance = scalar_check.regressors(B), row_covariance(noise)
    c_E = rough(rows, square, covariance, noise, -centre) if near is None else scalar_check.moved(near.c_E, -centre)
    of_row = rows * (1 / scalar_check.noise_variance(rows, square, c_E, noise, reference_noise))  # (5b)
    found = weighted(of_row, rows, square + scalar_check.noise_mean(c_E, noise), covariance)
    share = found.noise if unbiased else np.zeros((10, 10))
    c_E, signal = descend(found, c_E, share)
    if unbiased:
        determined(signal, share[:9, :9])
    return scalar_check.lazily(
        scalar_check.moved(c_E, centre), lambda: sandwich(signal, share[:9, :9], scalar_check.moving(centre))
    )


def rough(rows: Array, square: Array, covariance: Array, noise: Array, bias: Array) -> Array:
    """(c, E) (9,) near enough to weigh the rows by: a step from about `bias` (3,), with all weights alike."""
    alike = weighted(rows, rows, square + noise.trace(), covariance)
    c_M, *_ = step(alike.products - alike.noise, alike.pull, slopes(start(alike, bias)))
    return np.asarray(c_M - PERFECT)


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


def descend(found: Sums, c_E: Array, share: Array) -> tuple[Array, Array]:
    """(c, E) (9,) at the minimum of the full loss and its curvature (9, 9), the noise's `share` (10, 10) taken off.

    Raises ArithmeticError where the iteration does not settle.
    """
    signal, pull, along = found.products - share, found.pull, slopes(c_E)
    for _ in range(STEPS):
        c_M, curvature, solve = step(signal, pull, along)
        along = slopes(c_M - PERFECT)
        gradient = along.T.dot(pull - signal.dot(along.dot(c_M)))
        last = solve(gradient)
        if abs(gradient.dot(last)) < max(SETTLED**2, ROUNDING**2 * c_M.dot(curvature).dot(c_M)):
            return c_M + last - PERFECT, curvature
    raise ArithmeticError(f"Gauss-Newton does not settle, so the magnitudes hardly determine the parameters: {MISSING}")


def slopes(c_E: Array) -> Array:
    """The slopes (10, 9) of (c, M, −|b|²), by which the sums' rows (L, 1) become the regressors of a step."""
    out = NINE_OF_TEN.copy()
    out[9] = -scalar_check.bias_square(c_E)[1]
    return out


def step(signal: Array, pull: Array, along: Array) -> tuple[Array, Array, Callable[[Array], Array]]:
    """(c, M) (9,) after a step with the `along` (10, 9) of `slopes`, the curvature (9, 9) and what solves it again."""
    curvature = along.T.dot(signal).dot(along)
    factors, pivots, c_M, singular = dgesv(curvature, along.T.dot(pull))
    if singular:
        raise ArithmeticError(f"the magnitudes do not determine all nine parameters: {MISSING}")
    return c_M, curvature, lambda right: dgetrs(factors, pivots, right)[0]


def sandwich(signal: Array, share: Array, slope: Array) -> Array:
    """Covariance (9, 9) of `slope` (9, 9) times the (c, E) at the minimum: the noise's `share` between the signal's."""
    back = slope @ np.linalg.inv(signal)
    return np.asarray(back @ (signal + share) @ back.T)

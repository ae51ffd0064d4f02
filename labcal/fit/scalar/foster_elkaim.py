"""`foster-elkaim`: the two-step calibration in the sensor's own axes (Springmann & Cutler 2011, sections 2.1 and 2.2).

Where the field's magnitude is constant, the ten coefficients of (8) by linear least squares, then a, b, c, x0, y0, z0,
ρ, φ and λ by algebra; where it varies, the nonlinear form (9) to (11), which is `telemetry` without currents.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import astuple, dataclass

import numpy as np
from numpy.typing import NDArray

from labcal.fit.result import Fit
from labcal.fit.scalar import scalar_check
from labcal.fit.scalar import telemetry as nonlinear
from labcal.fit.scalar.moments import Moments, determined, moments
from labcal.fit.scalar.scalar_check import Estimate
from labcal.fit.scalar.scalar_run import fit_scalar, scalars
from labcal.record import Run

Array = NDArray[np.float64]
CONSTANT = 0.005  # of the magnitude: a field that varies by less counts as constant
# E within Tr E = 0, which fixes the free factor of (8) at A + D + F = 3; columns c, then E11 E22 E12 E13 E23
TRACELESS = np.delete(np.eye(9), 5, axis=1)
TRACELESS[5, 3:5] = -1.0


@dataclass(frozen=True, slots=True)
class SensorAxes:
    """Scale factors a, b, c, offsets x0, y0, z0 [the readings' unit] and misalignments ρ, φ, λ [rad], (5) to (7)."""

    a: float
    b: float
    c: float
    x0: float
    y0: float
    z0: float
    rho: float
    phi: float
    lam: float


def foster_elkaim(run: Run) -> Fit:
    """Calibrate `run` from magnitudes: linear where they are constant, else nonlinear."""
    try:
        magnitude = scalars(run).magnitude
    except ValueError as error:
        return Fit("foster-elkaim", ok=False, why_not=str(error))
    constant = float(np.ptp(magnitude)) < CONSTANT * float(magnitude.mean())
    return fit_scalar(run, "foster-elkaim", linear if constant else varying)


def varying(
    reading: Array,
    magnitude: Array,
    noise: Array,
    reference_noise: float = 0.0,
    *,
    unbiased: bool = True,
    near: Estimate | None = None,
) -> Estimate:
    """The nonlinear form, (9) to (11); the arguments as in `twostep.estimate`."""
    none = np.empty((len(reading), 0))
    start = None if near is None else nonlinear.TelemetryEstimate(near, np.empty((0, 3)), near.covariance)
    return nonlinear.estimate(reading, magnitude, none, noise, reference_noise, unbiased=unbiased, near=start).affine


def linear(
    reading: Array,
    magnitude: Array,
    noise: Array,
    reference_noise: float = 0.0,
    *,
    unbiased: bool = True,
    near: Estimate | None = None,
) -> Estimate:
    """The linear form, (8), for a field of constant magnitude; the arguments as in `twostep.estimate`."""
    unit = float(np.sqrt(np.mean(magnitude**2)))
    c_E = np.zeros(9) if near is None else scalar_check.to_c_E(near.bias / unit, near.D)
    found = moments(
        scalar_check.regressors(reading.T / unit), (magnitude / unit) ** 2, c_E, noise / unit**2, reference_noise / unit
    )
    information, share = (TRACELESS.T @ part @ TRACELESS for part in (found.information, found.noise_information))
    right = TRACELESS.T @ (found.projection - unbiased * found.noise_gradient)
    if unbiased:
        determined(information - share, share)
    back = np.linalg.inv(information - unbiased * share)
    coefficients = np.append(back @ right, found.z)
    spread = np.zeros((9, 9))
    spread[:8, :8], spread[8, 8] = back @ information @ back.T, found.variance
    slope = derivative(lambda at: scaled(at, found)[0], coefficients)
    c_E, factor = scaled(coefficients, found)
    return scalar_check.from_c_E(c_E, slope @ spread @ slope.T / factor**2).in_unit(unit)


def scaled(coefficients: Array, found: Moments) -> tuple[Array, float]:
    """(c, E) (9,) and the free factor of (8), from its coefficients: eight of the quadric, then the mean of z.

    With M' and c' of trace three and J' the constant, the factor is |H|² / (c'ᵀ M'⁻¹ c' − J'), for |H| = 1.
    """
    c_E = TRACELESS @ coefficients[:8]
    J = float(found.L @ c_E) - coefficients[8] - 1
    factor = 1 / (scalar_check.bias_square(c_E)[0] - J)
    trace = np.where(np.arange(9) // 3 == 1, 1.0, 0.0)
    return factor * (c_E + trace) - trace, float(factor)


def derivative(function: Callable[[Array], Array], at: Array, step: float = 1e-6) -> Array:
    """Central differences (m, n) of a function of n numbers of order one."""
    return np.column_stack([(function(at + e) - function(at - e)) / (2 * step) for e in step * np.eye(len(at))])


def parameters(found: Estimate) -> SensorAxes:
    """The paper's nine numbers: T = (I + D)⁻¹ turned until it is lower triangular, o = (I + D)⁻¹ b."""
    inverse = np.linalg.inv(np.eye(3) + found.D)
    T, o = np.linalg.cholesky(inverse @ inverse), inverse @ found.bias
    b, c = np.hypot(T[1, 0], T[1, 1]), float(np.linalg.norm(T[2]))
    angles = np.arctan2(T[1, 0], T[1, 1]), np.arctan2(T[2, 1], T[2, 2]), np.arcsin(T[2, 0] / c)
    return SensorAxes(*map(float, (T[0, 0], b, c, *o, *angles)))


def parameter_uncertainty(found: Estimate) -> SensorAxes:
    """Standard uncertainties of `parameters`, by the derivative of each by b and D."""

    def of_theta(theta: Array) -> Array:
        at = Estimate(theta[:3] * size, scalar_check.unstacked(theta[3:]), found.spread)
        return np.array(astuple(parameters(at)))

    size = max(1.0, float(np.abs(found.bias).max()))
    slope = derivative(of_theta, found.theta / np.repeat([size, 1.0], [3, 6])) / np.repeat([size, 1.0], [3, 6])
    return SensorAxes(*np.sqrt(np.diag(slope @ found.covariance @ slope.T)).tolist())

"""The sensor's figures that stand in a calibration's map: zero readings, scale factors, angles between the axes."""

from __future__ import annotations

import numpy as np

from labcal.model import Calibration
from labcal.model.sensor_figures import figures_covariance, sensor_figures
from labcal.uncertainty.conformity.decision import Measured

AXES, AXIS_PAIRS = ("x", "y", "z"), ("x-y", "y-z", "z-x")


def figures_of_the_map(calibration: Calibration) -> tuple[Measured, ...]:
    """Offset [nT, nominal], scale [ratio, from nominal] of each axis and non-orthogonality [deg] of each pair.

    u is NaN where the calibration states no covariance.
    """
    theta, nominal = calibration.affine.parameters, calibration.dut.nominal_nT_per_unit
    values = sensor_figures(theta)
    u = np.sqrt(np.maximum(np.diag(figures_covariance(theta, calibration.covariance)), 0.0))
    scale, zero, angle = values.reshape(3, 3)
    u_scale, u_zero, u_angle = u.reshape(3, 3)
    return (
        *_each("offset", "offset", AXES, zero * nominal, u_zero * nominal),
        *_each("scale", "scale", AXES, scale / nominal - 1, u_scale / nominal),
        *_each("non_orthogonality", "non-orthogonality", AXIS_PAIRS, angle, u_angle),
    )


def _each(
    figure: str,
    words: str,
    of: tuple[str, ...],
    values: np.ndarray[tuple[int], np.dtype[np.float64]],
    u: np.ndarray[tuple[int], np.dtype[np.float64]],
) -> list[Measured]:
    return [Measured(figure, f"{words} {n}", float(v), float(s)) for n, v, s in zip(of, values, u, strict=True)]

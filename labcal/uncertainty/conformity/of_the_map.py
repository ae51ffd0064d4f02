"""The sensor's figures that stand in a calibration's map: zero readings, scale factors, angles between the axes."""

from __future__ import annotations

from dataclasses import replace
from math import inf

import numpy as np

from labcal.model import Calibration
from labcal.model.sensor_figures import figures_covariance, sensor_figures
from labcal.uncertainty.conformity.decision import Measured

AXES, AXIS_PAIRS = ("x", "y", "z"), ("x-y", "y-z", "z-x")


def figures_of_the_map(calibration: Calibration) -> tuple[Measured, ...]:
    """Offset [nT, nominal], scale [ratio, from nominal] of each axis and non-orthogonality [deg] of each pair.

    u is NaN where the calibration states no covariance; its degrees of freedom are those of the budget, if it has one.
    """
    theta, nominal = calibration.affine.parameters, calibration.dut.nominal_nT_per_unit
    values = sensor_figures(theta)
    u = np.sqrt(np.maximum(np.diag(figures_covariance(theta, calibration.covariance)), 0.0))
    scale, zero, angle = values.reshape(3, 3)
    u_scale, u_zero, u_angle = u.reshape(3, 3)
    found = (
        *_each("offset", "offset", AXES, zero * nominal, u_zero * nominal),
        *_each("scale", "scale", AXES, scale / nominal - 1, u_scale / nominal),
        *_each("non_orthogonality", "non-orthogonality", AXIS_PAIRS, angle, u_angle),
    )
    dof = {b["quantity"]: b["dof"] for b in calibration.budget if b["dof"] is not None}
    return tuple(replace(one, dof=dof.get(in_the_budget(one.quantity), inf)) for one in found)


def in_the_budget(quantity: str) -> str:
    """The name under which the budget has a figure: "zero reading x" is the offset x."""
    if quantity.startswith("offset "):
        return quantity.replace("offset", "zero reading")
    return quantity.replace("non-orthogonality", "off 90°").replace("-", "–")


def _each(
    figure: str,
    words: str,
    of: tuple[str, ...],
    values: np.ndarray[tuple[int], np.dtype[np.float64]],
    u: np.ndarray[tuple[int], np.dtype[np.float64]],
) -> list[Measured]:
    return [Measured(figure, f"{words} {n}", float(v), float(s)) for n, v, s in zip(of, values, u, strict=True)]

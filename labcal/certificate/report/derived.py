"""What a magnetometer person compares from year to year: scale factors, zero readings, angles between the axes."""

from __future__ import annotations

import numpy as np

from labcal.certificate.report.page import Table
from labcal.certificate.report.style import of_the_map
from labcal.model import Calibration
from labcal.model.sensor_figures import figures_covariance
from labcal.model.sensor_figures import sensor_figures as figures_of
from labcal.uncertainty.of_calibration import FIGURES


def sensor_figures(calibration: Calibration, coverage: float) -> Table:
    """Scale factor, zero reading and nonorthogonality of each sensitive axis, with the budget's U.

    Without a budget it is `coverage` times u.
    """
    theta, unit = calibration.affine.parameters, calibration.dut.unit
    values = figures_of(theta).reshape(3, 3)
    variance = np.diag(figures_covariance(theta, calibration.covariance))
    k = {b["quantity"]: b["k"] for b in calibration.budget}
    U = np.sqrt(np.maximum(variance, 0)).reshape(3, 3)
    U *= np.reshape([k.get(name, coverage) for name in FIGURES], (3, 3))
    rows = []
    for i, (axis, pair) in enumerate(zip("xyz", ("x–y", "y–z", "z–x"), strict=True)):
        cells = [of_the_map(values[j, i], U[j, i], most) for j, most in enumerate((9, 3, 4))]
        rows.append((axis, *cells[0], *cells[1], pair, *cells[2]))
    header = ("Axis", f"Scale (nT/{unit})", "U", f"Zero reading ({unit})", "U", "Axes", "Off 90° (°)", "U")
    note = "The same calibration as figures of the sensor: m = K⁻¹ (b + k)."
    note += " U is that of the budget, with its k." if k else ""
    return Table(header, tuple(rows), frozenset({1, 2, 3, 4, 6, 7}), note)

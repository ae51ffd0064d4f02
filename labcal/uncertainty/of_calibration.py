"""The budgets of a calibration: of the field at the points of its working range, and of the sensor's own figures."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from labcal.model import Calibration
from labcal.model.apply import misfit_variance, reading_noise
from labcal.model.sensor_figures import PAIRS, figures_jacobian
from labcal.record import Run
from labcal.uncertainty.budget import Budget, Correlation, Row
from labcal.uncertainty.contribution import Contribution
from labcal.uncertainty.sources import Sources
from labcal.uncertainty.working_points import slopes_at, working_points

Array = NDArray[np.float64]
FIGURES = (
    *(f"scale {axis}" for axis in "xyz"),
    *(f"zero reading {axis}" for axis in "xyz"),
    *(f"off 90° {'xyz'[a]}–{'xyz'[b]}" for a, b in PAIRS),
)
CORRELATED = 0.5  # |r| from which two parameters are listed
NOISE = "noise of the run, through the fit"
ONE_READING = "noise of one reading"
MISFIT = "structure that held-out residuals keep"


def budgets(calibration: Calibration, sources: Sources, run: Run) -> tuple[Budget, ...]:
    """Of each component of one reading's field at each working point, then of scale, zero and angles of the axes."""
    return (*field_budgets(calibration, sources, run), *figure_budgets(calibration, sources))


def field_budgets(calibration: Calibration, sources: Sources, run: Run) -> list[Budget]:
    """Of the components of the field that `apply` makes of one reading, at the working points."""
    points, found = working_points(calibration, run), list[Budget]()
    _, slopes = slopes_at(calibration, points)
    own = _own_rows(calibration, sources, run)
    for point, J in zip(points, slopes[:, :, _places(calibration)], strict=True):
        for axis in range(3):
            rows = (*rows_of(sources, J[axis], "nT"), *own[axis])
            correlations = correlated(calibration, sources, J[axis])
            found.append(Budget(f"b {'xyz'[axis]}", point.says, "nT", rows, correlations))
    return found


def figure_budgets(calibration: Calibration, sources: Sources) -> list[Budget]:
    """Of scale factors, zero readings and the angles between the axes: figures of the map, at k's own conditions."""
    J = np.zeros((len(FIGURES), len(calibration.covariance_of)))
    J[:, :12] = figures_jacobian(calibration.affine.parameters)
    at, found = calibration.k_means().removeprefix("at "), list[Budget]()
    for name, unit, slope in zip(FIGURES, _units(calibration.dut.unit), J, strict=True):
        rows, correlations = rows_of(sources, slope, unit), correlated(calibration, sources, slope)
        found.append(Budget(name, at if name.startswith("zero") else "", unit, tuple(rows), correlations))
    return found


def _units(unit: str) -> tuple[str, ...]:
    """The units of the figures, for readings in `unit`."""
    return (*("1" if unit == "nT" else f"nT/{unit}",) * 3, *(unit,) * 3, *("deg",) * 3)


def rows_of(sources: Sources, slope: Array, unit: str) -> list[Row]:
    """The contributions to a quantity that depends on the parameters by `slope` (p,) [`unit` per theirs]."""
    variance = float(slope @ sources.noise.covariance @ slope)
    u = float(np.sqrt(max(variance, 0.0)))
    noise = Row(NOISE, "A", "normal", u, unit, 1.0, sources.noise.dof_of(slope))
    return [noise, *(_declared_row(one, slope) for one in sources.declared)]


def _declared_row(c: Contribution, slope: Array) -> Row:
    return Row(c.source, c.type, c.distribution, c.u, c.unit, float(slope @ c.shift) / c.u, c.dof)


def correlated(calibration: Calibration, sources: Sources, slope: Array) -> tuple[Correlation, ...]:
    """Pairs of parameters that both contribute and are correlated by more than `CORRELATED`, all sources together."""
    C = sources.covariance
    u = np.sqrt(np.maximum(np.diag(C), 0.0))
    r = C / np.outer(safe := np.where(u > 0, u, 1.0), safe)
    effect = np.abs(slope) * u
    there = effect > 0.1 * effect.max() if effect.any() else np.zeros(len(u), dtype=bool)
    names = calibration.covariance_of
    pairs = np.argwhere(np.triu(np.abs(r) > CORRELATED, k=1) & np.outer(there, there))
    return tuple(Correlation(names[a], names[b], float(np.clip(r[a, b], -1, 1))) for a, b in pairs)


def _own_rows(calibration: Calibration, sources: Sources, run: Run) -> list[list[Row]]:
    """Of each component: the reading's noise through K, and what the run's residuals keep beyond noise.

    Noise that the run declares, and that the residual did not enlarge, is taken as known: nothing was counted.
    """
    per_unit = np.linalg.norm(calibration.affine.K / calibration.dut.nominal_nT_per_unit, axis=1)
    noise, declared = reading_noise(calibration), run.dut.noise_nT
    of_noise = _by_residual(noise, sources)
    if declared is not None and np.isclose(noise, declared, rtol=1e-9):
        of_noise = _by_declaration(noise)
    misfit = np.sqrt(misfit_variance(calibration, float(noise * np.linalg.norm(per_unit))))
    left = [Row(MISFIT, "A", "normal", float(misfit), "nT", 1.0, np.inf)] if misfit else []
    return [[replace(of_noise, sensitivity=float(c)), *left] for c in per_unit]


def _by_declaration(noise_nT: float) -> Row:
    return Row(ONE_READING, "B", "normal", noise_nT, "nT", 1.0, np.inf)


def _by_residual(noise_nT: float, sources: Sources) -> Row:
    return Row(ONE_READING, "A", "normal", noise_nT, "nT", 1.0, sources.noise.dof)


def _places(calibration: Calibration) -> list[int]:
    """Where each parameter of `covariance_of` stands among all of map and effects."""
    effects = [f"{i}:{p.name}" for i, effect in enumerate(calibration.effects) for p in effect.parameters]
    everything = [*calibration.covariance_of[:12], *effects]
    return [everything.index(name) for name in calibration.covariance_of]


def u_indicated(calibration: Calibration, slopes: Array) -> Array:
    """Standard uncertainty (n, 3) [nT, nominal] of what one reading indicates of n known fields.

    `slopes` (n, 3, p) are those of the field, of all parameters. Errors of the components that have one source go
    through K⁻¹ together; the reading's own noise needs no way back through the map.
    """
    into = calibration.dut.nominal_nT_per_unit * np.linalg.inv(calibration.affine.K)
    J, noise = into @ slopes, reading_noise(calibration)
    of_field = float(noise * np.linalg.norm(calibration.affine.K / calibration.dut.nominal_nT_per_unit))
    own = noise**2 + misfit_variance(calibration, of_field) * np.sum(into**2, axis=1)
    return np.asarray(np.sqrt(np.sum(J @ calibration.joint_covariance() * J, axis=2) + own))


def as_json(found: Sequence[Budget]) -> tuple[dict[str, Any], ...]:
    """As the calibration file has them."""
    return tuple(one.as_json() for one in found)

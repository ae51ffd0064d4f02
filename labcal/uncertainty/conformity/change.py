"""As found and as left: what changed between two calibrations of one DUT, in units of its uncertainty (E_n).

E_n = (new - old) / U, U of 95.45 % of the difference (ISO/IEC 17043; ISO 13528): beyond ±1 the DUT has changed. k is 2,
or Student's t where few degrees of freedom are behind both. Errors that both calibrations share, as those of one
reference, count twice in it: E_n is too small then, never too large.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from labcal.model import Calibration
from labcal.model.affine import jacobian
from labcal.uncertainty.conformity.decision import COVERAGE, Measured, coverage_of
from labcal.uncertainty.conformity.of_the_map import AXES, figures_of_the_map

Array = NDArray[np.float64]
SHOWN = {"offset": (1.0, "nT"), "scale": (1e-6, "ppm"), "non_orthogonality": (1.0, "deg")}


@dataclass(frozen=True, slots=True)
class Change:
    """One figure as found (by the older calibration) and as left (by the newer), in `unit`.

    `U` is the expanded uncertainty of the difference, `k` times its standard one, `e_n` the difference in units of it;
    both None where a calibration states no covariance.
    """

    quantity: str
    found: float
    left: float
    U: float | None
    unit: str
    e_n: float | None
    k: float = COVERAGE

    @property
    def changed(self) -> bool:
        """Whether the two differ by more than both uncertainties explain."""
        return self.e_n is not None and abs(self.e_n) > 1


@dataclass(frozen=True, slots=True)
class Changes:
    """All figures of two calibrations, the runs that they are of, and what keeps them from being compared."""

    found: str  # run id of the older
    left: str
    rows: tuple[Change, ...]
    remarks: tuple[str, ...] = ()

    def in_words(self) -> str:
        """One sentence: how many figures changed, and the one that did most."""
        known = [row for row in self.rows if row.e_n is not None]
        if not known:
            return "Whether the sensor changed cannot be said: a calibration states no uncertainty."
        worst = max(known, key=lambda row: abs(row.e_n or 0.0))
        moved = sum(row.changed for row in known)
        most = f"the largest is E_n = {worst.e_n:+.2f} ({worst.quantity})"
        if not moved:
            return f"No figure changed by more than its uncertainty; {most}."
        return f"{moved} of {len(known)} figures changed by more than their uncertainty; {most}."


def changes(new: Calibration, old: Calibration) -> Changes:
    """What changed from `old` to `new`. Raises ValueError where they are of two sensors, or read in two units."""
    if new.dut.serial != old.dut.serial:
        raise ValueError(f"is of {old.dut.serial}, not of {new.dut.serial}")
    if (new.dut.unit, new.dut.nominal_nT_per_unit) != (old.dut.unit, old.dut.nominal_nT_per_unit):
        raise ValueError(f"has readings in {_unit(old)}, not in {_unit(new)}")
    pairs = zip(figures_of_the_map(old), figures_of_the_map(new), strict=True)
    rows = (*(_figure(a, b) for a, b in pairs), *_magnitudes(new, old))
    return Changes(old.run_id, new.run_id, rows, tuple(_remarks(new, old)))


def _unit(calibration: Calibration) -> str:
    dut = calibration.dut
    return dut.unit if dut.unit == "nT" else f"counts of {dut.nominal_nT_per_unit:g} nT"


def _figure(old: Measured, new: Measured) -> Change:
    factor, unit = SHOWN[new.figure]
    u, k = np.hypot(old.u, new.u) / factor, coverage_of(_dof(old, new))
    return _change(new.quantity, old.value / factor, new.value / factor, u, unit, k)


def _dof(old: Measured, new: Measured) -> float:
    """Effective degrees of freedom of the difference (GUM, G.4.1, (G.2b))."""
    inverse = old.u**4 / old.dof + new.u**4 / new.dof
    return (old.u**2 + new.u**2) ** 2 / inverse if inverse > 0 else np.inf


def _change(quantity: str, found: float, left: float, u: float, unit: str, k: float = COVERAGE) -> Change:
    U = k * float(u) if np.isfinite(u) else None
    return Change(quantity, found, left, U, unit, (left - found) / U if U else None, k)


def _magnitudes(new: Calibration, old: Calibration) -> list[Change]:
    """|b| by both at the readings of a field along each axis, as strong as the strongest that the new one holds for."""
    strength = new.validity.field_nT[1]
    signed = [(sign * np.eye(3)[axis], f"{mark}{name}") for axis, name in enumerate(AXES) for sign, mark in BOTH_WAYS]
    return [_magnitude(new, old, strength * where, f"|b| at {name}") for where, name in signed]


BOTH_WAYS = ((1.0, "+"), (-1.0, "-"))


def _magnitude(new: Calibration, old: Calibration, field_nT: Array, quantity: str) -> Change:
    reading = np.asarray(np.linalg.solve(new.affine.K, field_nT + new.affine.k_nT)[None, :], dtype=np.float64)
    (found, u_found), (left, u_left) = (_size(calibration, reading) for calibration in (old, new))
    return _change(quantity, found, left, float(np.hypot(u_found, u_left)), "nT")


def _size(calibration: Calibration, reading: Array) -> tuple[float, float]:
    """|K m − k| and its standard uncertainty; the attitude, which magnitudes leave open, is not in it."""
    field = calibration.affine.apply(reading)[0]
    size = float(np.linalg.norm(field))
    if calibration.covariance is None or size == 0:
        return size, float("nan")
    row = field @ jacobian(reading)[0] / size
    return size, float(np.sqrt(max(row @ calibration.covariance[:12, :12] @ row, 0.0)))


def _remarks(new: Calibration, old: Calibration) -> list[str]:
    said = []
    if dict(new.k_at) != dict(old.k_at):
        said.append(f"Offsets are not of the same state: as found {_state(old)}, as left {_state(new)}.")
    elif new.k_means():
        said.append(f"Offsets are those {new.k_means()}.")
    if new.simulated != old.simulated:
        said.append("One of the two is simulated.")
    return said


def _state(calibration: Calibration) -> str:
    return calibration.k_means() or "at any state"

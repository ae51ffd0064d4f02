"""Parameters of autopilots: a symmetric matrix and an offset, in gauss (PX4) or milligauss (ArduPilot).

With m the reading in the autopilot's own unit and S symmetric, PX4 (1.11 and later) corrects b = S (m − o), ArduPilot
b = S (m + o); neither has room for a turn of the axes beyond its own list of orientations, nor for an effect beside
the map. A calibration that needs more is refused.
"""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from labcal.certificate.flight.content import Content
from labcal.errors import InputError

Array = NDArray[np.float64]
GAUSS_nT, MILLIGAUSS_nT = 1e5, 1e2
SCALE_OF_PX4, OFF_DIAGONAL_OF_PX4 = (0.1, 3.0), 1.0  # its parameters' ranges
OFF_DIAGONAL = ((0, 1), (0, 2), (1, 2))  # x, y, z of both
ROUNDING = 1e-6
FLOAT = 9  # MAV_PARAM_TYPE_REAL32


def px4(content: Content) -> str:
    """A parameter file as QGroundControl loads it: CAL_MAG0_XOFF … [gauss], …SCALE and …ODIAG.

    Raises InputError where the calibration does not fit.
    """
    S, offset = _symmetric(content, "PX4")
    if (
        not all(SCALE_OF_PX4[0] <= s <= SCALE_OF_PX4[1] for s in np.diag(S))
        or np.max(np.abs(_off(S))) > OFF_DIAGONAL_OF_PX4
    ):
        low, high = SCALE_OF_PX4
        text = f"PX4 takes scales from {low} to {high} and off-diagonals up to {OFF_DIAGONAL_OF_PX4}"
        raise InputError(f"{text}; these are {np.round(np.diag(S), 4).tolist()} and {np.round(_off(S), 4).tolist()}")
    values = {f"CAL_MAG0_{a}OFF": v for a, v in zip("XYZ", offset / GAUSS_nT, strict=True)}
    values |= {f"CAL_MAG0_{a}SCALE": v for a, v in zip("XYZ", np.diag(S), strict=True)}
    values |= {f"CAL_MAG0_{a}ODIAG": v for a, v in zip("XYZ", _off(S), strict=True)}
    lines = [
        *_about(content),
        "b = S (m - o) [gauss], m what the driver gives, before CAL_MAG0_ROT turns it.",
        "XODIAG, YODIAG, ZODIAG are S_xy, S_xz, S_yz.",
        "PX4 uses it for the sensor whose CAL_MAG0_ID is set; CAL_MAG0_ROT stays as it is.",
        "",
        "Vehicle-Id Component-Id Name Value Type",
    ]
    rows = (f"1\t1\t{name}\t{_number(value)}\t{FLOAT}" for name, value in values.items())
    return "\n".join([*(f"# {line}".rstrip() for line in lines), *rows]) + "\n"


def ardupilot(content: Content) -> str:
    """A parameter file as Mission Planner loads it: COMPASS_OFS_X … [milligauss], COMPASS_DIA_X … and COMPASS_ODI_X ….

    Raises InputError where the calibration does not fit.
    """
    S, offset = _symmetric(content, "ArduPilot")
    values = {f"COMPASS_OFS_{a}": -v for a, v in zip("XYZ", offset / MILLIGAUSS_nT, strict=True)}
    values |= {f"COMPASS_DIA_{a}": v for a, v in zip("XYZ", np.diag(S), strict=True)}
    values |= {f"COMPASS_ODI_{a}": v for a, v in zip("XYZ", _off(S), strict=True)}
    values |= {"COMPASS_SCALE": 1.0}
    lines = [
        *_about(content),
        "b = S (m + o) [milligauss], m in the body's axes, turned by COMPASS_ORIENT.",
        "ODI_X, ODI_Y, ODI_Z are S_xy, S_xz, S_yz.",
        "COMPASS_LEARN has to be 0, or the offsets are learned anew; COMPASS_OFFS_MAX at least as large as they are.",
    ]
    rows = (f"{name},{_number(value)}" for name, value in values.items())
    return "\n".join([*(f"# {line}".rstrip() for line in lines), *rows]) + "\n"


def _symmetric(content: Content, whose: str) -> tuple[Array, Array]:
    """S (3, 3) without unit and o (3,) [nT], with b = S (m − o) for readings m in nT. Raises InputError."""
    if content.effects:
        effects = "; ".join(one.said for one in content.effects)
        raise InputError(
            f"{whose}'s parameters hold a matrix and an offset alone, and none of these: {effects}; --format c does"
        )
    S, affine = content.axes, content.calibration.affine
    field = max(content.calibration.validity.field_nT)
    turn = (S - S.T) / 2
    wrong, u = float(field * np.linalg.norm(turn, 2)), float(np.sqrt(np.mean(content.constant_nT2)))
    if wrong > (u if np.isfinite(u) else ROUNDING * field):
        angle = float(np.degrees(np.linalg.norm(turn, 2)))
        text = f"{whose}'s matrix is symmetric, and this K turns the axes by {angle:.3g} deg, which such a one lacks"
        raise InputError(f"{text}: {wrong:.3g} nT at {field:.0f} nT, more than u = {u:.3g} nT; --format c holds it")
    return (S + S.T) / 2, np.asarray(
        np.linalg.solve(affine.K, affine.k_nT) * content.calibration.dut.nominal_nT_per_unit
    )


def _off(S: Array) -> Array:
    return np.array([S[i, j] for i, j in OFF_DIAGONAL])


def _about(content: Content) -> list[str]:
    calibration = content.calibration
    dut = calibration.dut
    said: Mapping[str, str] = {
        f"labcal calibration of {dut.serial} {dut.model}".rstrip(): f"run {calibration.run_id}",
        "sha256 of the calibration file": content.sha256,
        "signatures": content.status,
        "a reading of 1": f"{dut.nominal_nT_per_unit:g} nT for each {dut.unit}, as the driver has to count it",
    }
    lines = [f"{name}: {value}" for name, value in said.items()]
    lines += ["SIMULATED: it describes no real sensor"] if calibration.simulated else []
    lines += [
        f"left out, for it is bound to the run's own time: {record.effect}, {float(np.sqrt(np.mean(rms**2))):.3g} nT"
        for record, rms in zip(content.left_out, content.left_out_nT, strict=True)
    ]
    return ["".join(c if c.isprintable() else "?" for c in line) for line in lines]


def _number(value: float) -> str:
    return f"{value:.9g}"

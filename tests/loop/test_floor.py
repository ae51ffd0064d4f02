"""What noise alone would leave: rounding of readings and angle is part of it, a load switched at rest is not."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from types import ModuleType
from typing import Literal

import numpy as np
import pytest

from labcal import session
from labcal.loop import close_loop
from labcal.loop.close import prepare
from labcal.loop.noise.differences import white_level

STEP_deg = 0.7


def in_halves(angle_deg: np.ndarray) -> np.ndarray:
    """No rounding: the second half of the run was started elsewhere."""
    return angle_deg + 0.6 * (np.arange(len(angle_deg)) >= len(angle_deg) // 2)


def rounded(angle_deg: np.ndarray) -> np.ndarray:
    """As an encoder of coarse steps tells it."""
    return STEP_deg * np.round(angle_deg / STEP_deg)


def from_rest(angle_deg: np.ndarray) -> np.ndarray:
    """No rounding: each sixth of the run begins at rest and ends there, within two rows."""
    each = angle_deg.reshape(6, -1).copy()
    each[:, 0] += 1.3
    each[:, -1] -= 0.65
    return each.ravel()


@pytest.mark.parametrize(("told", "step_deg"), [(in_halves, 0.0), (from_rest, 0.0), (rounded, STEP_deg)])
def test_the_angles_rounding_is_seen_where_the_motion_changes_by_its_steps(
    making: ModuleType, tmp_path: Path, told: Callable[[np.ndarray], np.ndarray], step_deg: float
) -> None:
    rows, segments = making.recorded()
    axes = np.repeat(np.tile(np.eye(3), (2, 1)), len(rows["t_s"]) // 6, axis=0)
    across = np.cross(axes, rows["ref"])
    rows["angle"] = np.radians(told(np.degrees(rows["angle"])))
    for segment in segments:  # where it was started is not known
        del segment["body_from_cage"]
    found = prepare(session.load_run(str(making.written(tmp_path, rows, segments))))[1]
    rounding = np.mean(np.sum(across**2, axis=1)) * np.radians(step_deg) ** 2 / 12
    assert found.nT == pytest.approx(np.sqrt(3 * (making.NOISE_nT / 1.05) ** 2 + rounding), rel=0.02)


@pytest.mark.parametrize(("unit", "counts"), [("nT", 1), ("count", 1), ("count", 8)])
@pytest.mark.parametrize("step_nT", [0.0, 60.0])
def test_the_readings_rounding_is_part_of_the_declared_noise(
    making: ModuleType, tmp_path: Path, unit: Literal["nT", "count"], counts: int, step_nT: float
) -> None:
    run = session.load_run(str(making.written(tmp_path, *making.recorded())))
    step = step_nT or 1e-3
    reading = np.round(run.reading / step) * (counts if unit == "count" else step)
    dut = replace(run.dut, unit=unit, nominal_nT_per_unit=step / counts if unit == "count" else 1.0)
    _, found, _ = prepare(replace(run, reading=reading, dut=dut))
    assert found.source == "declared"
    assert found.nT == pytest.approx(np.sqrt(3 * (making.NOISE_nT**2 + step_nT**2 / 12)) / 1.05, rel=0.02)


def test_rows_that_round_alike_are_no_measure_of_a_noise_that_is_not_stated(making: ModuleType, tmp_path: Path) -> None:
    """At rest in fields of many directions, in steps of four times the noise: most rows are as the one before."""
    rows, segments = making.recorded()
    for segment in segments:
        segment["kind"] = "static"
    rows["angle"] = np.full(len(rows["t_s"]), np.nan)
    draw = np.random.default_rng(6)
    rows["ref"] = np.repeat(draw.normal(0, 25000.0, (len(rows["t_s"]) // 10, 3)), 10, axis=0)
    rows["dut"] = 80.0 * np.round((rows["ref"] + draw.normal(0, 20.0, rows["ref"].shape)) / 80.0)
    closed = close_loop(session.load_run(str(making.written(tmp_path, rows, segments, noise_nT=None))))
    assert closed.verdict == "clean"
    assert closed.set_aside["outliers"] == 0
    assert closed.noise_floor_nT == pytest.approx(np.sqrt(3 * (20.0**2 + 80.0**2 / 12)), rel=0.2)


@pytest.mark.parametrize("told", [True, False], ids=["by its current", "by the power mode"])
def test_a_load_that_is_switched_at_rest_is_no_noise(making: ModuleType, tmp_path: Path, told: bool) -> None:
    rows, segments = making.recorded(seconds=20.0)
    for segment in segments:
        segment["kind"] = "static"
    rows["angle"] = np.full(len(rows["t_s"]), np.nan)
    attitudes = np.array([[1, 0, 0], [0, 1, 0], [0, 0, 1], [-1, 1, 0], [0, -1, 1], [1, 1, 1]])
    rows["ref"] = np.repeat(20000.0 * attitudes, 40, axis=0)
    noise = np.random.default_rng(2).normal(0, 20.0, rows["dut"].shape)
    on = np.mod(np.arange(len(noise)), 9) < 4
    rows["dut"] = rows["ref"] + noise + on[:, None] * np.array([90.0, -60.0, 40.0])
    rows["i_load"] = np.where(told, 0.8 * on, 0.0)
    run = session.load_run(str(making.written(tmp_path, rows, segments, noise_nT=None)))
    if not told:
        run = replace(run, row_mode=np.where(on, "full", "idle"))
    _, found, _ = prepare(run)
    assert found.source == "static"
    assert found.nT == pytest.approx(np.sqrt(3) * 20.0, rel=0.06)


@pytest.mark.parametrize("stated", [True, False], ids=["stated", "not stated"])
def test_what_the_reference_scatters_is_not_the_devices_noise(making: ModuleType, tmp_path: Path, stated: bool) -> None:
    """A reference of 30 nT an axis, which it states, beside a device of 20 nT whose noise is stated or not.

    A level from the differences of 540 rows is known to 2.5 %, so what is left of it for the device to 9 %.
    """
    rows, segments = making.recorded()
    rows["ref"] = rows["ref"] + np.random.default_rng(2).normal(0, 30.0, rows["ref"].shape)
    run = session.load_run(str(making.written(tmp_path, rows, segments, noise_nT=making.NOISE_nT if stated else None)))
    closed = close_loop(replace(run, reference=replace(run.reference, noise_nT=30.0)))
    whole_nT = np.sqrt(3) * np.hypot(30.0, making.NOISE_nT / 1.05)
    assert closed.noise_floor_nT == pytest.approx(whole_nT, rel=0.02 if stated else 0.075)
    assert closed.noise_nT == pytest.approx(making.NOISE_nT, rel=1e-9 if stated else 0.25)
    assert closed.metrics()["after"]["noise_beside_readings_nT"] == pytest.approx(np.sqrt(3) * 30.0, rel=1e-6)


def test_noise_smaller_than_the_step_is_seen_where_a_field_that_is_held_falls_between_two_steps() -> None:
    rng, held, step = np.random.default_rng(4), np.repeat(np.arange(400), 5), 1.0
    said = np.round((rng.uniform(0, 50, 400)[held] + rng.normal(0, 0.25, 2000)) / step)[:, None]
    within = np.sqrt(np.mean(said.reshape(400, 5).var(axis=1, ddof=1)))
    assert white_level(said, held, step / np.sqrt(12)) == pytest.approx(within, rel=0.15)

"""What a temperature does beyond a straight line: a gain that bends, an offset unlike in heating and cooling."""

from __future__ import annotations

from pathlib import Path
from types import ModuleType

import numpy as np
import pytest

from labcal import session
from labcal.fit import draft_calibration
from labcal.loop import close_loop
from labcal.model import apply as applying
from labcal.model.readings import readings_of

DIRECTIONS = np.array([1.0, -0.7, 0.5])
Rows = dict[str, np.ndarray]


def _warmed(rows: Rows) -> np.ndarray:
    t = rows["t_s"]
    T = 20 + 5 * np.sin(t / 46.0) + 2 * np.sin(t / 15.0)
    rows["temp"] = T + np.random.default_rng(9).normal(0, 0.03, len(t))
    return T - 20


def test_a_gain_that_bends_with_temperature(making: ModuleType, tmp_path: Path) -> None:
    rows, segments = making.recorded()
    warm, field = _warmed(rows)[:, None], (rows["dut"] - 800) / 1.05
    rows["dut"] = rows["dut"] + 1.05 * field * (2e-4 * warm + 2e-4 * warm**2) * DIRECTIONS
    closed = close_loop(session.load_run(str(making.written(tmp_path, rows, segments))))
    assert ([e.effect for e in closed.accepted], closed.verdict) == (["gain-temperature"], "explained")
    found = {p.name: p for p in closed.accepted[0].parameters}
    for axis, size in zip("xyz", DIRECTIONS, strict=True):
        assert abs(found[f"h_{axis}"].value - 2e-4 * size) < max(4 * found[f"h_{axis}"].u, 2e-5)


@pytest.mark.parametrize("slope", [0.0, 9.0])
def test_an_offset_unlike_in_heating_and_cooling_has_two_branches(
    making: ModuleType, tmp_path: Path, slope: float
) -> None:
    rows, segments = making.recorded()
    warm, clean = _warmed(rows), rows["dut"]
    stop, turn = np.zeros(len(warm)), 1.3
    for i in range(1, len(warm)):
        stop[i] = np.clip(stop[i - 1] + warm[i] - warm[i - 1], -turn, turn)
    branch = stop / turn
    rows["dut"] = clean + (20 * warm + 65 * branch + slope * warm * branch)[:, None] * DIRECTIONS
    run = session.load_run(str(making.written(tmp_path, rows, segments)))
    closed = close_loop(run)
    assert ([(e.effect, e.channels) for e in closed.accepted], closed.verdict) == (
        [("offset-temperature", ("temp",))],
        "explained",
    )
    found = {p.name: p for p in closed.accepted[0].parameters}
    assert abs(found["r_C"].value - turn) < max(4 * found["r_C"].u, 0.2)
    at_reference = 65 + slope * (closed.accepted[0].reference_value["temp"] - 20)
    assert abs(found["b_x"].value - at_reference / 1.05) < 6
    assert ("f_x" in found) == bool(slope)
    calibration, readings = draft_calibration(run, closed.fit(), ""), readings_of(run)
    whole = applying.apply(calibration, readings)
    assert np.sqrt(np.mean((whole.field_nT - (clean - 800) / 1.05) ** 2)) < 10
    parts = list(applying.apply_in_pieces(calibration, readings, 37))
    assert np.allclose(np.concatenate([part.field_nT for part in parts]), whole.field_nT, atol=1e-6)

"""Lines in time: fixed to the device, or to the cage while the device turns in it."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
import pytest

from labcal import session
from labcal.errors import InputError
from labcal.geometry import rotate
from labcal.loop import close_loop
from labcal.loop.close import prepare
from labcal.loop.data.decimate import rows_per_bin
from labcal.model.effects.registry import load_shipped

Rows = dict[str, np.ndarray]
LINE_nT, NYQUIST_Hz = 138 * np.array([0.6, -0.64, 0.48]), 1.0


def _in_the_body(rows: Rows, segments: list[dict[str, Any]], field_nT: np.ndarray) -> np.ndarray:
    """A field of the cage (n, 3) as the device sees it."""
    out = np.zeros_like(field_nT)
    for segment in segments:
        here = rows["segment"] == segment["id"]
        out[here] = rotate(np.array(segment["axis_body"]), -rows["angle"][here], field_nT[here])
    return out


@pytest.mark.parametrize(("frame", "owner", "f_Hz"), [("cage", "rig", 0.93 * NYQUIST_Hz), ("body", "sensor", 0.3)])
def test_a_line_is_found_in_the_frame_that_it_is_fixed_to(
    making: ModuleType, tmp_path: Path, frame: str, owner: str, f_Hz: float
) -> None:
    rows, segments = making.recorded()
    line = np.cos(2 * np.pi * f_Hz * rows["t_s"] + 0.4)[:, None] * LINE_nT
    rows["dut"] = rows["dut"] + 1.05 * (_in_the_body(rows, segments, line) if frame == "cage" else line)
    closed = close_loop(session.load_run(str(making.written(tmp_path, rows, segments))))
    assert [(e.effect, e.belongs_to) for e in closed.accepted] == [("periodic", owner)]
    assert closed.verdict == "explained"
    found = {p.name: p for p in closed.accepted[0].parameters}
    prefix = "cage_" if frame == "cage" else ""
    sizes = [np.hypot(found[f"{prefix}cos_{a}"].value, found[f"{prefix}sin_{a}"].value) for a in "xyz"]
    assert np.allclose(sizes, np.abs(LINE_nT), atol=5 * found[f"{prefix}cos_x"].u)
    assert abs(found["f_Hz"].value - f_Hz) < 5 * found["f_Hz"].u
    if frame == "cage":
        with pytest.raises(InputError, match="the rig's, never the sensor's"):
            load_shipped(replace(closed.accepted[0], belongs_to="sensor"))


def test_rows_are_not_binned_where_a_fast_line_of_the_cage_would_be_lost(making: ModuleType, tmp_path: Path) -> None:
    rows, segments = making.recorded("z", seconds=2700.0)
    draw = np.random.default_rng(1)
    rows["angle"] = rows["angle"] + np.cumsum(draw.normal(0, 0.1, len(rows["angle"])))  # smears it over the body's axes
    line = 30 * np.cos(2 * np.pi * 0.9 * rows["t_s"])[:, None] * [1.0, 0.0, 0.0]
    seen = _in_the_body(rows, segments, rows["ref"] + line)
    rows["dut"] = 1.05 * seen + 800 + draw.normal(0, 20, seen.shape)
    problem, _, _ = prepare(session.load_run(str(making.written(tmp_path, rows, segments))))
    assert rows_per_bin(problem) == 1


@pytest.mark.parametrize(("period_s", "f_Hz"), [(None, 50.3143), (1.13, 60.0271)])
def test_the_mains_are_found_at_their_own_frequency_where_the_recorder_starts_anew(
    making: ModuleType, tmp_path: Path, period_s: float | None, f_Hz: float
) -> None:
    rows, segments = making.recorded()
    if period_s is not None:
        rows["t_s"] = rows["t_s"] * (period_s / np.median(np.diff(rows["t_s"])))
    for number, segment in enumerate(segments):
        rows["t_s"][rows["segment"] == segment["id"]] += [0.1317, 0.3702, 0.0285, 0.2939, 0.4411, 0.2123][number]
    line = np.cos(2 * np.pi * f_Hz * rows["t_s"] + 0.4)[:, None] * LINE_nT
    rows["dut"] = rows["dut"] + 1.05 * line
    closed = close_loop(session.load_run(str(making.written(tmp_path, rows, segments))))
    assert ([e.effect for e in closed.accepted], closed.verdict) == (["periodic"], "explained")
    found = {p.name: p for p in closed.accepted[0].parameters}
    assert abs(found["f_Hz"].value - f_Hz) < max(5 * found["f_Hz"].u, 1e-4)
    assert abs(np.hypot(found["cos_x"].value, found["sin_x"].value) - LINE_nT[0]) < 5

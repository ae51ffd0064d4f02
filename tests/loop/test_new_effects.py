"""A gain that steps, and a reference that follows the room: put in, found, and put back."""

from __future__ import annotations

from pathlib import Path
from types import ModuleType

import numpy as np
import pytest

from labcal import session
from labcal.loop import close_loop

DIRECTIONS = np.array([1.0, -0.7, 0.5])


def test_a_gain_that_steps_is_found_with_its_moment(making: ModuleType, tmp_path: Path) -> None:
    rows, segments = making.recorded()
    at, gains = float(rows["t_s"][260]) - 0.2, 0.004 * DIRECTIONS
    field = (rows["dut"] - 800) / 1.05
    rows["dut"] = rows["dut"] + 1.05 * field * gains * (rows["t_s"] >= at)[:, None]
    closed = close_loop(session.load_run(str(making.written(tmp_path, rows, segments))))
    assert [e.effect for e in closed.accepted] == ["gain-step"]
    assert closed.verdict == "explained"
    found = {p.name: p for p in closed.accepted[0].parameters}
    assert abs(found["t_step_s"].value - at) < 1.0
    for axis, put_in in zip("xyz", gains, strict=True):
        assert abs(found[f"g_{axis}"].value - put_in) < max(5 * found[f"g_{axis}"].u, 0.1 * abs(put_in))


def test_a_reference_that_follows_the_room_is_the_rigs(making: ModuleType, tmp_path: Path) -> None:
    rows, segments = making.recorded()
    t = rows["t_s"]
    rows["temp_room"] = 21.3 + 1.4 * np.sin(t / 61.0) + 0.004 * t
    warm = (rows["temp_room"] - np.median(rows["temp_room"]))[:, None]
    rows["ref"] = rows["ref"] * (1 - 0.002 * warm) - 90.0 * DIRECTIONS * warm
    channels = making.CHANNELS | {"temp_room": {"unit": "degC", "quantity": "temperature", "role": "room"}}
    closed = close_loop(session.load_run(str(making.written(tmp_path, rows, segments, channels))))
    assert [(e.effect, e.channels, e.belongs_to) for e in closed.accepted] == [
        ("reference-temperature", ("temp_room",), "rig")
    ]
    found = {p.name: p.value for p in closed.accepted[0].parameters}
    assert abs(found["g"] - 0.002) < 0.0004
    assert np.allclose([found[f"c_{a}"] for a in "xyz"], 90.0 * DIRECTIONS, atol=20.0)


def test_where_the_zeros_agree_nearly_the_scale_is_right_where_they_are_and_u_holds_how_nearly(
    making: ModuleType, tmp_path: Path
) -> None:
    """Else the device's scale would be off by what the reference's is at the mean temperature, unsaid."""
    rows, segments = making.recorded()
    t, right_at = rows["t_s"], np.array([18.4, 18.5, 18.7])
    rows["temp_room"] = 21.3 + 1.4 * np.sin(t / 61.0) + 0.004 * t
    room = rows["temp_room"][:, None]
    rows["ref"] = (rows["ref"] - 720.0 * DIRECTIONS * (room - right_at)) / (1 + 0.016 * (room - 18.5))
    channels = making.CHANNELS | {"temp_room": {"unit": "degC", "quantity": "temperature", "role": "room"}}
    closed = close_loop(session.load_run(str(making.written(tmp_path, rows, segments, channels))))
    assert [e.effect for e in closed.accepted] == ["reference-temperature"]
    [found] = [p for p in closed.accepted[0].parameters if p.name == "scale_right_at"]
    assert abs(found.value - 18.5) < 2 * found.u < 0.4
    off = np.diag(closed.fit().affine.K) * 1.05 - 1
    u = np.sqrt(np.diag(closed.fit().covariance)[[0, 4, 8]]) * 1.05
    assert np.all(np.abs(off) < 2 * u)  # at the mean temperature it would be 0.05
    assert np.allclose(u, 0.016 * found.u, rtol=0.3)


@pytest.mark.parametrize("times", [pytest.param(1.0, marks=pytest.mark.slow), 8.0])
def test_a_reference_that_is_right_at_another_temperature_leaves_the_device_its_own_scale(
    making: ModuleType, tmp_path: Path, times: float
) -> None:
    """What the reference's scale is on average is no fit's to tell, unless zero and scale are right together.

    A strong one is right within a hundredth of a degree, which no grid of temperatures has a point near.
    """
    rows, segments = making.recorded()
    t, right_at = rows["t_s"], 18.5
    rows["temp_room"] = 21.3 + 1.4 * np.sin(t / 61.0) + 0.004 * t
    warm = (rows["temp_room"] - right_at)[:, None]
    rows["ref"] = (rows["ref"] - 90.0 * times * DIRECTIONS * warm) / (1 + 0.002 * times * warm)
    channels = making.CHANNELS | {"temp_room": {"unit": "degC", "quantity": "temperature", "role": "room"}}
    closed = close_loop(session.load_run(str(making.written(tmp_path, rows, segments, channels))))
    assert [e.effect for e in closed.accepted] == ["reference-temperature"]
    found = {p.name: p.value for p in closed.accepted[0].parameters}
    assert abs(found["right_at"] - right_at) < 0.3
    assert np.allclose(np.diag(closed.fit().affine.K), 1 / 1.05, rtol=5e-4)  # else 0.6 % off

"""A gain that follows a channel which is no temperature: found where it is, taken off by `apply`, and left else."""

from __future__ import annotations

from pathlib import Path
from types import ModuleType

import numpy as np
import pytest

from labcal import session
from labcal.fit import draft_calibration
from labcal.loop import close_loop
from labcal.model.apply import apply
from labcal.model.readings import readings_of
from labcal.record import Channel
from labcal.testing import check_effect

DIRECTIONS = np.array([1.0, -0.7, 0.5])
Rows = dict[str, np.ndarray]


def supply(t_s: np.ndarray) -> list[Channel]:
    volts = 8.0 + 0.3 * np.sin(t_s / 11.0) + 0.1 * np.sin(t_s / 3.7)
    return [Channel("v_bus", "V", "voltage", volts)]


def in_each_axis(scene, values):
    along = np.linalg.solve(scene.axes, scene.field_nT.T).T * [values["g_x"], values["g_y"], values["g_z"]]
    return (along * scene.channels["v_bus"][:, None]) @ scene.axes.T


@pytest.mark.slow
def test_it_is_its_physics_alone_and_is_taken_off_by_apply() -> None:
    check_effect("gain-channel", {"g_x": 0.01, "g_y": -0.007, "g_z": 0.012}, in_each_axis, channels=supply)


def fed(rows: Rows) -> np.ndarray:
    """A supply that wanders, and its deviation from 8 V."""
    volts = supply(rows["t_s"])[0].values
    rows["v_bus"] = volts + np.random.default_rng(3).normal(0, 0.005, len(volts))
    return (volts - 8.0)[:, None]


@pytest.mark.parametrize("bent", [pytest.param(0.0, marks=pytest.mark.slow), 0.03])
def test_a_gain_that_follows_the_supply_is_named_beside_temperatures_and_loads(
    making: ModuleType, tmp_path: Path, bent: float
) -> None:
    rows, segments = making.recorded()
    off, clean = fed(rows), rows["dut"]
    field = (clean - 800) / 1.05
    rows["dut"] = clean + 1.05 * field * (0.008 * off + bent * off**2) * DIRECTIONS
    channels = making.CHANNELS | {"v_bus": {"unit": "V", "quantity": "voltage"}}
    run = session.load_run(str(making.written(tmp_path, rows, segments, channels)))
    closed = close_loop(run)
    assert ([(e.effect, e.channels) for e in closed.accepted], closed.verdict) == (
        [("gain-channel", ("v_bus",))],
        "explained",
    )
    found = {p.name: p for p in closed.accepted[0].parameters}
    assert ("h_x" in found) == bool(bent)
    slope = 0.008 + 2 * bent * (closed.accepted[0].reference_value["v_bus"] - 8.0)
    for axis, size in zip("xyz", DIRECTIONS, strict=True):
        assert abs(found[f"g_{axis}"].value - slope * size) < max(4 * found[f"g_{axis}"].u, 3e-4)
    left = apply(draft_calibration(run, closed.fit(), ""), readings_of(run)).field_nT - field
    assert np.sqrt(np.mean(left**2)) < 6  # of the readings' noise nothing: it is in both


def test_a_gain_that_stands_has_no_such_name(making: ModuleType, tmp_path: Path) -> None:
    rows, segments = making.recorded()
    fed(rows)
    channels = making.CHANNELS | {"v_bus": {"unit": "V", "quantity": "voltage"}}
    closed = close_loop(session.load_run(str(making.written(tmp_path, rows, segments, channels))))
    assert (closed.verdict, closed.accepted) == ("clean", ())

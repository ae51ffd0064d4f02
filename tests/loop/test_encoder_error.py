"""A platform whose angle is read with an error of one or two cycles a turn: named, and the device's map as without."""

from __future__ import annotations

from pathlib import Path
from types import ModuleType

import numpy as np
import pytest

from labcal import session
from labcal.fit import draft_calibration
from labcal.loop import close_loop
from labcal.model.apply import apply
from labcal.model.readings import Readings


@pytest.mark.parametrize("second_deg", [pytest.param(0.0, marks=pytest.mark.slow), 0.25])
def test_a_disc_off_its_centre_is_named_and_the_map_is_the_devices_own(
    making: ModuleType, tmp_path: Path, second_deg: float
) -> None:
    rows, segments = making.recorded()
    true = rows["angle"]
    rows["angle"] = true - np.radians(0.5 * np.sin(true - 0.7) + second_deg * np.cos(2 * true))
    run = session.load_run(str(making.written(tmp_path, rows, segments)))
    closed = close_loop(run)
    assert [(e.effect, e.belongs_to) for e in closed.accepted] == [("encoder-error", "rig")]
    assert closed.verdict == "explained"
    found = {p.name: p for p in closed.accepted[0].parameters}
    put_in = {"cos1_deg": 0.5 * np.sin(-0.7), "sin1_deg": 0.5 * np.cos(0.7)}
    put_in |= {"cos2_deg": second_deg, "sin2_deg": 0.0} if second_deg else {}
    assert set(found) == set(put_in)
    for name, value in put_in.items():
        assert abs(found[name].value - value) < 0.02
    draft = draft_calibration(run, closed.fit(), "")
    assert not draft.effects
    fresh = np.random.default_rng(2).normal(0, 3e4, (50, 3))
    applied = apply(draft, Readings(1.05 * fresh + 800, np.arange(50.0), np.zeros(50, dtype=np.intp)))
    assert np.sqrt(np.mean((applied.field_nT - fresh) ** 2)) < 8


@pytest.mark.slow
def test_an_angle_that_is_off_by_as_much_everywhere_is_no_such_error(making: ModuleType, tmp_path: Path) -> None:
    rows, segments = making.recorded()
    rows["angle"] = rows["angle"] + 0.02
    closed = close_loop(session.load_run(str(making.written(tmp_path, rows, segments))))
    assert [e.effect for e in closed.accepted] == ["lag"]  # at one rate that is the same

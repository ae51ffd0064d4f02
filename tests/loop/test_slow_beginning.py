"""Where a slow response begins: what went before the first row nobody recorded."""

from __future__ import annotations

from itertools import pairwise
from pathlib import Path
from types import ModuleType

import numpy as np
import pytest

from labcal import session
from labcal.loop import close_loop
from labcal.model.effects import offset_current
from labcal.model.effects.regressors import low_passed

TAU_S, OFF_C = 18.0, 4.0
DIRECTIONS = np.array([60.0, -40.0, 30.0])  # nT/degC


def behind(t_s: np.ndarray, drive: np.ndarray, begins: float) -> np.ndarray:
    """The response of first order, in steps of 50 ms from its own first value; the drive is straight between rows."""
    fine = np.arange(t_s[0], t_s[-1] + 0.05, 0.05)
    keep, inputs, found = np.exp(-0.05 / TAU_S), np.interp(fine, t_s, drive), [begins]
    for before, here in pairwise(inputs):
        found.append(keep * found[-1] + (1 - keep) * (before + here) / 2)
    return np.interp(t_s, fine, found)


@pytest.mark.slow
def test_a_temperature_that_acts_late_may_begin_anywhere(making: ModuleType, tmp_path: Path) -> None:
    """A sensor that is still warm from what it did before: 4 degC, which fade within the first minute."""
    rows, segments = making.recorded()
    t = rows["t_s"]
    T = 20 + 5 * np.sin(t / 46.0) + 2 * np.sin(t / 15.0)
    rows["temp"] = T + np.random.default_rng(9).normal(0, 0.01, len(t))
    acts = behind(t, T, T[0] + OFF_C) - 20
    rows["dut"] = rows["dut"] + acts[:, None] * DIRECTIONS
    closed = close_loop(session.load_run(str(making.written(tmp_path, rows, segments))))
    assert [(e.effect, e.channels) for e in closed.accepted] == [("offset-temperature", ("temp",))]
    found = {p.name: p for p in closed.accepted[0].parameters}
    assert abs(found["begins_off"].value - OFF_C) < 4 * found["begins_off"].u
    assert abs(found["tau_s"].value - TAU_S) < 4 * found["tau_s"].u
    for axis, size in zip("xyz", DIRECTIONS, strict=True):
        assert abs(found[f"c_{axis}"].value - size / 1.05) < 4 * found[f"c_{axis}"].u
    assert closed.after.train_rms_nT < 1.05 * closed.noise_floor_nT


@pytest.mark.parametrize("slowness", [0.3, 0.5, 0.8, 1.2])
def test_a_course_that_bends_is_followed_by_less_than_a_line(slowness: float) -> None:
    """A sine of 1 with ω tau = `slowness`: begun where it rises, its response lags by ω tau / (1 + (ω tau)²)."""
    t = np.arange(0.0, 20 * TAU_S, 0.5)
    drive, first = np.sin(slowness / TAU_S * t), t <= TAU_S
    begun = low_passed(t, np.zeros(len(t), dtype=np.intp), drive, TAU_S)[0]
    line, true = -TAU_S * np.polyfit(t[first], drive[first], 1)[0], -slowness / (1 + slowness**2)
    assert abs(begun - true) < 0.7 * abs(line - true)


def test_a_course_that_goes_on_as_a_line_is_followed_as_a_line() -> None:
    t = np.arange(0.0, 20 * TAU_S, 0.5)
    begun = low_passed(t, np.zeros(len(t), dtype=np.intp), 0.3 * t, TAU_S)[0]
    assert begun == pytest.approx(-0.3 * TAU_S)


def test_no_sum_of_responses_holds_one_that_is_slower_than_the_run_is_long(making: ModuleType, tmp_path: Path) -> None:
    """Several of them would be a drift in time, and take a temperature's part beside any current that moves."""
    run = session.load_run(str(making.written(tmp_path, *making.recorded())))
    for span_s, sums in ((40.0, [{"0", "3", "12"}]), (2.5, []), (400.0, [{"0", "3", "12", "50"}])):
        terms = offset_current.candidates(run.select(run.t_s - run.t_s[0] <= span_s))
        names = [{name[1 : name.index("s_")] for name, _ in t.parameters if "s_" in name} for t in terms]
        assert [found for found in names if found] == sums

"""Where a slow response begins: what went before the first row nobody recorded."""

from __future__ import annotations

from itertools import pairwise
from pathlib import Path
from types import ModuleType

import numpy as np
import pytest

from labcal import session
from labcal.loop import close_loop
from labcal.loop.close import candidates_of, prepare, relinearised
from labcal.loop.selection.select import select
from labcal.model.effects import Scene, gain_temperature, offset_current, offset_temperature
from labcal.model.effects.past import Past
from labcal.model.effects.regressors import low_passed
from labcal.model.effects.term import Term
from labcal.record import Channel, Run
from labcal.testing.made_up_runs import made_up_run

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


def begun_anew(run: Run, family: ModuleType) -> Term:
    """Its form that may begin anywhere in each segment."""
    found: list[Term] = family.candidates(run)
    return next(term for term in found if term.of_beginnings)


@pytest.mark.parametrize("family", [offset_temperature, gain_temperature])
def test_what_was_left_of_a_beginning_fades_and_is_the_fits_own(
    family: ModuleType, making: ModuleType, tmp_path: Path
) -> None:
    rows, segments = making.recorded()
    rows["temp"] = 20 + np.sin(rows["t_s"] / 30.0)
    run = session.load_run(str(making.written(tmp_path, rows, segments)))
    term = begun_anew(run, family)
    field = np.full((len(run), 3), 2e4)
    fit, other = (
        term.columns(
            Scene(run.t_s, run.segment_index, field, {"temp": rows["temp"]}, run.mode, np.eye(3), None, of_the_fit=own)
        )
        for own in (True, False)
    )
    assert fit[:, :, : term.lasting] == pytest.approx(other[:, :, : term.lasting])
    assert not other[:, :, term.lasting :].any()
    second = run.segment_index == 1
    begun = fit[:, :, term.lasting + 3]
    assert not begun[~second].any()
    fades = np.exp(-(run.t_s[second] - run.t_s[second][0]) / term.at("tau_s"))
    assert begun[second, 0] == pytest.approx(begun[second, 0][0] * fades)


def test_a_current_that_acts_late_may_begin_anywhere_in_each_segment() -> None:
    """What it was switched to between two segments nobody recorded."""
    rows, draw = 120, np.random.default_rng(4)
    t_s = made_up_run(rows=rows).run.t_s
    amps = 0.4 * (np.mod(t_s, 37.0) < 19.0)
    parts = [slice(first, first + rows) for first in range(0, len(t_s), rows)]
    acts = np.concatenate([behind(t_s[part], amps[part], draw.uniform(0.0, 0.4)) for part in parts])
    made = made_up_run(rows=rows, channels=[Channel("load", "A", "current", amps)])
    problem, level, _ = prepare(made.with_effect(acts[:, None] * [3000.0, -2000.0, 1500.0]))
    pool = relinearised(candidates_of(problem.run, problem))
    (found,) = select(pool, level).accepted
    assert (found.cause, found.term.of_beginnings) == (("offset-current", ("load",)), 3 * len(parts))
    assert found.term.at("tau_s") == pytest.approx(TAU_S, rel=0.05)
    assert np.mean(pool.residual([found]) ** 2) == pytest.approx(1.0, abs=0.1)


def test_a_state_that_is_carried_over_a_gap_may_be_off_by_as_much_as_the_runs_own_were() -> None:
    t = np.r_[np.arange(0.0, 60.0), np.arange(70.0, 130.0)]
    segment, drive = np.repeat([0, 1], 60), np.sin(t / 20.0)
    rest, astray = (
        low_passed(t, segment, drive, TAU_S, Past(len(t), astray=off), (-1.0, 1.0), None, 0.4) for off in (0.0, 1.0)
    )
    first = astray[60] - rest[60]
    kept = np.exp(-(t[60] - t[59]) / TAU_S) * (astray[59] - rest[59])
    assert first - kept == pytest.approx(0.4)
    assert (astray - rest)[60:] == pytest.approx(first * np.exp(-(t[60:] - t[60]) / TAU_S))


def test_no_sum_of_responses_holds_one_that_is_slower_than_the_run_is_long(making: ModuleType, tmp_path: Path) -> None:
    """Several of them would be a drift in time, and take a temperature's part beside any current that moves."""
    run = session.load_run(str(making.written(tmp_path, *making.recorded())))
    for span_s, sums in ((40.0, [{"0", "3", "12"}]), (2.5, []), (400.0, [{"0", "3", "12", "50"}])):
        terms = offset_current.candidates(run.select(run.t_s - run.t_s[0] <= span_s))
        names = [{name[1 : name.index("s_")] for name, _ in t.parameters if "s_" in name} for t in terms]
        assert [found for found in names if found] == sums


@pytest.mark.parametrize("moved", [0.0, -5.0])
def test_a_branch_is_known_no_longer_where_the_temperature_moved_unseen(moved: float) -> None:
    """Heated through in the first segment; before the second it may have turned back, if it moved at all."""
    T = np.r_[20 + np.linspace(0.0, 6.0, 60), 26 + moved + np.linspace(0.0, 6.0, 60)]
    run = made_up_run(rows=20, channels=[Channel("T", "degC", "temperature", T)]).run
    term = next(t for t in offset_temperature.candidates(run) if any(shape.name == "r_C" for shape in t.shape))
    term = term.with_values(r_C=1.0)
    segment, field = np.repeat(np.arange(2, dtype=np.intp), 60), np.full((120, 3), 2e4)
    high, low = (
        term.columns(
            Scene(np.arange(120.0), segment, field, {"T": T}, run.mode, np.eye(3), None, past=Past(120, astray=astray))
        )[:, 0, 3]
        for astray in (1.0, -1.0)
    )
    assert high[0] - low[0] > 1.0
    assert high[30:60] == pytest.approx(np.ones(30))
    assert high[60] - low[60] == pytest.approx(1.0 if moved else 0.0)
    assert high[90:] == pytest.approx(low[90:])

"""Drift, recalibration intervals and comparisons, against what was put in."""

from __future__ import annotations

import numpy as np
import pytest

from labcal.quality.drift import drift
from labcal.quality.intercomparison import compare_benches
from labcal.quality.recalibration import LONGEST_D, METHODS, SHORTEST_D, IntervalProposal, proposals


@pytest.mark.parametrize("beyond", [0.0, 3.0])
def test_the_interval_of_a_drift_holds_the_truth_as_often_as_it_says(beyond: float) -> None:
    draw, inside, times = np.random.default_rng(4), 0, np.arange(8.0)
    for _ in range(600):
        u = draw.uniform(0.5, 2.0, 8)
        y = 5 + 1.5 * times + draw.normal(0, np.hypot(u, beyond))
        low, high = drift(times, y, u).interval
        inside += low <= 1.5 <= high
    assert 0.92 <= inside / 600 <= 0.985


def test_the_scatter_beyond_u_is_found_and_a_line_reaches_ahead() -> None:
    draw, times = np.random.default_rng(5), np.arange(200.0)
    found = drift(times, 2 - 0.5 * times + draw.normal(0, 4, 200), np.full(200, 1.0))
    assert found.scatter == pytest.approx(np.sqrt(15), rel=0.15)
    assert found.significant
    value, u = found.at(300.0)
    assert value == pytest.approx(2 - 150, abs=4 * u)
    assert u > found.at(199.0)[1]


def test_too_few_calibrations_have_no_drift() -> None:
    with pytest.raises(ValueError, match="needs 3"):
        drift([0, 1], [1, 2], [1, 1])
    with pytest.raises(ValueError, match="different times"):
        drift([1, 1, 1], [1, 2, 3], [1, 1, 1])


def proposed(values: list[float], permitted: float, hours: list[float] | None = None) -> dict[str, IntervalProposal]:
    days = 365.25 * np.arange(float(len(values)))
    u = np.full(len(values), 0.1)
    used = None if hours is None else np.array(hours)
    return {p.method: p for p in proposals(days, np.array(values), u, permitted, 365.0, used)}


def test_a_steady_sensor_may_wait_and_one_that_moved_too_far_comes_back_sooner() -> None:
    steady = proposed([0.0, 0.05, -0.02, 0.03, 0.0], 10.0)
    assert steady["staircase"].days == pytest.approx(1.25 * 365)
    assert steady["control chart"].days == steady["drift"].days == LONGEST_D
    assert steady["in-use time"].days is None
    moved = proposed([0.0, 4.0, 8.0, 12.0, 24.0], 10.0)
    assert moved["staircase"].days == pytest.approx(365 / 2)
    assert proposed([0.0, 9.0], 10.0)["staircase"].days == 365.0


def test_a_drift_reaches_what_is_permitted_when_it_is_due() -> None:
    """2 nT a year of 10 nT, each calibration 0.1 nT: nearly five years, the cautious method sooner."""
    found = proposed([0.0, 2.05, 3.98, 6.01, 7.97], 5.0, [0.0, 500.0, 1000.0, 1500.0, 2000.0])
    years = (5.0 - 0.2) / 2.0
    assert found["control chart"].days == pytest.approx(365.25 * years, rel=0.03)
    drifting = found["drift"].days
    assert drifting is not None
    assert drifting < (found["control chart"].days or 0)
    assert drifting > 0.85 * 365.25 * years
    assert found["in-use time"].hours == pytest.approx(500 * years, rel=0.03)


def test_calibrations_of_one_day_have_no_use_a_day() -> None:
    found = proposals(np.zeros(3), np.array([1.0, 1.5, 1.2]), np.full(3, 0.1), 5.0, 365.0, np.array([0.0, 2.0, 4.0]))
    assert found[2].days is None
    assert "of one day" in found[2].why


def test_what_eats_the_permitted_change_by_itself_is_told() -> None:
    found = proposed([0.0, 5.0, -5.0, 5.0, -5.0], 1.0)
    assert found["control chart"].days == SHORTEST_D
    assert "calibrate better" in found["control chart"].why
    assert set(found) == set(METHODS)


def test_benches_that_agree_have_e_n_within_one_and_one_that_does_not_is_left_out() -> None:
    values, u = np.array([10.0, 10.4, 9.8, 10.1]), np.full(4, 0.3)
    found = compare_benches(["a", "b", "c", "d"], values, u)
    assert all(abs(d.e_n or 9) < 1 for d in found.degrees)
    assert found.p > 0.05
    off = compare_benches(["a", "b", "c", "d"], values + [0, 0, 0, 5], u)
    assert [d.counted for d in off.degrees] == [True, True, True, False]
    assert (off.degrees[3].e_n or 0) > 5
    assert off.degrees[0].reference == pytest.approx(10.0667, abs=1e-3)


def test_e_n_is_spread_as_it_should_be_though_each_bench_is_in_the_mean() -> None:
    draw, u = np.random.default_rng(6), np.array([1.0, 2.0, 0.5, 1.5])
    all_e = [[d.e_n for d in compare_benches("abcd", draw.normal(0, u), u).degrees if d.counted] for _ in range(800)]
    assert np.std(np.concatenate(all_e)) == pytest.approx(0.5, rel=0.07)


def test_a_travelling_standard_that_drifts_is_judged_where_the_pilot_saw_it() -> None:
    times = np.array([0.0, 1.0, 2.0, 3.0, 4.0])
    values = np.array([0.0, 10.2, 20.0, 29.8, 40.0])
    found = compare_benches(["p", "a", "p", "b", "p"], values, np.full(5, 0.5), times, pilot="p")
    assert [abs(d.difference) < 0.3 for d in found.degrees] == [True] * 5
    assert all(abs(d.e_n or 0) < 1 for d in found.degrees)
    assert "line" in found.by


def test_what_cannot_be_compared_is_refused() -> None:
    with pytest.raises(ValueError, match="two benches"):
        compare_benches(["a", "a"], np.zeros(2), np.ones(2))
    with pytest.raises(ValueError, match="states no uncertainty"):
        compare_benches(["a", "b"], np.zeros(2), np.array([1.0, np.nan]))
    with pytest.raises(ValueError, match="pilot"):
        compare_benches(["a", "b"], np.zeros(2), np.ones(2), pilot="c")

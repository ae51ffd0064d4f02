"""Control charts: their constants, what they alarm at, and how often for nothing."""

from __future__ import annotations

import numpy as np
import pytest

from labcal.quality.control_chart import B3_B4, c4, control_chart, spread_false_alarm_rate
from labcal.quality.western_electric import average_run_length, broken_rules


@pytest.mark.parametrize(
    ("n", "a3", "b3", "b4"), [(2, 2.659, 0.0, 3.267), (5, 1.427, 0.0, 2.089), (10, 0.975, 0.284, 1.716)]
)
def test_the_constants_are_those_of_the_tables(n: int, a3: float, b3: float, b4: float) -> None:
    assert 3 / (c4(n) * np.sqrt(n)) == pytest.approx(a3, abs=5e-4)
    assert B3_B4(n) == pytest.approx((b3, b4), abs=5e-4)


@pytest.mark.parametrize(
    ("rules", "run_length"),
    [((1,), 370.40), ((1, 2), 225.44), ((1, 3), 166.05), ((1, 4), 152.73), ((1, 2, 3, 4), 91.75)],
)
def test_run_lengths_are_those_that_champ_and_woodall_found(rules: tuple[int, ...], run_length: float) -> None:
    assert average_run_length(rules) == pytest.approx(run_length, abs=0.01)


@pytest.mark.parametrize(
    "rules",
    [
        (1,),
        pytest.param((2,), marks=pytest.mark.slow),
        pytest.param((3,), marks=pytest.mark.slow),
        pytest.param((4,), marks=pytest.mark.slow),
        pytest.param((1, 2, 3, 4), marks=pytest.mark.slow),
    ],
)
def test_run_lengths_hold_in_a_simulation(rules: tuple[int, ...]) -> None:
    """120 charts of points that never change: points until the first alarm."""
    draw = np.random.default_rng(7)
    lengths = []
    for _ in range(120):
        z, first = draw.normal(size=6000), None
        candidates = [i for i in range(len(z)) if could_break(z, i, rules)]
        for i in candidates:
            if broken_rules(z[max(0, i - 7) : i + 1], rules)[-1]:
                first = i + 1
                break
        lengths.append(first or len(z))
    expected = average_run_length(rules)
    assert np.mean(lengths) == pytest.approx(expected, abs=4 * expected / np.sqrt(len(lengths)))


def could_break(z: np.ndarray, i: int, rules: tuple[int, ...]) -> bool:
    """Cheap: whether the last point is so far out, or so many are on one side, that a rule is worth asking."""
    far = {1: 3.0, 2: 2.0, 3: 1.0}
    reach = min((far[rule] for rule in rules if rule in far), default=np.inf)
    return abs(z[i]) > reach or (4 in rules and i >= 7 and abs(np.sign(z[i - 7 : i + 1]).sum()) == 8)


def test_each_rule_sees_its_pattern_and_not_one_point_less() -> None:
    assert broken_rules([0.1, 3.1])[-1] == (1,)
    assert broken_rules([2.1, 0.0, 2.1])[-1] == (2,)
    assert broken_rules([2.1, 0.0, 0.0, 2.1])[-1] == ()
    assert broken_rules([2.1, 0.0, -2.1])[-1] == ()
    assert broken_rules([1.1, 1.2, -0.1, 1.1, 1.1])[-1] == (3,)
    assert broken_rules([1.1, 1.2, -0.1, 0.1, 1.1])[-1] == ()
    assert broken_rules([0.1] * 8)[-1] == (4,)
    assert broken_rules([0.1] * 7)[-1] == ()
    assert broken_rules([2.1, 2.1, 0.0])[-1] == ()  # the last is where it should be


def test_a_shift_is_seen_and_a_steady_standard_stays_in_control() -> None:
    draw = np.random.default_rng(3)
    steady = [list(draw.normal(100, 2, 3)) for _ in range(25)]
    chart = control_chart(steady, 20)
    assert chart.sigma == pytest.approx(2, rel=0.3)
    assert not chart.out_of_control
    shifted = control_chart([*steady, [108.0, 107.0, 109.0]], 20)
    assert shifted.out_of_control
    assert 1 in shifted.broken[-1]
    wild = control_chart([*steady, [90.0, 100.0, 110.0]], 20)
    assert wild.spread_out[-1]
    assert wild.out_of_control


def test_the_spread_s_false_alarms_come_as_often_as_is_said() -> None:
    draw = np.random.default_rng(5)
    for n in (2, 4, 8):
        s = draw.normal(size=(200_000, n)).std(axis=1, ddof=1)
        chart = control_chart(draw.normal(size=(8, n)).tolist(), 8, sigma=1.0, centre=0.0)
        beyond = ((s > chart.spread_upper[0]) | (s < chart.spread_lower[0])).mean()
        assert beyond == pytest.approx(spread_false_alarm_rate(n), rel=0.15)


def test_single_values_have_moving_ranges_and_a_known_sigma_is_taken() -> None:
    draw = np.random.default_rng(9)
    values = draw.normal(0, 3, 400)
    chart = control_chart([[v] for v in values], 400)
    assert chart.sigma == pytest.approx(3, rel=0.1)
    assert np.isnan(chart.spread[0])
    assert chart.spread[1] == pytest.approx(abs(values[1] - values[0]))
    known = control_chart([[1.0], [2.0]], 1, sigma=0.5, centre=0.0)
    assert known.z == pytest.approx([2.0, 4.0])
    assert known.out_of_control


def test_days_that_differ_more_than_their_repeats_are_told_and_may_be_judged_by_their_own_spread() -> None:
    draw = np.random.default_rng(11)
    days = [list(day + draw.normal(0, 1, 3)) for day in draw.normal(0, 5, 30)]
    narrow, wide = control_chart(days, 20), control_chart(days, 20, between=True)
    assert narrow.differ
    alarms = [sum(map(bool, chart.broken[20:])) + sum(chart.spread_out[20:]) for chart in (narrow, wide)]
    assert alarms[0] > 3 * alarms[1]
    assert not control_chart([list(draw.normal(0, 1, 3)) for _ in range(30)], 20).differ


def test_what_gives_no_limits_is_refused() -> None:
    with pytest.raises(ValueError, match="at least 8"):
        control_chart([[1.0], [2.0]], 2)
    with pytest.raises(ValueError, match="does not vary"):
        control_chart([[1.0]] * 10, 10)


def test_back_from_a_point_that_was_out_a_single_value_is_in_control() -> None:
    values = [*np.random.default_rng(2).normal(5, 2, 12), 40.0, 5.0]
    chart = control_chart([[v] for v in values], 12)
    assert chart.spread_out[-1]
    assert not chart.out_of_control


def test_a_point_whose_repeats_are_not_all_there_is_judged_by_what_it_has() -> None:
    draw = np.random.default_rng(3)
    steady = [list(draw.normal(100, 2, 3)) for _ in range(20)]
    chart = control_chart([*steady, [101.0]], 20)
    assert chart.sigma == control_chart(steady, 20).sigma
    assert not chart.single
    assert np.isnan(chart.spread[-1])
    assert chart.upper[-1] - chart.centre == pytest.approx(3 * chart.sigma)
    assert not chart.out_of_control

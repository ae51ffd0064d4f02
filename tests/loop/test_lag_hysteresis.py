"""The kernels that remember, against what they must do by definition."""

from dataclasses import replace

import numpy as np

from labcal.model.effects import Scene, Term
from labcal.model.effects.hysteresis import candidates, dahl, kernel, stop
from labcal.model.effects.regressors import low_passed, per_axis, shifted
from labcal.model.effects.shape import Shape
from labcal.record import Dut, Reference, Run, Segment


def test_a_stop_follows_until_its_threshold_and_back() -> None:
    drive = np.array([[0.0], [5.0], [20.0], [15.0], [-20.0]])
    assert stop(drive, 10.0)[:, 0].tolist() == [0.0, 5.0, 10.0, 5.0, -10.0]


def test_a_dahl_loop_comes_within_one_part_in_e_of_its_branch_over_its_width() -> None:
    drive = np.linspace(0, 3000, 301)[:, None]
    assert np.isclose(dahl(drive, 3000.0)[-1, 0], 1 - np.exp(-1))


def test_a_loop_is_looked_for_where_a_segment_sweeps_the_field_alone() -> None:
    noise = np.random.default_rng(1).normal(0, 20.0, (100, 3))
    swept = np.linspace(-1, 1, 100)[:, None] * [3e4, 0.0, 0.0]
    segments = (Segment("a", "static"), Segment("b", "static"))
    held, moved = (
        Run("r", "2026-01-01T00:00:00Z", True, "", Dut("s", noise_nT=20.0), Reference("vector"), segments,
            np.arange(100.0), np.repeat([0, 1], 50), reading, reference_vector=reading.copy())
        for reading in (noise + np.repeat([[0.0], [3e4]], 50, axis=0), noise + swept)
    )  # fmt: skip
    assert not candidates(held)
    assert candidates(moved)


def test_relays_of_many_widths_are_a_saturating_loop_and_no_curve() -> None:
    draw = np.random.default_rng(4)
    s = 45e3 * np.sin(np.linspace(0, 12, 1500))[:, None] * np.array([1.0, 0.7, 0.9])
    centre, half = draw.normal(0, 8000.0, (300, 1)), draw.gamma(3.0, 700.0, (300, 1))
    state, seen = np.sign(s[0] - centre), np.empty_like(s)
    for row, field in enumerate(s):
        state = np.where(field > centre + half, 1.0, np.where(field < centre - half, -1.0, state))
        seen[row] = state.mean(axis=0)
    left = [_left(columns, seen) for columns in _saturating(s)]
    assert left[0] < 0.35 * left[1]


def _saturating(s: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Columns along x of the saturating loop about its curve, and of the curve alone."""
    scene = Scene(np.arange(float(len(s))), np.zeros(len(s), dtype=np.intp), s)
    shape = (Shape("r_nT", 2000.0, "nT"), Shape("s_nT", 10000.0, "nT"))
    columns = kernel(Term(kernel, (("c_x", "nT"),), shape=shape), scene)[:, 0, ::3]
    columns = np.column_stack([columns / np.abs(columns).max(axis=0), s[:, 0] / 45e3, np.ones(len(s))])
    return columns, columns[:, 1:]


def _left(columns: np.ndarray, seen: np.ndarray) -> float:
    found = np.linalg.lstsq(columns, seen[:, 0], rcond=None)[0]
    return float(np.std(columns @ found - seen[:, 0]))


def test_a_first_order_response_to_a_step_reaches_63_per_cent_after_tau() -> None:
    t = np.arange(0, 60, 0.01)
    out = low_passed(t, np.zeros(len(t), dtype=np.intp), (t >= 20).astype(float), 8.0)
    assert abs(out[np.searchsorted(t, 28.0)] - (1 - np.exp(-1))) < 2e-3


def test_a_slow_thermometer_is_undone_by_the_negative_time_constant() -> None:
    t = np.concatenate([np.arange(0, 100, 0.1), np.arange(400, 500, 0.1)])
    segment = np.repeat([0, 1], 1000)
    warm = 20 + np.sin(t / 15.0)
    shown = low_passed(t, segment, warm, 6.0) + np.random.default_rng(3).normal(0, 0.01, len(t))
    assert np.std(shown - warm) > 0.2
    assert np.std(low_passed(t, segment, shown, -6.0) - warm) < 0.05


def test_a_demagnetised_sensor_has_followed_the_field_from_nought_and_remembers_other_segments_where_it_is_kept():
    field = np.array([20.0, 15.0, -5.0, -5.0])[:, None] * np.eye(3)[0]
    scene = Scene(np.arange(4.0), np.array([0, 0, 0, 1]), field)
    kept = (Shape("r_nT", 10.0, "nT"), Shape("kept", 0.0, "1"))
    each, first = (Term(kernel, (("c_x", "1"),), shape=(kept[0], replace(kept[1], value=v))) for v in (0.0, 1.0))
    assert kernel(each, scene)[:, 0, 0].tolist() == [10.0, 5.0, -10.0, -5.0]
    assert kernel(first, scene)[:, 0, 0].tolist() == [10.0, 5.0, -10.0, -10.0]


def test_a_soft_bar_follows_the_field_along_itself_and_its_own_field_points_anywhere() -> None:
    along = np.array([0.0, 4000.0, 9000.0, 3000.0])
    bar = np.array([np.cos(np.radians(30)), 0.0, np.sin(np.radians(30))])
    scene = Scene(np.arange(4.0), np.zeros(4, dtype=np.intp), along[:, None] * bar + [0.0, 7e3, 0.0])
    turned = (Shape("lon_deg", 0.0, "deg"), Shape("lat_deg", 30.0, "deg"), Shape("kept", 0.0, "1"))
    columns = kernel(Term(kernel, per_axis("body_c6000", "1"), shape=turned), scene)
    assert np.allclose(columns, np.array([0.0, 4000.0, 6000.0, 0.0])[:, None, None] * np.eye(3))


def test_a_shift_is_exact_for_a_parabola_and_stops_at_a_segment() -> None:
    t, segment = np.arange(0.0, 20.0), np.repeat([0, 1], 10)
    values = np.where(segment == 0, t**2, 5.0)[:, None]
    moved = shifted(t, segment, values, 0.25)
    assert np.allclose(moved[1:8, 0], (t[1:8] + 0.25) ** 2)
    assert np.allclose(moved[10:, 0], 5.0)


def test_a_slow_response_goes_on_over_a_short_gap_between_segments_and_starts_anew_after_a_long_one() -> None:
    t = np.concatenate([np.arange(0.0, 100.0), np.arange(150.0, 250.0), np.arange(9000.0, 9100.0)])
    segment = np.repeat([0, 1, 2], 100)
    drive = np.minimum(t, 120.0)
    whole = np.arange(0.0, 250.0)
    expected = low_passed(whole, np.zeros(250, dtype=np.intp), np.minimum(whole, 120.0), 60.0)
    out = low_passed(t, segment, drive, 60.0)
    assert np.allclose(out[:100], expected[:100])
    assert np.abs(out[100:200] - expected[150:]).max() < 4.0
    assert np.allclose(out[200:], 120.0)


def test_a_chain_of_stops_is_the_same_row_by_row() -> None:
    drive = np.cumsum(np.random.default_rng(5).normal(0, 700, (300, 3)), axis=0)
    state, expected = np.zeros(3), [np.zeros(3)]
    for step in np.diff(drive, axis=0):
        state = np.clip(state + step, -1500.0, 1500.0)
        expected.append(state)
    assert np.allclose(stop(drive, 1500.0), expected)

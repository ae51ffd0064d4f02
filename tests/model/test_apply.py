from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from labcal.errors import InputError
from labcal.fit import draft_calibration
from labcal.fit.result import Fit
from labcal.model import AffineMap, Calibration, EffectRecord, Parameter, Validity
from labcal.model.apply import apply, needed_columns
from labcal.model.effects.hysteresis import stop
from labcal.model.plausibility import bends, second_difference_outliers
from labcal.model.readings import Applied, Readings
from labcal.model.smooth import Domain
from labcal.record import Dut
from labcal.store import read_bundle

K = np.array([[1.1, 0.1, 0.0], [0.0, 0.9, -0.1], [0.05, 0.0, 1.0]])
k = np.array([100.0, -200.0, 300.0])
NOISE_NT = 10.0
EXAMPLE = Path(__file__).parents[2] / "examples" / "short-preflight"
TURN = np.linspace(0, 6, 400)
FIELD = 30e3 * np.column_stack([np.cos(TURN), np.sin(TURN), 0.3 * np.cos(2 * TURN)])


def calibration(*effects: EffectRecord, **more) -> Calibration:
    stated = {
        "run_id": "r",
        "simulated": True,
        "dut": Dut(serial="S"),
        "affine": AffineMap(K, k),
        "covariance": None,
        "frame_known": True,
        "validity": Validity((20e3, 40e3), modes=("nominal", "quiet")),
        "span_s": (0.0, 1000.0),
        "run_sha256": "0" * 64,
        "effects": effects,
        "metrics": {"before": {}, "after": {"noise_nT": NOISE_NT}},
    }
    return Calibration(**{**stated, **more})


def effect(name: str, channels: tuple[str, ...] = (), reference: dict | None = None, **values) -> EffectRecord:
    parameters = tuple(Parameter(key, value, u, "") for key, (value, u) in values.items())
    return EffectRecord(name, channels, reference or {}, "sensor", parameters)


def readings(field=FIELD, **more) -> Readings:
    """The noiseless readings of `field` (n, 3) [nT]."""
    return Readings(np.linalg.solve(K, (field + k).T).T, **more)


def test_the_base_map_alone() -> None:
    found = apply(calibration(), readings())
    assert np.allclose(found.field_nT, FIELD, atol=1e-8)
    assert found.u_nT == pytest.approx(NOISE_NT * np.sqrt(np.trace(K @ K.T) / 3))
    assert set(found.flags) == {""}


def test_uncertainty_is_the_scatter_of_drawn_maps_and_noise() -> None:
    rng = np.random.default_rng(0)
    A = rng.normal(size=(12, 12)) * np.r_[np.full(9, 3e-4), np.full(3, 5.0)][:, None]
    row = readings(FIELD[:1])
    drawn = rng.multivariate_normal(np.zeros(12), A @ A.T, size=100_000)
    noisy = row.reading + NOISE_NT * rng.normal(size=(100_000, 3))
    b = np.einsum("nij,nj->ni", K + drawn[:, :9].reshape(-1, 3, 3), noisy) - k - drawn[:, 9:]
    u = apply(calibration(covariance=A @ A.T), row).u_nT[0]
    assert u == pytest.approx(np.sqrt(np.mean(np.var(b, axis=0))), rel=0.02)


def test_a_positive_offset_parameter_is_taken_off_and_counts_from_its_reference() -> None:
    cal = calibration(effect("offset-current", ("i_eps",), {"i_eps": 0.2}, c_x=(50, 2), c_y=(0, 2), c_z=(-10, 2)))
    amps = np.full(len(FIELD), 1.2)
    found = apply(cal, readings(channels={"i_eps": amps}))
    assert np.allclose(found.field_nT, FIELD - [50.0, 0.0, -10.0], atol=1e-8)
    at_reference = apply(cal, readings(channels={"i_eps": amps - 1.0}))
    assert np.allclose(at_reference.field_nT, FIELD, atol=1e-8)
    assert found.u_nT[0] ** 2 - at_reference.u_nT[0] ** 2 == pytest.approx(2.0**2)


def _loaded(amps: np.ndarray) -> Applied:
    cal = calibration(effect("offset-current", ("i_eps",), {"i_eps": 0.0}, c_x=(500, 0), c_y=(0, 0), c_z=(0, 0)))
    return apply(cal, readings(channels={"i_eps": amps}))


def test_a_row_whose_channel_nothing_tells_keeps_its_place_with_a_larger_uncertainty() -> None:
    amps = np.where(np.arange(len(FIELD)) < 7, 0.0, 1.0)
    amps[7] = np.nan
    found = _loaded(amps)
    assert np.allclose(found.field_nT[7], FIELD[7], atol=1e-8)
    assert found.u_nT[7] > 200 > found.u_nT[8]


def test_a_gap_that_can_be_told_is_bridged_and_a_little_less_certain() -> None:
    amps = np.where(np.arange(len(FIELD)) < 7, 0.0, 1.0)
    amps[12] = np.nan
    found = _loaded(amps)
    assert np.allclose(found.field_nT[12], FIELD[12] - [500.0, 0, 0], atol=1e-8)
    assert 200 > found.u_nT[12] > found.u_nT[13]


def test_effects_of_the_run_hold_inside_its_span_only() -> None:
    cal = calibration(
        effect("offset-step", t_step_s=(500.0, 0.0), c_x=(80.0, 0.0), c_y=(0.0, 0.0), c_z=(0.0, 0.0)),
    )
    found = apply(cal, readings(t_s=np.linspace(0, 1500, len(FIELD))))
    t = np.linspace(0, 1500, len(FIELD))
    assert np.allclose(found.field_nT[t < 500], FIELD[t < 500], atol=1e-8)
    inside = (t > 500) & (t <= 1000)
    assert np.allclose(found.field_nT[inside] - FIELD[inside], [-80, 0, 0], atol=1e-8)
    after = t > 1000
    assert np.allclose(found.field_nT[after], FIELD[after], atol=1e-8)
    assert {found.flags[i] for i in np.flatnonzero(after)} == {"time"}
    assert found.u_nT[after].min() > found.u_nT[inside].max() + 10


def test_rows_in_the_gap_that_a_step_lies_in_are_flagged_and_less_certain() -> None:
    gap = 60.0
    step = effect("offset-step", t_step_s=(500.0, gap / np.sqrt(12)), c_x=(80.0, 1), c_y=(0.0, 1), c_z=(0.0, 1))
    t = np.linspace(0, 1000, len(FIELD))
    found = apply(calibration(step), readings(t_s=t))
    unsure = np.abs(t - 500) < gap / 2
    assert [flag == "time" for flag in found.flags] == unsure.tolist()
    assert found.u_nT[unsure] == pytest.approx(np.hypot(found.u_nT[t > 600][0], 40 / np.sqrt(3)), rel=0.01)


@pytest.mark.parametrize("lag", [0.05, -0.08])
def test_a_lag_is_undone_but_for_the_ends(lag: float) -> None:
    t = np.arange(400) * 0.25
    rate = 0.2
    now, then = (np.column_stack([np.cos(rate * (t - d)), np.sin(rate * (t - d)), 0 * t]) * 30e3 for d in (0.0, lag))
    cal = calibration(effect("lag", secant_s=(lag, 0.0), lag_s=(lag, 0.0)))
    found = apply(cal, readings(then, t_s=t, segment=np.full(400, "new")))
    assert np.abs(found.field_nT - now)[5:-5].max() < 3.0  # of a shift of 300 and more
    assert "rate" in (found.flags[-1] if lag > 0 else found.flags[0])
    assert found.flags[200] == ""


@pytest.mark.parametrize("delay", [1.5, -1.5])
def test_what_follows_a_channel_late_is_undone_but_for_the_rows_that_the_delay_cannot_reach(delay: float) -> None:
    t, edge = np.arange(400) * 0.5, 200
    segment = np.where(np.arange(400) < edge, "one", "two")
    load, late = (np.mod(t - d, 40.0) / 40.0 for d in (0.0, delay))
    record = effect("offset-current", ("i",), {"i": 0.0}, c_x=(90, 1), c_y=(0, 1), c_z=(0, 1), delay_s=(delay, 0.1))
    assert set(needed_columns(calibration(record))) == {"i", "t_s", "segment"}
    found = apply(
        calibration(record), readings(FIELD + late[:, None] * [90, 0, 0], t_s=t, segment=segment, channels={"i": load})
    )
    rows = np.arange(400) % edge
    reached = (rows >= 3) if delay > 0 else (rows < edge - 3)
    level = np.abs(np.diff(load, prepend=load[0])) < 0.5  # a ramp falls back: straight between two rows is not exact
    level = np.roll(level, int(delay / 0.5)) & np.roll(level, int(delay / 0.5) - 1)
    assert np.abs(found.field_nT - FIELD)[reached & level].max() < 1e-6
    assert found.u_nT[~reached].min() > found.u_nT[reached].max() + 1.0


def test_needed_columns_are_those_that_effects_use() -> None:
    assert needed_columns(calibration()) == ()
    memory = effect("offset-temperature", ("temp",), {"temp": 20.0}, tau_s=(30, 0), c_x=(1, 0), c_y=(1, 0), c_z=(1, 0))
    assert set(needed_columns(calibration(memory))) == {"temp", "t_s", "segment"}
    mode = EffectRecord(
        "offset-mode", (), {}, "sensor", tuple(Parameter(f"c_{a} quiet", 5.0, 1.0, "nT") for a in "xyz")
    )
    assert needed_columns(calibration(mode)) == ("mode",)
    with pytest.raises(InputError, match="mode"):
        apply(calibration(mode), readings())


def test_rows_beyond_the_validity_are_flagged_and_less_certain() -> None:
    field = FIELD.copy()
    field[100:103] *= 3
    field[100] = field[101] = field[102]  # a slow excursion, not an outlier
    modes = np.full(len(field), "nominal", dtype="<U9")
    modes[5] = "full"
    found = apply(calibration(), readings(field, mode=modes))
    assert found.flags[101] == "field"
    assert found.flags[5] == "mode"
    assert found.u_nT[101] > 1.5 * found.u_nT[50]
    assert found.u_nT[5] == pytest.approx(2 * found.u_nT[50])


def test_temperature_outside_the_range_is_flagged() -> None:
    cal = calibration(validity=Validity((0.0, 1e5), (10.0, 30.0)))
    temperature = np.full(len(FIELD), 20.0)
    temperature[3] = 50.0
    found = apply(cal, readings(channels={"temp_dut": temperature}))
    assert found.flags[3] == "temperature"
    assert found.u_nT[3] == pytest.approx(2 * found.u_nT[4])


def test_a_channel_where_its_effect_was_not_seen_is_flagged_and_less_certain() -> None:
    stated = effect("offset-current", ("i_eps",), {"i_eps": 0.2}, c_x=(50, 2), c_y=(0, 2), c_z=(-10, 2))
    seen = replace(stated, domain=(Domain(("channel:i_eps",), ((0.1,), (1.1,))),))
    amps = np.linspace(0.1, 1.1, len(FIELD))
    amps[200:203] = 0.0, 1.3, np.nan
    plain, found = (apply(calibration(one), readings(channels={"i_eps": amps})) for one in (stated, seen))
    assert list(found.flags[199:204]) == ["", "domain", "domain", "", ""]
    assert np.allclose(found.field_nT, plain.field_nT, atol=1e-9)
    growth = found.u_nT / plain.u_nT
    assert growth[[200, 201]] == pytest.approx([1 + 0.1 / 1.0, 1 + 0.2 / 1.0])
    assert np.delete(growth, [200, 201]) == pytest.approx(1.0)


@pytest.mark.parametrize("hull", [(), ((0.1,),), ((1.1,), (0.1,)), ((0.1, 0.0), (1.1, 1.0))])
@pytest.mark.parametrize("named", ["channel:i_eps", "channel:other", "rate"])
def test_a_domain_that_is_not_two_ends_of_an_own_channel_is_refused(named: str, hull: tuple) -> None:
    stated = effect("offset-current", ("i_eps",), {"i_eps": 0.2}, c_x=(50, 2), c_y=(0, 2), c_z=(-10, 2))
    strange = replace(stated, domain=(Domain((named,), hull if named == "channel:i_eps" else ((0.1,), (1.1,))),))
    with pytest.raises(InputError, match="its domain is not two ends of a channel that it follows"):
        apply(calibration(strange), readings(channels={"i_eps": np.ones(len(FIELD))}))


def test_a_draft_says_where_each_effect_was_seen() -> None:
    run = read_bundle(EXAMPLE / "run.zip")
    followed = effect("offset-current", ("i_radio",), {"i_radio": 0.2}, c_x=(50, 2), c_y=(0, 2), c_z=(-10, 2))
    fit = Fit("m", True, affine=AffineMap(K, k), noise_nT=10.0, effects=(followed,))
    (domain,) = draft_calibration(run, fit, "").effects[0].domain
    values = run.channel("i_radio").values
    assert domain == Domain(("channel:i_radio",), ((np.nanmin(values),), (np.nanmax(values),)))


def test_a_spike_is_an_outlier_and_a_step_is_none() -> None:
    rng = np.random.default_rng(1)
    measured = readings().reading + NOISE_NT * rng.normal(size=FIELD.shape)
    measured[50] += [4e3, 0, 0]
    measured[200:] -= [0, 3e3, 0]
    found = apply(calibration(), Readings(measured))
    assert [i for i, flag in enumerate(found.flags) if "outlier" in flag] == [50]
    assert found.u_nT[50] > 1000


def test_corners_of_a_ramped_field_are_no_outliers_and_a_spike_on_a_ramp_is_one() -> None:
    rng = np.random.default_rng(4)
    course = np.interp(np.arange(200), [0, 60, 90, 150, 199], [20e3, 20e3, 45e3, 45e3, 22e3])
    field = np.column_stack([course, 0.4 * course, np.full(200, 18e3)]) + rng.normal(0, 5.0, (200, 3))
    field[75, 1] += 400.0
    assert np.flatnonzero(second_difference_outliers(np.r_[0.0, bends(field), 0.0], None, 5.0)).tolist() == [75]


def test_what_the_run_left_unexplained_is_part_of_the_uncertainty() -> None:
    explained = calibration(metrics={"before": {}, "after": {"noise_nT": NOISE_NT, "holdout_rms_nT": 17.5}})
    left = calibration(metrics={"before": {}, "after": {"noise_nT": NOISE_NT, "holdout_rms_nT": 60.0}})
    assert apply(explained, readings()).u_nT[0] == pytest.approx(NOISE_NT * np.sqrt(np.trace(K @ K.T) / 3))
    assert apply(left, readings()).u_nT[0] == pytest.approx(60.0 / np.sqrt(3))


@pytest.mark.parametrize(("components", "held_out_nT"), [(1.0, 46.0), (3.0, 46.0 * np.sqrt(3))])
def test_what_is_left_of_a_magnitude_is_that_of_every_component(components: float, held_out_nT: float) -> None:
    """46 nT along b are 46 nT of each component, whether the frame is known (axes without angles) or not."""
    after = {"noise_nT": NOISE_NT, "holdout_rms_nT": held_out_nT, "holdout_components": components}
    found = calibration(metrics={"before": {}, "after": after})
    assert found.frame_known
    assert apply(found, readings()).u_nT[0] == pytest.approx(46.0)
    below = replace(found, metrics={"before": {}, "after": {**after, "holdout_rms_nT": 1.1 * NOISE_NT}})
    assert apply(below, readings()).u_nT[0] == pytest.approx(NOISE_NT * np.sqrt(np.trace(K @ K.T) / 3))


def test_what_declared_errors_left_of_it_is_in_the_parameters_and_counts_once() -> None:
    after = {"noise_nT": NOISE_NT, "holdout_rms_nT": 260.0, "holdout_beside_declared_nT": 60.0}
    left = calibration(metrics={"before": {}, "after": after})
    assert apply(left, readings()).u_nT[0] == pytest.approx(60.0 / np.sqrt(3))


def test_what_the_reference_scatters_is_in_no_reading() -> None:
    """A reference of 40 nT an axis beside residuals of noise alone, and of 60 nT."""
    own_nT = NOISE_NT * np.sqrt(np.trace(K @ K.T))
    after = {"noise_nT": NOISE_NT, "noise_beside_readings_nT": 40.0 * np.sqrt(3)}
    of_noise, more = (
        calibration(
            metrics={"before": {}, "after": {**after, "holdout_rms_nT": float(np.hypot(rms, 40.0 * np.sqrt(3)))}}
        )
        for rms in (own_nT, 60.0)
    )
    assert apply(of_noise, readings()).u_nT[0] == pytest.approx(own_nT / np.sqrt(3))
    assert apply(more, readings()).u_nT[0] == pytest.approx(60.0 / np.sqrt(3))


def test_a_row_without_a_reading_stays_empty() -> None:
    measured = readings().reading.copy()
    measured[9, 1] = np.nan
    found = apply(calibration(), Readings(measured))
    assert len(found.flags) == len(FIELD)
    assert np.isnan(found.field_nT[9]).any()
    assert np.isfinite(found.field_nT[[8, 10]]).all()


def test_counts_take_the_noise_through_the_scale() -> None:
    cal = replace(calibration(), affine=AffineMap(13.0 * K, k), dut=Dut(serial="S", nominal_nT_per_unit=13.0))
    found = apply(cal, Readings(readings().reading / 13.0))
    assert np.allclose(found.field_nT, FIELD, atol=1e-8)
    assert found.u_nT == pytest.approx(NOISE_NT * np.sqrt(np.trace(K @ K.T) / 3))


def test_a_channel_that_a_recording_does_not_have_at_all_costs_what_the_effect_once_brought() -> None:
    found = effect("offset-current", ("i_eps",), {"i_eps": 0.0}, c_x=(500, 0), c_y=(0, 0), c_z=(0, 0))
    cal = calibration(replace(found, holdout_rms_before_nT=173.5, holdout_rms_after_nT=17.3))
    empty = apply(cal, readings(channels={"i_eps": np.full(len(FIELD), np.nan)}))
    assert empty.u_nT.min() > np.sqrt((173.5**2 - 17.3**2) / 3)


def test_a_lost_channel_costs_what_the_effect_is_at_either_end_and_the_row_says_so() -> None:
    """A load that is off at its reference value: leaving it out costs its mean too, which a refitted map takes up."""
    found = effect("offset-current", ("i_eps",), {"i_eps": 0.0}, c_x=(500, 0), c_y=(0, 0), c_z=(0, 0))
    cal = calibration(
        replace(found, domain=(Domain(("channel:i_eps",), ((0.0,), (0.8,))),), holdout_rms_before_nT=200.0)
    )
    draw = np.random.default_rng(1)
    amps = np.where(draw.random(len(FIELD)) < 0.5, 0.8, 0.0)
    lost = apply(cal, readings(channels={"i_eps": np.full(len(FIELD), np.nan)}))
    error = np.column_stack([500.0 * amps, np.zeros((len(FIELD), 2))])
    assert lost.u_nT == pytest.approx(
        np.hypot(np.sqrt(np.mean(error**2)), apply(cal, readings(channels={"i_eps": 0 * amps})).u_nT), rel=0.2
    )
    assert set(lost.flags) == {"domain"}


def test_a_row_whose_mode_is_unknown_goes_without_that_offset_and_says_so() -> None:
    values = {f"c_{a} full": (300.0, 1.0) for a in "xyz"}
    cal = calibration(effect("offset-mode", **values), validity=Validity((0.0, 1e5), modes=("full", "nominal")))
    modes = np.array(["nominal", "full", "safe", ""] * (len(FIELD) // 4))
    found = apply(cal, readings(mode=modes))
    assert np.allclose((found.field_nT - FIELD)[:4, 0], [0, -300, 0, 0])
    assert found.flags[:4] == ("", "", "mode", "mode")
    assert found.u_nT[[2, 3]].min() > 300 > 20 > found.u_nT[[0, 1]].max()


def test_where_k_belongs_to_rows_without_a_mode_they_are_known() -> None:
    values = {f"c_{a} full": (300.0, 1.0) for a in "xyz"}
    cal = calibration(effect("offset-mode", **values), validity=Validity((0.0, 1e5), modes=("full",)))
    found = apply(cal, readings(mode=np.full(len(FIELD), "")))
    assert set(found.flags) == {""}
    assert found.u_nT.max() < 20


def test_a_correlation_of_k_with_a_current_s_coefficient_is_in_the_uncertainty() -> None:
    record = effect("offset-current", ("i",), {"i": 0.5}, c_x=(90, 4.0), c_y=(0, 4.0), c_z=(0, 4.0))
    C = np.diag([0.0] * 9 + [9.0] * 3 + [16.0] * 3)
    for axis in range(3):
        C[9 + axis, 12 + axis] = C[12 + axis, 9 + axis] = 0.67 * 3.0 * 4.0
    names = (*calibration().covariance_of, "0:c_x", "0:c_y", "0:c_z")
    noise = NOISE_NT * np.sqrt(np.trace(K @ K.T) / 3)
    for current in (0.0, 0.5, 1.5):  # b = K m - k - c (i - 0.5)
        found = apply(
            calibration(record, covariance=C, covariance_of=names), readings(channels={"i": 0 * TURN + current})
        )
        x = current - 0.5
        assert found.u_nT[0] ** 2 - noise**2 == pytest.approx(9 + 16 * x**2 + 2 * 0.67 * 12 * x)


def test_a_shape_s_uncertainty_is_in_that_of_the_field() -> None:
    t = np.linspace(0.0, 100.0, len(FIELD))
    wave = {"s_x": (80.0, 0.0), "s_y": (0.0, 0.0), "s_z": (0.0, 0.0), "c_x": (0.0, 0.0), "c_y": (0.0, 0.0)}
    sure, unsure = (
        apply(calibration(effect("periodic", f_Hz=(0.05, u), **wave, c_z=(0.0, 0.0))), readings(t_s=t)).u_nT
        for u in (0.0, 1e-4)
    )
    grown = np.sqrt(np.maximum(unsure**2 - sure**2, 0.0)).max()
    assert grown == pytest.approx(80.0 * 2 * np.pi * 1e-4 * 100.0 / np.sqrt(3), rel=0.1)


def test_a_loop_that_a_reference_drove_is_undone_where_it_is_a_third_of_the_field_s_way() -> None:
    """The reading holds the loop; where that drove it, what is undone would be another loop."""
    t = np.arange(600) * 0.5
    wave = np.sin(0.11 * t) + 0.4 * np.sin(0.29 * t)
    field = np.column_stack([20e3 * wave, 15e3 * np.roll(wave, 40), np.full(600, 9e3)])
    loop = stop(field, 2500.0) * [0.33, -0.25, 0.2] @ K.T
    parameters = {"body_c_x": (0.33, 0.0), "body_c_y": (-0.25, 0.0), "body_c_z": (0.2, 0.0), "r_nT": (2500.0, 0.0)}
    seen = readings(field + loop, t_s=t, segment=np.full(600, "new"))
    alone = apply(calibration(effect("hysteresis", **parameters, less_itself=(1.0, 0.0))), seen)
    assert np.abs(alone.field_nT - field).max() < 1e-3
    by_the_reading = apply(calibration(effect("hysteresis", **parameters)), seen)
    assert np.abs(by_the_reading.field_nT - field).max() > 100.0


def test_a_lag_is_undone_between_rows_that_lie_far_apart_and_what_is_missed_is_in_u() -> None:
    """A table that turns by twenty degrees from row to row, and by sixty."""
    t, lag = np.arange(400) * 1.0, 0.4
    cal = calibration(effect("lag", secant_s=(lag, 0.0), lag_s=(lag, 0.0)))
    for degrees, most in ((20.0, 1.0), (60.0, 200.0)):
        w = np.radians(degrees)
        now, then = (30e3 * np.column_stack([np.cos(w * (t - d)), np.sin(w * (t - d)), 0 * t]) for d in (0.0, lag))
        found = apply(cal, readings(then, t_s=t, segment=np.full(400, "new")))
        off = (found.field_nT - now)[8:-8]
        assert np.abs(off).max() < most
        still = apply(cal, readings(np.full_like(then, 17e3), t_s=t, segment=np.full(400, "new"))).u_nT[8:-8]
        more = np.sqrt(np.maximum(found.u_nT[8:-8] ** 2 - still**2, 0.0))
        assert np.sqrt(np.mean(off**2)) <= np.sqrt(np.mean(more**2)) + 0.1

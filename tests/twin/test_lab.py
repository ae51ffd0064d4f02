"""The simulated lab against formulas worked out here for themselves."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from labcal.geometry import rotation
from labcal.twin import Lab, open_twin
from labcal.twin.coils import Coil, square_coils
from labcal.twin.effects import NAMES
from labcal.twin.pick import pick_effect
from labcal.twin.platform import Turntable

QUIET: dict[str, Any] = {
    "ambient": {"drift_nT": 0.0, "mains_nT": 0.0},
    "platform": {"wobble_deg": 0.0},
    "reference": {"noise_nT": 0.0, "nT_per_unit": 1.0, "step_units": 1e-6},
    "dut": {"noise_nT": 0.0, "nT_per_unit": 1.0, "step_units": 1e-6},
}
EARTH = np.array([20_400.0, 1_150.0, -43_700.0])
TURN_UP = [[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]  # x of the body along the platform axis


def quiet(seed: int = 1, **effects: dict[str, Any]) -> Lab:
    return open_twin({**QUIET, "effects": effects}, seed)


def times(seconds: float = 60.0, rate: float = 10.0) -> np.ndarray:
    return np.arange(0, seconds, 1 / rate)


def too_much(t: np.ndarray, **effects: dict[str, Any]) -> np.ndarray:
    """What a DUT with these effects reads beside one without (n, 3) [nT]."""
    return quiet(**effects).dut_reading(t)[0] - quiet().dut_reading(t)[0]


def test_square_coils_make_the_field_of_the_law_of_biot_and_savart() -> None:
    side, turns, z = 1.5, 46, 0.5445 * 1.5 / 2
    one = 4e-7 * np.pi * turns * side**2 / (2 * np.pi * (z**2 + side**2 / 4) * np.sqrt(z**2 + side**2 / 2))
    matrix = square_coils(side, turns, np.zeros((3, 3))).matrix_nT_per_A
    np.testing.assert_allclose(matrix, 2e9 * one * np.eye(3), rtol=1e-9, atol=1e-6)


def test_a_tilted_pair_tilts_its_column_and_no_other() -> None:
    tilt = np.zeros((3, 3))
    tilt[0, 2] = 0.5  # the x pair, right-handed about z
    matrix = square_coils(1.5, 46, tilt).matrix_nT_per_A
    np.testing.assert_allclose(np.degrees(np.arctan2(matrix[1, 0], matrix[0, 0])), 0.5, rtol=1e-9)
    np.testing.assert_allclose(matrix[:, 1:] / matrix[1, 1], [[0, 0], [1, 0], [0, 1]], atol=1e-9)


def test_the_current_settles_through_the_inductance() -> None:
    coil = Coil(resistance_ohm=6.0, tau_s=0.02)
    coil.drive(1.0, 2.0, 20.0, True)
    coil.drive(2.0, 0.5, 20.0, True)
    t = np.array([0.5, 1.0, 1.02, 1.5, 2.02, 3.0])
    np.testing.assert_allclose(coil.at(t), [0, 0, 2 * (1 - np.exp(-1)), 2, 0.5 + 1.5 * np.exp(-1), 0.5], atol=1e-9)


def test_a_supply_without_the_voltage_cannot_drive_the_current() -> None:
    coil = Coil(resistance_ohm=6.0, tau_s=0.02)
    assert coil.drive(0.0, 2.0, 6.0, True)
    np.testing.assert_allclose(coil.at(np.array([5.0])), 1.0)


def test_a_circuit_that_is_closed_for_a_time_opens_by_itself_whatever_the_supply_does() -> None:
    coil = Coil(6.0, 0.02)
    coil.drive(0.0, 1.0, 12.0, True)
    coil.close(1.0, "interlock", 4.0)
    coil.drive(2.0, 0.5, 12.0, True)
    assert coil.current.now(3.9) == pytest.approx(0.5, abs=1e-6)
    assert coil.at(np.array([1.9, 3.9, 4.0 + 7 * 0.02, 50.0])) == pytest.approx([1.0, 0.5, 0.0, 0.0], abs=0.001)
    coil.close(3.0, "interlock", 6.0)
    coil.close(3.5, "watchdog", 5.0)
    assert coil.at(np.array([4.5, 5.5])) == pytest.approx([0.5, 0.0], abs=1e-6)
    coil.drive(7.0, 0.7, 12.0, True)
    assert coil.current.now(8.0) == pytest.approx(0.0, abs=1e-6)
    coil.close(9.0, "watchdog", np.inf)
    coil.close(9.0, "interlock", np.inf)
    assert coil.current.now(10.0) == pytest.approx(0.7, abs=1e-6)


def test_contacts_that_move_under_current_are_remembered() -> None:
    coil = Coil(resistance_ohm=6.0, tau_s=0.02)
    coil.reverse(0.5, -1)
    assert coil.hot_switches == []
    coil.drive(1.0, 2.0, 20.0, True)
    coil.reverse(2.0, 1)
    assert coil.hot_switches == [2.0]
    np.testing.assert_allclose(coil.at(np.array([1.9, 2.1])), [-2.0, 2.0])


@pytest.mark.parametrize(("way", "rate"), [(90.0, 6.0), (-360.0, 20.0), (0.5, 20.0)])
def test_the_platform_moves_with_finite_rate_and_acceleration(way: float, rate: float) -> None:
    table = Turntable(accel_deg_per_s2=5.0)
    table.move(1.0, way, rate)
    t = np.linspace(0, 120, 120_001)
    angle = table.at(t)
    speed = np.gradient(angle, t)
    assert angle[0] == 0
    assert angle[-1] == way
    assert np.abs(speed).max() == pytest.approx(min(rate, np.sqrt(abs(way) * 5)), rel=0.01)
    assert np.abs(np.gradient(speed, t)).max() < 5.1
    assert [table.now(float(s))[0] for s in t[::7000]] == pytest.approx(angle[::7000].tolist())


def test_a_platform_that_is_stopped_brakes() -> None:
    table = Turntable(accel_deg_per_s2=5.0)
    table.move(0.0, 360.0, 10.0)
    table.stop(10.0)
    assert table.moving(11.0)
    assert not table.moving(12.1)
    np.testing.assert_allclose(table.at(np.array([10.0, 12.0, 50.0])), [90, 100, 100])


def test_the_dut_sees_the_field_as_the_contract_says() -> None:
    """v_B = R(axis_body, -angle) · body_from_cage · v_C."""
    table = {**QUIET, "dut": {**QUIET["dut"], "scale": [1, 1, 1], "nonorthogonality_deg": [0, 0, 0]}}
    lab = open_twin({**table, "dut": {**table["dut"], "misalignment_deg": [0, 0, 0], "bias_nT": [0, 0, 0]}}, 1)
    lab.mount(0.0, TURN_UP)
    lab.platform.move(0.0, 200.0, 10.0)
    t = times()
    axis_body = np.array(TURN_UP) @ [0, 0, 1]
    angle = np.radians(lab.platform.at(t))
    expected = rotation(axis_body, -angle) @ np.array(TURN_UP) @ EARTH
    np.testing.assert_allclose(lab.dut_reading(t)[0], expected, atol=1e-5)


def test_the_readings_invert_to_the_field_through_the_true_response() -> None:
    lab = quiet()
    truth = lab._dut
    np.testing.assert_allclose(
        lab.dut_reading(times())[0] - truth.bias_nT, np.tile(truth.response @ EARTH, (600, 1)), atol=1e-5
    )


def test_noise_and_step_of_the_sensor_are_as_stated() -> None:
    lab = open_twin({"ambient": QUIET["ambient"], "dut": {"noise_nT": 15.0, "nT_per_unit": 4.0}}, 3)
    reading = lab.dut_reading(times(2000.0))[0]
    np.testing.assert_array_equal(reading, np.round(reading))
    np.testing.assert_allclose(4 * reading.std(axis=0), np.sqrt(15**2 + 16 / 12), rtol=0.03)


def test_coil_current_is_field_at_both_sensors() -> None:
    lab = quiet()
    lab.coils["y"].drive(0.0, 0.4, 20.0, True)
    t = times()[20:]
    field = EARTH + 0.4004 * lab.coil_field.matrix_nT_per_A[:, 1]
    np.testing.assert_allclose(lab.reference_nT(t), np.tile(field * [1.0, 1.0, 1.0], (len(t), 1)), atol=0.1)


@pytest.mark.parametrize("name", NAMES)
def test_every_effect_does_something_and_does_not_mind_how_time_is_cut(name: str) -> None:
    def read(cuts: int) -> np.ndarray:
        lab = open_twin({"effects": {name: {}}}, 5)
        lab.mount(0.0, TURN_UP)
        lab.switch_mode(200.0, "safe")
        lab.coils["x"].drive(10.0, 1.0, 20.0, True)
        lab.platform.move(50.0, 350.0, 2.0)
        parts = np.array_split(times(800.0, 2.0), cuts)
        return np.vstack([np.hstack([lab.dut_reading(p)[0], lab.reference_nT(p)]) for p in parts])

    whole = read(1)
    np.testing.assert_array_equal(whole, read(7))
    other = open_twin({}, 5)
    other.mount(0.0, TURN_UP)
    other.coils["x"].drive(10.0, 1.0, 20.0, True)
    other.platform.move(50.0, 350.0, 2.0)
    t = times(800.0, 2.0)
    same = np.hstack([other.dut_reading(t)[0], other.reference_nT(t)])
    assert np.abs(whole - same).max() > 5.0


def test_an_offset_follows_its_own_channel() -> None:
    t = times(600.0)
    true = quiet().housekeeping.true(t)
    seen = too_much(t, **{"offset-current": {"channel": "i_radio", "nT_per_A": [900.0, -600.0, 400.0]}})
    response = quiet()._dut.response
    np.testing.assert_allclose(seen, np.outer(true["i_radio"], [900, -600, 400]) @ response.T, atol=1e-4)


def test_a_late_reading_is_the_field_of_before() -> None:
    t = times(80.0)[100:]
    late, sharp = quiet(lag={"late_s": 0.3}), quiet()
    for lab in (late, sharp):
        lab.platform.move(0.0, 360.0, 6.0)
    np.testing.assert_allclose(late.dut_reading(t)[0], sharp.dut_reading(t - 0.3)[0], atol=1e-5)


def test_a_first_order_sensor_trails_a_turn_by_its_time_constant() -> None:
    t = times(60.0)
    slow, sharp = quiet(**{"first-order-lag": {"tau_s": 0.25}}), quiet()
    for lab in (slow, sharp):
        lab.platform.move(0.0, 360.0, 6.0)
    np.testing.assert_allclose(slow.dut_reading(t)[0][100:500], sharp.dut_reading(t - 0.25)[0][100:500], atol=15.0)


def test_hysteresis_reads_another_value_on_the_way_back() -> None:
    for name in ("hysteresis", "hysteresis-preisach"):
        lab = quiet(**{name: {}})
        for k, amps in enumerate([0.0, 0.4, 0.8, 0.4, 0.0]):
            lab.coils["x"].drive(10.0 * k, amps, 20.0, True)
        reading = lab.dut_reading(times(50.0))[0][:, 0]
        assert abs(reading[195] - reading[395]) > 20.0, name


def test_the_dipole_falls_with_the_cube_of_the_distance() -> None:
    def drawn(place: float) -> float:
        table = {**QUIET, "reference_place_m": [0, 0, place]}
        with_it = open_twin({**table, "effects": {"dut-dipole-at-reference": {}}}, 1).reference_nT(times(1.0))
        return float(np.linalg.norm((with_it - open_twin(table, 1).reference_nT(times(1.0)))[0]))

    assert drawn(0.2) / drawn(0.4) == pytest.approx(8.0, rel=1e-3)


def test_a_tilted_axis_keeps_the_reading_at_angle_zero() -> None:
    lab = quiet(**{"axis-tilt": {"cage_deg": [1.0, 0.0, 0.0]}})
    lab.platform.move(1.0, 180.0, 20.0)
    t = times(30.0)
    difference = np.linalg.norm(lab.dut_reading(t)[0] - _turned(t), axis=1)
    assert difference[0] < 1e-4
    assert difference[-1] > 500


def _turned(t: np.ndarray) -> np.ndarray:
    lab = quiet()
    lab.platform.move(1.0, 180.0, 20.0)
    return lab.dut_reading(t)[0]


def test_the_seed_picks_one_effect_and_many_seeds_pick_many() -> None:
    picked = [pick_effect(seed) for seed in range(60)]
    assert all(len(p) == 1 and set(p) <= set(NAMES) for p in picked)
    assert len({name for p in picked for name in p}) > 6
    assert pick_effect(7) == pick_effect(7)


@pytest.mark.parametrize(
    ("table", "says"),
    [
        ({"effects": {"gremlins": {}}}, "no such effect"),
        ({"effects": {"lag": {"later_s": 1}}}, "no such parameter"),
        ({"coils": {"side": 1}}, "side"),
        ({"dut": {"noise_nT": -1}}, "noise_nT"),
    ],
)
def test_a_wrong_table_is_refused(table: dict[str, Any], says: str) -> None:
    with pytest.raises(ValueError, match=says):
        open_twin(table, 0)

"""Each procedure against the twin, whose truth is known here and nowhere in the run."""

from __future__ import annotations

import json
import re
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from labcal import session
from labcal.record.stream import Block, Prompt
from labcal.twin.coils import square_coils
from labcal.twin.config import TwinTruth

Run = Callable[..., Any]
REFERENCE = "reference = {{ bias_nT = {}, noise_nT = 2.5, nT_per_unit = 6.6666667 }}"
BIAS = np.array(TwinTruth().dut.bias_nT)


def xyz(found: Any, name: str) -> np.ndarray:
    return np.array([found.value(name.format(axis)) for axis in "xyz"])


def test_ambient_finds_mean_and_noise_and_names_the_mains_that_a_rate_folds_to_zero(ran: Run) -> None:
    noisy = "reference = { noise_nT = 10.0, nT_per_unit = 6.6666667 }"
    found = ran("ambient", f"ambient = {{ drift_nT = 0.0, mains_nT = 0.0 }}\n{noisy}", duration_s=20)
    assert xyz(found, "mean ref_{}") == pytest.approx(TwinTruth().ambient.earth_nT, abs=25)
    quantised = np.hypot(10.0, 1e5 / 15000 / np.sqrt(12))
    assert xyz(found, "noise ref_{}") == pytest.approx([quantised] * 3, rel=0.15)
    assert "50 Hz is seen as a steady field at 10 dut samples/s" in found.event("ambient").text
    notes = [i.text for i in found.items if getattr(i, "kind", "") == "note"]
    assert "100 Hz is not distinguishable from 50 Hz at 30/s" in notes
    assert [(s.id, s.kind) for s in session.load_run(found.outcome.run_id).segments] == [("room", "static")]


def test_the_mains_is_measured_at_the_fastest_rate_and_the_rate_set_back(ran: Run) -> None:
    swift = "reference = { noise_nT = 2.5, nT_per_unit = 6.6666667, bandwidth_hz = 1e5 }"
    twin = f"ambient = {{ drift_nT = 0.0, mains_nT = 30.0 }}\n{swift}"
    fast = [("settings = { rate = 20 }", 'settings = { rate = 20, format = "binary", baud = 19200 }')]
    found = ran("ambient", twin, edits=fast, duration_s=10, mains_s=10)
    amplitude = found.measured["amplitude of 50 Hz"]
    assert amplitude.value == pytest.approx(30.0, abs=5 * amplitude.u)
    assert found.value("amplitude of 100 Hz") < 5 * found.measured["amplitude of 100 Hz"].u
    stamps = np.concatenate([i.t_s for i in found.items if isinstance(i, Block) and i.stream == "reference"])
    rates = 1 / np.diff(stamps)
    assert np.median(rates[stamps[1:] < 9]) == pytest.approx(154, rel=0.01)
    assert np.median(rates[stamps[1:] > 12]) == pytest.approx(20, rel=0.01)
    loud = ran("ambient", twin, edits=fast, duration_s=10, mains_s=10, mains_nT=20)
    assert "not fit for the job: amplitude of 50 Hz" in loud.event("ambient").text


def test_sync_check_finds_a_late_dut(ran: Run) -> None:
    early = ran("sync-check", chips=15)
    late = ran("sync-check", "effects = { lag = { late_s = 0.3 } }", chips=15)
    for name in ("DUT behind the set-point", "DUT behind the angle"):
        assert late.value(name) - early.value(name) == pytest.approx(0.3, abs=0.01)
    assert late.value("reference behind the set-point") == pytest.approx(
        early.value("reference behind the set-point"), abs=0.01
    )


def test_cage_calibration_finds_the_matrix_within_its_uncertainty(ran: Run) -> None:
    ended = ran("cage-calibration", steps=2, dwell_s=1.5)
    found = ended.event("cage-calibration").data
    of_a_mean = ended.value("DUT: noise") / np.sqrt(0.75 * 1.5 * 20)  # three quarters of each step, 20 a second
    assert ended.measured["DUT: departure from the line"].u == pytest.approx(of_a_mean, rel=0.2)
    truth = TwinTruth()
    coils = square_coils(truth.coils.side_m, truth.coils.turns, np.array(truth.coils.tilt_deg))
    for place, where in (("DUT", np.zeros(3)), ("reference", np.array([0.0, 0.0, 0.15]))):
        matrix, u = np.array(found[place]["matrix_nT_per_A"]), np.sqrt(np.diag(found[place]["covariance"]))
        true = coils.at(np.eye(3), where).T
        assert np.all(np.abs(matrix - true) < 4 * u[:9].reshape(3, 3) + 4e-5 * np.abs(true))
        assert found[place]["offset_nT"] == pytest.approx(truth.ambient.earth_nT, abs=60)
    difference = np.array(found["DUT less reference"]["matrix_nT_per_A"])
    true_difference = (coils.at(np.eye(3), np.zeros(3)) - coils.at(np.eye(3), np.array([0.0, 0.0, 0.15]))).T
    assert difference == pytest.approx(true_difference, abs=60)


def test_flip_finds_the_offset_without_a_reference(ran: Run) -> None:
    found = ran("flip", "ambient = { mains_nT = 0.0 }\n" + REFERENCE.format("[500.0, 300.0, -400.0]"), dwell_s=5)
    assert xyz(found, "offset {}") == pytest.approx(BIAS, abs=15)


def test_reference_check_finds_its_zero_and_enforces_its_due_date(ran: Run, bench_file: Callable[..., Any]) -> None:
    zero = [12.0, -9.0, 15.0]
    found = ran("reference-check", REFERENCE.format(zero), dwell_s=5)
    assert xyz(found, "zero {}") == pytest.approx(zero, abs=3)
    assert 0 < found.measured["zero x"].u < 1
    old = bench_file("", ("[reference]\n", '[reference]\ncalibration = "aa00, 2020-01-31"\n'))
    assert "days old, beyond 365" in session.run("reference-check", old).status


def test_a_reference_s_zero_is_as_uncertain_as_the_place_s_field_changes_while_it_is_turned(ran: Run) -> None:
    z = list[float]()
    for seed in range(5):
        zero = (30 * np.random.default_rng([seed, 77]).normal(size=3)).tolist()
        found = ran("reference-check", REFERENCE.format(zero), seed, dwell_s=5)
        z += [(found.value(f"zero {a}") - v) / found.measured[f"zero {a}"].u for a, v in zip("xyz", zero, strict=True)]
    assert 0.2 < np.sqrt(np.mean(np.square(z))) < 1.5


def test_a_reference_s_zero_is_none_of_its_scale(ran: Run) -> None:
    """40 nT of 50 µT would be 800 ppm either way along its axis."""
    none, large = (ran("reference-check", REFERENCE.format(zero), dwell_s=2) for zero in ([0.0] * 3, [0.0, 40.0, 0.0]))
    spread = "magnitude against direction"
    assert large.value(spread) == pytest.approx(none.value(spread), abs=50)


def test_linearity_tells_a_bent_dut_from_a_straight_one(ran: Run) -> None:
    straight = ran("linearity", steps=3, dwell_s=2)
    bent = ran("linearity", "effects = { nonlinearity = { cubic_per_uT2 = 2e-5 } }", steps=3, dwell_s=2)
    assert straight.measured["departure from a straight line"].verdict == "PASS"
    b = np.repeat(np.linspace(-5e4, 5e4, 7), 3)
    cubic = 2e-5 * 1e-6 * b**3 * 1.022
    left = cubic - np.polyval(np.polyfit(b, cubic, 1), b)
    assert abs(bent.value("departure from a straight line")) == pytest.approx(np.abs(left).max(), abs=60)


def test_current_coupling_finds_the_bias_per_ampere_of_the_load_that_couples(
    ran: Run, dut_response: np.ndarray
) -> None:
    effect = 'effects = { "offset-current" = { channel = "i_payload", nT_per_A = [400.0, -250.0, 300.0] } }'
    found = ran("current-coupling", effect, repeats=3, dwell_s=6)
    assert xyz(found, "i_payload: bias {}") == pytest.approx(dut_response @ [400.0, -250.0, 300.0], abs=15)
    assert abs(found.value("i_payload: delay")) < 0.3
    for other in ("i_eps", "i_radio"):
        for axis in "xyz":
            quiet = found.measured[f"{other}: bias {axis}"]
            assert abs(quiet.value) < 5 * quiet.u


def test_temperature_drift_finds_offset_and_gain(ran: Run, dut_response: np.ndarray) -> None:
    effects = (
        '"offset-temperature" = { nT_per_C = [30.0, -20.0, 10.0] }, "gain-temperature" = { per_C = [0.0, 0.0, 1e-3] }'
    )
    found = ran("temperature-drift", f"effects = {{ {effects} }}", rounds=12, dwell_s=10)
    for field, true in (("+0", [30.0, -20.0, 10.0]), ("+50", [30.0, -20.0, 60.0])):
        u = found.measured[f"x at {field} µT per temp_dut"].u
        assert u < 5
        slopes = xyz(found, f"{{}} at {field} µT per temp_dut")
        assert slopes == pytest.approx(dut_response @ true, abs=3.3 * u)  # one in a thousand


PERMANENT_Am2 = (0.02, -0.01, 0.03)
INDUCED_Am2_per_T = ((30.0, 8.0, -5.0), (8.0, 50.0, 6.0), (-5.0, 6.0, 20.0))


def moment_errors(ran: Run, seed: int, place_m: float) -> tuple[np.ndarray, Any]:
    """What `dut-moment` finds less what is true, over its stated uncertainty (9,), and the run."""
    truth = f"moment_Am2 = {list(PERMANENT_Am2)}, induced_Am2_per_T = {[list(row) for row in INDUCED_Am2_per_T]}"
    effect = f'effects = {{ "dut-dipole-at-reference" = {{ {truth} }} }}'
    twin = f"placing_error_m = {place_m}\n{effect}"
    found = ran("dut-moment", twin, seed=seed, rate_deg_per_s=20, rest_s=3, u_place_m=place_m)
    names = [*(f"permanent moment {a}" for a in "xyz"), *(f"induced moment {a}" for a in MOMENT_PAIRS)]
    measured = [found.measured[name] for name in names]
    true = np.concatenate([PERMANENT_Am2, [INDUCED_Am2_per_T["xyz".index(a)]["xyz".index(b)] for a, b in MOMENT_PAIRS]])
    return np.array([(m.value - t) / m.u for m, t in zip(measured, true, strict=True)]), found


MOMENT_PAIRS = ("xx", "yy", "zz", "xy", "xz", "yz")


def test_dut_moment_finds_the_permanent_and_the_induced_moment(ran: Run) -> None:
    errors, found = moment_errors(ran, 11, 0.0)
    assert np.abs(errors).max() < 4
    assert max(found.measured[f"permanent moment {a}"].u for a in "xyz") < 2e-5
    assert max(found.measured[f"induced moment {a}"].u for a in MOMENT_PAIRS) < 0.5
    largest = found.measured["largest induced moment in 50 µT"]
    assert largest.value == pytest.approx(5e-5 * np.linalg.norm(INDUCED_Am2_per_T, 2), abs=4 * largest.u)
    segments = session.load_run(found.outcome.run_id).segments
    assert [(s.kind, s.mounting) for s in segments] == [("rotation", "z")] * 4 + [("rotation", "x")] * 4


@pytest.mark.slow
@pytest.mark.parametrize("place_m", [0.0, 0.001])
def test_the_stated_uncertainty_of_the_moment_is_its_scatter(ran: Run, place_m: float) -> None:
    """With the reference where it is said to be, and as far beside it as a hand puts it."""
    errors = np.array([moment_errors(ran, seed, place_m)[0] for seed in range(100, 120)])
    assert 0.6 < np.sqrt(np.mean(errors**2)) < 1.2
    assert np.abs(errors).max() < 4.5


def test_field_hold_takes_back_what_drifts(ran: Run) -> None:
    found = ran("field-hold", "ambient = { drift_nT = 400.0 }", duration_s=120)
    set_points = [np.array(i.data["read_back_A"]) for i in found.items if getattr(i, "kind", "") == "set-point"]
    bump_nT = 5e4 * np.linalg.norm(set_points[1] - set_points[0])  # from manual to automatic
    assert bump_nT < 2 * found.value("open-loop error") + 50
    assert found.measured["rms error while held"].verdict == "PASS"
    tracked = np.array(found.event("ambient").data["ambient_nT"]) - xyz(found, "zero: ref_{}")
    assert np.linalg.norm(tracked) > 2 * found.value("rms error while held")


def test_degauss_alternates_decays_and_ends_at_zero(ran: Run) -> None:
    found = ran("degauss", cycles=8, hold_s=0.1)
    along_x = [i.data["read_back_A"][0] for i in found.items if getattr(i, "kind", "") == "set-point"][:8]
    assert np.all(np.sign(along_x[:6]) == [1, -1, 1, -1, 1, -1])
    assert np.all(np.diff(np.abs(along_x[:6])) < 0)
    assert "no deperm" in found.event("note").text


def test_cage_map_agrees_with_the_probe(ran: Run) -> None:
    found = ran("cage-map", probes=2, dwell_s=1)
    assert found.measured["probe less computed"].verdict == "PASS"
    other = ran("cage-map", probes=2, dwell_s=1, side_m=0.8)
    assert other.measured["probe less computed"].verdict == "FAIL"


def test_platform_signature_is_small_on_a_quiet_platform(ran: Run) -> None:
    found = ran("platform-signature", "ambient = { drift_nT = 0.0 }", rate_deg_per_s=18, dwell_s=5)
    assert {m.verdict for m in found.measured.values() if m.limit} == {"PASS"}


@pytest.mark.parametrize(
    ("name", "given", "turns"),
    [
        ("rate-sweep", {"rates_deg_per_s": "10,20"}, [(10, 360), (-10, 360), (20, 360), (-20, 360)]),
        ("reverse", {"rate_deg_per_s": "20"}, [(20, 360), (-20, 360)]),
        ("repeat", {"rate_deg_per_s": "20", "times": "3", "pause_s": "1"}, [(20, 360), (-20, 360), (20, 360)]),
    ],
)
def test_turns_are_made_as_asked_in_one_mounting(ran: Run, name: str, given: dict[str, str], turns: list[Any]) -> None:
    run = session.load_run(ran(name, **given).outcome.run_id)
    assert {s.mounting for s in run.segments} == {"z"}
    assert len(run.segments) == len(turns)
    for index, (rate, span) in enumerate(turns):
        rows = run.rows(index)
        t, angle = run.t_s[rows], run.angle_deg[rows]
        middle = (angle > 120) & (angle < 240)
        assert np.polyfit(t[middle], angle[middle], 1)[0] == pytest.approx(rate, rel=0.01)
        assert np.nanmax(angle) - np.nanmin(angle) == pytest.approx(span, abs=2)


def test_a_dial_without_a_motor_is_turned_by_a_person_until_no_sector_is_missing(ran: Run) -> None:
    found = ran("rotate-axis", "platform = { misreading_deg = 0.1 }", edits=[('"zaber"', '"manual"')], zero_s=2)
    asked = [i.drawing["angle_deg"] for i in found.items if isinstance(i, Prompt) and "angle_deg" in i.drawing]
    assert asked == pytest.approx([0.0, *(15.0 * n - 7.5 for n in range(1, 25))], abs=0.1)
    assert found.measured["z+50uT: missing sectors"].verdict == "PASS"


@pytest.mark.parametrize(
    ("earth_nT", "said"),
    [
        ("[20000.0, 1100.0, -43950.0]", r"U = 276 nT, k = 2\)$"),
        ("[20000.0, 1100.0, -43000.0]", "nT below what WMM20.*iron near by"),
        ("[200.0, 11.0, -437.0]", "iron near by, or the reference's unit and scale"),
    ],
)
def test_ambient_says_what_the_model_of_the_earth_expects_there(ran: Run, earth_nT: str, said: str) -> None:
    place = ("[dut]\nserial", "[site]\nlatitude_deg = 47.0\nlongitude_deg = 8.0\nheight_m = 500.0\n[dut]\nserial")
    found = ran("ambient", f"ambient = {{ earth_nT = {earth_nT} }}", edits=[place], duration_s=10)
    assert re.search(said, found.event("ambient").text)
    expected = next(m for name, m in found.measured.items() if name.startswith("magnitude by WMM"))
    assert expected.value == pytest.approx(48_250, abs=250)  # IGRF there, of another package
    assert found.value("magnitude") == pytest.approx(np.linalg.norm(json.loads(earth_nT)), abs=30)

"""A verdict is as uncertain as the reference that it rests on, and what nobody stated is named."""

from __future__ import annotations

from collections.abc import Callable
from datetime import UTC, datetime, timedelta
from typing import Any

import numpy as np
import pytest
from scalar_lab import SCALAR, sensor

from labcal import session
from labcal.record.stream import Event
from procedures.linearity import straightness

Run = Callable[..., Any]
WORSE = (("u_scale_ppm = 50.0", "u_scale_ppm = 5000.0"), ("u_offset_nT = 3.0", "u_offset_nT = 300.0"))
SMALL = {"positions": 4, "dwell_s": 1}


def notes(found: Any) -> str:
    return " ".join(i.text for i in found.items if isinstance(i, Event) and i.kind == "note")


def test_verify_is_as_uncertain_as_its_reference(ran: Run) -> None:
    good, bad = ran("verify", **SMALL), ran("verify", edits=WORSE, **SMALL)
    for name in ("before: rms magnitude error", "before: largest magnitude error"):
        assert good.value(name) == pytest.approx(bad.value(name))
        assert bad.measured[name].u > 20 * good.measured[name].u
    # the DUT reads some thousand nT wrong at each position: the scale, 0.5 % of 35 µT, moves each error by 175 nT
    scale_and_zero = np.hypot(5e-3 * 35_000, 300 / np.sqrt(3))
    assert 0.3 * scale_and_zero < bad.measured["before: rms magnitude error"].u < 2 * scale_and_zero
    assert "alignment" in notes(good)
    assert "mounting uncertainty not included" in notes(good)


def test_a_mounting_that_is_stated_is_in_the_heading(ran: Run) -> None:
    stated = ran("verify", u_mounting_deg=0.5, **SMALL)
    open_ = ran("verify", **SMALL)
    heading = "before: rms heading error"
    assert stated.measured[heading].u > 0.05 > 5 * open_.measured[heading].u
    assert "mounting uncertainty not included" not in notes(stated)


@pytest.mark.slow
def test_the_platform_s_angle_is_in_the_heading(ran: Run) -> None:
    angle = "angle_sign = 1", "angle_sign = 1\nangle_noise_deg = 0.05\nu_axis_cage_deg = 0.001"
    stated, open_ = ran("verify", edits=[angle], **SMALL), ran("verify", **SMALL)
    rms, largest = "before: rms heading error", "before: largest heading error"
    assert stated.measured[rms].u == pytest.approx(np.hypot(0.05 / np.sqrt(4), open_.measured[rms].u), rel=0.02)
    assert stated.measured[largest].u == pytest.approx(np.hypot(0.05, open_.measured[largest].u), rel=0.02)
    assert "The platform's angle." in notes(open_)
    assert "The direction of the platform's axis in the cage." in notes(open_)
    assert "platform" not in notes(stated)


@pytest.mark.parametrize(
    ("procedure", "given", "name"),
    [
        ("play-field", {"duration_s": 20, "step_s": 10, "limit_nT": 1000}, "rms tracking error"),
        ("field-hold", {"duration_s": 10, "period_s": 2, "limit_nT": 1000}, "rms error while held"),
    ],
)
def test_a_field_is_held_as_well_as_the_reference_can_tell(
    ran: Run, procedure: str, given: dict[str, Any], name: str
) -> None:
    good, bad = ran(procedure, **given), ran(procedure, edits=WORSE, **given)
    assert bad.measured[name].u > np.sqrt(3) * 300.0 / 2  # three zeros, beside a scale that may take some of it off
    assert good.measured[name].u < 30.0
    assert "alignment" in notes(good)


@pytest.mark.slow
def test_linearity_s_slope_is_as_uncertain_as_the_reference_s_scale_and_its_departure_is_not(ran: Run) -> None:
    short = {"steps": 2, "dwell_s": 1}
    good, bad = ran("linearity", **short), ran("linearity", edits=WORSE, **short)
    assert bad.measured["slope"].u == pytest.approx(5e-3 * bad.value("slope"), rel=0.05)
    assert good.measured["slope"].u < 2e-4
    name = "departure from a straight line"
    assert bad.measured[name].u == pytest.approx(good.measured[name].u, rel=0.1)
    assert "The reference's own linearity." in notes(good)


def test_a_slope_is_as_uncertain_by_noise_as_a_line_through_all_steps(ran: Run) -> None:
    """Three times −50, −25, 0, 25 and 50 µT: σ / √(3 · 2.5) of 50 µT, by five repeats (GUM, G.2: 2.65)."""
    found = ran("linearity", edits=[("u_scale_ppm = 50.0\nu_offset_nT = 3.0", "")], steps=2, dwell_s=1)
    sigma = straightness(*np.array(found.event("linearity").data["field_reading_nT"]).T)[2]
    assert found.measured["slope"].u == pytest.approx(2.65 / 2 * sigma / 50_000 / np.sqrt(7.5), rel=0.02)


@pytest.mark.slow
def test_the_largest_of_many_departures_is_no_fault_of_a_straight_device(ran: Run) -> None:
    """Of 33 steps the largest departure by noise is about two and a half times its standard deviation."""
    found = ran("linearity", steps=5, dwell_s=1)
    name = "departure from a straight line"
    sigma = straightness(*np.array(found.event("linearity").data["field_reading_nT"]).T)[2]
    assert 1.3 * sigma < abs(found.value(name)) < 2.0001 * found.measured[name].u < 4 * sigma  # it reaches zero
    cage = ran("cage-calibration", steps=2, dwell_s=1, limit_ppm=20_000)
    for figure in ("up less down", "polarity + less −"):
        told = cage.measured[f"DUT: {figure}"]
        assert abs(told.value) < 2.0001 * told.u, told


@pytest.mark.slow
def test_a_heading_is_as_uncertain_by_noise_as_the_field_across_its_axis_is_small(ran: Run) -> None:
    """Of 24 fields of 35 µT between 37° and 90° from the axis.

    What a bias does to a heading is as 1 / sin, and so is its noise: where the error is largest the noise counts most.
    The mean of 1 / sin⁴ over that of 1 / sin² is 1.51.
    """
    bare = [("u_scale_ppm = 50.0\nu_offset_nT = 3.0", "")]
    far_off = "dut = { noise_nT = 20.0, nT_per_unit = 4.0, bias_nT = [2000.0, 2000.0, 2000.0] }"
    found = ran("verify", far_off, edits=bare, positions=24, dwell_s=1)
    heading, magnitude = (found.measured[f"before: rms {which} error"].u for which in ("heading", "magnitude"))
    assert heading == pytest.approx(np.degrees(magnitude / 35_000) * np.sqrt(1.51), rel=0.1)


def test_a_cage_s_matrix_is_as_uncertain_as_the_reference_s_scale(ran: Run) -> None:
    short = {"steps": 2, "dwell_s": 1, "limit_ppm": 20_000}
    good, bad = ran("cage-calibration", **short), ran("cage-calibration", edits=WORSE, **short)
    u = "DUT: uncertainty of the matrix"
    assert bad.value(u) == pytest.approx(5_000, rel=0.05)  # ppm of the coil's own constant
    assert 50 <= good.value(u) < 0.1 * bad.value(u)
    of_the_file = np.sqrt(np.diag(bad.event("cage-calibration").data["DUT"]["covariance"]))
    assert of_the_file[[0, 4, 8]] == pytest.approx(5e-3 * 49_950 * np.ones(3), rel=0.05)
    assert of_the_file[9:] == pytest.approx(np.hypot(300.0, 5e-3 * np.array([20_400, 1_150, 43_700])), rel=0.05)
    assert bad.measured["DUT: change from bench.toml"].u > 20 * good.measured["DUT: change from bench.toml"].u
    assert "The supplies' read-back." in notes(good)


@pytest.mark.slow
def test_a_reference_elsewhere_is_put_at_the_dut_s_place_for_a_cage_s_matrix(ran: Run) -> None:
    short = {"steps": 2, "dwell_s": 1, "limit_ppm": 20_000}
    remote = ran("cage-calibration", edits=[*WORSE, ('place = "dut"', 'place = "remote"')], **short)
    assert remote.value("DUT: uncertainty of the matrix") == pytest.approx(5_000, rel=0.05)
    assert "there is no reference" not in notes(remote)


def test_a_room_s_mean_is_as_uncertain_as_the_reference_and_its_drift_is_not(ran: Run) -> None:
    short = {"duration_s": 10, "mains_s": 5}
    good, bad = ran("ambient", **short), ran("ambient", edits=WORSE, **short)
    for name, true_nT in (("x", 20_400.0), ("y", 1_150.0), ("z", -43_700.0)):
        assert bad.measured[f"mean ref_{name}"].u == pytest.approx(np.hypot(300.0, 5e-3 * true_nT), rel=0.05)
        assert good.measured[f"mean ref_{name}"].u < 10
        drift = f"drift ref_{name}"
        assert bad.measured[drift].u == pytest.approx(good.measured[drift].u)
    assert "alignment" in notes(good)


def test_a_flip_that_is_met_well_is_as_uncertain_as_its_readings(ran: Run) -> None:
    """0.01 degrees of 48 µT are 4.2 nT for all four attitudes; of a noisy DUT short dwells tell less."""
    met_well = {"dwell_s": 4, "u_mounting_deg": 0.01}
    noisy = ran("flip", "dut = { noise_nT = 300.0 }", **met_well).measured["offset x"].u
    assert noisy > 0.5 * 300 / np.sqrt(4 * 4 * 10)  # ten readings a second
    assert noisy > 5 * 4.2


def test_a_half_turn_that_is_missed_is_in_the_zero_and_one_that_nobody_states_is_named(ran: Run) -> None:
    open_ = ran("reference-check", dwell_s=1)
    stated = ran("reference-check", dwell_s=1, u_turn_deg=0.1, u_cage_ppm=100)
    ambient_nT = np.linalg.norm([1_150, -43_700])  # across x
    missed = np.radians(0.1) * ambient_nT * np.sqrt(3) / 4
    assert stated.measured["zero x"].u == pytest.approx(np.hypot(missed, open_.measured["zero x"].u), rel=0.02)
    spread = "magnitude against direction"
    assert stated.measured[spread].u == pytest.approx(np.hypot(100 / np.sqrt(2), open_.measured[spread].u), rel=0.02)
    assert "the half turns, the cage" in notes(open_)
    assert "not stated" not in notes(stated)


@pytest.mark.slow
def test_a_sphere_s_map_and_verdict_are_as_uncertain_as_the_reference(ran: Run) -> None:
    short = {"n_directions": 8, "magnitudes_nT": "20000,50000", "dwell_s": 0.5, "verify": 2}
    two_years_ago = (datetime.now(UTC) - timedelta(days=730)).date()
    aged = "u_offset_nT = 3.0", f'u_offset_nT = 3.0\nu_drift_nT_per_year = 150.0\ncalibration = "{two_years_ago}"'
    good, bad, old = (
        ran("field-sphere", **short),
        ran("field-sphere", edits=WORSE, **short),
        ran("field-sphere", edits=[aged], **short),
    )
    for found, u_K, u_k in ((bad, 5e-3, 300.0), (old, 0.0, 300.0)):
        assert found.measured["K xx"].u == pytest.approx(max(u_K, good.measured["K xx"].u), rel=0.1)
        assert found.measured["k x"].u == pytest.approx(u_k, rel=0.1)
        # of the two fields the scale moves 20 and 50 µT, the zeros all three components
        rms = np.sqrt(u_K**2 * (20e3**2 + 50e3**2) / 2 + 3 * u_k**2)
        name = "verify: rms error"
        assert good.value(name) == pytest.approx(found.value(name), rel=1e-3)
        assert 0.5 * rms < found.measured[name].u < 1.5 * rms
    assert good.measured["verify: rms error"].u < 20
    assert "alignment" in notes(good)
    assert "drift since its own calibration" in notes(good)
    assert "drift since its own calibration" not in notes(old)


def test_verify_beside_a_scalar_reference_judges_magnitudes_alone(ran: Run) -> None:
    """A magnitude is no vector of three equal components; the DUT is some thousand nT off as it stands."""
    vector, scalar = ran("verify", **SMALL), ran("verify", sensor(1), 11, SCALAR, **SMALL)
    name = "before: rms magnitude error"
    assert scalar.value(name) == pytest.approx(vector.value(name), rel=0.2)
    assert not any("heading" in name for name in scalar.measured)
    assert "No heading is judged" in notes(scalar)
    worse = ran("verify", sensor(1), 11, [*SCALAR, ("u_scale_ppm = 1.0", "u_scale_ppm = 5000.0")], **SMALL)
    largest = "before: largest magnitude error"
    assert 0.5 < worse.measured[largest].u / (5e-3 * 35_000) < 2, worse.measured[largest]  # another may be the largest
    assert scalar.measured[largest].u < 20


def test_linearity_refuses_a_scalar_reference(bench_file: Callable[..., Any]) -> None:
    assert "needs a vector reference" in session.run("linearity", bench_file(sensor(1), *SCALAR)).status

"""Temperature, age and distance of the reference, from run.json to the map; what is not stated is named."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from labcal.errors import InputError
from labcal.fit import fit
from labcal.fit.declared import contributions
from labcal.model import AffineMap
from labcal.record import Channel, Run
from labcal.store import bundle_of, load_bundle, save_bundle
from labcal.uncertainty import declared_errors
from labcal.uncertainty.unstated import not_covered
from labcal.uncertainty.verdicts import in_body, rms, u_by, u_declared, u_of_size, uncovered

RUN = Path(__file__).parents[2] / "examples" / "short-preflight" / "run.zip"
STATED = {
    "tc_ppm_per_K": 30.0,
    "u_tc_ppm_per_K": 40.0,
    "tc_nT_per_K": -3.0,
    "u_tc_nT_per_K": 4.0,
    "drift_nT_per_year": 6.0,
    "u_drift_nT_per_year": 8.0,
    "certificate": {"number": "M-1", "issuer": "PTB", "date": "2025-01-01", "due": "2027-01-01", "temperature_C": 23.0},
}
ROOM = {"temperature_C": 27.0, "gradient_nT_per_m": 100.0, "gradient_ppm_per_m": 2_000.0}


@pytest.fixture(scope="module")
def run() -> Run:
    """Everything stated, two years after the certificate, 4 K warmer, 0.2 m apart."""
    recorded = load_bundle(RUN).run()
    reference = replace(recorded.reference, position_m=(0.0, 0.12, 0.16), place="dut", u_align_deg=0.1, **STATED)
    return replace(recorded, reference=reference, environment=ROOM, started_utc="2027-01-01T12:00:00Z")


def changed(run: Run) -> dict[str, np.ndarray]:
    assert run.reference_vector is not None
    return {e.source: e.change(run).reference_vector - run.reference_vector for e in declared_errors(run)}


def test_what_is_stated_moves_the_reference_by_so_much(run: Run) -> None:
    by, field = changed(run), run.reference_vector
    assert by["reference's temperature, scale"] == pytest.approx(field * 50e-6 * 4.0, rel=1e-6)  # 50 = hypot(30, 40)
    x = np.broadcast_to(np.eye(3)[0], field.shape)
    assert by["reference's temperature, zero x"] == pytest.approx(5.0 * 4.0 * x, abs=1e-9)
    aged = by["reference's drift since its certificate x"]
    assert aged == pytest.approx(10.0 * 730.0 / 365.25 * x, rel=1e-3, abs=1e-9)
    assert by["gradient over the distance x"] == pytest.approx(0.2 * 100.0 * x, abs=1e-9)
    along_y = field * np.eye(3)[1]
    assert by["coils' gradient over the distance y"] == pytest.approx(0.2 * 2_000e-6 * along_y, rel=1e-6, abs=1e-9)


def test_the_room_s_own_thermometer_goes_before_one_number(run: Run) -> None:
    warm = Channel("t_room", "degC", "temperature", np.linspace(22.0, 24.0, len(run)), "room")
    by = changed(replace(run, channels=(*run.channels, warm)))
    assert by["reference's temperature, zero y"][[0, -1], 1] == pytest.approx([-5.0, 5.0], abs=0.01)


def test_a_bundle_keeps_it_and_a_fault_is_named(run: Run, tmp_path: Path) -> None:
    save_bundle(bundle_of(run), tmp_path / "b")
    again = load_bundle(tmp_path / "b").run()
    assert again.reference == run.reference
    assert again.environment == ROOM
    path = tmp_path / "b" / "run.json"
    for old, new, said in (
        ("2025-01-01", "1.1.2025", "ISO 8601"),
        ('"u_tc_nT_per_K": 4.0', '"u_tc_nT_per_K": -4.0', "0"),
    ):
        text = path.read_text()
        path.write_text(text.replace(old, new))
        with pytest.raises(InputError, match=said):
            load_bundle(tmp_path / "b").run()
        path.write_text(text)
    assert json.loads(path.read_text())["environment"] == ROOM


def test_the_map_follows(run: Run) -> None:
    """A zero that is 20 nT uncertain for its age alone is in k."""
    bare = replace(run.reference, drift_nT_per_year=None, u_drift_nT_per_year=None)
    wide, narrow = (fit(one, holdout=False) for one in (run, replace(run, reference=bare)))
    more = np.diag(wide.covariance - narrow.covariance)[9:]
    drift_nT = 10.0 * 730.0 / 365.25
    assert np.sqrt(more) == pytest.approx([drift_nT] * 3, rel=0.6)
    assert (more > 0).all()


def test_a_closed_form_s_map_follows_as_well(run: Run) -> None:
    """`pso-axis` adds what each error does in closed form (`labcal.fit.declared`)."""
    affine = AffineMap(np.diag([1.1, 0.9, 1.0]), np.array([100.0, -200.0, 300.0]))
    shift = {c.source: c.shift for c in contributions(run, affine, frame_known=True)}
    drifted = shift["reference's drift since its certificate y"]
    assert drifted == pytest.approx([0] * 10 + [10.0 * 730.0 / 365.25, 0], rel=1e-3)
    assert shift["reference's temperature, scale"] == pytest.approx(200e-6 * affine.parameters)  # 4 K of 50 ppm
    assert shift["reference's temperature, zero z"][11] == pytest.approx(20.0)
    assert shift["gradient over the distance x"][9] == pytest.approx(20.0)
    assert shift["coils' gradient over the distance x"] == pytest.approx(400e-6 * affine.parameters)


def test_the_platform_s_axis_and_a_mounting_are_named_where_nobody_states_them(run: Run) -> None:
    axis, mounted = "The direction of the platform's axis in the cage.", "Frame as mounted; mounting uncertainty"
    known = {"u_axis_cage_deg": 0.1, "u_axis_body_deg": 0.1, "u_time_s": 1e-3}

    def said(**more: object) -> str:
        return " ".join(not_covered(replace(run, segments=tuple(replace(s, **known | more) for s in run.segments))))

    assert axis not in said()
    assert mounted not in said()
    assert "time" not in said()  # each segment states its own
    assert axis in said(u_axis_cage_deg=None)
    assert mounted in said(u_axis_body_deg=None)
    assert "time" in said(u_time_s=None)
    at_rest = {"kind": "static", "axis_body": None, "axis_cage": None, "body_from_cage": tuple(map(tuple, np.eye(3)))}
    assert mounted in said(u_axis_body_deg=None, **at_rest)
    assert axis not in said(u_axis_cage_deg=None, **at_rest)


def test_what_is_stated_as_nothing_is_named_too(run: Run) -> None:
    """An uncertainty of 0 contributes nothing, and nothing is exact."""
    reference = replace(run.reference, u_scale_ppm=0.0, u_offset_nT=3.0, u_align_deg=0.0)
    exact = tuple(replace(s, u_axis_body_deg=0.0, u_axis_cage_deg=0.0, u_time_s=1e-3) for s in run.segments)
    said = not_covered(replace(run, reference=reference, segments=exact))
    assert "Of the reference, because the run states it as 0: scale, alignment." in said
    assert "Frame as mounted; mounting uncertainty not included." in said
    assert "The direction of the platform's axis in the cage." in said


def test_what_is_not_stated_is_named(run: Run) -> None:
    assert not any("temperature" in said or "gradient" in said for said in not_covered(run))
    cold = replace(run, reference=replace(run.reference, certificate={"number": "M-1"}))
    assert "The reference's temperature, and its drift since its own calibration." in not_covered(cold)
    apart = replace(run, environment=None)
    assert "The field's gradient between the reference and the device." in not_covered(apart)


def figure_rms(run: Run) -> float:
    return float(np.sqrt(np.mean((np.linalg.norm(in_body(run), axis=1) - 50_000.0) ** 2)))


def positions(run: Run, **stated: float) -> Run:
    """Six standstills along the axes of the body, all of 50 µT."""
    field = 50_000.0 * np.vstack([np.eye(3), -np.eye(3)])
    same = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
    part = replace(run.segments[0], body_from_cage=same, u_axis_body_deg=None, u_axis_cage_deg=None, u_time_s=None)
    bare = dict.fromkeys(("u_scale_ppm", "u_offset_nT", "u_align_deg", "u_time_s", "position_m", *STATED))
    cut = run.select(np.arange(6))
    return replace(
        cut,
        reference=replace(run.reference, **{**bare, **stated}),
        segments=tuple(replace(part, id=str(i)) for i in range(6)),
        segment_index=np.arange(6),
        reference_vector=field,
        environment=None,
    )


def test_an_rms_that_begins_at_zero_is_as_large_as_the_error_alone_makes_it(run: Run) -> None:
    assert u_declared(positions(run, u_scale_ppm=400.0), figure_rms) == pytest.approx(20.0, rel=1e-6)
    one = u_declared(positions(run, u_offset_nT=30.0), figure_rms)
    assert one == pytest.approx(30.0, rel=1e-3)  # each axis is met in a third of the positions: sqrt(3 · 30² / 3)
    assert u_declared(positions(run), figure_rms) == 0.0


def test_an_error_that_could_hide_the_figure_does_not_hide_the_uncertainty(run: Run) -> None:
    """Of 25 nT too much an error of −50 nT leaves the size as it is: the other way makes it 75."""
    off = positions(run, u_scale_ppm=1_000.0)
    off = replace(off, reference_vector=off.reference_vector * (1 + 25.0 / 50_000.0))
    (error,) = declared_errors(off)
    assert u_by(off, error, figure_rms) == pytest.approx(50.0 / np.sqrt(2), rel=0.01)


def errors_over_u(run: Run, true_nT: np.ndarray, noise_nT: float = 10.0) -> np.ndarray:
    """Of 200 references as wrong as they are declared, and of noise: rms found less the true one, over its u."""
    draw, truth, z = np.random.default_rng(3), float(np.sqrt(np.mean(true_nT**2))), []
    told = positions(run, u_scale_ppm=400.0, u_offset_nT=30.0)
    field = told.reference_vector
    for _ in range(200):
        wrong = field * (1 + 400e-6 * draw.normal()) + 30.0 * draw.normal(size=3)
        noise = noise_nT * draw.normal(size=len(field))

        def errors(seen: Run, noise: np.ndarray = noise) -> np.ndarray:
            return 50_000.0 + true_nT + noise - np.linalg.norm(in_body(seen), axis=1)

        there = replace(told, reference_vector=wrong)
        z.append((rms(errors(there)) - truth) / u_of_size(there, errors, rms, noise_nT))
    return np.array(z)


@pytest.mark.parametrize(
    "size_nT",
    [
        pytest.param(0.0, marks=pytest.mark.slow),
        20.0,
        pytest.param(40.0, marks=pytest.mark.slow),
        pytest.param(300.0, marks=pytest.mark.slow),
    ],
)
def test_an_rms_is_as_uncertain_as_all_that_raises_it(run: Run, size_nT: float) -> None:
    """Scale, three zeros and noise raise it together, whatever the device's own error is."""
    z = errors_over_u(run, size_nT * np.array([1.0, -1.0, 0.5, 1.2, -0.7, 0.9]))
    assert np.mean(np.abs(z) < 2.0001) > 0.92
    assert np.sqrt(np.mean(z**2)) > (0.7 if size_nT in (0.0, 300.0) else 0.5)  # nor by being far too large


def test_one_sentence_names_what_a_verdict_leaves_out(run: Run) -> None:
    said = uncovered(positions(run), ["the supplies' read-back"])
    assert said.startswith("Not covered by the uncertainties: ")
    assert said.endswith("The supplies' read-back.")
    assert "scale, zero, alignment" in said

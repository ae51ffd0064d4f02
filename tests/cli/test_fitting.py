from __future__ import annotations

import csv
import json
from pathlib import Path

import numpy as np
import pytest

from labcal.certificate import read_calibration
from labcal.cli import execute
from labcal.fit import METHODS
from labcal.store import read_bundle

PRACTICE = "data/practice/p01"
FIT_KEYS = {
    "method", "ok", "why_not", "K", "k_nT", "covariance", "frame_known", "bias_nT",
    "rms_scalar_nT", "holdout_rms_scalar_nT", "axis_error_deg", "seconds", "effects",
}  # fmt: skip


@pytest.fixture(scope="module")
def drafted(shared: Path, tmp_path_factory: pytest.TempPathFactory) -> bytes:
    """The draft that `labcal fit` makes of a practice run."""
    out = tmp_path_factory.mktemp("drafted") / "cal.json"
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("LABCAL_HOME", str(out.parent / "home"))
        assert execute(["fit", str(shared / PRACTICE / "bundle"), "--out", str(out)]) == 0
    return out.read_bytes()


@pytest.fixture
def calibration(drafted: bytes, tmp_path: Path) -> Path:
    """That draft, for one test alone."""
    (out := tmp_path / "cal.json").write_bytes(drafted)
    return out


def test_fit_json_on_stdout_is_the_contracts_and_nothing_else(shared: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert execute(["fit", str(shared / PRACTICE / "bundle"), "--json", "-"]) == 0
    said = json.loads(capsys.readouterr().out)
    assert said.keys() == {"format", "run_id", "n_samples", "fits"}
    assert (said["format"], said["n_samples"]) == ("labcal-fit/1", 1788)
    (found,) = said["fits"]
    assert found.keys() == FIT_KEYS
    assert np.shape(found["covariance"]) == (12, 12)
    assert found["method"] == "ml"
    assert found["ok"]
    assert found["frame_known"]
    assert len(found["axis_error_deg"]) == 6


def test_apply_comes_as_near_to_the_true_field_as_the_noise_allows(
    shared: Path, calibration: Path, tmp_path: Path
) -> None:
    fresh, out = shared / PRACTICE / "fresh/samples.csv", tmp_path / "out.csv"
    assert execute(["apply", str(calibration), str(fresh), "--out", str(out), "--dut", "SN328"]) == 0
    truth = json.loads((shared / PRACTICE / "truth.json").read_text())
    rows, true = (
        list(csv.DictReader(path.read_text().splitlines())) for path in (out, shared / PRACTICE / "truth_fresh.csv")
    )
    assert [row["t_s"] for row in rows] == [row["t_s"] for row in true]
    valid = np.array([row["valid"] == "1" for row in true])
    field, expected = (np.array([[float(row[f"b_{a}"]) for a in "xyz"] for row in table]) for table in (rows, true))
    error = np.sqrt(np.mean(np.sum((field - expected)[valid] ** 2, axis=1)))
    per_reading = np.linalg.inv(truth["S"]) * truth["unit_nT"]
    noise = truth["noise_nT_per_axis"] * np.sqrt(np.trace(per_reading @ per_reading.T))
    assert error < 1.05 * noise
    stated = np.array([float(row["u_nT"]) for row in rows])[valid]
    assert np.sqrt(3 * np.mean(stated**2)) == pytest.approx(error, rel=0.1)


def test_apply_keeps_every_row_and_cell(shared: Path, calibration: Path, tmp_path: Path) -> None:
    fresh, out = shared / PRACTICE / "fresh/samples.csv", tmp_path / "out.csv"
    assert execute(["apply", str(calibration), str(fresh), "--out", str(out)]) == 0
    before, after = fresh.read_text().splitlines(), out.read_text().splitlines()
    assert after[0] == before[0] + ",b_x,b_y,b_z,u_nT,flag"
    assert [line.rsplit(",", 5)[0] for line in after] == before


def test_another_serial_is_refused_and_nothing_is_written(shared: Path, calibration: Path, tmp_path: Path) -> None:
    out = tmp_path / "out.csv"
    fresh = str(shared / PRACTICE / "fresh/samples.csv")
    assert execute(["apply", str(calibration), fresh, "--out", str(out), "--dut", "SN999"]) == 2
    assert not out.exists()


@pytest.mark.parametrize(
    ("text", "place"),
    [
        ("dut_x,dut_y\n1,2\n", "dut_z"),
        ("dut_x,dut_y,dut_z\n1,2,3\n1,oops,3\n", "line 3, column dut_y"),
        ("dut_x,dut_y,dut_z\n1,2\n", "line 2"),
        ("dut_x,dut_y,dut_z,flag\n1,2,3,\n", "flag"),
        ("", "line 1"),
    ],
)
def test_bad_readings_are_a_sentence_with_the_place(
    calibration: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str], text: str, place: str
) -> None:
    bad = tmp_path / "bad.csv"
    bad.write_text(text)
    assert execute(["apply", str(calibration), str(bad), "--out", str(tmp_path / "out.csv")]) == 2
    assert place in capsys.readouterr().err
    assert not (tmp_path / "out.csv").exists()


def test_the_draft_says_where_it_comes_from_and_where_it_holds(shared: Path, calibration: Path) -> None:
    made = read_calibration(calibration)
    assert (made.run_id, made.dut.serial, made.simulated) == ("r82d47edd", "SN328", True)
    magnitude = read_bundle(shared / PRACTICE / "bundle").magnitude_nT
    assert made.validity.field_nT == (magnitude.min(), magnitude.max())
    assert made.validity.modes == ("full-power", "nominal")
    assert made.metrics["after"]["noise_nT"] == pytest.approx(25.0, rel=0.1)
    assert not made.approvers


def test_a_run_that_determines_nothing_is_a_negative_result(shared: Path, tmp_path: Path) -> None:
    out = tmp_path / "cal.json"
    assert execute(["fit", str(shared / "data/px4-battery-current"), "--out", str(out)]) == 1
    assert not out.exists()


def test_currents_that_depend_on_each_other_are_named(
    bench_run: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("COLUMNS", "200")
    assert execute(["fit", str(bench_run), "--method", "telemetry"]) == 1
    assert "the currents i_panel, i_total are linearly dependent" in capsys.readouterr().out
    assert execute(["fit", str(bench_run), "--method", "telemetry", "--channels", "i_panel,i_load", "--json", "-"]) == 0
    (found,) = json.loads(capsys.readouterr().out)["fits"]
    assert [effect["channels"] for effect in found["effects"]] == [["i_panel"], ["i_load"]]


def test_all_methods_stand_side_by_side_with_what_the_columns_mean(
    bench_run: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("COLUMNS", "200")
    execute(["fit", str(bench_run), "--method", "all"])
    said = capsys.readouterr().out
    assert all(f" {method} " in said for method in METHODS)
    assert "standard uncertainties of the offsets" in said


@pytest.fixture
def bench_run(tmp_path: Path) -> Path:
    """A bundle of a sensor that tumbles, with two currents that move its offset and their sum."""
    random = np.random.default_rng(0)
    direction = random.standard_normal((400, 3))
    field = direction / np.linalg.norm(direction, axis=1, keepdims=True) * random.uniform(2e4, 5e4, (400, 1))
    current = random.uniform(0, 1, (400, 2))
    reading = field + [500.0, -300.0, 200.0] + current @ [[900.0, 0, 0], [0, 700.0, 0]] + random.normal(0, 20, (400, 3))
    names = ("i_panel", "i_load", "i_total")
    header = {
        "format": "labcal-run/1", "run_id": "r1", "started_utc": "2026-01-01T00:00:00Z", "simulated": True,
        "operator": "",
        "dut": {"serial": "s", "model": "m", "unit": "nT", "nominal_nT_per_unit": 1.0, "noise_nT": 20.0},
        "reference": {"kind": "scalar", "serial": "r", "noise_nT": None},
        "segments": [{"id": "all", "kind": "free", "mode": "nominal", "note": ""}],
        "channels": {name: {"unit": "A", "quantity": "current"} for name in names},
    }  # fmt: skip
    (tmp_path / "run.json").write_text(json.dumps(header))
    columns = [np.arange(400.0), *reading.T, np.linalg.norm(field, axis=1), *current.T, 2 * current[:, 0]]
    with (tmp_path / "samples.csv").open("w", newline="") as file:
        rows = csv.writer(file)
        rows.writerow(["t_s", "segment", "dut_x", "dut_y", "dut_z", "ref_f", *names])
        rows.writerows([t, "all", *rest] for t, *rest in np.column_stack(columns).tolist())
    return tmp_path


def test_unknown_methods_and_channels_are_refused(shared: Path, capsys: pytest.CaptureFixture[str]) -> None:
    run = str(shared / PRACTICE / "bundle")
    assert execute(["fit", run, "--method", "magic"]) == 2
    said = capsys.readouterr().err
    assert all(name in said for name in METHODS)
    assert execute(["fit", run, "--channels", "nothing"]) == 2
    assert "hk01" in capsys.readouterr().err


def test_a_recording_is_never_replaced_by_what_is_corrected(shared: Path, calibration: Path, tmp_path: Path) -> None:
    recording = tmp_path / "in.csv"
    recording.write_text("dut_x,dut_y,dut_z,t_s\n20000,0,0,2026-11-21T08:00:00\n")
    before = recording.read_bytes()
    assert execute(["apply", str(calibration), str(recording), "--out", str(recording)]) == 2
    assert recording.read_bytes() == before
    assert execute(["apply", str(calibration), str(recording), "--out", str(tmp_path / "no_t_s_needed.csv")]) == 0


def test_a_bundle_in_the_place_of_its_table_is_told_which_file_to_name(
    shared: Path, calibration: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert execute(["apply", str(calibration), str(shared / PRACTICE / "fresh"), "--out", str(tmp_path / "o.csv")]) == 2
    assert "is a folder: name the table of readings, of a bundle its samples.csv" in capsys.readouterr().err


def test_a_crafted_effect_is_refused_with_the_file_and_its_place(
    shared: Path, calibration: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    stated = json.loads(calibration.read_text())
    parameters = [{"name": f"c_{a}", "value": 1, "u": 0, "unit": "nT"} for a in "xy"]
    lag = {"effect": "offset-step", "channels": [], "reference_value": {}, "belongs_to": "sensor"}
    stated["effects"] = [lag | {"parameters": [*parameters, {**parameters[0], "name": "t_step_s"}]}]
    calibration.write_text(json.dumps(stated))
    fresh, out = shared / PRACTICE / "fresh/samples.csv", tmp_path / "out.csv"
    assert execute(["apply", str(calibration), str(fresh), "--out", str(out)]) == 2
    assert f"{calibration}: effects[0]: the effect offset-step is not whole" in capsys.readouterr().err
    assert not out.exists()

"""`labcal runs`, `show`, `import`, `export`: what they print, and the exit code of what is wrong."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

import pytest

from labcal.cli import execute as labcal
from labcal.record import Dut, Reference, RunHeader
from labcal.record.stream import Measurement
from labcal.store import Store

GOLDEN = Path(__file__).parents[1] / "golden" / "bundle-1"
RUN_ID = "20260302-081500-SN1"


def test_a_bundle_goes_in_is_shown_and_comes_out_the_same(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert labcal(["runs"]) == 0
    assert "no runs yet" in capsys.readouterr().out
    assert labcal(["import", str(GOLDEN)]) == 0
    assert capsys.readouterr().out == f"{RUN_ID}\n"
    assert labcal(["runs"]) == 0
    assert "imported" in capsys.readouterr().out
    assert labcal(["show", RUN_ID]) == 0
    shown = capsys.readouterr().out
    assert all(word in shown for word in ("SIMULATED", "Ana Müller", "x-20uT", "vector", "temp_dut", "remote"))
    assert labcal(["export", RUN_ID, "--format", "bundle", "--out", str(tmp_path / "out")]) == 0
    for name in ("run.json", "samples.csv"):
        assert (tmp_path / "out" / name).read_bytes() == (GOLDEN / name).read_bytes()
    for format_ in ("csv", "hdf5", "mat"):
        assert labcal(["export", RUN_ID, "--format", format_, "--out", str(tmp_path / format_)]) == 0
    assert (tmp_path / "csv").read_bytes() == (GOLDEN / "samples.csv").read_bytes()


def test_the_list_of_runs_loads_no_numbers_no_tables_and_no_window() -> None:
    header = RunHeader("r9", "2026-03-02T08:15:00Z", True, "", Dut("S"), Reference("none"), procedure="ambient")
    with Store.open() as store, store.begin(header):
        pass
    list_runs = "import sys; from labcal.cli import execute; assert execute(['runs']) == 0; print(*sys.modules)"
    said = subprocess.run([sys.executable, "-c", list_runs], capture_output=True, text=True, check=True).stdout
    assert said.splitlines()[1].startswith("r9 ")
    heavy = {"numpy", "scipy", "rich", "matplotlib", "h5py", "cryptography", "serial", "PySide6", "labcal.session"}
    heavy |= {"pydantic", "labcal.cli.bench"}
    assert not heavy & {*said.splitlines()[-1].split()}


def test_of_many_segments_the_first_are_shown_and_json_has_all(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    head = json.loads((GOLDEN / "run.json").read_text(encoding="utf-8"))
    first, second = ({"id": f"{letter}{n}", "kind": "free"} for letter, n in (("a", 0), ("b", 0)))
    head |= {"segments": [first, second, *({"id": f"s{n}", "kind": "free"} for n in range(1_998))], "channels": {}}
    (tmp_path / "run.json").write_text(json.dumps(head))
    rows = "0,b0,1,2,3,0,3,4\n1,a0,1,2,3,0,6,8\n2,b0,1,2,,0,5,12\n"
    (tmp_path / "samples.csv").write_text(f"t_s,segment,dut_x,dut_y,dut_z,ref_x,ref_y,ref_z\n{rows}")
    assert labcal(["show", str(tmp_path)]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert len(lines) < 600
    assert "… and 1500 more segments: --json has all 2000" in lines
    assert labcal(["show", str(tmp_path), "--json", "-"]) == 0
    said = json.loads(capsys.readouterr().out)["segments"]
    counts = [(one["id"], one["n_samples"], one["duration_s"], one["missing"], one["magnitude_nT"]) for one in said[:3]]
    assert counts == [("a0", 1, 0.0, 0, [10.0, 10.0]), ("b0", 2, 2.0, 1, [5.0, 13.0]), ("s0", 0, 0.0, 0, None)]
    assert len(said) == 2_000


def test_json_is_alone_on_standard_output(capsys: pytest.CaptureFixture[str]) -> None:
    labcal(["import", str(GOLDEN)])
    capsys.readouterr()
    assert labcal(["show", str(GOLDEN), "--json", "-"]) == 0
    told = json.loads(capsys.readouterr().out)
    assert [segment["offers"] for segment in told["segments"]] == ["vector", "vector"]
    assert labcal(["runs", "--json", "-"]) == 0
    assert json.loads(capsys.readouterr().out)[0]["run_id"] == RUN_ID


def test_a_recorded_run_shows_its_measurements(capsys: pytest.CaptureFixture[str]) -> None:
    header = RunHeader("r9", "2026-03-02T08:15:00Z", True, "", Dut("S"), Reference("none"), procedure="ambient")
    with Store.open() as store, store.begin(header) as writer:
        writer.write(Measurement(1.0, "closure", 3.0, 0.5, "nT", 10.0))
        writer.write(Measurement(1.0, "[drift]", float("nan"), 0.5, "nT"))
    assert labcal(["show", "r9"]) == 0
    shown = capsys.readouterr().out
    assert all(word in shown for word in ("closure", "PASS", "[drift]", "ambient", "finished"))
    assert labcal(["show", "r9", "--json", "-"]) == 0
    assert json.loads(capsys.readouterr().out)["measurements"][1]["value"] is None


@pytest.mark.parametrize(
    "arguments",
    [
        ["show", "nothing"],
        ["show", "no/such/bundle"],
        ["import", "nothing.zip"],
        ["import", "."],
        ["export", "nothing", "--format", "csv", "--out", "x.csv"],
        ["export", str(GOLDEN), "--format", "xls", "--out", "x.csv"],
        ["export", str(GOLDEN), "--format", "csv", "--out", "no/such/folder/x.csv"],
    ],
)
def test_a_wrong_request_is_one_sentence_and_exit_2(
    arguments: list[str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    assert labcal(arguments) == 2
    told = capsys.readouterr()
    assert not told.out
    assert "Traceback" not in told.err
    assert told.err.strip()
    assert not list(tmp_path.iterdir())


def test_a_folder_of_the_run_s_name_does_not_hide_the_run(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / RUN_ID).mkdir()
    labcal(["import", str(GOLDEN)])
    assert labcal(["show", RUN_ID]) == 0
    assert labcal(["export", RUN_ID, "--format", "bundle", "--out", RUN_ID]) == 0
    assert labcal(["show", RUN_ID]) == 0
    assert "not in the store" in capsys.readouterr().out


def test_an_export_that_fails_leaves_the_bundle_that_was_there(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "samples.csv").write_text("old")
    (tmp_path / "run.json").mkdir()
    assert labcal(["export", str(GOLDEN), "--format", "bundle", "--out", str(tmp_path)]) == 2
    assert "run.json: is a folder" in capsys.readouterr().err
    assert (tmp_path / "samples.csv").read_text() == "old"
    assert sorted(path.name for path in tmp_path.iterdir()) == ["run.json", "samples.csv"]

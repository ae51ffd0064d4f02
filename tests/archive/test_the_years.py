"""What the years ask of the archive: a sensor's drift, the fleet, and a watch for new runs."""

from __future__ import annotations

import json
from dataclasses import asdict
from pathlib import Path

import numpy as np
import pytest
from conftest import Bundle
from cryptography.hazmat.primitives.asymmetric.ed25519 import Ed25519PrivateKey
from fleet import build
from made_up import Years, fill
from postgres import Server

from labcal.certificate import sshsig
from labcal.cli import execute as labcal
from labcal.errors import InputError
from labcal.session import archiving
from labcal.session.figures import SensorFigure, place_of
from labcal.study.fleet import fetched, fleet_jobs
from labcal.study.specification import FleetStudy, read_study

FLEET = Years(16, 6)


def test_a_sensor_s_drift_and_the_fleet_are_read_from_the_archive(
    postgres: Server, database: str, url: str, capsys: pytest.CaptureFixture[str]
) -> None:
    fill(postgres, database, FLEET)
    assert labcal(["intervals", "S0001", "--archive", url, "--json", "-"]) == 0
    found = json.loads(capsys.readouterr().out)
    x = next(one for one in found["figures"] if one["quantity"] == "offset x")
    assert x["values"] == pytest.approx(FLEET.offsets[1, :, 0].tolist())
    assert labcal(["intervals", "S9999", "--archive", url]) == 2
    capsys.readouterr()
    assert labcal(["fleet", "--archive", url, "--json", "-"]) == 0
    fleet = json.loads(capsys.readouterr().out)
    assert (fleet["sensors"], fleet["calibrations"]) == (16, 96)
    assert sum(sum(batches.values()) for batches in fleet["batches"].values()) == 16
    assert labcal(["fleet", "--archive", url, "--model", "M0", "--json", "-"]) == 0
    assert set(json.loads(capsys.readouterr().out)["batches"]) == {"M0"}


def test_a_check_standard_is_charted_from_the_archive(
    url: str, bundle: Bundle, capsys: pytest.CaptureFixture[str]
) -> None:
    runs = [bundle(f"cs-{number:02}", "CS-1") for number in range(10)]
    offsets = [*np.random.default_rng(4).normal(5, 2, 9).tolist(), 90.0]
    for run, offset in zip(runs, offsets, strict=True):  # the figures of each run are known already, by its content
        place = place_of(run)
        place.parent.mkdir(parents=True, exist_ok=True)
        figures = {f"{kind} {axis}": offset for kind in ("offset", "scale") for axis in "xyz"}
        place.write_text(json.dumps([asdict(SensorFigure(name, one, 1.0, "nT")) for name, one in figures.items()]))
    archiving.push(url, [str(run) for run in [*runs, bundle("other", "SN-1")]])
    assert labcal(["charts", "CS-1", "--baseline", "8"]) == 2  # the store here has none of them
    assert "the store has no finished run of CS-1" in capsys.readouterr().err
    assert labcal(["charts", "CS-1", "--baseline", "8", "--archive", url, "--json", "-"]) == 1
    found = json.loads(capsys.readouterr().out)
    assert [point for [point] in found["points"]] == [run.name.split("-CS-1")[0] for run in runs]
    assert labcal(["charts", "--bench", "bench.toml", "--archive", url]) == 2


def test_a_fleet_is_worked_out_again_from_the_archive(url: str, tmp_path: Path) -> None:
    here = build(tmp_path / "fleet", 2).parent
    key = Ed25519PrivateKey.generate()
    for file in here.glob("cal-*.json"):
        file.with_name(f"{file.name}.sshsig").write_text(sshsig.sign(file.read_bytes(), key))
    pushed = archiving.push(url, [*map(str, here.glob("cal-*.json")), *map(str, here.glob("run-*"))])
    assert (pushed.runs, pushed.calibrations, pushed.refused) == (2, 2, ())
    file = tmp_path / "study.toml"
    file.write_text(f'format = "labcal-study/1"\nkind = "fleet"\narchive = "{url}"\n')
    study = read_study(file)
    assert isinstance(study, FleetStudy)
    there, _ = fleet_jobs(fetched(study, file, tmp_path / "fetched"))
    expected, _ = fleet_jobs(FleetStudy(format="labcal-study/1", kind="fleet", runs=here))
    assert {job.key for job in there} == {job.key for job in expected}
    assert all(Path(place).is_relative_to(tmp_path / "fetched") for job in there for place in job.places.values())
    with pytest.raises(InputError, match="leave out their folders"):
        fetched(study.model_copy(update={"runs": here}), file, tmp_path / "fetched")


def test_a_watch_fetches_new_runs_of_the_archive_once(
    url: str, bundle: Bundle, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    archiving.push(url, [str(bundle())])
    words = ["watch", "--archive", url, "--once", "--out", str(tmp_path / "out"), "--json", "-"]
    assert labcal(words) in (0, 1)
    [found] = json.loads(capsys.readouterr().out)
    assert found["run"] == "demo-0"
    assert labcal(words) == 0
    assert json.loads(capsys.readouterr().out) == []

"""What the years ask of the archive: a sensor's drift, the fleet, and a watch for new runs."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from conftest import Bundle
from made_up import Years, fill
from postgres import Server

from labcal.cli import execute as labcal
from labcal.session import archiving

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

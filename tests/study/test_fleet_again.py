"""A fleet worked out again: what a new effect, or a loop that looks for causes, would do to every certificate."""

from __future__ import annotations

import csv
import shutil
from collections.abc import Mapping
from pathlib import Path

import numpy as np
import pytest
from fleet import build, sensor

from labcal import session
from labcal.cli import execute as labcal
from labcal.files.home import home
from labcal.session.signing import CALIBRATIONS
from labcal.study.run import run_study

SLOPES = (12.0, 0.0)  # nT/K of two sensors
EFFECT = 'effect = {id = "offset-temperature", channels = ["temp_dut"]}\n'


def again(folder: Path, more: str) -> list[Mapping[str, str]]:
    file = folder / "again.toml"
    file.write_text(f'format = "labcal-study/1"\nkind = "fleet"\nruns = "."\n{more}')
    assert run_study(file, folder / "out").without == 0
    with (folder / "out" / "table.csv").open(newline="") as table:
        return list(csv.DictReader(table))


@pytest.fixture
def fleet(tmp_path: Path) -> Path:
    return build(tmp_path / "fleet", 2, nT_per_K=SLOPES).parent


def test_a_new_effect_moves_the_offset_of_those_that_have_it_and_of_no_other(fleet: Path) -> None:
    before = {file.name: file.read_bytes() for file in fleet.glob("cal-*.json")}
    warm, cold = again(fleet, EFFECT)
    assert (warm["effects"], warm["effects_before"]) == ("offset-temperature temp_dut", "")
    temperature = sensor(0, 0.0).channels[0].values  # k belonged to its mean, and does now to its median
    moved_nT = SLOPES[0] * float(np.median(temperature) - np.mean(temperature))
    U = float(warm["offset x change (nT)"]) / float(warm["offset x change (U)"])
    assert 2.0 < U < 4.0  # of the calibration that stands: 2 · 25 nT / sqrt(400)
    assert float(warm["offset x change (nT)"]) == pytest.approx(moved_nT, abs=1.5 * U)
    assert (warm["worst"], abs(float(warm["worst_change_U"])) > 1) == ("offset x", True)
    assert abs(float(cold["offset x change (U)"])) < 1.5
    assert {file.name: file.read_bytes() for file in fleet.glob("cal-*.json")} == before


def test_the_loop_names_the_cause_in_those_that_have_it(fleet: Path, capsys: pytest.CaptureFixture[str]) -> None:
    warm, cold = again(fleet, 'by = "close-loop"\n')
    assert (warm["effects"], cold["effects"]) == ("offset-temperature temp_dut", "")
    assert abs(float(warm["offset x change (U)"])) > 1
    assert labcal(["study", str(fleet / "again.toml"), "--out", str(fleet / "out")]) == 0
    told = dict(line.rsplit(maxsplit=1) for line in capsys.readouterr().out.splitlines()[:3])
    assert told == {"jobs": "2", "worked out": "2", "moved": "1"}


def test_the_example_asks_it_of_this_lab_s_own(fleet: Path, capsys: pytest.CaptureFixture[str]) -> None:
    own = home() / CALIBRATIONS
    own.mkdir(parents=True)
    for number in range(len(SLOPES)):
        session.import_bundle(fleet / f"run-00{number}")
        shutil.copy(fleet / f"cal-00{number}.json", own)
    example = Path(__file__).parents[2] / "examples" / "fleet.toml"
    assert labcal(["study", str(example), "--out", str(fleet / "out")]) == 0
    told = " ".join(capsys.readouterr().out.split())
    assert "1 of 2 calibrations would move by more than their U; the largest by" in told


@pytest.mark.slow
def test_an_effect_that_is_there_already_is_not_added_twice(fleet: Path) -> None:
    for file in fleet.glob("cal-*.json"):
        file.unlink()
    session.close_loop(fleet / "run-000", fleet / "cal-000.json")
    [row] = again(fleet, EFFECT)
    assert (row["effects"], row["effects_before"]) == ("offset-temperature temp_dut",) * 2
    assert abs(float(row["worst_change_U"])) < 0.5

"""`labcal import --from`: into the store or to a bundle, the words around it, and on to `close-loop`."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest
from foreign_files import BIAS_nT, K, csv, mapping, table, tumble

from labcal import session
from labcal.cli import execute as labcal
from labcal.store import read_bundle

EXAMPLES = Path(__file__).parents[2] / "examples" / "measured"


@pytest.fixture
def log(tmp_path: Path) -> Path:
    return csv(tmp_path / "log.csv", table(tumble(300, noise_nT=20.0)))


def test_a_recording_goes_into_the_store_and_through_close_loop(
    log: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    stated = mapping(tmp_path, more='[channels.temp_dut]\ncolumn = "temp"\nunit = "degC"\n')
    assert labcal(["import", str(log), "--from", "csv", "--map", str(stated)]) == 0
    run_id = capsys.readouterr().out.strip()
    assert run_id == "log"
    assert (
        labcal(["close-loop", run_id, "--json", str(tmp_path / "loop.json"), "--out", str(tmp_path / "cal.json")]) == 0
    )
    told = json.loads((tmp_path / "loop.json").read_text())
    calibration = json.loads((tmp_path / "cal.json").read_text())
    assert told["verdict"] == "clean"
    assert told["residual_kind"] == "vector"
    assert np.allclose(np.linalg.inv(calibration["K"]), K, atol=1e-3)
    assert np.allclose(np.linalg.solve(calibration["K"], calibration["k_nT"]), BIAS_nT, atol=10)


def test_the_same_recording_gives_the_same_bytes(log: Path, tmp_path: Path) -> None:
    for name in ("one.zip", "two.zip"):
        assert (
            labcal(
                ["import", str(log), "--from", "csv", "--map", str(mapping(tmp_path)), "--out", str(tmp_path / name)]
            )
            == 0
        )
    assert (tmp_path / "one.zip").read_bytes() == (tmp_path / "two.zip").read_bytes()
    assert len(read_bundle(tmp_path / "one.zip")) == 300


def test_a_guess_goes_to_the_screen_or_to_the_mapping_and_nothing_is_imported(
    log: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert labcal(["import", str(log), "--from", "csv", "--guess"]) == 0
    shown = capsys.readouterr().out
    assert labcal(["import", str(log), "--from", "csv", "--guess", "--map", str(tmp_path / "guess.toml")]) == 0
    assert (tmp_path / "guess.toml").read_text() == shown
    assert session.runs() == []


@pytest.mark.parametrize(
    ("words", "told"),
    [
        ("--from xls", "csv, ulog, dataflash"),
        ("--from csv", "--guess --map"),
        ("--from csv --guess --out x", "for a person to check"),
        ("--from csv --map nowhere.toml", "nowhere.toml"),
        ("--from iaga --guess", "IAGA-2002"),
        ("--map map.toml", "--from"),
        ("--guess", "--from"),
    ],
)
def test_words_that_do_not_go_together_are_one_sentence(
    words: str, told: str, log: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert labcal(["import", str(log), *words.split()]) == 2
    said = capsys.readouterr().err
    assert told in said
    assert len(said.strip().splitlines()) == 1


def test_what_is_noticed_is_said_beside_the_run(log: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    lines = log.read_text().splitlines()
    log.write_text("\n".join(lines[:200] + lines[260:]) + "\n")
    assert (
        labcal(["import", str(log), "--from", "csv", "--map", str(mapping(tmp_path)), "--out", str(tmp_path / "b")])
        == 0
    )
    assert "reading: 1 gap, the longest 15.25 s" in capsys.readouterr().err


def test_a_folder_of_other_things_gets_no_bundle(log: Path, tmp_path: Path) -> None:
    before = sorted(tmp_path.iterdir())
    stated = mapping(tmp_path)
    assert labcal(["import", str(log), "--from", "csv", "--map", str(stated), "--out", str(tmp_path), "--force"]) == 2
    assert sorted(tmp_path.iterdir()) == sorted([*before, stated])


@pytest.mark.parametrize("name", sorted(path.name for path in EXAMPLES.glob("*.toml")))
def test_the_mappings_of_the_measured_data_are_read_and_say_what_makes_them(name: str) -> None:
    from labcal.importers import read_mapping

    assert read_mapping(EXAMPLES / name).dut.serial
    said = (EXAMPLES / name).read_text(encoding="utf-8")
    assert "#   git clone https://" in said
    assert f"--map {name}" in said


def test_there_are_mappings_of_four_public_sets() -> None:
    assert len(list(EXAMPLES.glob("*.toml"))) >= 4


def test_an_unknown_kind_is_told_all_that_there_are(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "log.xml").write_text("<log/>")
    assert labcal(["import", str(tmp_path / "log.xml"), "--from", "xml"]) == 2
    said = capsys.readouterr().err
    assert "imagcdf" in said
    assert "magcal" in said

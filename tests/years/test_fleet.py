"""The report of a fleet: which batch is worst, who stands out, and what is refused."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from calibrations_of_years import calibrated, kept

from labcal.cli import execute as labcal


@pytest.fixture
def fleet(tmp_path: Path) -> Path:
    """Three batches of ten; batch C drifts with temperature by 3.1 nT/K, and B-4 has an offset of its own."""
    draw, made = np.random.default_rng(1), []
    for batch, slope in (("A", 0.2), ("B", 0.1), ("C", 3.1)):
        for i in range(10):
            x = 900.0 if (batch, i) == ("B", 4) else draw.normal(0, 10)
            found = slope + draw.normal(0, 0.5)
            effect = (found, 0.3) if abs(found) > 0.6 else None
            made.append(calibrated(f"{batch}-{i}", offset_nT=(x, *draw.normal(0, 10, 2)), slope=effect))
    folder = tmp_path / "fleet"
    folder.mkdir()
    kept(folder, *made)
    return folder


def test_the_worst_batch_and_the_worst_sensor_come_first(fleet: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert labcal(["fleet", str(fleet), "--json", "-"]) == 0
    found = json.loads(capsys.readouterr().out)
    assert (found["sensors"], found["batches"]) == (30, {"EM": {"A": 10, "B": 10, "C": 10}})
    first = found["effects"][0]["pooled"]["batches"][0]
    assert first["name"] == "C"
    assert first["value"] == pytest.approx(3.1, abs=3 * first["u"])
    assert first["u"] < 0.5
    for one in found["effects"][0]["pooled"]["batches"][1:]:
        assert abs(one["value"] - {"A": 0.2, "B": 0.1}[one["name"]]) < 2 * one["u"]  # hidden in most of them
        assert found["effects"][0]["found_in"][one["name"]] < 6
    assert (found["stand_out"][0]["serial"], found["stand_out"][0]["quantity"]) == ("B-4", "offset x")


def test_the_page_says_it_in_words_and_is_there_as_html_and_pdf(
    fleet: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    page, paper = tmp_path / "fleet.html", tmp_path / "fleet.pdf"
    assert labcal(["fleet", str(fleet), "--out", str(page)]) == 0
    assert "B-4 stands out most" in capsys.readouterr().out
    assert "batch C 3." in page.read_text()
    assert labcal(["fleet", str(fleet), "--out", str(paper)]) == 0
    assert paper.read_bytes().startswith(b"%PDF")


def test_only_the_last_calibration_of_a_sensor_counts(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    kept(tmp_path, calibrated("A-1"), calibrated("A-1", day=300, offset_nT=(70.0, 0, 0)), calibrated("A-2"))
    assert labcal(["fleet", str(tmp_path), "--json", "-"]) == 0
    found = json.loads(capsys.readouterr().out)
    assert (found["sensors"], found["calibrations"]) == (2, 3)
    assert next(f for f in found["figures"] if f["quantity"] == "offset x")["most"] == pytest.approx(70.0)


def test_a_date_is_needed_only_to_tell_the_last_of_several(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    kept(tmp_path, *(replace(calibrated(name), issued_utc=None) for name in ("A-1", "A-2")))
    assert labcal(["fleet", str(tmp_path), "--json", "-"]) == 0
    assert json.loads(capsys.readouterr().out)["sensors"] == 2
    kept(tmp_path, calibrated("A-1", day=300))
    assert labcal(["fleet", str(tmp_path)]) == 2
    assert "there are several of A-1: which is last?" in capsys.readouterr().err


def test_batches_may_be_told_by_an_expression(fleet: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert labcal(["fleet", str(fleet), "--batch", r"[ABC]-([0-4])?", "--json", "-"]) == 0
    assert json.loads(capsys.readouterr().out)["batches"]["EM"]["no batch"] == 15


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["{folder}", "--batch", "("], "no regular expression"),
        (["{folder}", "--batch", "abc"], "one group"),
        (["{folder}", "--model", "XX"], "no calibration here"),
        (["{folder}/none"], "none"),
        (["{folder}", "--out", "x.doc"], "a page ends in"),
        (["{folder}", "--archive", "postgresql://x/y"], "say files, or --archive"),
    ],
)
def test_what_is_no_fleet_is_refused(
    words: list[str], said: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    kept(tmp_path, calibrated("A-1"))
    assert labcal(["fleet", *(word.format(folder=tmp_path) for word in words)]) == 2
    assert said in capsys.readouterr().err

"""The report of a fleet: which batch is worst, who stands out, and what is refused."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from calibrations_of_years import calibrated, kept, three_batches
from matplotlib.figure import Figure

from labcal.certificate import read_calibration
from labcal.cli import execute as labcal
from labcal.years.fleet import Spread
from labcal.years.fleet_page import draw_spreads


@pytest.fixture
def fleet(tmp_path: Path) -> Path:
    return three_batches(tmp_path / "fleet")


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


def test_the_page_says_it_in_words(fleet: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    page = tmp_path / "fleet.html"
    assert labcal(["fleet", str(fleet), "--out", str(page)]) == 0
    assert "B-4 stands out most" in capsys.readouterr().out
    assert "batch C 3." in page.read_text()


@pytest.mark.slow
def test_the_page_is_there_as_pdf_too(fleet: Path, tmp_path: Path) -> None:
    paper = tmp_path / "fleet.pdf"
    assert labcal(["fleet", str(fleet), "--out", str(paper)]) == 0
    assert paper.read_bytes().startswith(b"%PDF")


def test_the_distribution_of_each_figure_is_in_the_report(
    fleet: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert labcal(["fleet", str(fleet), "--json", "-", "--out", str(tmp_path / "fleet.html")]) == 0
    found = {one["quantity"]: one for one in json.loads(capsys.readouterr().out)["figures"]}
    draw = np.array([cal.affine.k_nT for cal in map(read_calibration, sorted(fleet.glob("*.json")))])
    for axis, values in zip("xyz", draw.T, strict=True):
        one = found[f"offset {axis}"]
        assert one["median"] == pytest.approx(np.median(values))
        assert (one["least"], one["most"]) == pytest.approx((values.min(), values.max()))
        assert one["robust_sigma"] == pytest.approx(1.4826 * np.median(np.abs(values - np.median(values))), rel=1e-3)
    assert "How figures are spread" in (tmp_path / "fleet.html").read_text()


def test_the_distributions_are_drawn_each_sensor_in_one_bar() -> None:
    values = np.array([0.0, 1.0, 2.0, 90.0])
    spreads = [Spread("EM", f"offset {axis}", "nT", values, 1.5, 1.5, (("S-4", 90.0, 59.0),)) for axis in "xy"]
    draw_spreads(figure := Figure(), spreads)
    drawn = [axes for axes in figure.axes if axes.patches]
    assert len(drawn) == 2
    assert [sum(bar.get_height() for bar in axes.patches) for axes in drawn] == [len(values)] * 2


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

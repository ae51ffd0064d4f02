"""What is wrong with the data is said, by the command, and no effect is named for it."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
import pytest

from labcal import session
from labcal.loop.close import prepare
from labcal.loop.data.checks import check_data

Closed = Callable[[Path], tuple[int, dict[str, Any], str]]


def _said(result: dict[str, Any]) -> str:
    return result["summary"] + " ".join(f["says"] for f in result["findings"])


def test_too_few_samples_are_refused_with_their_number(making: ModuleType, tmp_path: Path, closed_loop: Closed) -> None:
    rows, segments = making.recorded()
    bundle = making.written(tmp_path, {name: values[:20] for name, values in rows.items()}, segments)
    code, result, error = closed_loop(bundle)
    assert (code, result) == (2, {})
    assert "20 rows" in error


def test_a_plain_run_is_clean_and_nothing_is_found(making: ModuleType, tmp_path: Path, closed_loop: Closed) -> None:
    code, result, _ = closed_loop(making.written(tmp_path, *making.recorded()))
    assert (code, result["verdict"], result["accepted"], result["findings"]) == (0, "clean", [], [])


def test_one_axis_alone_names_no_effect(making: ModuleType, tmp_path: Path, closed_loop: Closed) -> None:
    _, result, _ = closed_loop(making.written(tmp_path, *making.recorded(axes="z", seconds=90)))
    assert result["accepted"] == []


def test_one_axis_of_a_sensor_that_is_not_square_says_what_is_not_excited(
    making: ModuleType, tmp_path: Path, closed_loop: Closed
) -> None:
    rows, segments = making.recorded(axes="z", seconds=90)
    rows = {name: values[rows["segment"] == segments[0]["id"]] for name, values in rows.items()}
    rows["dut"] = rows["dut"] @ np.array([[1.0, 0.01, -0.02], [0.015, 0.98, 0.01], [0.0, 0.02, 1.03]])
    code, result, _ = closed_loop(making.written(tmp_path, rows, segments[:1]))
    assert (code, result["verdict"], result["accepted"]) == (1, "unexplained", [])
    assert "does not determine the whole map" in result["summary"]
    assert result["next_experiment"]["procedure"] == "preflight"


def test_constant_and_empty_channels_name_no_effect(making: ModuleType, tmp_path: Path, closed_loop: Closed) -> None:
    rows, segments = making.recorded()
    rows["temp"][:], rows["i_load"][:] = 20.0, np.nan
    code, result, _ = closed_loop(making.written(tmp_path, rows, segments))
    assert (code, result["verdict"]) == (0, "clean")
    assert "no value in this run: i_load" in _said(result)
    assert "one value all through this run: temp" in _said(result)


def test_text_in_a_channel_is_refused_with_line_and_column(
    making: ModuleType, tmp_path: Path, closed_loop: Closed
) -> None:
    bundle = making.written(tmp_path, *making.recorded())
    lines = (bundle / "samples.csv").read_text().splitlines()
    cells = lines[8].split(",")
    lines[8] = ",".join([*cells[:-2], "warm", cells[-1]])
    (bundle / "samples.csv").write_text("\n".join(lines) + "\n")
    code, result, error = closed_loop(bundle)
    assert (code, result) == (2, {})
    assert all(word in error for word in ("line 9", "temp", "warm"))


@pytest.mark.slow
def test_a_cause_with_gaps_in_its_channel_is_found(making: ModuleType, tmp_path: Path, closed_loop: Closed) -> None:
    rows, segments = making.recorded()
    rows["dut"] += (rows["temp"] - 20)[:, None] * [40.0, -30.0, 20.0]
    rows["temp"][np.random.default_rng(1).random(len(rows["temp"])) < 0.2] = np.nan
    rows["temp"][200:280] = np.nan
    code, result, _ = closed_loop(making.written(tmp_path, rows, segments))
    assert (code, [e["effect"] for e in result["accepted"]]) == (0, ["offset-temperature"])


@pytest.mark.slow
def test_two_identical_channels_are_rivals_and_called_one_signal(
    making: ModuleType, tmp_path: Path, closed_loop: Closed
) -> None:
    rows, segments = making.recorded()
    rows["dut"] += (rows["temp"] - 20)[:, None] * [40.0, -30.0, 20.0]
    rows["temp_two"] = rows["temp"].copy()
    channels = {**making.CHANNELS, "temp_two": making.CHANNELS["temp"]}
    code, result, _ = closed_loop(making.written(tmp_path, rows, segments, channels))
    assert (code, result["verdict"]) == (1, "ambiguous")
    assert "temp_two) does as well" in result["summary"] or "temp) does as well" in result["summary"]
    assert any("does as well as" in other["why"] and other["holdout_rms_after_nT"] for other in result["rejected"])
    cause = result["accepted"][0]
    assert {*cause["channels"], *(c for r in cause["rivals"] for c in r["channels"])} == {"temp", "temp_two"}
    assert "temp and temp_two are one signal" in _said(result)


def _flip(rows: dict[str, Any]) -> None:
    rows["ref"] = rows["ref"] * [1, 1, -1]


def _swap(rows: dict[str, Any]) -> None:
    rows["ref"] = rows["ref"][:, [1, 0, 2]]


def _into_body(rows: dict[str, Any]) -> None:
    rows["ref"] = (rows["dut"] - 800) / 1.05


def _backwards(rows: dict[str, Any]) -> None:
    rows["angle"] = -rows["angle"]


@pytest.mark.parametrize(
    ("spoil", "words"),
    [
        (_flip, "reference's z flipped"),
        pytest.param(_swap, "reference's x and y swapped", marks=pytest.mark.slow),
        pytest.param(_into_body, "in the body's frame, not the cage's", marks=pytest.mark.slow),
        pytest.param(_backwards, "angle counted the other way", marks=pytest.mark.slow),
    ],
)
def test_a_reference_in_another_frame_is_said_and_nothing_is_searched(
    making: ModuleType, tmp_path: Path, closed_loop: Closed, spoil: Callable[[dict[str, Any]], None], words: str
) -> None:
    rows, segments = making.recorded()
    spoil(rows)
    code, result, _ = closed_loop(making.written(tmp_path, rows, segments))
    assert (code, result["verdict"], result["accepted"]) == (1, "unexplained", [])
    assert words in result["summary"]
    assert result["findings"][0]["belongs_to"] == "data"


def _radians(rows: dict[str, Any]) -> None:
    rows["angle"] = np.radians(rows["angle"])


def _microtesla(rows: dict[str, Any]) -> None:
    rows["dut"] = rows["dut"] / 1000


def _reference_in_microtesla(rows: dict[str, Any]) -> None:
    rows["ref"] = rows["ref"] / 1000


def _stuck(rows: dict[str, Any]) -> None:
    rows["dut"][:, 1] = 812.0


@pytest.mark.parametrize(
    ("spoil", "kind", "words"),
    [
        (_radians, "reference-frame", "angle taken in radians"),
        (_microtesla, "units", "nominal_nT_per_unit"),
        (_reference_in_microtesla, "units", "not as declared"),
        (_stuck, "dead-axis", "along y is the same in every row"),
    ],
)
def test_another_unit_or_a_dead_axis_is_said(
    making: ModuleType, tmp_path: Path, spoil: Callable[[dict[str, Any]], None], kind: str, words: str
) -> None:
    rows, segments = making.recorded()
    spoil(rows)
    problem, level, _ = prepare(session.load_run(str(making.written(tmp_path, rows, segments))))
    finding = check_data(problem, level)
    assert finding is not None
    assert finding.kind == kind
    assert words in finding.says


def test_a_large_offset_in_a_small_field_is_no_other_unit(making: ModuleType, tmp_path: Path) -> None:
    rows, segments = making.recorded()
    rows["dut"], rows["ref"] = 90_000 + rows["dut"] / 100, rows["ref"] / 100
    problem, level, _ = prepare(session.load_run(str(making.written(tmp_path, rows, segments))))
    assert check_data(problem, level) is None


@pytest.mark.parametrize("late", [5, pytest.param(-7, marks=pytest.mark.slow)])
def test_clocks_apart_by_seconds_are_said_with_their_seconds(
    making: ModuleType, tmp_path: Path, closed_loop: Closed, late: int
) -> None:
    rows, segments = making.recorded()
    rows["dut"] = np.roll(rows["dut"], late, axis=0)
    code, result, _ = closed_loop(making.written(tmp_path, rows, segments))
    assert (code, result["verdict"], result["accepted"]) == (1, "unexplained", [])
    way = "late" if late > 0 else "early"
    assert f"the device under test seem {abs(late) / 2:.1f} s {way}" in result["summary"]


def test_a_device_mounted_otherwise_than_declared_is_no_flipped_reference(
    making: ModuleType, tmp_path: Path, closed_loop: Closed
) -> None:
    rows, segments = making.recorded()
    rows["dut"] = rows["dut"] @ np.array([[0.0, -1, 0], [1, 0, 0], [0, 0, 1]])
    code, result, _ = closed_loop(making.written(tmp_path, rows, segments))
    assert (code, result["verdict"]) == (0, "clean")
    assert [f["kind"] for f in result["findings"]] == ["axes"]
    assert "turns the axes" in _said(result)


def test_an_axis_of_the_device_that_reads_the_wrong_sign_is_said(
    making: ModuleType, tmp_path: Path, closed_loop: Closed
) -> None:
    rows, segments = making.recorded()
    rows["dut"] = rows["dut"] * [1, -1, 1]
    code, result, _ = closed_loop(making.written(tmp_path, rows, segments))
    assert (code, result["verdict"]) == (0, "clean")
    assert "mirrors the axes" in _said(result)


def test_readings_that_have_nothing_to_do_with_the_reference_are_called_so(
    making: ModuleType, tmp_path: Path, closed_loop: Closed
) -> None:
    rows, segments = making.recorded()
    rows["dut"] = np.random.default_rng(2).normal(0, 30000, rows["dut"].shape)
    code, result, error = closed_loop(making.written(tmp_path, rows, segments))
    assert code in (1, 2)
    said = _said(result) if result else error
    assert "do not follow the reference" in said or "determine" in said

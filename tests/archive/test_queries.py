"""What the archive is asked: the right answers, and soon enough with ten years of five hundred sensors."""

from __future__ import annotations

import json
import time
from collections.abc import Callable
from datetime import UTC, datetime

import pytest
from made_up import Years, copy, fill
from postgres import Server

from labcal.cli import execute as labcal
from labcal.session import archiving

SMALL, LARGE = Years(20, 10), Years(500, 10)
SINCE = datetime(2020, 1, 1, tzinfo=UTC)
AT_MOST_S = 2.0
ASKED: dict[str, tuple[dict[str, object], Callable[[Years], set[str]]]] = {
    "touched by a reference": (
        {"instrument": "R3", "since": SINCE},
        lambda years: years.touched("R3", SINCE),
    ),
    "changed by more than U": ({"changed": True}, Years.changed),
    "drift of a model above": (
        {"model": "M0", "effect": "offset-drift", "above": (4.5e-3, "nT/s")},
        lambda years: years.drifting(0, 4.5e-3),
    ),
}


def answers(url: str, years: Years) -> None:
    """Ask all, and look at the answers."""
    for question, (wanted, expected) in ASKED.items():
        found = archiving.archived_calibrations(url, **wanted)
        assert {one["run_id"] for one in found} == expected(years) != set(), question
        assert len(found) == len(expected(years)), question


def test_what_is_asked_is_answered_rightly(postgres: Server, database: str, url: str) -> None:
    fill(postgres, database, SMALL)
    answers(url, SMALL)


def test_of_two_calibrations_of_one_run_the_one_that_was_issued_later_is_the_later(
    postgres: Server, database: str, url: str
) -> None:
    """A run of 2020 calibrated twice, its offset 0 and then 100 nT, whose hash comes first; one of 2021 with 100 nT."""
    made = [("z", 2020, 1, 0.0), ("a", 2020, 2, 100.0), ("m", 2021, 3, 100.0)]
    sensor = (True, "S", "M", "nT", "ada")
    columns = "site sha256 run_sha256 run_id simulated dut_serial dut_model dut_unit operator issued_utc content"
    issued = [datetime(2022, 1, day, tzinfo=UTC) for _, _, day, _ in made]
    rows = [("aalto", one[0], f"r{one[1]}", one[0], *sensor, utc, b"{}") for one, utc in zip(made, issued, strict=True)]
    copy(postgres, database, "calibration", columns, rows)
    columns = "site sha256 run_id started_utc status simulated dut_serial dut_model dut_unit operator procedure "
    columns += "reference_kind reference_serial n_samples bundle_sha256 bundle_bytes"
    runs = [("aalto", f"r{y}", f"r{y}", datetime(y, 1, 1, tzinfo=UTC), "finished", *sensor, *[""] * 3, 0, "", 0)
            for y in (2020, 2021)]  # fmt: skip
    copy(postgres, database, "run", columns, runs)
    offsets = [("aalto", name, 0, "figure", "offset x", offset, 1.0, "nT") for name, _, _, offset in made]
    copy(postgres, database, "parameter", "site calibration number of name value u unit", offsets)
    assert [one["run_id"] for one in archiving.archived_calibrations(url, changed=True)] == ["a"]


def processor_s(server: Server, url: str, question: str, times: int = 5) -> float:
    """What the server and whoever asks take of a processor for a question: what it takes where nobody else is busy."""
    wanted, _ = ASKED[question]
    archiving.archived_calibrations(url, **wanted)  # the first has to load what asks
    begun = server.busy_s() + time.process_time()
    for _ in range(times):
        archiving.archived_calibrations(url, **wanted)
    return (server.busy_s() + time.process_time() - begun) / times


@pytest.mark.slow
def test_ten_years_of_five_hundred_sensors_are_asked_in_two_seconds(postgres: Server, database: str, url: str) -> None:
    fill(postgres, database, LARGE)
    answers(url, LARGE)
    took = {question: processor_s(postgres, url, question) for question in ASKED}
    assert max(took.values()) < AT_MOST_S, took


def test_the_command_says_what_fits(
    postgres: Server, database: str, url: str, capsys: pytest.CaptureFixture[str]
) -> None:
    fill(postgres, database, Years(8, 10))
    drift = ["archive", "calibrations", "--archive", url, "--effect", "offset-drift", "--above", "0.0085 nT/s"]
    assert labcal(drift) == 0
    shown = capsys.readouterr().out
    assert "c1_y -0.009 ± 1e-05 nT/s" in shown
    assert len(shown.splitlines()) == 3  # sensors 0 and 7, the last year, and the heads
    assert labcal([*drift, "--json", "-"]) == 0
    told = json.loads(capsys.readouterr().out)
    assert [(one["dut_serial"], round(one["value"], 9)) for one in told] == [("S0000", -0.009), ("S0007", -0.009)]
    assert labcal(["archive", "calibrations", "--archive", url, "--changed", "--dut", "S0001", "--json", "-"]) == 0
    for one in json.loads(capsys.readouterr().out):
        assert abs(one["left"] - one["found"]) > one["U"] == pytest.approx(2 * 2**0.5 * 3)
    assert labcal(["runs", "--archive", url]) == 0
    assert len(capsys.readouterr().out.splitlines()) == 81


@pytest.mark.parametrize(
    ("words", "told"),
    [
        (["--above", "0.1"], "--above is a value with its unit"),
        (["--above", "nan nT"], "--above is a value with its unit"),
        (["--above", "1 nT"], "say which effect"),
        (["--above", "1e400 nT"], "--above is a value with its unit"),
        (["--since", "yesterday"], "'yesterday' is no date"),
    ],
)
def test_a_question_that_is_none_is_refused(
    words: list[str], told: str, url: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert labcal(["archive", "calibrations", "--archive", url, *words]) == 2
    assert told in capsys.readouterr().err

"""Preflight, fit, draft, and verify on positions that the fit has never seen; an orbit played with its error."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from labcal import session

Run = Callable[..., Any]


def test_verify_passes_the_calibration_that_a_preflight_gave_and_fails_another(ran: Run, tmp_path: Path) -> None:
    run_id = ran("preflight", modes="nominal", rate_deg_per_s=10, zero_s=3, dwell_s=2).outcome.run_id
    _, (found,) = session.fit_run(run_id)
    session.draft(run_id, found, tmp_path / "CAL.json")
    good = ran("verify", positions=8, dwell_s=2, calibration=tmp_path / "CAL.json")
    assert good.value("before: rms magnitude error") > 500
    assert good.value("after: rms magnitude error") < 25
    assert good.value("after: rms heading error") < 0.05
    shifted = "dut = { bias_nT = [2850.0, -2400.0, 950.0], noise_nT = 15.0, nT_per_unit = 4.0 }"
    other = ran("verify", shifted, positions=8, dwell_s=2, calibration=tmp_path / "CAL.json")
    assert other.measured["after: rms magnitude error"].verdict == "FAIL"


def test_an_orbit_is_played_and_its_error_recorded(ran: Run, tmp_path: Path) -> None:
    found = ran("play-field", duration_s=40, step_s=5)
    assert found.measured["rms tracking error"].verdict == "PASS"
    table = tmp_path / "history.csv"
    table.write_text("t_s,b_x,b_y,b_z\n0,10000,0,0\n4,0,20000,0\n8,0,0,-30000\n", encoding="utf-8")
    found = ran("play-field", file=table)
    set_points = [i.data["field_nT"] for i in found.items if getattr(i, "kind", "") == "set-point"]
    assert set_points == [[10000, 0, 0], [0, 20000, 0], [0, 0, -30000]]
    run = session.load_run(found.outcome.run_id)
    assert run.segments[0].kind == "free"
    assert run.t_s[-1] - run.t_s[0] == pytest.approx(12, abs=1)


@pytest.mark.parametrize(
    ("procedure", "given", "says"),
    [
        ("verify", {"calibration": "absent.json"}, "absent.json"),
        ("play-field", {"file": "absent.csv"}, "there is no such file"),
        ("play-field", {"epoch": "soon"}, "expected ISO 8601"),
        ("preflight", {"modes": "turbo"}, "'turbo' is none of the DUT's"),
        ("current-coupling", {"loads": "i_laser"}, "no current channel 'i_laser'"),
    ],
)
def test_what_is_wrong_is_said_in_a_sentence(
    bench_file: Callable[..., Path], procedure: str, given: dict[str, str], says: str
) -> None:
    with pytest.raises((session.InputError, OSError), match=says):
        session.run(procedure, bench_file(), given).raise_fault()

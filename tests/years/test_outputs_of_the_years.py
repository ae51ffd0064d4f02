"""Files that the commands of the years write replace nothing that is not theirs."""

from __future__ import annotations

from pathlib import Path

import pytest
from calibrations_of_years import calibrated, kept

from labcal.cli import execute as labcal

TABLE = "dut,operator,value\nA,x,1\nA,y,1.1\nB,x,2\nB,y,2.2\nA,x,1\nA,y,1\nB,x,2\nB,y,2\n"
ASKED = {
    "rr": ["rr", "--table", "t.csv"],
    "intervals": ["intervals", "EM-1", "EM-1-0.json", "EM-1-300.json"],
    "intercompare": ["intercompare", "a=EM-1-0.json", "b=EM-1-300.json"],
    "fleet": ["fleet", "EM-1-0.json", "EM-1-300.json"],
}


@pytest.mark.parametrize("name", ASKED)
@pytest.mark.parametrize(
    ("option", "file"), [("--json", "out.json"), pytest.param("--out", "out.html", marks=pytest.mark.slow)]
)
def test_what_is_there_is_kept_until_force_is_said_and_an_input_even_then(
    name: str, option: str, file: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "t.csv").write_text(TABLE)
    kept(tmp_path, calibrated(), calibrated(day=300))
    out = tmp_path / file
    out.write_text("the work of a week")
    assert labcal([*ASKED[name], option, file]) == 2
    assert out.read_text() == "the work of a week"
    assert labcal([*ASKED[name], option, file, "--force"]) in (0, 1)
    assert out.read_text() != "the work of a week"
    read = "t.csv" if name == "rr" else "EM-1-0.json"
    before = (tmp_path / read).read_bytes()
    assert labcal([*ASKED[name], "--json", read, "--force"]) == 2
    assert (tmp_path / read).read_bytes() == before


def test_a_watch_writes_over_nothing(tmp_path: Path) -> None:
    out = tmp_path / "found.json"
    out.write_text("the work of a week")
    assert labcal(["watch", str(tmp_path), "--once", "--out", str(tmp_path / "w"), "--json", str(out)]) == 2
    assert out.read_text() == "the work of a week"

"""`labcal bench`: what a technician sees, and the exit codes that scripts see."""

from __future__ import annotations

from pathlib import Path

import pytest

from labcal.cli import _run

EXAMPLE = Path(__file__).parents[2] / "examples" / "simulated.toml"


def test_check_greets_every_instrument_by_name(capsys: pytest.CaptureFixture[str]) -> None:
    assert _run(["bench", "check", str(EXAMPLE)]) == 0
    said = capsys.readouterr().out
    for name in ("supply_x", "supply_y", "supply_z", "reversers", "stage", "reference", "dut"):
        assert name in said


def test_one_that_is_not_there_hides_no_other_and_ends_with_3(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path, text = tmp_path / "bench.toml", EXAMPLE.read_text()
    path.write_text(text[: text.rindex("[twin]")].replace('link = "emulated://"', 'link = "serial:///dev/none"', 1))
    assert _run(["bench", "check", str(path)]) == 3
    said = capsys.readouterr().out
    assert "lost" in said
    assert "HMR2300" in said


def test_off_says_how_every_coil_ended(capsys: pytest.CaptureFixture[str]) -> None:
    assert _run(["bench", "off", str(EXAMPLE)]) == 0
    assert capsys.readouterr().out.count("zero, open") == 3


def test_a_wrong_file_is_one_sentence_and_2(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "bench.toml"
    path.write_text("nme = 1\n")
    assert _run(["bench", "check", str(path)]) == 2
    assert capsys.readouterr().err.count("\n") == 1
    assert _run(["bench", "off", str(tmp_path / "absent.toml")]) == 2

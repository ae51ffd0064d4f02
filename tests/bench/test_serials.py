"""Serial numbers are those of the bench's pattern, wherever they come from."""

import re
from pathlib import Path

import pytest
from served_lab import example

from labcal import session
from labcal.bench.config import read_config
from labcal.bench.serials import USUAL, objection
from labcal.errors import InputError


@pytest.mark.parametrize("serial", ["EM-07", "7", "S/N 0012 (B)", "Ärger_3.1", "MS-90:12#4+1", ""])
def test_usual_serials_are_taken(serial: str) -> None:
    assert objection(serial, USUAL) == ""


@pytest.mark.parametrize("serial", ["EM 07/!?<b>", "<b>", "EM-07 ", " EM-07", "EM-07;", "a\nb", "EM-07/", "-"])
def test_what_stands_on_no_label_is_refused(serial: str) -> None:
    assert "is no serial number" in objection(serial, USUAL)


def test_a_run_takes_no_other_serial_than_those_of_the_bench_file(tmp_path: Path) -> None:
    path = tmp_path / "bench.toml"
    path.write_text(example().replace("[dut]\n", '[dut]\nserial_pattern = "EM-[0-9]{2}"\n'), encoding="utf-8")
    with pytest.raises(InputError, match=re.escape("'FM-1' is no serial number of this bench: they match EM-[0-9]{2}")):
        session.run("axes-check", path, dut="FM-1")
    path.write_text(example().replace("[dut]\n", '[dut]\nserial_pattern = "EM-["\n'), encoding="utf-8")
    with pytest.raises(InputError, match=r"dut.serial_pattern.* is no regular expression"):
        read_config(path)


def test_a_bench_file_cannot_hold_up_who_types_a_serial(tmp_path: Path) -> None:
    path = tmp_path / "bench.toml"
    path.write_text(example().replace("[dut]\n", '[dut]\nserial_pattern = "(\\\\w+)+-"\n'), encoding="utf-8")
    with pytest.raises(InputError, match=r"dut.serial_pattern.* may take very long to match"):
        read_config(path)
    assert "a serial number of 101 characters: at most 100" in objection("a" * 101, USUAL)

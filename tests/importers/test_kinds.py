"""Which format a file is of, whatever it is called."""

from __future__ import annotations

from pathlib import Path

import foreign_files as files
import pytest

from labcal.importers.kinds import kind_of

MADE = {
    "ulog": files.ulog,
    "dataflash": files.dataflash,
    "mat": files.mat,
    "iaga": files.iaga,
    "imagcdf": files.imagcdf,
}


@pytest.mark.parametrize("kind", MADE)
@pytest.mark.parametrize("name", ["recording", "recording.txt", "recording.bin.1", "LOG.CSV"])
def test_a_file_is_what_it_begins_with(tmp_path: Path, kind: str, name: str) -> None:
    if kind == "imagcdf":
        pytest.importorskip("cdflib")
        MADE[kind](tmp_path / "it.cdf", files.tumble(20)).rename(tmp_path / name)  # its writer ends every name so
    else:
        MADE[kind](tmp_path / name, files.tumble(20))
    assert kind_of(tmp_path / name) == kind


@pytest.mark.parametrize(
    ("name", "kind"),
    [("a.ULG", "ulog"), ("a.BIN", "dataflash"), ("a.bag", "rosbag"), ("a.mcap", "rosbag"), ("a.sec", "iaga"),
     ("a.csv", "csv"), ("a.dat", "csv"), ("a", "csv")],
)  # fmt: skip
def test_where_it_does_not_say_so_it_is_what_it_is_called(tmp_path: Path, name: str, kind: str) -> None:
    assert kind_of(tmp_path / name) == kind  # there is none
    (tmp_path / name).write_text("t,x,y,z\n")
    assert kind_of(tmp_path / name) == kind


def test_a_text_log_of_an_autopilot_and_a_folder(tmp_path: Path) -> None:
    (tmp_path / "7.log").write_text("FMT, 128, 89, FMT, BBnNZ, Type,Length,Name,Format,Columns\n")
    assert kind_of(tmp_path / "7.log") == "dataflash"
    assert kind_of(tmp_path) == "rosbag"

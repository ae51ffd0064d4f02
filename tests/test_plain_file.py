"""What is no file of its own kind is refused at once: nothing is waited for, and nothing without an end is read."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

from labcal.cli import execute
from labcal.errors import InputError
from labcal.files.plain_file import first_bytes, read_limited

SOON_S = 60.0  # a busy machine gets there; a pipe that is waited for never ends

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="needs pipes with names")


@pytest.fixture
def pipe(tmp_path: Path) -> Path:
    """A pipe that nobody writes into."""
    os.mkfifo(tmp_path / "pipe")
    return tmp_path / "pipe"


def test_pipes_devices_and_folders_are_none(pipe: Path) -> None:
    for place in (pipe, Path("/dev/zero"), pipe.parent):
        with pytest.raises(InputError, match="is not a regular file"):
            first_bytes(place, 10)


def test_one_that_is_larger_is_refused_whole(tmp_path: Path) -> None:
    (tmp_path / "a").write_bytes(b"12345")
    assert read_limited(tmp_path / "a", 5) == b"12345"
    assert first_bytes(tmp_path / "a", 2) == b"12"
    with pytest.raises(InputError, match="is larger than 4 bytes"):
        read_limited(tmp_path / "a", 4)


@pytest.mark.parametrize(
    ("asks", "says"),
    [
        ("from labcal.store.photos import keep_photo; keep_photo(place)", "is not a regular file"),
        ("from labcal.session.new_effect import new_effect; new_effect(place, 'pump', place)", "is no result of"),
    ],
)
def test_who_reads_what_a_person_names_does_not_wait_for_a_pipe(pipe: Path, asks: str, says: str) -> None:
    code = f"import pathlib; place = pathlib.Path({str(pipe)!r}); {asks}"
    told = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=SOON_S, check=False)
    assert says in told.stderr.splitlines()[-1], told


def test_deep_json_and_an_empty_name_are_a_sentence(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "deep.json").write_text("[" * 100_000)
    deep = ["effect", "new", "--from", str(tmp_path / "deep.json"), "--name", "pump", "--out", str(tmp_path / "p")]
    for command in (deep, ["import", "", "--from", "magcal"]):
        assert execute(command) == 2
        assert "a fault of labcal's own" not in capsys.readouterr().err

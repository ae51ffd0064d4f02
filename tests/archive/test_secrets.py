"""A database's password stands in no text, no record, no file, no process list and no child's environment."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest
from conftest import Bundle, rows_of
from postgres import Server

from labcal.cli import execute as labcal
from labcal.errors import InputError
from labcal.files.home import for_children, home
from labcal.files.text_safety import without_passwords
from labcal.session import archiving

CANARY = "c4nary"
PLACES = (
    f"postgresql://labcal:{CANARY}@/nowhere?host={{socket}}",
    f"postgresql://labcal:{CANARY}%40x@127.0.0.1:1/nowhere",
    f"postgresql://labcal:x@{CANARY}@127.0.0.1:1/nowhere",
    f"postgresql://labcal:{CANARY}/x@127.0.0.1/nowhere",
    f"postgresql://labcal:{CANARY}#x@127.0.0.1/nowhere",
    f"postgresql://labcal:{CANARY}@127.0.0.1:port/nowhere",
    f"postgresql://labcal:{CANARY}@/nowhere?host={{socket}}&no_such_setting={CANARY}",
    f"postgresql://keeper@/nowhere?host={{socket}}&password={CANARY}",
    f"mysql://labcal:{CANARY}@127.0.0.1/nowhere",
    f"labcal:{CANARY}@127.0.0.1",
    f"postgresql://labcal:{CANARY}@[127.0.0.1/nowhere",
)


def files_below(folder: Path) -> bytes:
    return b"\n".join(path.read_bytes() for path in folder.rglob("*") if path.is_file())


@pytest.mark.parametrize("place", PLACES)
def test_no_error_and_no_file_repeats_it(
    place: str, postgres: Server, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv("LABCAL_ARCHIVE", place.format(socket=postgres.folder))
    for words in (
        ["push"],
        ["archive", "runs"],
        ["archive", "init"],
        ["push", "--archive", os.environ["LABCAL_ARCHIVE"]],
    ):
        assert labcal(words) == 2
    told = capsys.readouterr()
    assert CANARY not in told.out + told.err
    assert len(told.err.splitlines()) == 4
    assert CANARY.encode() not in files_below(home())


def test_one_on_the_command_line_is_refused_and_one_in_the_environment_is_used(
    postgres: Server, database: str, url: str, bundle: Bundle, tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str],
) -> None:  # fmt: skip
    place = url.replace("//keeper@", f"//keeper:{CANARY}@")
    assert labcal(["push", "--archive", place]) == 2
    assert "everybody on this machine can read a password on a command line" in capsys.readouterr().err
    monkeypatch.setenv("LABCAL_ARCHIVE", place)
    assert labcal(["push", str(bundle())]) == 0
    assert labcal(["archive", "runs"]) == 0
    told = capsys.readouterr()
    assert "postgresql://keeper@" in told.out
    assert CANARY not in told.out + told.err
    assert CANARY.encode() not in files_below(home()) + files_below(tmp_path)
    assert CANARY not in str(rows_of(postgres, database))
    assert not {"LABCAL_ARCHIVE", "PGPASSWORD"} & for_children().keys()


def test_a_fault_of_labcal_s_own_repeats_it_nowhere(
    url: str, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def fails(*_: object) -> None:
        raise RuntimeError(f"postgresql://labcal:{CANARY}@host/lab")

    monkeypatch.setattr("sys.argv", ["labcal", "push", "--archive", f"postgresql://labcal:{CANARY}@host/lab"])
    monkeypatch.setattr("labcal.session.archiving.archived_runs", fails)
    assert labcal(["archive", "runs", "--archive", url]) == 2
    assert "a fault of labcal's own" in (told := capsys.readouterr().err)
    assert CANARY not in told
    report = (home() / "last-fault.txt").read_text()
    assert "labcal push --archive postgresql://labcal:***@host/lab" in report
    assert CANARY not in report


def test_the_sentence_for_people_names_the_place_alone() -> None:
    assert without_passwords("a postgresql://u:p@ss@h/d b") == "a postgresql://u:***@h/d b"
    assert without_passwords("x://h/d?a=1&password=p&b=2") == "x://h/d?a=1&password=***&b=2"
    assert without_passwords("tcp://127.0.0.1:5025 is silent") == "tcp://127.0.0.1:5025 is silent"


def test_without_an_archive_and_without_its_libraries_it_is_one_sentence(
    monkeypatch: pytest.MonkeyPatch, url: str, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.delenv("LABCAL_ARCHIVE", raising=False)
    with pytest.raises(InputError, match="which archive"):
        archiving.push(None)
    for name in ("labcal.archive.server", "labcal.archive.versions"):
        monkeypatch.delitem(sys.modules, name, raising=False)
    monkeypatch.setitem(sys.modules, "sqlalchemy", None)
    assert labcal(["push", "--archive", url]) == 2
    assert "pip install 'labcal[archive]'" in capsys.readouterr().err


def test_nothing_of_it_is_loaded_by_who_does_not_ask_for_it() -> None:
    looked = "import sys, labcal.session, labcal.cli.commands; print({'sqlalchemy', 'psycopg'} & sys.modules.keys())"
    told = subprocess.run([sys.executable, "-c", looked], check=True, capture_output=True, text=True)
    assert told.stdout == "set()\n"

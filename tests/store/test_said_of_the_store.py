"""What is said of a store that fails: what was seen, who held it, where it lies, what can be done there."""

from __future__ import annotations

import os
import sqlite3
import subprocess
import sys
from collections.abc import Callable, Iterator
from contextlib import closing, contextmanager
from pathlib import Path

import pytest

from labcal.errors import InstrumentError
from labcal.record import Dut, Reference, RunHeader
from labcal.record.stream import Event
from labcal.store import RunWriter, Store, place

HEADER = RunHeader("r1", "2026-03-02T08:15:00Z", True, "bench", Dut("SN1"), Reference("none"))
LOCKS = """
import sqlite3, sys
held = sqlite3.connect(sys.argv[1], isolation_level=None)
held.execute("BEGIN IMMEDIATE")
print("held", flush=True)
sys.stdin.read()
"""
on_linux = pytest.mark.skipif(sys.platform != "linux", reason="only Linux says who it was, and where a file lies")


@contextmanager
def another_program(path: Path) -> Iterator[int]:
    """The number of a process that has the store locked."""
    with subprocess.Popen(
        [sys.executable, "-c", LOCKS, str(path)], stdin=subprocess.PIPE, stdout=subprocess.PIPE
    ) as process:
        assert process.stdout is not None
        assert process.stdout.readline().strip() == b"held"
        yield process.pid
        process.communicate()


@pytest.fixture
def writer(monkeypatch: pytest.MonkeyPatch) -> Iterator[RunWriter]:
    """Of a run into an own store, patient for a moment."""
    monkeypatch.setattr("labcal.store.writer.PATIENCE_S", 0.3)
    with Store.open() as store:
        yield store.begin(HEADER)


def not_kept(writer: RunWriter) -> InstrumentError:
    writer.write(Event(1.0, "note", "a row"))
    with pytest.raises(InstrumentError) as caught:
        writer.finish("finished")
    return caught.value


@on_linux
def test_a_locked_store_says_which_process_held_it_and_how_long_a_row_has_waited(writer: RunWriter) -> None:
    told = list[InstrumentError]()
    writer.waits = told.append
    with another_program(writer._path) as process:
        fault = not_kept(writer)
    assert f"the store was locked by process {process} (python" in fault.what
    assert "; a row has waited 0." in fault.what
    assert str(process) in told[0].what, "told while it waits, not after that"


def test_nobody_is_named_where_the_system_names_nobody(writer: RunWriter) -> None:
    """This process itself holds it: that is nobody whom a person could close."""
    with closing(sqlite3.connect(writer._path, isolation_level=None)) as here:
        here.execute("BEGIN IMMEDIATE")
        assert "locked, by whom is not known; a row has waited" in not_kept(writer).what


def moved(path: Path) -> None:
    path.rename(path.with_name("elsewhere.sqlite"))


def removed(path: Path) -> None:
    path.unlink()


def replaced(path: Path) -> None:
    other = path.with_name("other.sqlite")
    with closing(sqlite3.connect(path)) as here, closing(sqlite3.connect(other)) as there:
        here.backup(there)
    other.replace(path)


def without_wal(path: Path) -> None:
    path.with_name(f"{path.name}-wal").unlink()


@on_linux
@pytest.mark.parametrize(
    ("deed", "what", "remedy"),
    [
        (moved, "it was moved to {0}/elsewhere.sqlite while", "Move it back, with what lies beside it"),
        (removed, "it was removed while it was written to.", "Put a copy of the store in its place; without one"),
        (replaced, "it was removed while it was written to, and another file", "Put a copy of the store in its place"),
        (without_wal, "-wal: it was removed while", "`labcal check-store` looks at what is left"),
    ],
)
def test_a_store_that_is_gone_says_where_it_is_and_only_what_can_be_done_there(
    writer: RunWriter, deed: Callable[[Path], None], what: str, remedy: str
) -> None:
    deed(writer._path)
    fault = not_kept(writer)
    assert fault.fault == "store gone"
    assert what.format(writer._path.parent) in fault.what
    assert fault.remedy.startswith(remedy)


@pytest.mark.skipif(os.name != "posix", reason="an open file cannot be removed on Windows")
def test_where_the_system_does_not_tell_nothing_is_taken_for_known(
    writer: RunWriter, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(place, "OPEN_FILES", Path("/nowhere"))
    removed(writer._path)
    fault = not_kept(writer)
    assert "it was moved, removed or replaced while" in fault.what
    assert fault.remedy.startswith("If it was moved, move it back, with what lies beside it")
    assert "without one what it held is lost" in fault.remedy

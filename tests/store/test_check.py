"""`labcal check-store`: every way in which a page or a row can be wrong is told, and a sound store is called sound."""

from __future__ import annotations

import os
import sqlite3
from collections.abc import Callable
from contextlib import closing
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from labcal.cli import execute
from labcal.errors import InputError, InstrumentError
from labcal.files.home import home
from labcal.record import Dut, Reference, RunHeader
from labcal.record.stream import Block, Event, Measurement
from labcal.store import Store, check_store, schema

HEADER = RunHeader("r1", "2026-03-02T08:15:00Z", True, "bench", Dut("SN1"), Reference("none"))


def block(start: float, n: int = 100) -> Block:
    t = start + np.arange(n) / 10
    return Block("dut", "dut", ("dut_x", "dut_y", "dut_z"), t, np.outer(t, [1.0, 2.0, -3.0]), b"frame;" * n)


@pytest.fixture
def path(bundle: Callable[..., Path]) -> Path:
    """The user's own store: two recorded runs and an imported one."""
    with Store.open() as store:
        for run_id in ("r1", "r2"):
            with store.begin(replace(HEADER, run_id=run_id)) as writer:
                for number in range(20):
                    writer.write(block(10.0 * number))
                    writer.write(Measurement(float(number), "zero", 3.5, 0.5, "nT", 10.0))
                    writer.write(Event(float(number), "note", "a"))
        store.add_bundle(bundle(lambda header: header.update(run_id="imported")))
        return store.path


def edit(path: Path, statement: str, *values: object) -> None:
    """As somebody would who knows SQLite: guards off, edited, guards on."""
    with closing(sqlite3.connect(path, isolation_level=None)) as connection:
        kept = connection.execute("SELECT name, sql FROM sqlite_master WHERE type = 'trigger'").fetchall()
        for name, _ in kept:
            connection.execute(f"DROP TRIGGER {name}")
        connection.execute(statement, values)
        for _, sql in kept:
            connection.execute(sql)


def test_a_sound_store_is_called_sound(path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    before = path.read_bytes()
    assert execute(["check-store"]) == 0
    assert capsys.readouterr().out == "sound: 3 runs, 120 rows\n"
    assert execute(["check-store", "r2"]) == 0
    assert capsys.readouterr().out == "sound: 1 run, 60 rows\n"
    assert path.read_bytes() == before


def test_a_run_that_is_being_recorded_is_no_damage() -> None:
    with Store.open() as store, store.begin(HEADER) as writer:
        writer.write(block(0.0))
        writer.commit()
        assert check_store(store.path).items == 1
        assert check_store(store.path).fault == ""


ITEM = "UPDATE item SET {} WHERE number = (SELECT min(number) FROM item WHERE run = 2 AND kind = '{}')"
EDITS = (
    (ITEM.format("content = '{\"t_s\": 0}'", "event"), "run r2, row 63 (event): it cannot be read"),
    (ITEM.format("content = 'no JSON'", "block"), "run r2, row 61 (block): it cannot be read"),
    (ITEM.format("kind = 'cake'", "event"), "row 63 (cake): no labcal writes such a row"),
    (ITEM.format("t_s = t_s + 1", "measurement"), "row 62 (measurement): its time is not the one it states"),
    (ITEM.format("stamps = x'00'", "block"), "row 61 (block): 1 bytes of stamps are no numbers"),
    (ITEM.format("samples = substr(samples, 9)", "block"), "row 61 (block): 2392 bytes of samples where 2400 belong"),
    (ITEM.format("t_s = 99.0", "block"), "row 61 (block): its stamps are not those it was written with"),
    (ITEM.format("samples = x'00'", "event"), "row 63 (event): it has samples and is no block"),
    ("UPDATE item SET run = 3 WHERE number = 63", "run r2: row 63 of item is gone, that link"),
    ("UPDATE run SET header = '{}' WHERE run_id = 'r2'", "run r2: "),
    ("UPDATE run SET header = replace(header, 'r2', 'r9') WHERE run_id = 'r2'", "run r2: its head is of run r9"),
    ("UPDATE run SET header = '{}' WHERE run_id = 'imported'", "run imported: its head is not its bundle's"),
    ("UPDATE bundle SET samples_csv = x'00'", "run imported: "),
    ("UPDATE status SET status = 'fine' WHERE run = 2 AND status = 'finished'", "run r2: 'fine' is no status"),
    ("UPDATE status SET utc = 'noon' WHERE run = 2 AND status = 'finished'", "run r2: 'noon' is no time"),
    ("DELETE FROM status WHERE run = 2", "run r2: its first status is missing"),
    ("INSERT INTO status VALUES (2, 'stopped', '2026-03-02')", "run r2: it was finished, and another status follows"),
    ("DELETE FROM run WHERE run_id = 'r2'", "row 61 of item is of a run that is not there"),
)


@pytest.mark.parametrize(("statement", "says"), EDITS)
def test_a_row_that_was_edited_behind_the_guards_is_told(path: Path, statement: str, says: str) -> None:
    edit(path, statement)
    assert says in check_store(path).fault
    if "run r2" in says and "imported" not in says:
        assert check_store(path, "r1").fault == ""


def test_it_is_one_line_and_exit_1(path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    edit(path, "UPDATE status SET status = ? WHERE run = 2", "\x1b[2Jfine\n")
    assert execute(["check-store"]) == 1
    said = capsys.readouterr()
    assert said.out.startswith("NOT SOUND: run r2: its first status is ")
    assert "\x1b" not in said.out
    assert (said.out.count("\n"), said.err) == (1, "")


def test_an_overwritten_page_is_told_when_the_store_is_opened_and_by_the_command(path: Path) -> None:
    whole = path.read_bytes()
    for page in range(1, len(whole) // 4096):
        path.write_bytes(whole[: page * 4096] + b"\xa5" * 4096 + whole[(page + 1) * 4096 :])
        if check_store(path).fault == "":
            continue  # the inside of a blob: only what was written of it could tell
        with pytest.raises(InputError, match="damaged"):
            Store.open(path).runs()
        break
    else:
        pytest.fail("no page of the store is looked at")


@pytest.mark.parametrize("left", [100, 4096, 4096 * 7, 4096 * 7 + 100])
def test_a_truncated_store_is_told(path: Path, left: int) -> None:
    path.write_bytes(path.read_bytes()[:left])
    assert check_store(path).fault
    with pytest.raises(InputError, match="damaged"):
        Store.open(path)


def test_no_store_no_run_and_a_locked_one_are_said_so(path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    with pytest.raises(InputError, match="no run called r9"):
        check_store(path, "r9")
    with pytest.raises(InputError, match="no store here yet"):
        check_store(home() / "absent.sqlite")
    monkeypatch.setattr("labcal.store.check.PATIENCE_S", 0.1)
    with closing(sqlite3.connect(path, isolation_level=None)) as other:
        other.execute("PRAGMA journal_mode = DELETE")
        other.execute("BEGIN EXCLUSIVE")
        with pytest.raises(InstrumentError, match="locked"):
            check_store(path)


def test_a_store_beyond_the_size_looked_through_at_opening_is_so_before_a_run(
    path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("labcal.store.database.CHECKED_BYTES", 0)
    with closing(sqlite3.connect(path)) as connection:
        root = connection.execute("SELECT rootpage FROM sqlite_master WHERE name = 'item_of_run'").fetchone()[0]
    with path.open("r+b") as file:
        file.seek((root - 1) * 4096 + 3)
        file.write(os.urandom(64))
    with Store.open(path) as store, pytest.raises(InputError, match="the store is damaged"):
        store.begin(replace(HEADER, run_id="r3"))


def test_another_program_s_database_is_no_store(tmp_path: Path) -> None:
    with closing(sqlite3.connect(tmp_path / "x.sqlite")) as other:
        other.execute("CREATE TABLE cake (slices)")
        assert other.execute("PRAGMA application_id").fetchone()[0] != schema.APPLICATION
    assert "another program" in check_store(tmp_path / "x.sqlite").fault

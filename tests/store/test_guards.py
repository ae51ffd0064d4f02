"""What keeps rows as they were written: guards against every way to replace one, and a look at the guards."""

from __future__ import annotations

import shutil
import sqlite3
from collections.abc import Iterator
from contextlib import closing
from pathlib import Path

import pytest

from labcal.errors import InputError
from labcal.record import Dut, Reference, RunHeader
from labcal.record.stream import Event
from labcal.store import Store, check_store
from labcal.store.schema import VERSION

GOLDEN = Path(__file__).parents[1] / "golden"
HEADER = RunHeader("r1", "2026-03-02T08:15:00Z", True, "bench", Dut("SN1"), Reference("none"))


@pytest.fixture
def path(tmp_path: Path, bundle) -> Path:
    """A store with a recorded run of three rows and an imported one."""
    with Store.open(tmp_path / "s.sqlite") as store:
        with store.begin(HEADER) as writer:
            for number in range(3):
                writer.write(Event(float(number), "note", str(number)))
        store.add_bundle(bundle(lambda header: header.update(run_id="imported")))
    return tmp_path / "s.sqlite"


@pytest.fixture
def other(path: Path) -> Iterator[sqlite3.Connection]:
    """Another program's connection to it."""
    with closing(sqlite3.connect(path, isolation_level=None)) as connection:
        yield connection


ITEM = "item (number, run, kind, t_s, content) VALUES ({}, 1, 'event', 0.0, '{{}}')"
REPLACING = (
    "INSERT OR REPLACE INTO " + ITEM.format(1),
    "INSERT OR REPLACE INTO " + ITEM.format(3),  # the last one
    "REPLACE INTO " + ITEM.format(2),
    "INSERT INTO " + ITEM.format(2) + " ON CONFLICT (number) DO UPDATE SET content = 'x'",
    "INSERT OR IGNORE INTO " + ITEM.format(2),
    "INSERT INTO " + ITEM.format(-7),  # before all others
    "INSERT INTO " + ITEM.format(0),
    "UPDATE OR REPLACE item SET number = 1 WHERE number = 2",
    "UPDATE OR IGNORE item SET content = 'x'",
    "REPLACE INTO status (rowid, run, status, utc) VALUES (2, 1, 'stopped', '2026-03-02')",
    "INSERT INTO status (rowid, run, status, utc) VALUES (-3, 1, 'stopped', '2026-03-02')",
    "REPLACE INTO run (number, run_id, header) VALUES (1, 'other', '{}')",
    "REPLACE INTO run (run_id, header) VALUES ('r1', '{}')",
    "REPLACE INTO bundle (run, run_json, samples_csv) VALUES (2, '{}', '')",
    "UPDATE bundle SET run_json = '{}'",
    "DELETE FROM bundle",
)


@pytest.mark.parametrize("statement", REPLACING)
@pytest.mark.parametrize("recursive", ["ON", "OFF"])
def test_no_statement_takes_the_place_of_a_row(
    path: Path, other: sqlite3.Connection, statement: str, recursive: str
) -> None:
    other.execute(f"PRAGMA recursive_triggers = {recursive}")
    before = list(other.iterdump())
    with pytest.raises(sqlite3.IntegrityError, match="never edited"):
        other.execute(statement)
    assert list(other.iterdump()) == before


TAMPERED = (
    ("DROP TRIGGER item_update", "its trigger item_update is gone"),
    ("DROP TRIGGER item_taken", "its trigger item_taken is gone"),
    (
        "DROP TRIGGER run_delete; CREATE TRIGGER run_delete BEFORE DELETE ON run BEGIN SELECT 1; END",
        "its trigger run_delete is not as labcal made it",
    ),
    (
        "CREATE TRIGGER mine AFTER INSERT ON item BEGIN SELECT 1; END",
        "it has a trigger that labcal did not make, mine",
    ),
    ("ALTER TABLE status ADD COLUMN more TEXT", "its table status is not as labcal made it"),
    (
        "PRAGMA writable_schema = ON; DELETE FROM sqlite_master WHERE name = 'status_update'",
        "its trigger status_update is gone",
    ),
)


@pytest.mark.parametrize(("statements", "says"), TAMPERED)
def test_a_store_whose_guards_were_tampered_with_is_refused_by_name(
    path: Path, other: sqlite3.Connection, statements: str, says: str
) -> None:
    other.executescript(statements)
    other.close()
    with pytest.raises(InputError, match=says):
        Store.open(path)
    assert says in check_store(path).fault


def test_an_index_that_is_gone_is_made_again(path: Path, other: sqlite3.Connection) -> None:
    other.execute("DROP INDEX item_of_run")
    with Store.open(path) as store:
        assert store.status("r1") == "finished"
    assert other.execute("SELECT count(*) FROM sqlite_master WHERE name = 'item_of_run'").fetchone() == (1,)


def test_a_store_of_version_1_gains_the_guards_and_keeps_every_row(tmp_path: Path) -> None:
    path = tmp_path / "store-1.sqlite"
    shutil.copy(GOLDEN / "store-1.sqlite", path)

    def rows() -> list[str]:
        with closing(sqlite3.connect(path)) as connection:
            return [line for line in connection.iterdump() if line.startswith("INSERT")]

    before = rows()
    assert check_store(path).fault == ""
    Store.open(path).close()
    assert rows() == before
    with closing(sqlite3.connect(path)) as other:
        assert other.execute("PRAGMA user_version").fetchone() == (VERSION,)
        with pytest.raises(sqlite3.IntegrityError, match="never edited"):
            other.execute("REPLACE INTO " + ITEM.format(1))
    assert check_store(path).fault == ""


def test_a_store_of_version_1_that_lost_a_guard_of_its_own_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "store-1.sqlite"
    shutil.copy(GOLDEN / "store-1.sqlite", path)
    with closing(sqlite3.connect(path)) as other:
        other.execute("DROP TRIGGER item_update")
    with pytest.raises(InputError, match="its trigger item_update is gone"):
        Store.open(path)


def test_a_store_of_a_later_version_is_refused(path: Path, other: sqlite3.Connection) -> None:
    other.execute(f"PRAGMA user_version = {VERSION + 1}")
    with pytest.raises(InputError, match=f"a store of version {VERSION + 1}"):
        Store.open(path)

"""The store's file: its schema, how it is opened, and plain words for what can go wrong with it."""

from __future__ import annotations

import sqlite3
import time
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

from labcal.errors import InputError, InstrumentError

APPLICATION = 0x6C61_6263  # "labc", in the file's header
VERSION = 1
PATIENCE_S = 5.0  # how long another program may hold the file

SCHEMA = """
CREATE TABLE run (
    number INTEGER PRIMARY KEY,
    run_id TEXT NOT NULL UNIQUE,
    header TEXT NOT NULL  -- JSON: who, with what, by which procedure; of an imported run what its run.json says
);
CREATE TABLE status (  -- how a run stands: its last row counts
    run INTEGER NOT NULL REFERENCES run (number),
    status TEXT NOT NULL,  -- running, finished, stopped, failed: ..., imported
    utc TEXT NOT NULL
);
CREATE INDEX status_of_run ON status (run);
CREATE TABLE item (  -- the timeline, in the order of `number`
    number INTEGER PRIMARY KEY,
    run INTEGER NOT NULL REFERENCES run (number),
    kind TEXT NOT NULL,  -- block, segment-opened, segment-closed, mode-changed, step, measurement, event, prompt
    t_s REAL NOT NULL,  -- seconds of the bench's clock
    content TEXT NOT NULL,  -- JSON
    stamps BLOB,  -- of a block: (n,) little-endian float64, s
    samples BLOB,  -- of a block: (n, columns) little-endian float64, row by row
    raw BLOB  -- of a block: the frames as they came over the wire
);
CREATE INDEX item_of_run ON item (run, number);
CREATE TABLE bundle (  -- imported runs, byte for byte
    run INTEGER PRIMARY KEY REFERENCES run (number),
    run_json BLOB NOT NULL,
    samples_csv BLOB NOT NULL
);
""" + "".join(
    f"CREATE TRIGGER {table}_{verb.lower()} BEFORE {verb} ON {table}"
    " BEGIN SELECT RAISE(ABORT, 'what was recorded is never edited'); END;\n"
    for table in ("run", "status", "item", "bundle")
    for verb in ("UPDATE", "DELETE")
)


CORRECTED = "serial-corrected"  # an Event of this kind: from here on the run is of another DUT's serial
IS_CORRECTION = f"kind = 'event' AND content LIKE '%\"{CORRECTED}\"%'"
CORRECTIONS = f"CREATE INDEX IF NOT EXISTS correction_of_run ON item (run, number) WHERE {IS_CORRECTION}"


def connect(path: Path) -> sqlite3.Connection:
    """Open the store at `path`, made where it is absent. Raises InputError where the file is no store of ours.

    Every commit is on the disk when it returns (WAL, synchronous FULL); others read meanwhile.
    """
    with named_faults(path):
        path.parent.mkdir(parents=True, exist_ok=True)
        connection = sqlite3.connect(path, timeout=PATIENCE_S, isolation_level=None, check_same_thread=False)
        try:
            _set_up(connection, path)
        except BaseException:
            connection.close()
            raise
    return connection


@contextmanager
def transaction(connection: sqlite3.Connection, path: Path) -> Iterator[None]:
    """All that is written within is committed together, or not at all."""
    with named_faults(path):
        connection.execute("BEGIN IMMEDIATE")
        try:
            yield
            connection.execute("COMMIT")
        except BaseException:
            if connection.in_transaction:
                connection.execute("ROLLBACK")
            raise


@contextmanager
def named_faults(path: Path) -> Iterator[None]:
    """Say in plain words what SQLite reports."""
    try:
        yield
    except sqlite3.Error as error:
        raise _named(error, path) from None


def _named(error: sqlite3.Error, path: Path) -> InputError | InstrumentError:
    name = getattr(error, "sqlite_errorname", "")
    if name.startswith(("SQLITE_FULL", "SQLITE_IOERR")):
        remedy = "What was committed is safe; make room on the disk, then go on with the run."
        return InstrumentError(f"{path}: the disk is full or fails ({error}).", fault="disk full", remedy=remedy)
    if name.startswith(("SQLITE_BUSY", "SQLITE_LOCKED")):
        remedy = "Close the program that holds it, then try again."
        return InstrumentError(f"{path}: another program keeps the store locked.", fault="store locked", remedy=remedy)
    if name.startswith(("SQLITE_NOTADB", "SQLITE_CORRUPT")):
        return InputError(f"the store is damaged, or is no store: {error}", file=path)
    if name.startswith(("SQLITE_CANTOPEN", "SQLITE_READONLY", "SQLITE_PERM", "SQLITE_AUTH")):
        return InputError(f"the store cannot be opened for writing: {error}", file=path)
    return InstrumentError(f"{path}: the store refused: {error}.", fault="store failed")


def _set_up(connection: sqlite3.Connection, path: Path) -> None:
    """Make what is not there yet. Where others open the same store just now, SQLite may not wait by itself."""
    deadline = time.monotonic() + PATIENCE_S
    while True:
        try:
            if connection.execute("PRAGMA application_id").fetchone()[0] != APPLICATION:
                _create(connection, path)
            _check_version(connection, path)
            for pragma in ("journal_mode = WAL", "synchronous = FULL", "foreign_keys = ON"):
                connection.execute(f"PRAGMA {pragma}")
            _index(connection)
            return
        except sqlite3.OperationalError as error:
            busy = error.sqlite_errorname.startswith(("SQLITE_BUSY", "SQLITE_LOCKED"))
            if not busy or time.monotonic() > deadline:
                raise
            if connection.in_transaction:
                connection.execute("ROLLBACK")
            time.sleep(0.02)


def _index(connection: sqlite3.Connection) -> None:
    """So that a list of runs need not look at their items; a store that cannot have it now is slower, no worse."""
    with suppress(sqlite3.OperationalError):
        connection.execute(CORRECTIONS)


def _create(connection: sqlite3.Connection, path: Path) -> None:
    connection.execute("BEGIN IMMEDIATE")  # two programs may open a new store at once: one makes it, one waits
    if connection.execute("PRAGMA application_id").fetchone()[0] != APPLICATION:
        if connection.execute("SELECT count(*) FROM sqlite_master").fetchone()[0]:
            raise InputError("a database of another program, not a store of labcal", file=path)
        for statement in _statements():
            connection.execute(statement)
        connection.execute(f"PRAGMA application_id = {APPLICATION}")
        connection.execute(f"PRAGMA user_version = {VERSION}")
    connection.execute("COMMIT")


def _statements() -> Iterator[str]:
    """The schema's statements one by one, since executescript would commit before it begins."""
    statement = ""
    for line in SCHEMA.splitlines(keepends=True):
        statement += line
        if sqlite3.complete_statement(statement):
            yield statement
            statement = ""


def _check_version(connection: sqlite3.Connection, path: Path) -> None:
    version = connection.execute("PRAGMA user_version").fetchone()[0]
    if version != VERSION:
        raise InputError(f"a store of version {version}; this labcal reads version {VERSION}", file=path)

"""The store's file: how it is opened and written, and plain words for what can go wrong with it."""

from __future__ import annotations

import os
import sqlite3
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from labcal.errors import InputError, InstrumentError
from labcal.files.home import home, own_file, own_folder, tightened
from labcal.store import schema
from labcal.store.holder import holder
from labcal.store.place import BESIDE, Files, files_at, require_same

PATIENCE_S = 5.0  # how long another program may hold the file
CHECKED_BYTES = 32 << 20  # a store up to this size is looked through whenever it is opened (15 ms)
CHECKED_BEFORE_A_RUN_BYTES = 512 << 20  # and up to this one before a run is recorded into it (0.3 s)
MAKE_ROOM = "Make room on the disk."
SEE_THE_DISK = "See whether the disk is full or fails."
CLOSE_IT = "Close the program that holds it, if it still does, and try again."
DAMAGED = "`labcal check-store` looks through all of it; set the file aside and go on with a copy, or with a new store"


class Connection(sqlite3.Connection):
    """A connection that knows which files it writes to."""

    files: Files


def connect(path: Path) -> Connection:
    """Open the store at `path`, made where it is absent. Raises InputError where the file is no store of ours.

    Every commit is on the disk when it returns (WAL, synchronous FULL); others read meanwhile. Only this user can.
    """
    with named_faults(path):
        _for_this_user_alone(path)
        connection = sqlite3.connect(
            path, timeout=PATIENCE_S, isolation_level=None, check_same_thread=False, factory=Connection
        )
        try:
            _set_up(connection, path)
            connection.files = files_at(path)
            require_sound(connection, path, CHECKED_BYTES)
        except BaseException:
            connection.close()
            raise
    return connection


def require_sound(connection: sqlite3.Connection, path: Path, at_most_bytes: int) -> None:
    """Look through a store of up to this size, page by page. Raises InputError with the first thing that is wrong."""
    with named_faults(path):
        if os.stat(path).st_size <= at_most_bytes:
            (found,) = connection.execute("PRAGMA quick_check(1)").fetchone()
            if found != "ok":
                raise InputError(f"the store is damaged: {' '.join(found.split())}; {DAMAGED}", file=path)


@contextmanager
def transaction(connection: Connection, path: Path) -> Iterator[None]:
    """All that is written within is committed together into the file at `path`, or not at all."""
    with named_faults(path):
        connection.execute("BEGIN IMMEDIATE")
        try:
            yield
            require_same(path, connection.files)
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
    if name.startswith("SQLITE_FULL"):
        return InstrumentError(f"{path}: there was no room on the disk ({error}).", fault="disk full", remedy=MAKE_ROOM)
    if name.startswith("SQLITE_IOERR"):
        refused = f"{path}: the system refused to read or write it ({error}, {name})."
        return InstrumentError(refused, fault="disk full", remedy=SEE_THE_DISK)
    if name.startswith(("SQLITE_BUSY", "SQLITE_LOCKED")):
        by_whom = f" by {who}" if (who := holder(path)) else ", by whom is not known"
        return InstrumentError(f"{path}: the store was locked{by_whom}.", fault="store locked", remedy=CLOSE_IT)
    if name.startswith(("SQLITE_NOTADB", "SQLITE_CORRUPT")):
        return InputError(f"the store is damaged, or is no store: {error}; {DAMAGED}", file=path)
    if name.startswith(("SQLITE_CANTOPEN", "SQLITE_READONLY", "SQLITE_PERM", "SQLITE_AUTH")):
        return InputError(f"the store cannot be opened or written: {error}", file=path)
    return InstrumentError(f"{path}: the store refused: {error}.", fault="store failed")


def _for_this_user_alone(path: Path) -> None:
    """The store, what SQLite keeps beside it, and the folder where it is labcal's own. Raises InputError."""
    try:
        if path.parent == home():
            own_folder(path.parent)
        path.parent.mkdir(parents=True, exist_ok=True)
        if not path.is_dir():
            own_file(path)
    except OSError as error:
        raise InputError(f"the store cannot be opened or written: {error.strerror}", file=path) from None
    for end in BESIDE[1:]:
        tightened(path.with_name(path.name + end))


def _set_up(connection: sqlite3.Connection, path: Path) -> None:
    """Make what is not there yet. Where others open the same store just now, SQLite may not wait by itself."""
    deadline = time.monotonic() + PATIENCE_S
    while True:
        try:
            if connection.execute("PRAGMA application_id").fetchone()[0] != schema.APPLICATION:
                _create(connection, path)
            schema.require(connection, path)
            if schema.behind(connection):
                _bring_up(connection)
            for pragma in ("journal_mode = WAL", "synchronous = FULL", "foreign_keys = ON", "cell_size_check = ON"):
                connection.execute(f"PRAGMA {pragma}")
            return
        except sqlite3.OperationalError as error:
            busy = error.sqlite_errorname.startswith(("SQLITE_BUSY", "SQLITE_LOCKED"))
            if not busy or time.monotonic() > deadline:
                raise
            if connection.in_transaction:
                connection.execute("ROLLBACK")
            time.sleep(0.02)


def _create(connection: sqlite3.Connection, path: Path) -> None:
    connection.execute("BEGIN IMMEDIATE")  # two programs may open a new store at once: one makes it, one waits
    if connection.execute("PRAGMA application_id").fetchone()[0] != schema.APPLICATION:
        if connection.execute("SELECT count(*) FROM sqlite_master").fetchone()[0]:
            raise InputError("a database of another program, not a store of labcal", file=path)
        schema.create(connection)
    connection.execute("COMMIT")


def _bring_up(connection: sqlite3.Connection) -> None:
    connection.execute("BEGIN IMMEDIATE")
    if schema.behind(connection):
        schema.bring_up(connection)
    connection.execute("COMMIT")

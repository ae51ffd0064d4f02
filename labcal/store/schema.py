"""The store's tables, and the guards that let rows be added at the end and nothing else.

`OR REPLACE` would delete a row without any trigger being asked: so a key that is taken is refused before it comes to
that. What drops or rewrites a guard is noticed when the store is opened next.
"""

from __future__ import annotations

import sqlite3
from collections.abc import Iterator
from functools import cache
from pathlib import Path

from labcal.errors import InputError

APPLICATION = 0x6C61_6263  # "labc", in the file's header
VERSION = 3  # 1: rows could be put between others; 2: no chain. Those are brought to this one when they are opened
LATER = {2: ("_taken", "_last"), 3: ("chain", "origin")}  # by version: how the names of what it added end or begin

TABLES = """
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
CREATE TABLE bundle (  -- imported runs, byte for byte
    run INTEGER PRIMARY KEY REFERENCES run (number),
    run_json BLOB NOT NULL,
    samples_csv BLOB NOT NULL
);
CREATE TABLE origin (  -- of an imported run: the chain that its bundle held, byte for byte
    run INTEGER PRIMARY KEY REFERENCES run (number),
    chain_jsonl BLOB NOT NULL
);
CREATE TABLE chain (  -- every row of a run in the order of writing, each bound to all before it
    run INTEGER NOT NULL REFERENCES run (number),
    place INTEGER NOT NULL,  -- 1, 2, 3 ...
    kept_in TEXT NOT NULL,  -- the row's table
    row INTEGER NOT NULL,  -- its key there
    sha256 TEXT NOT NULL,
    PRIMARY KEY (run, place)
) WITHOUT ROWID;
"""
CORRECTED = "serial-corrected"  # an Event of this kind: from here on the run is of another DUT's serial
IS_CORRECTION = f"kind = 'event' AND content LIKE '%\"{CORRECTED}\"%'"
INDEXES = f"""
CREATE INDEX status_of_run ON status (run);
CREATE INDEX item_of_run ON item (run, number);
CREATE INDEX correction_of_run ON item (run, number) WHERE {IS_CORRECTION};
"""
NEVER_EDITED = "BEGIN SELECT RAISE(ABORT, 'what was recorded is never edited'); END;\n"
TAKEN = {  # by table: when a new row would take another's place
    "run": "EXISTS (SELECT 1 FROM run WHERE number = NEW.number OR run_id = NEW.run_id)",
    "status": "EXISTS (SELECT 1 FROM status WHERE rowid = NEW.rowid)",
    "item": "EXISTS (SELECT 1 FROM item WHERE number = NEW.number)",
    "bundle": "EXISTS (SELECT 1 FROM bundle WHERE run = NEW.run)",
    "origin": "EXISTS (SELECT 1 FROM origin WHERE run = NEW.run)",
    "chain": "NEW.place <> (SELECT coalesce(max(place), 0) + 1 FROM chain WHERE run = NEW.run)",
}
ORDERED = {"run": "number", "status": "rowid", "item": "number"}  # by table: the key that tells the order
GUARDS = (
    "".join(
        f"CREATE TRIGGER {t}_{v.lower()} BEFORE {v} ON {t} {NEVER_EDITED}" for t in TAKEN for v in ("UPDATE", "DELETE")
    )
    + "".join(
        f"CREATE TRIGGER {t}_taken BEFORE INSERT ON {t} WHEN {taken} {NEVER_EDITED}" for t, taken in TAKEN.items()
    )
    + "".join(
        f"CREATE TRIGGER {t}_last AFTER INSERT ON {t} WHEN NEW.{key} < (SELECT max({key}) FROM {t}) {NEVER_EDITED}"
        for t, key in ORDERED.items()
    )
)


def create(connection: sqlite3.Connection) -> None:
    """Make everything, inside a transaction that is open."""
    for statement in _statements(TABLES + INDEXES + GUARDS):
        connection.execute(statement)
    connection.execute(f"PRAGMA application_id = {APPLICATION}")
    connection.execute(f"PRAGMA user_version = {VERSION}")


def fault(connection: sqlite3.Connection) -> str:
    """What of the tables and guards is not as labcal made it, in words; "" where all is."""
    there, version = _named(connection), connection.execute("PRAGMA user_version").fetchone()[0]
    for name, (kind, text) in _expected().items():
        if kind == "index" or _added_after(version, name):
            continue  # no guard, or added when the store is opened for work
        if name not in there:
            return f"its {kind} {name} is gone"
        if there[name] != (kind, text):
            return f"its {kind} {name} is not as labcal made it"
    foreign = [name for name, (kind, _) in there.items() if kind == "trigger" and name not in _expected()]
    return f"it has a trigger that labcal did not make, {foreign[0]}" if foreign else ""


def require(connection: sqlite3.Connection, path: Path) -> None:
    """Raise InputError where the store is of a version that is not known here, or its guards were tampered with."""
    version = connection.execute("PRAGMA user_version").fetchone()[0]
    if not 1 <= version <= VERSION:
        raise InputError(f"a store of version {version}; this labcal reads versions 1 to {VERSION}", file=path)
    if what := fault(connection):
        raise InputError(
            f"another program has changed this store: {what}. What was recorded may have been edited: set the file "
            "aside and go on with a copy from before, or with a new store; `labcal check-store` looks through it",
            file=path,
        )


def behind(connection: sqlite3.Connection) -> bool:
    """Whether anything is missing that `bring_up` adds."""
    older = connection.execute("PRAGMA user_version").fetchone()[0] != VERSION
    return older or not _expected().keys() <= _named(connection).keys()


def bring_up(connection: sqlite3.Connection) -> None:
    """Add guards and indexes that an earlier version did not make, inside an open transaction; no row is touched."""
    there = _named(connection)
    for name, (_, text) in _expected().items():
        if name not in there:
            connection.execute(text)
    connection.execute(f"PRAGMA user_version = {VERSION}")


def _added_after(version: int, name: str) -> bool:
    """Whether a store of `version` cannot have what is called so."""
    return (version < 3 and name.startswith(LATER[3])) or (version < 2 and name.endswith(LATER[2]))


@cache
def _expected() -> dict[str, tuple[str, str]]:
    memory = sqlite3.connect(":memory:")
    try:
        create(memory)
        return _named(memory)
    finally:
        memory.close()


def _named(connection: sqlite3.Connection) -> dict[str, tuple[str, str]]:
    """By name: its kind (table, index, trigger) and the text that made it, as SQLite keeps it."""
    rows = connection.execute("SELECT name, type, sql FROM sqlite_master WHERE sql IS NOT NULL")
    return {name: (kind, text) for name, kind, text in rows if not name.startswith("sqlite_")}


def _statements(text: str) -> Iterator[str]:
    """Statements one by one, since executescript would commit before it begins."""
    statement = ""
    for line in text.splitlines(keepends=True):
        statement += line
        if sqlite3.complete_statement(statement):
            yield statement
            statement = ""

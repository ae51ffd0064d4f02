"""The hash chain of a run: every row is bound to all rows before it, in the same transaction that writes it.

A row's link is the SHA-256 of the lines: the link before it (64 zeros before the first), the row's table, and one line
for each of its values: "-" for none, "real 0.5", "text HEX", "bytes HEX", HEX being the SHA-256 of the UTF-8 text or of
the bytes. The last link is the head of the chain: who knows it can tell any other record from this one.
"""

from __future__ import annotations

import sqlite3
from collections.abc import Sequence
from dataclasses import asdict, dataclass
from hashlib import sha256
from typing import Any

from labcal.store.items import ItemRow

FORMAT = "labcal-chain/1"  # stated in the head of a run that has one
START = "0" * 64
COLUMNS = {  # by table: the values that a link binds
    "run": ("run_id", "header"),
    "status": ("status", "utc"),
    "item": ItemRow._fields,
    "bundle": ("run_json", "samples_csv"),
    "origin": ("chain_jsonl",),
}
KEYS = {"run": "number", "status": "rowid", "item": "number", "bundle": "run", "origin": "run"}
LAST = "SELECT place, sha256 FROM chain WHERE run = ? ORDER BY place DESC LIMIT 1"


@dataclass(frozen=True, slots=True)
class Chain:
    """The head of a run's chain, its last link in lower-case hex, and how many rows it binds."""

    head: str
    rows: int

    def stated(self) -> dict[str, Any]:
        """As a calibration states it (contract: calibration file)."""
        return asdict(self)


class Misfit(Exception):
    """The first row that does not fit, in words."""


def link(before: str, table: str, values: Sequence[object]) -> str:
    """The link of a row of `table` that comes after the link `before`."""
    return sha256("".join(f"{line}\n" for line in (before, table, *map(_line, values))).encode()).hexdigest()


def begin(connection: sqlite3.Connection, run_id: str, header: str) -> int:
    """Add a run with the first link of its chain, inside a transaction that is open; returns the run's number."""
    number = _inserted(connection, "run", (run_id, header))
    _linked(connection, number, "run", number, 1, link(START, "run", (run_id, header)))
    return number


def append(connection: sqlite3.Connection, run: int, table: str, values: Sequence[object]) -> None:
    """Add a row of `run` with its link, inside a transaction that is open.

    A run that an earlier version began has no chain, and gets none.
    """
    row = _inserted(connection, table, values, run)
    if last := connection.execute(LAST, (run,)).fetchone():
        place, before = last
        _linked(connection, run, table, row, place + 1, link(before, table, values))


def walk(connection: sqlite3.Connection, run: int) -> Chain | None:
    """The chain of a run, every row of it looked at; None for a run of before there were chains.

    Raises Misfit at the first row that does not fit. Needs a transaction that is open, where somebody else may write.
    """
    if not connection.execute("SELECT 1 FROM sqlite_master WHERE name = 'chain'").fetchone():
        _refuse_one_that_is_gone(connection, run, None)
        return None  # not opened for work since an earlier version wrote it
    chain = Chain(START, 0)
    links = connection.execute("SELECT place, kept_in, row, sha256 FROM chain WHERE run = ? ORDER BY place", (run,))
    for place, table, row, stated in links:
        if place != chain.rows + 1:
            raise Misfit(f"link {chain.rows + 1} of its chain is gone")
        values = _values(connection, run, table, row, place)
        if link(chain.head, table, values) != stated:
            raise Misfit(f"{_named(table, row, values)}: it is not as it was written, or its link is not")
        chain = Chain(stated, place)
    if chain.rows:
        return _with_nothing_else(connection, run, chain)
    (earliest,) = connection.execute("SELECT min(run) FROM chain").fetchone()
    _refuse_one_that_is_gone(connection, run, earliest)
    return None


def parts(connection: sqlite3.Connection, run: int) -> list[tuple[str, int, str]]:
    """Table, row and link of everything that the chain of a run binds, in its order."""
    return connection.execute("SELECT kept_in, row, sha256 FROM chain WHERE run = ? ORDER BY place", (run,)).fetchall()


def values_of(connection: sqlite3.Connection, run: int, table: str, row: int) -> tuple[Any, ...] | None:
    """What a row of `run` holds, in the order of COLUMNS; None where it is not there."""
    query = f"SELECT {', '.join(COLUMNS[table])} FROM {table} WHERE {KEYS[table]} = ? AND {_run_key(table)} = ?"
    found: tuple[Any, ...] | None = connection.execute(query, (row, run)).fetchone()
    return found


def _values(connection: sqlite3.Connection, run: int, table: str, row: int, place: int) -> tuple[Any, ...]:
    if table not in COLUMNS:
        raise Misfit(f"link {place} of its chain is of no table that labcal makes")
    if (table == "run") != (place == 1):
        raise Misfit(f"link {place} of its chain is in another's place")
    values = values_of(connection, run, table, row)
    if values is None:
        raise Misfit(f"row {row} of {table} is gone, that link {place} of its chain binds")
    return values


def _with_nothing_else(connection: sqlite3.Connection, run: int, chain: Chain) -> Chain:
    """The chain, where it binds all that the run has. Raises Misfit."""
    for table, key in KEYS.items():
        bound = "SELECT row FROM chain WHERE run = ? AND kept_in = ?"
        query = f"SELECT min({key}) FROM {table} WHERE {_run_key(table)} = ? AND {key} NOT IN ({bound})"
        (stranger,) = connection.execute(query, (run, run, table)).fetchone()
        if stranger is not None:
            raise Misfit(f"row {stranger} of {table}: no link of its chain binds it")
    return chain


def _refuse_one_that_is_gone(connection: sqlite3.Connection, run: int, earliest: int | None) -> None:
    """Raise Misfit where a run without a chain had one: its head says so, and each run since `earliest` has."""
    stated = connection.execute(
        "SELECT CASE WHEN json_valid(header) THEN json_extract(header, '$.chain') END FROM run WHERE number = ?", (run,)
    ).fetchone()
    if stated[0] == FORMAT or (earliest is not None and run > earliest):
        raise Misfit("its chain is gone")


def _run_key(table: str) -> str:
    return "number" if table == "run" else "run"


def _inserted(connection: sqlite3.Connection, table: str, values: Sequence[object], run: int | None = None) -> int:
    columns = COLUMNS[table] if run is None else ("run", *COLUMNS[table])
    row = values if run is None else (run, *values)
    insert = f"INSERT INTO {table} ({', '.join(columns)}) VALUES ({', '.join('?' * len(columns))})"
    number = connection.execute(insert, tuple(row)).lastrowid
    assert number is not None
    return number


def _linked(connection: sqlite3.Connection, run: int, table: str, row: int, place: int, made: str) -> None:
    insert = "INSERT INTO chain (run, place, kept_in, row, sha256) VALUES (?, ?, ?, ?, ?)"
    connection.execute(insert, (run, place, table, row, made))


def _named(table: str, row: int, values: Sequence[object]) -> str:
    if table == "item":
        return f"row {row} ({values[0]})"
    return "its head" if table == "run" else f"row {row} of {table}"


def _line(value: object) -> str:
    if value is None:
        return "-"
    if isinstance(value, str):
        return f"text {sha256(value.encode()).hexdigest()}"
    if isinstance(value, bytes):
        return f"bytes {sha256(value).hexdigest()}"
    return f"real {value!r}" if isinstance(value, float) else f"integer {value!r}"

"""Looks through the whole store and tells the first thing that does not fit; it changes nothing."""

from __future__ import annotations

import json
import sqlite3
from contextlib import closing
from dataclasses import dataclass
from datetime import datetime
from pathlib import Path

import numpy as np

from labcal.errors import InputError, InstrumentError
from labcal.store import chain, schema
from labcal.store.bundle import Bundle
from labcal.store.database import PATIENCE_S, named_faults
from labcal.store.items import KINDS, SAMPLES, ItemRow, from_row, header_from_json
from labcal.store.origin import ends

ITEM = f"SELECT number, {', '.join(ItemRow._fields)} FROM item WHERE run = ? ORDER BY number"


@dataclass(frozen=True, slots=True)
class StoreCheck:
    """What was looked through, up to the first `fault`; "" where everything fits.

    `parsed`: how many rows' raw frames were parsed again.
    """

    runs: int
    items: int
    fault: str = ""
    parsed: int = 0


def check_store(path: Path, run_id: str | None = None) -> StoreCheck:
    """Look through the file, then every row of the run `run_id`, or of all runs.

    Raises InputError where there is no such file or run, InstrumentError where another program keeps it locked.
    """
    if not path.is_file():
        raise InputError("there is no store here yet", file=path)
    looked = _Look()
    try:
        with closing(sqlite3.connect(f"{path.resolve().as_uri()}?mode=ro", uri=True, timeout=PATIENCE_S)) as store:
            store.execute("BEGIN")  # one state of it, whoever writes meanwhile
            _check_file(store)
            for number, name in _runs(store, path, run_id):
                _check_run(store, number, name, looked)
    except chain.Misfit as misfit:
        return StoreCheck(looked.runs, looked.items, str(misfit))
    except sqlite3.Error as error:
        return StoreCheck(looked.runs, looked.items, _fault_in_words(error, path))
    return StoreCheck(looked.runs, looked.items)


@dataclass
class _Look:
    runs: int = 0
    items: int = 0


def _fault_in_words(error: sqlite3.Error, path: Path) -> str:
    """What SQLite met, in words. Raises InstrumentError where it could not look at all."""
    try:
        with named_faults(path):
            raise error
    except InputError as fault:
        return fault.what
    except InstrumentError as fault:
        if fault.fault in ("store locked", "disk full"):
            raise
        return fault.what


def _check_file(store: sqlite3.Connection) -> None:
    """The pages, the guards, and that every row belongs to a run that is there."""
    if store.execute("PRAGMA application_id").fetchone()[0] != schema.APPLICATION:
        raise chain.Misfit("it is a database of another program, not a store of labcal")
    if what := schema.fault(store):
        raise chain.Misfit(f"another program has changed this store: {what}")
    (found,) = store.execute("PRAGMA integrity_check(1)").fetchone()
    if found != "ok":
        raise chain.Misfit(f"a page is damaged: {' '.join(found.split())}")
    orphans = sorted(store.execute("PRAGMA foreign_key_check"), key=lambda found: found[0] == "chain")
    if orphans:  # links come last: they have no number of their own
        raise chain.Misfit(f"row {orphans[0][1]} of {orphans[0][0]} is of a run that is not there")


def _runs(store: sqlite3.Connection, path: Path, run_id: str | None) -> list[tuple[int, str]]:
    if run_id is None:
        return list(store.execute("SELECT number, run_id FROM run ORDER BY number"))
    if not (found := list(store.execute("SELECT number, run_id FROM run WHERE run_id = ?", (run_id,)))):
        raise InputError(f"the store has no run called {run_id}; `labcal runs` lists those it has", file=path)
    return found


def _check_run(store: sqlite3.Connection, number: int, run_id: str, looked: _Look) -> None:
    statuses = list(store.execute("SELECT status, utc FROM status WHERE run = ? ORDER BY rowid", (number,)))
    imported = store.execute("SELECT run_json, samples_csv FROM bundle WHERE run = ?", (number,)).fetchone()
    (header,) = store.execute("SELECT header FROM run WHERE number = ?", (number,)).fetchone()
    for wrong in (_of_statuses(statuses, imported is not None), _of_head(run_id, header, imported)):
        if wrong:
            raise chain.Misfit(f"run {run_id}: {wrong}")
    for row_number, *row in store.execute(ITEM, (number,)):
        item = ItemRow(*row)
        if wrong := "it lies in an imported run" if imported else _of_item(item):
            raise chain.Misfit(f"run {run_id}, row {row_number} ({item.kind}): {wrong}")
        looked.items += 1
    try:
        chain.walk(store, number)
    except chain.Misfit as misfit:
        raise chain.Misfit(f"run {run_id}: {misfit}") from None
    looked.runs += 1


def _of_statuses(statuses: list[tuple[str, str]], imported: bool) -> str:
    """What is wrong with how a run stood, one after the other."""
    words = [str(status) for status, _ in statuses]
    if words[:1] != ["imported" if imported else "running"]:
        return f"its first status is {words[0] if words else 'missing'}"
    for word, (_, utc) in zip(words, statuses, strict=True):
        if word not in ("running", "interrupted") and not ends(word):
            return f"{word!r} is no status"
        if not _is_time(utc):
            return f"{utc!r} is no time of a status"
    if ended := [word for word in words[:-1] if ends(word)]:
        return f"it was {ended[0]}, and another status follows"
    return ""


def _of_head(run_id: str, header: str, imported: tuple[bytes, bytes] | None) -> str:
    try:
        if imported is None:
            named = header_from_json(header).run_id
        else:
            named = Bundle(*imported, Path(run_id)).run().run_id
            if header != imported[0].decode("utf-8-sig"):
                return "its head is not its bundle's"
    except (ValueError, TypeError) as error:
        return str(error)
    return "" if named == run_id else f"its head is of run {named}"


def _of_item(row: ItemRow) -> str:
    """What is wrong with a row of the timeline."""
    if row.kind not in KINDS:
        return "no labcal writes such a row"
    try:
        if wrong := _of_block(row) if row.kind == "block" else _of_words(row):
            return wrong
        from_row(row)
    except (ValueError, KeyError, TypeError) as error:
        return f"it cannot be read: {error}"
    return ""


def _of_words(row: ItemRow) -> str:
    if not (row.stamps is row.samples is row.raw is None):
        return "it has samples and is no block"
    return "" if json.loads(row.content)["t_s"] == row.t_s else "its time is not the one it states"


def _of_block(row: ItemRow) -> str:
    columns, stamps = json.loads(row.content)["columns"], row.stamps or b""
    if len(stamps) % SAMPLES.itemsize or not stamps:
        return f"{len(stamps)} bytes of stamps are no numbers"
    if len(row.samples or b"") != len(stamps) * len(columns):
        return f"{len(row.samples or b'')} bytes of samples where {len(stamps) * len(columns)} belong to its stamps"
    t_s = np.frombuffer(stamps, SAMPLES)
    return "" if t_s[0] == row.t_s and np.isfinite(t_s).all() else "its stamps are not those it was written with"


def _is_time(utc: str) -> bool:
    try:
        datetime.fromisoformat(utc)
    except (ValueError, TypeError):
        return False
    return True

"""A run that is written without its hash chain, as before there were chains: to measure what the chain costs."""

from __future__ import annotations

import sqlite3
from contextlib import closing

from labcal.record import Dut, Reference, RunHeader
from labcal.store import RunWriter, Store


def begun(store: Store, name: str, *, chained: bool) -> RunWriter:
    """A run that is written; without its first link it is one of a labcal before there were chains, and gets none."""
    writer = store.begin(RunHeader(name, "2026-01-01T00:00:00Z", True, "", Dut("1"), Reference("vector")))
    if not chained:
        with closing(sqlite3.connect(store.path)) as connection, connection:
            (guard,) = connection.execute("SELECT sql FROM sqlite_master WHERE name = 'chain_delete'").fetchone()
            connection.execute("DROP TRIGGER chain_delete")
            connection.execute("DELETE FROM chain WHERE run = (SELECT max(number) FROM run)")
            connection.execute(guard)
    return writer

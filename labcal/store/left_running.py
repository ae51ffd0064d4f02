"""The run of a bench that nobody has ended: another process drives it still, or was killed and said nothing more."""

from __future__ import annotations

import tomllib
from contextlib import closing
from pathlib import Path

from labcal.record.left_running import LeftRunning
from labcal.store.database import connect, named_faults
from labcal.store.listing import LAST_CORRECTION, LAST_STATUS, corrected, lock_file
from labcal.store.liveness import is_alive

HEAD = "CASE WHEN json_valid(header) THEN json_extract(header, '$.{}') END"
LAST_SAID = "(SELECT max(rowid) FROM status WHERE status.run = run.number)"  # a run that was gone on with is newer


def left_running(path: Path, bench: str) -> LeftRunning | None:
    """Of the store at `path` the last run on the bench of this name, where that has no end.

    Of one that ended its process has said how it left the coils, and a later run has read them. Raises InputError.
    """
    if not path.is_file():
        return None
    with closing(connect(path)) as connection, named_faults(path):
        heads = ", ".join((HEAD.format("bench"), HEAD.format("dut.serial"), LAST_STATUS, LAST_CORRECTION))
        for run_id, text, serial, status, correction in connection.execute(
            f"SELECT run_id, {heads} FROM run WHERE {LAST_SAID} NOT NULL ORDER BY {LAST_SAID} DESC"
        ):
            if _name(text) == bench:
                alive = status == "running" and is_alive(lock_file(path, run_id))
                return LeftRunning(run_id, corrected(correction) or serial, alive) if status == "running" else None
    return None


def _name(text: str | None) -> str | None:
    """Of the bench in the file `text`; None of a run that was imported."""
    try:
        return str(tomllib.loads(text or "").get("name")) if text else None
    except tomllib.TOMLDecodeError:
        return None

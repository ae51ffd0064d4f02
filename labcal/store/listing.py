"""The list of a store's runs: of each its head and how it stands, without what reads rows and bundles."""

from __future__ import annotations

import json
from contextlib import closing, suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from labcal.errors import InputError
from labcal.files.home import home
from labcal.record.bench_kind import bench_kind
from labcal.record.endings import BY_ABORT, STOPPED, STOPPED_BY, ended_word
from labcal.record.run_id import as_file_name
from labcal.store.database import Connection, connect, named_faults
from labcal.store.liveness import is_alive
from labcal.store.schema import IS_CORRECTION

FILE = "store.sqlite"
LAST_CORRECTION = (
    f"(SELECT content FROM item WHERE item.run = run.number AND {IS_CORRECTION} ORDER BY item.number DESC LIMIT 1)"
)
HEAD = "CASE WHEN json_valid(header) THEN json_extract(header, {}) END".format(
    ", ".join(f"'$.{key}'" for key in ("started_utc", "dut.serial", "simulated", "operator", "procedure"))
)  # of a header, what a list shows: a bench file and more stand in it too
LAST_STATUS = "(SELECT status FROM status WHERE status.run = run.number ORDER BY status.rowid DESC LIMIT 1)"
BEGUN_ON = f"""CASE WHEN json_valid(header) AND {LAST_STATUS} IN ('running', 'interrupted')
THEN json_extract(header, '$.bench', '$.instruments') END"""  # of those that may be gone on with alone: it is long
IDENTITY = ("manufacturer", "model", "serial", "firmware")

BY_A_PERSON = f"""(SELECT (kind = 'event') * ((content LIKE '%"{STOPPED_BY}"%') + (content LIKE '%"{BY_ABORT}"%'))
FROM item WHERE item.run = run.number ORDER BY item.number DESC LIMIT 1)"""  # by its last word; 2 where by COILS OFF


@dataclass(frozen=True, slots=True)
class RunSummary:
    """One line about a run, for a list. `status`: running, finished, stopped, failed: …, interrupted, imported.

    `stopped`: a person ended it, whether or not it can be gone on with; `by_off`: by COILS OFF in the window.
    `bench`: of one that was interrupted, the name of the bench it was begun on; `instruments`: who answered there then,
    each by its name and as it said who it is; `bench_kind`: whether that was real, simulated or served.
    """

    run_id: str
    started_utc: str
    status: str
    dut_serial: str
    operator: str
    procedure: str
    simulated: bool
    stopped: bool = False
    by_off: bool = False
    bench: str = ""
    instruments: tuple[tuple[str, str], ...] = ()
    bench_kind: str = ""


def list_runs(path: Path | None = None) -> list[RunSummary]:
    """All runs of the store at `path` (default: the user's own), the oldest first. Raises as `Store.open` does."""
    path = home() / FILE if path is None else path
    with closing(connect(path)) as connection:
        return summaries(connection, path)


def summaries(connection: Connection, path: Path, number: int | None = None) -> list[RunSummary]:
    """All runs, the oldest first; with `number` the one that the store has under it."""
    chosen = "" if number is None else f" WHERE number = {number:d}"
    with named_faults(path):
        rows = connection.execute(
            f"SELECT run_id, {HEAD}, {LAST_STATUS}, {LAST_CORRECTION}, {BY_A_PERSON}, {BEGUN_ON} "
            f"FROM run{chosen} ORDER BY number"
        ).fetchall()
    heads = json.loads(f"[{','.join(head or 'null' for _, head, *_ in rows)}]")  # read at once: there may be many
    return [_summary(path, row[0], head, *row[2:]) for row, head in zip(rows, heads, strict=True)]


def true_status(path: Path, run_id: str, written: str) -> str:
    """How a run stands that was left with the status `written`."""
    if written != "running" or is_alive(lock_file(path, run_id)):
        return written
    return "interrupted"


def lock_file(path: Path, run_id: str) -> Path:
    """What the writer of a run keeps locked as long as it lives."""
    return path.with_name(f"{path.name}-writers") / f"{as_file_name(run_id)}.lock"


def corrected(event: str | None) -> str:
    """The serial that the JSON of a correction states; "" where there was none."""
    return str(json.loads(event)["data"]["to"]) if event else ""


def _begun_on(text: str | None) -> tuple[str, tuple[tuple[str, str], ...], str]:
    """The name of the bench, its instruments as they said who they are, and its kind; nothing of one that says none."""
    import tomllib  # for the few that were interrupted

    bench, instruments = json.loads(text) if text else ("", ())
    with suppress(tomllib.TOMLDecodeError):
        name = tomllib.loads(bench or "").get("name", "")
        who = tuple((one["name"], " ".join(filter(None, map(one.get, IDENTITY)))) for one in instruments)
        return str(name), who, bench_kind(bench or "")
    return "", (), ""


def _summary(
    path: Path,
    run_id: str,
    head: list[Any] | None,
    status: str,
    correction: str | None,
    by_person: int | None,
    begun_on: str | None,
) -> RunSummary:
    started_utc, serial, simulated, operator, procedure = head or [None] * 5
    if started_utc is None or serial is None or simulated is None:
        raise InputError(f"the store is damaged: the header of run {run_id!r}", file=path)
    stands = true_status(path, run_id, status)
    bench, instruments, kind = _begun_on(begun_on if stands == "interrupted" else None)
    return RunSummary(
        run_id=run_id,
        started_utc=started_utc,
        status=stands,
        dut_serial=corrected(correction) or serial,
        operator=operator or "",
        procedure=procedure or "",
        simulated=simulated,
        stopped=(stopped := ended_word(status, stopped=bool(by_person)) == STOPPED),
        by_off=stopped and (by_person or 0) > 1,
        bench=bench,
        instruments=instruments,
        bench_kind=kind,
    )

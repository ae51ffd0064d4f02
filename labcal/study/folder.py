"""The folder of a study: a small file for each job that is done, whole or absent, by which a study is gone on with."""

from __future__ import annotations

import json
from collections.abc import Iterable
from pathlib import Path

from labcal.files.atomic import write_bytes
from labcal.study.job import Job, Row

JOBS = "jobs"


def open_folder(out: Path) -> None:
    """Make the folder; what a killed study left half-written of a job goes."""
    (out / JOBS).mkdir(parents=True, exist_ok=True)
    for part in (out / JOBS).glob(".*.json.*.part"):
        part.unlink(missing_ok=True)


def keep(out: Path, job: Job, row: Row) -> Row:
    """Write the row of a job that is done; returns it as it will be read, its columns in their order."""
    said = {"job": job.key, "kind": job.kind, "row": row}
    text = json.dumps(said, separators=(",", ":"), ensure_ascii=False, allow_nan=False)
    write_bytes(_place(out, job), text.encode() + b"\n")
    kept: Row = json.loads(text)["row"]
    return kept


def done(out: Path, jobs: Iterable[Job]) -> dict[str, Row]:
    """The rows that are kept, by the jobs' keys; a file that is not whole, or another's, counts for nothing."""
    found = ((job.key, _read(_place(out, job), job)) for job in jobs)
    return {key: row for key, row in found if row is not None}


def _read(place: Path, job: Job) -> Row | None:
    try:
        said = json.loads(place.read_bytes())
        whole = said["job"] == job.key and isinstance(said["row"], dict)
    except (OSError, ValueError, KeyError, TypeError, RecursionError):
        return None
    return said["row"] if whole else None


def _place(out: Path, job: Job) -> Path:
    return out / JOBS / f"{job.key}.json"

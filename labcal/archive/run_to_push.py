"""A finished run made ready for the archive: its bundle as a zip, and what the catalogue says of it.

It is light to import and needs neither the archive nor its secrets: processes of their own do it.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from contextlib import closing
from dataclasses import dataclass, replace
from hashlib import sha256
from pathlib import Path
from tempfile import mkstemp

from labcal.archive.rows import Row, instruments_of_run, run_row
from labcal.errors import InputError
from labcal.files.home import home
from labcal.record import Run
from labcal.store import Bundle, Store, zipped
from labcal.store.listing import FILE as STORE

FINISHED = ("finished", "imported")


@dataclass(frozen=True, slots=True)
class RunToPush:
    """`row` and `instruments` are those of the catalogue; `kept_head` is its chain's in the store it came from."""

    run_id: str
    sha256: str
    zipped: bytes
    bundle_sha256: str  # of `zipped`
    row: Row
    instruments: list[Row]
    chain_head: str | None = None
    kept_head: str | None = None


def of_bundle(
    bundle: Bundle,
    run: Run | None = None,
    status: str = "imported",
    procedure: str = "",
    instruments: Iterable[Mapping[str, str]] = (),
    kept_head: str | None = None,
) -> RunToPush:
    """The run of a bundle."""
    run = bundle.run() if run is None else run
    chain = bundle.stated_chain
    content = zipped(bundle)
    return RunToPush(
        run.run_id,
        bundle.sha256,
        content,
        sha256(content).hexdigest(),
        run_row(run, status, procedure),
        instruments_of_run(run, instruments),
        str(chain["head"]) if chain else None,
        kept_head,
    )


def of_store(run_id: str) -> RunToPush:
    """A run of this user's store. Raises InputError where it has not finished, or does not fit its chain."""
    return of_bundle(*read(run_id))


def of_store_into(folder: str, run_id: str) -> tuple[RunToPush, Path]:
    """The same, its zip in a file of `folder`: a process that is killed inside a long answer is waited for for ever."""
    one = of_store(run_id)
    number, path = mkstemp(dir=folder)
    with open(number, "wb") as file:
        file.write(one.zipped)
    return replace(one, zipped=b""), Path(path)


def taken(one: RunToPush, path: Path) -> RunToPush:
    """What `of_store_into` made, its file gone."""
    content = path.read_bytes()
    path.unlink()
    return replace(one, zipped=content)


def read(run_id: str) -> tuple[Bundle, Run, str, str, Iterable[Mapping[str, str]], str | None]:
    """What `of_bundle` takes, of a run of this user's store. Raises InputError as `of_store` does."""
    with closing(Store.read_only(home() / STORE)) as store:
        summary, head = store.summary(run_id), store.head_of(run_id)
        if summary.status not in FINISHED:
            raise InputError(f"run {run_id} is {summary.status}: only a finished run goes into the archive")
        bundle, run = store.bundle_and_run(run_id)
        instruments = () if summary.status == "imported" else store.header(run_id).instruments
    return bundle, run, summary.status, summary.procedure, instruments, head

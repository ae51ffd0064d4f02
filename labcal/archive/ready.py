"""Runs made ready before anybody pushes: each in one file of labcal's folder, until a push has put it into the archive.

The file is called by what it was made of: the head of the run's chain, which binds all rows of its record, and the
programs that made it. A run that was corrected since, or another labcal, looks for another file. Each may go at any
time, for then the push makes the run ready itself.

A file is three things: the SHA-256 of the next line and a line end, a line of JSON that states the zip's, the zip.
"""

from __future__ import annotations

import json
import time
from collections.abc import Iterable
from contextlib import suppress
from dataclasses import asdict, replace
from hashlib import sha256
from pathlib import Path
from typing import Any

import numpy as np

from labcal.archive.rows import utc
from labcal.archive.run_to_push import RunToPush
from labcal.errors import InputError
from labcal.files.atomic import write_bytes
from labcal.files.home import FILE, home, own_folder
from labcal.version import __version__, sources

HALVES_S = 3600.0  # so long nobody writes at one: who did was killed
FOLDER, ENDING, FORMAT = "made-ready", ".run", "labcal-made-ready/2"


def want() -> None:
    """From now on runs are made ready when they have ended: who has pushed once will push again."""
    with suppress(OSError):
        own_folder(folder())


def folder() -> Path:
    """Where they lie; runs are made ready where it is there."""
    return home() / FOLDER


def keep(one: RunToPush) -> None:
    """Keep a run of this user's store, whole or not at all. Raises OSError, InputError where the place takes none."""
    if one.kept_head is None:  # of before there were chains: nothing binds its record
        return
    stated = asdict(replace(one, zipped=b"")) | {"zipped": None}
    line = json.dumps(stated, default=str).encode()
    made = b"\n".join((sha256(line).hexdigest().encode(), line, one.zipped))
    write_bytes(_path(one.kept_head), made, FILE)


def is_kept(head: str | None) -> bool:
    """Whether there is a file for a run whose chain has this head; not whether it is sound."""
    return head is not None and _path(head).is_file()


def kept(run_id: str, head: str | None) -> RunToPush | None:
    """A run whose chain has this head, from its file, as `run_to_push.of_store` made it; None without a sound one.

    The chain was held against the run's record when the file was made, and its head tells that record from any other:
    a record that was damaged since is in the archive as it was.
    """
    found = None if head is None else _read(_path(head))
    return found if found and (found.run_id, found.kept_head) == (run_id, head) else None


def forget(head: str | None) -> None:
    """Remove the file of a run, which is in the archive now, or has to be made anew."""
    if head is not None:
        with suppress(OSError):
            _path(head).unlink()


def forget_all_but(heads: Iterable[str | None]) -> None:
    """Remove what was made of records that have gone on since, or by another labcal, and halves of before an hour."""
    wanted = {_path(head) for head in heads if head is not None}
    for path in folder().glob("*"):
        with suppress(OSError):
            if path not in wanted and (path.suffix == ENDING or time.time() - path.stat().st_mtime > HALVES_S):
                path.unlink()


def _path(head: str) -> Path:
    """Rows decide the samples up to their last bits, which the labcal and the numpy that interpolate them decide."""
    made_of = "\n".join((FORMAT, head, __version__, sources(), np.__version__))
    return folder() / f"{sha256(made_of.encode()).hexdigest()}{ENDING}"


def _read(path: Path) -> RunToPush | None:
    """What `keep` wrote, each byte as it was written; else None."""
    with suppress(OSError, ValueError, TypeError, KeyError, InputError):
        with path.open("rb") as file:
            digest, line, zipped = file.readline(), file.readline(), file.read()
        if sha256(line.rstrip(b"\n")).hexdigest().encode() == digest.rstrip(b"\n"):
            found: dict[str, Any] = json.loads(line)
            found["row"]["started_utc"] = utc(found["row"]["started_utc"])
            one = RunToPush(**found | {"zipped": zipped})
            return one if sha256(zipped).hexdigest() == one.bundle_sha256 else None
    return None

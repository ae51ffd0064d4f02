"""Whether the files a connection writes to are still the ones at their path: SQLite itself does not look again."""

from __future__ import annotations

import os
from collections.abc import Mapping
from pathlib import Path

from labcal.errors import InstrumentError

BESIDE = ("", "-wal", "-shm")
Files = Mapping[str, tuple[int, int]]


def files_at(path: Path) -> Files:
    """By the end of its name: device and inode of the store and of each file beside it that is there."""
    found = dict[str, tuple[int, int]]()
    for end in BESIDE:
        try:
            told = os.stat(f"{path}{end}")
        except OSError:
            continue
        found[end] = told.st_dev, told.st_ino
    return found


def require_same(path: Path, opened: Files) -> None:
    """Raise InstrumentError (store gone) where the files at `path` are not those that were `opened`."""
    there = files_at(path)
    for end, which in opened.items():
        if there.get(end) != which:
            what = "is another file than before" if end in there else "is no longer there"
            raise InstrumentError(
                f"{path}{end}: {what}: somebody moved, removed or replaced it while it was written to.",
                fault="store gone",
                remedy="Put that file back, or a copy of the store, and go on with the run; the last rows are lost.",
            )

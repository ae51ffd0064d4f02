"""Whether the files a connection writes to are still the ones at their path, and where they lie."""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping
from contextlib import suppress
from pathlib import Path

from labcal.errors import InstrumentError

BESIDE = ("", "-wal", "-shm")
Which = tuple[int, int]  # device and inode
Files = Mapping[str, Which]
OPEN_FILES = Path("/proc/self/fd")
REMOVED = " (deleted)"  # as Linux ends the name of an open file that has none any more


def files_at(path: Path) -> Files:
    """By the end of its name: device and inode of the store and of each file beside it that is there."""
    found = dict[str, tuple[int, int]]()
    for end in BESIDE:
        try:
            status = os.stat(f"{path}{end}")
        except OSError:
            continue
        found[end] = status.st_dev, status.st_ino
    return found


def require_same(path: Path, opened: Files) -> None:
    """Raise InstrumentError (store gone) where the files at `path` are not those that were `opened`."""
    there = files_at(path)
    for end, which in opened.items():
        if there.get(end) != which:
            another = ", and another file lies there" if end in there else ""
            happened, remedy = _what_became_of(end, which)
            what = f"{path}{end}: it {happened} while it was written to{another}."
            raise InstrumentError(what, fault="store gone", remedy=remedy)


def open_here(which: Which) -> Iterator[Path]:
    """The handles by which this process has that file open, as links to where it lies; none where nothing tells."""
    with suppress(OSError):
        for handle in OPEN_FILES.iterdir():
            with suppress(OSError):
                status = handle.stat()
                if (status.st_dev, status.st_ino) == which:
                    yield handle


def _what_became_of(end: str, which: Which) -> tuple[str, str]:
    """What happened to an open file, and what can be done, as far as the system knows."""
    lies = next((str(handle.readlink()) for handle in open_here(which)), "")
    copy = "put a copy of the store in its place; without one what it held is lost."
    if lies.endswith(REMOVED):
        left = "`labcal check-store` looks at what is left; what was committed last may be lost."
        return "was removed", left if end else copy.capitalize()
    back = "ove it back, with what lies beside it (-wal, -shm), then go on with the run."
    if lies:
        return f"was moved to {lies}", f"M{back}"
    return "was moved, removed or replaced", f"If it was moved, m{back} If not, {copy}"

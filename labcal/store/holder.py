"""Who holds the lock of a store: asked of the system by a handle that SQLite has open already.

A handle of one's own is no way: when it is closed, the locks of the whole process on that file are gone.
"""

from __future__ import annotations

import struct
import sys
from contextlib import suppress
from pathlib import Path

from labcal.store.place import files_at, open_here

WRITE_LOCK = 120  # byte of the -shm file that a writer locks: sqlite.org/walformat.html, 2.3
FLOCK = "hhqqi4x"  # struct flock of Linux: type, whence, start, length, process


def holder(path: Path) -> str:
    """Who keeps others from writing into the store just now: "process 42 (python3)"; "" where that is not known."""
    for process in _processes(path):
        name = ""
        with suppress(OSError):
            name = f" ({Path(f'/proc/{process}/comm').read_text(encoding='utf-8', errors='replace').strip()})"
        return f"process {process}{name}"
    return ""


if sys.platform == "linux":
    import fcntl

    def _processes(path: Path) -> list[int]:
        """The process that has the lock; none of this process itself, and none that this machine does not number."""
        asked = struct.pack(FLOCK, fcntl.F_WRLCK, 0, WRITE_LOCK, 1, 0)
        for handle in open_here(files_at(path).get("-shm", (0, 0))):
            with suppress(OSError):
                kind, *_, process = struct.unpack(FLOCK, fcntl.fcntl(int(handle.name), fcntl.F_GETLK, asked))
                return [process] if kind != fcntl.F_UNLCK and process > 0 else []
        return []
else:

    def _processes(path: Path) -> list[int]:
        """Nobody tells."""
        return []

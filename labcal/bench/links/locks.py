"""One lock file: who has it holds the port. The lock dies with its process; the file says how that one is reached.

Whatever else lies under its name (a link, a pipe, a folder, another's file) is never followed, opened for good, or
waited for: it is set aside.
"""

from __future__ import annotations

import json
import os
import stat
import sys
import time
from contextlib import suppress
from pathlib import Path
from typing import IO, Any

from labcal.bench.links import places
from labcal.bench.links.holders import locker

PATIENCE_S = 0.3  # who only looks whether a port is held holds it for a moment; who makes a file needs one
LONGEST = 65536  # characters that a holder says
FLAGS = os.O_RDWR | getattr(os, "O_NOFOLLOW", 0) | getattr(os, "O_NONBLOCK", 0)


def take(path: Path) -> IO[str] | None:
    """The lock of `path`, for as long as it is open; None where another process has it.

    Raises OSError where there can be no such file.
    """
    for _ in range(2):
        file, odd = _taken_in_time(path)
        if not odd:
            return file
        path.rename(path.with_name(f".{path.name}.{os.urandom(4).hex()}.aside"))
    return None


def _taken_in_time(path: Path) -> tuple[IO[str] | None, bool]:
    """The lock; or None, and whether what lies there is nothing that anybody could hold."""
    deadline = time.monotonic() + PATIENCE_S
    while True:
        odd = False
        try:
            file = _open(path) or _make(path)
        except OSError:
            if not os.path.lexists(path):
                raise
            odd = locker(path) is None
        else:
            if try_lock(file):
                if stands(file, path):
                    return file, False
                odd = os.fstat(file.fileno()).st_nlink > 1  # it has a second name, and would be written to
            file.close()
        if time.monotonic() > deadline:
            return None, odd
        time.sleep(0.01)


def look(path: Path) -> dict[str, Any] | None:
    """What the process that has this lock has written ({} if nothing yet); None where none has it."""
    try:
        file = _open(path)
    except OSError:
        return None if locker(path) is None else {}
    if file is None:
        return None
    with file:
        return None if try_lock(file, to_look=True) else read(file)


def read(file: IO[str]) -> dict[str, Any]:
    """What is written there; {} where that is nothing, or spoilt."""
    try:
        file.seek(0)
        card = json.loads(file.read(LONGEST))
    except (OSError, ValueError, RecursionError):
        return {}
    return card if isinstance(card, dict) else {}


def left_behind(path: Path) -> dict[str, Any]:
    """What a process had written here that died without giving the lock back; {} where one has it, or none did."""
    with suppress(OSError):
        if (file := _open(path)) is not None:
            with file:
                return read(file) if try_lock(file, to_look=True) else {}
    return {}


def text_of(path: Path) -> str:
    """What a plain file says. Raises OSError where there is none, or something else."""
    if (file := _open(path)) is None:
        raise FileNotFoundError(path)
    with file:
        return file.read(LONGEST)


def write(file: IO[str], card: dict[str, Any]) -> None:
    """Say how the holder is reached, or nothing; where the disk is full nothing is said."""
    with suppress(OSError):
        file.seek(0)
        file.truncate()
        file.write(json.dumps(card) if card else "")
        file.flush()


def release(file: IO[str], path: Path) -> None:
    """Give the lock back, and take its file away."""
    with suppress(OSError):
        if stands(file, path):
            path.unlink()
    with suppress(OSError):
        file.close()


def _open(path: Path) -> IO[str] | None:
    """The file that is there; None where nothing is. Raises OSError for whatever is no plain file that may be read."""
    try:
        handle = os.open(path, FLAGS)
    except FileNotFoundError:
        return None
    if not stat.S_ISREG(os.fstat(handle).st_mode):
        os.close(handle)
        raise OSError(f"{path} is no plain file")
    return os.fdopen(handle, "r+", encoding="utf-8", errors="replace")


def _make(path: Path) -> IO[str]:
    handle = os.open(path, FLAGS | os.O_CREAT | os.O_EXCL, places.OWN)
    places.belongs(handle)
    return os.fdopen(handle, "r+", encoding="utf-8", errors="replace")


def stands(file: IO[str], path: Path) -> bool:
    """Whether this is the file of that name, and of no other; a holder before took his away when he let go."""
    with suppress(OSError):
        own = os.fstat(file.fileno())
        return os.path.samestat(own, os.lstat(path)) and own.st_nlink == 1
    return False


def try_lock(file: IO[str], *, to_look: bool = False) -> bool:
    """Whether the lock could be had now; `to_look`: together with others who only look, where the system has that."""
    try:
        if sys.platform == "win32":
            import msvcrt

            file.seek(1 << 20)  # far behind the text, which others must be able to read
            msvcrt.locking(file.fileno(), msvcrt.LK_NBLCK, 1)
            file.seek(0)
        else:
            import fcntl

            fcntl.flock(file, (fcntl.LOCK_SH if to_look else fcntl.LOCK_EX) | fcntl.LOCK_NB)
    except OSError:
        file.seek(0)
        return False
    return True

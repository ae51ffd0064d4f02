"""Whether a run's writer still lives: a lock on a file, which dies with the process that holds it, however it dies."""

from __future__ import annotations

import os
import sys
import time
import weakref
from pathlib import Path

from labcal.errors import InstrumentError

if sys.platform == "win32":
    import msvcrt

    def _lock(handle: int, *, shared: bool) -> None:
        msvcrt.locking(handle, msvcrt.LK_NBLCK, 1)
else:
    import fcntl

    def _lock(handle: int, *, shared: bool) -> None:
        fcntl.flock(handle, (fcntl.LOCK_SH if shared else fcntl.LOCK_EX) | fcntl.LOCK_NB)


class Alive:
    """Held by the writer of a run for as long as it writes; no other writer can hold the same."""

    def __init__(self, path: Path) -> None:
        """Take the lock `path`. Raises InstrumentError where another writer has it."""
        path.parent.mkdir(parents=True, exist_ok=True)
        self._handle = os.open(path, os.O_RDWR | os.O_CREAT, 0o666)
        try:
            _patiently(self._handle)
        except OSError:
            os.close(self._handle)
            raise InstrumentError("the run is being written by another program", fault="store locked") from None
        _held.add(self)

    def end(self) -> None:
        """Let go; the second call does nothing. The empty file stays: its removal would race with the next writer."""
        if self in _held:
            _held.discard(self)
            os.close(self._handle)

    def forget(self) -> None:
        """In a forked child: the lock is the parent's alone and must not outlive it here."""
        os.close(self._handle)


def is_alive(path: Path) -> bool:
    """Whether a process holds the lock `path`."""
    try:
        handle = os.open(path, os.O_RDWR)
    except FileNotFoundError:
        return False
    try:
        _lock(handle, shared=True)
    except OSError:
        return True
    finally:
        os.close(handle)
    return False


_held: weakref.WeakSet[Alive] = weakref.WeakSet()


def _forget_all() -> None:
    for alive in list(_held):
        alive.forget()
    _held.clear()


if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_forget_all)


def _patiently(handle: int) -> None:
    """Lock for writing; a reader that looks just now is waited for."""
    for _ in range(20):
        try:
            return _lock(handle, shared=False)
        except OSError:
            time.sleep(0.05)
    return _lock(handle, shared=False)

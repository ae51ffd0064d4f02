"""Whether a run's writer still lives: a lock on a file, which dies with the process that holds it, however it dies.

The file names its writer. A lock that somebody else holds, for whatever reason, makes no dead writer alive.
"""

from __future__ import annotations

import os
import platform
import sys
import time
import weakref
from pathlib import Path

from labcal.errors import InstrumentError
from labcal.files.home import FILE, own_folder, tightened

if sys.platform == "win32":
    import msvcrt

    def _lock(handle: int, *, shared: bool) -> None:
        msvcrt.locking(handle, msvcrt.LK_NBLCK, 1)
else:
    import fcntl

    def _lock(handle: int, *, shared: bool) -> None:
        fcntl.flock(handle, (fcntl.LOCK_SH if shared else fcntl.LOCK_EX) | fcntl.LOCK_NB)


LONGEST = 200  # bytes of a writer's name
NAMES = sys.platform != "win32"  # there a locked file cannot be read


class Alive:
    """Held by the writer of a run for as long as it writes; no other writer can hold the same."""

    def __init__(self, path: Path) -> None:
        """Take the lock `path`. Raises InstrumentError where another writer, or anybody else, has it."""
        own_folder(path.parent)
        self._handle = os.open(path, os.O_RDWR | os.O_CREAT, FILE)
        try:
            tightened(path)
            _patiently(self._handle)
            if sys.platform != "win32":
                os.truncate(self._handle, 0)
                os.pwrite(self._handle, _name(os.getpid()).encode(), 0)
        except OSError:
            writer = _writer_lives(self._handle)
            os.close(self._handle)
            raise _taken(path, writer) from None
        _held.add(self)

    def end(self) -> None:
        """Let go; the second call does nothing. The file stays: its removal would race with the next writer."""
        if self in _held:
            _held.discard(self)
            os.close(self._handle)

    def forget(self) -> None:
        """In a forked child: the lock is the parent's alone and must not outlive it here."""
        os.close(self._handle)


def is_alive(path: Path) -> bool:
    """Whether the writer that took the lock `path` still holds it."""
    try:
        handle = os.open(path, os.O_RDWR)
    except FileNotFoundError:
        return False
    try:
        _lock(handle, shared=True)
    except OSError:
        return _writer_lives(handle)
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


def _taken(path: Path, by_a_writer: bool) -> InstrumentError:
    if by_a_writer:
        return InstrumentError("the run is being written by another program", fault="store locked")
    remedy = f"The run's writer is dead. End the program that holds the file (`fuser {path}` names it), or remove it."
    return InstrumentError(f"{path}: locked by a program that is no writer.", fault="store locked", remedy=remedy)


def _writer_lives(handle: int) -> bool:
    """Whether the process lives that a locked file names; one that names nobody, or of another host, is believed."""
    if sys.platform == "win32":
        return True
    try:
        named = os.pread(handle, LONGEST, 0).decode("ascii")
        pid, _, host = named.split()
        return host != _host() or named == _name(int(pid))
    except (OSError, ValueError):
        return True


def _name(pid: int) -> str:
    """A process as no other will be called: its number, when it began, its host; another text when it is dead."""
    try:
        os.kill(pid, 0)
    except ProcessLookupError:
        return ""
    except PermissionError:  # another user's
        pass
    return f"{pid} {_begun(pid)} {_host()}"


def _begun(pid: int) -> str:
    """When a process began, in ticks of the system; "-" where that is not known, "dead" where nobody reaped it."""
    try:
        with open(f"/proc/{pid}/stat", encoding="ascii", errors="replace") as stat:
            stat_fields = stat.read().rpartition(")")[2].split()
        return "dead" if stat_fields[0] in "ZX" else stat_fields[19]
    except (OSError, IndexError):
        return "-"


def _host() -> str:
    """This machine's name: on another one the numbers of processes mean something else."""
    return platform.node().replace(" ", "_").encode("ascii", "replace").decode()[:80] or "-"

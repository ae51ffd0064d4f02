"""Who holds a port: one lock file a port, in this user's runtime folder. The lock dies with the process that has it."""

from __future__ import annotations

import hashlib
import json
import os
import stat
import sys
import tempfile
import time
from collections.abc import Callable, Iterable
from contextlib import suppress
from pathlib import Path
from typing import IO, Any

from labcal.errors import InstrumentError

PATIENCE_S = 0.3  # who only looks whether a port is held holds it for a moment
_held: dict[str, IO[str]] = {}


def runtime_folder() -> Path:
    """The folder of sockets and locks: this user's alone. Raises InstrumentError where somebody else made it."""
    folder = Path(tempfile.gettempdir()) / f"labcal-{_user()}"
    with suppress(FileExistsError):
        folder.mkdir(mode=0o700)
    if not _is_ours(folder.lstat()):  # a link that somebody else laid is not followed
        raise InstrumentError(
            f"{folder} is not a folder of this user alone.",
            fault="forbidden",
            remedy="Remove it; labcal makes its own.",
        )
    return folder


def _user() -> str:
    if sys.platform == "win32":
        return os.environ.get("USERNAME", "user")
    return str(os.getuid())


def _is_ours(stands: os.stat_result) -> bool:
    if sys.platform == "win32":
        return stat.S_ISDIR(stands.st_mode)
    return stat.S_ISDIR(stands.st_mode) and stands.st_uid == os.getuid() and not stands.st_mode & 0o077


def port_of(url: str) -> str:
    """What two links to the same port have in common: the device file, or host and port."""
    address = url.split("://", 1)[1].split("?")[0].removeprefix("socket://")
    return os.path.realpath(address) if address.startswith("/") else address.lower()


def hold(urls: Iterable[str]) -> bool:
    """Take the locks of all these ports, for as long as this process lives; False, and none, where one is taken."""
    taken: dict[str, IO[str]] = {}
    for url in sorted(set(map(port_of, urls)) - set(_held)):
        file = _lock_file(url).open("a+", encoding="utf-8")
        if not _locked_in_time(file):
            for other in (file, *taken.values()):
                other.close()
            return False
        taken[url] = file
    for lock in taken.values():
        lock.truncate(0)  # what a holder before this one announced
    _held.update(taken)
    return True


def let_go() -> None:
    """Give all ports of this process back."""
    while _held:
        _, file = _held.popitem()
        file.close()


def announce(card: dict[str, Any]) -> None:
    """Write into the locks of this process how its owner is reached."""
    for file in _held.values():
        _write(file, card)


def holder(url: str) -> dict[str, Any] | None:
    """What the process that holds this port has announced ({} if nothing yet); None where nobody, or this one, does."""
    port = port_of(url)
    return None if port in _held or not _lock_file(port).exists() else _announced(_lock_file(port))


def announced() -> list[dict[str, Any]]:
    """What all processes that hold ports have announced, whatever the ports."""
    cards = (_announced(path) for path in sorted(runtime_folder().glob("port-*.lock")))
    return [card for card in cards if card]


def _announced(path: Path) -> dict[str, Any] | None:
    with path.open("a+", encoding="utf-8") as file:
        if _try_lock(file):
            return None
        file.seek(0)
        try:
            card = json.loads(file.read())
        except (ValueError, RecursionError):
            return {}
        return card if isinstance(card, dict) else {}


def claim(url: str) -> Callable[[], None]:
    """Take the lock of this port for one link; returns what gives it back. A port that this process holds needs none.

    Raises InstrumentError (in use), naming who holds it.
    """
    port = port_of(url)
    if port in _held:
        return lambda: None
    file = _lock_file(port).open("a+", encoding="utf-8")
    if not _locked_in_time(file):
        file.close()
        raise _in_use(url, holder(url) or {})
    _write(file, {"pid": os.getpid(), "program": " ".join([Path(sys.argv[0]).name, *sys.argv[1:]])})
    return file.close


def _in_use(url: str, card: dict[str, Any]) -> InstrumentError:
    program = f"{card['program']!r}" if "program" in card else "a guardian"
    return InstrumentError(
        f"{url}: {program} (process {card.get('pid', 'unknown')}) holds this port.",
        fault="in use",
        remedy="End it, or the session that drives this bench; `labcal bench off` brings its coils to zero meanwhile.",
    )


def _write(file: IO[str], card: dict[str, Any]) -> None:
    file.truncate(0)
    file.write(json.dumps(card))
    file.flush()


def _lock_file(port: str) -> Path:
    return runtime_folder() / f"port-{hashlib.sha256(port.encode()).hexdigest()[:16]}.lock"


def _locked_in_time(file: IO[str]) -> bool:
    deadline = time.monotonic() + PATIENCE_S
    while not _try_lock(file):
        if time.monotonic() > deadline:
            return False
        time.sleep(0.01)
    return True


def _try_lock(file: IO[str]) -> bool:
    try:
        if sys.platform == "win32":
            import msvcrt

            file.seek(1 << 20)  # far behind the text, which others must be able to read
            msvcrt.locking(file.fileno(), msvcrt.LK_NBLCK, 1)
        else:
            import fcntl

            fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except OSError:
        return False
    return True

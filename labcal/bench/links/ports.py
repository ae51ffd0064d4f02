"""Who holds a port: one lock file a port, and for a device its own lock too. Both die with the process that has them.

The file says how that process is reached, the device's lock is met by every user of the computer.
"""

from __future__ import annotations

import hashlib
import os
import sys
import time
from collections.abc import Callable, Iterable
from contextlib import suppress
from dataclasses import dataclass
from datetime import UTC, datetime
from pathlib import Path
from typing import IO, Any

from labcal.bench.links import devices, hosts, locks
from labcal.bench.links.holders import connected, locker, process
from labcal.bench.links.places import folders, meet, own_folder, runtime_folder, user, user_name
from labcal.bench.links.urls import NETWORK, OVER_NETWORK, place, split
from labcal.bench.links.visa import canonical
from labcal.errors import InputError, InstrumentError

__all__ = [
    "amend_left_behind", "announce", "announced", "as_spelt", "claim", "hold", "holder", "holding", "left_behind",
    "let_go", "meet", "port_of", "refuse_connected", "runtime_folder", "still_held",
]  # fmt: skip

GUARDIAN = "End it, or the session that drives this bench; `labcal bench off` brings its coils to zero meanwhile."
PROGRAM = "End it, then try again."  # a labcal that talks to one instrument, and brings nothing to zero
DRIVEN = "driven"  # in a guardian's card: the essentials of its bench, for who finds it dead
BRIEF, BRIEF_S = "brief", 5.0  # in the card of who only reads and lets go at once: whoever wants the port waits so long
BEFORE = "before"  # in the card of who came after it, and has not brought its coils to an end yet: that card


@dataclass
class Lock:
    """What this process has of a port. `file` is None where no folder has room for one."""

    port: str
    path: Path
    file: IO[str] | None
    device: int | None = None

    def take_device(self, patience_s: float = locks.PATIENCE_S) -> None:
        """Lock the device, where there is one, and again where it was unplugged. Raises BlockingIOError."""
        self.drop_device_that_is_gone()
        if self.device is None:
            self.device = devices.lock(self.port, patience_s)
        else:
            devices.reopen(self.device)

    def drop_device_that_is_gone(self) -> None:
        """What comes back after it was unplugged gets its name only when nobody has the old one open."""
        if self.device is not None and not devices.still(self.device, self.port):
            devices.unlock(self.device)
            self.device = None

    def release(self, *, in_doubt: bool = False) -> None:
        """Give the port back; `in_doubt`: what was driven by it stays written there."""
        if self.device is not None:
            devices.unlock(self.device)
        if self.file is not None and in_doubt and (driven := _driving(locks.read(self.file))):
            locks.write(self.file, driven)
            self.file.close()
        elif self.file is not None:
            locks.release(self.file, self.path)
        self.device = self.file = None


_held: dict[str, Lock] = {}
_card: dict[str, Any] = {}


def port_of(url: str) -> str:
    """What two links to the same port have in common, however it is spelt: the device file, or address and port.

    A host whose name has no address is compared as text.
    """
    scheme, rest = url.split("://", 1)
    address = rest.split("?")[0]
    if address.startswith("/"):
        return os.path.realpath(address)
    if scheme == "visa":
        return _of_visa(address)
    kind, _, there = address.rpartition("://")
    if scheme in NETWORK or kind.lower() in OVER_NETWORK:
        with suppress(InputError):  # whoever opens it says so
            host, port = place(url, scheme, there)
            return f"{hosts.one_of(host)}:{port}"
    return as_spelt(url)


def _of_visa(address: str) -> str:
    """The resource, its name completed."""
    with suppress(InputError):
        return canonical(address).lower()
    return address.lower()


def as_spelt(url: str) -> str:
    """The text of a link that names its port, in small letters: it stays where a host gets another address."""
    return url.split("://", 1)[1].split("?")[0].removeprefix("socket://").lower()


def hold(urls: Iterable[str]) -> bool:
    """Take the locks of all these ports, for as long as this process lives; False, and none, where one is taken.

    A device that another program has locked is not waited for: its link will say so, and the others are reached.
    """
    taken: list[Lock] = []
    for port in sorted(set(map(port_of, urls)) - set(_held)):
        if (lock := _take(port)) is None:
            for other in taken:
                other.release()
            return False
        taken.append(lock)
    for lock in taken:
        _say(lock, {})  # not how a holder before this one is reached
        with suppress(OSError):
            lock.take_device(patience_s=0.0)
    _held.update({lock.port: lock for lock in taken})
    return True


def let_go(*, in_doubt: bool = False) -> None:
    """Give all ports of this process back; `in_doubt`: a coil may be on, and who says off later has to find it."""
    _card.clear()
    while _held:
        _held.popitem()[1].release(in_doubt=in_doubt)


def still_held() -> bool:
    """Whether everybody can see that this process holds its ports: each lock file is there, under its name."""
    return all(lock.file is None or locks.stands(lock.file, lock.path) for lock in _held.values())


def announce(card: dict[str, Any]) -> None:
    """Write into the locks of this process how its owner is reached."""
    _card.update(card)
    for lock in _held.values():
        _say(lock, card)


def holder(url: str) -> dict[str, Any] | None:
    """What the process that holds this port has announced ({} if nothing yet); None where nobody, or this one, does.

    It is looked for in every folder that this user may see: a guardian may be older than the group in bench.toml.
    """
    port = port_of(url)
    if port in _held:
        return None
    cards = (locks.look(path) for path in _lock_files(port))
    return next((card for card in cards if card is not None), None)


def holding(url: str) -> int | None:
    """The process that holds this port, by the kernel's own word; None where nobody does, or that is not known."""
    pids = (locker(path) for path in _lock_files(port_of(url)))
    return next((pid for pid in pids if pid is not None), None)


def announced() -> list[dict[str, Any]]:
    """What all processes that hold ports have announced, whatever the ports, in all folders that this user may see."""
    cards = [locks.look(path) for folder in folders() for path in sorted(folder.glob("port-*.lock"))]
    return [card for card in cards if card]


def left_behind() -> list[dict[str, Any]]:
    """What processes had announced that died without letting go of their ports, in all folders this user may see.

    Of a guardian also where others died after it on the same ports, who had announced nothing of coils.
    """
    cards = [locks.left_behind(path) for folder in folders() for path in sorted(folder.glob("port-*.lock"))]
    return [_driving(card) or card for card in cards if card]


def amend_left_behind(amend: Callable[[dict[str, Any]], dict[str, Any]]) -> None:
    """What dead guardians drove, as `amend` has it of each card; {} is forgotten. Ports that somebody has are left."""
    for path in (path for folder in folders() for path in sorted(folder.glob("port-*.lock"))):
        with suppress(OSError):
            if (before := _driving(locks.left_behind(path))) and (file := locks.take(path)) is not None:
                if after := amend(before):
                    locks.write(file, after)
                    file.close()
                else:
                    locks.release(file, path)


def refuse_connected(urls: Iterable[str]) -> None:
    """Raise InstrumentError (in use) where another user's program has a connection to one of these ports.

    Who has no folder in common with that user sees no lock of his. Zero asks for none of this.
    """
    for url in urls:
        for uid in _connected(url) - {user()}:
            raise InstrumentError(
                f"{url}: a program of user {user_name(uid)} is connected to it.",
                fault="in use",
                remedy=f"Ask user {user_name(uid)} to end it, then try again.",
            )


def _connected(url: str) -> set[int]:
    try:
        scheme, address, _ = split(url)
    except InputError:  # whoever opens it says so, with the line in the file
        return set()
    if scheme not in ("tcp", "telnet", "modbus-tcp") and not address.startswith("socket://"):
        return set()
    host, port = place(url, scheme, address.removeprefix("socket://"))
    return {uid for found in hosts.addresses(host) for uid in connected(found, port)}


def claim(url: str) -> Callable[[], None]:
    """Take the lock of this port for one link; returns what gives it back. A port that this process holds needs none.

    Raises InstrumentError (in use), naming who holds it.
    """
    port = port_of(url)
    if (mine := _held.get(port)) is not None:
        _take_device(url, mine)
        return mine.drop_device_that_is_gone
    if (lock := _take_patiently(port, url)) is None:
        raise _in_use(url, holder(url) or {})
    try:
        _take_device(url, lock)
    except InstrumentError:
        lock.release()
        raise
    _say(lock, _card or {"pid": os.getpid(), "program": " ".join([Path(sys.argv[0]).name, *sys.argv[1:]])})
    return lock.release


def _take_patiently(port: str, url: str) -> Lock | None:
    """The lock of a port; who only reads there and lets go of it at once is waited for."""
    deadline = time.monotonic() + BRIEF_S
    while (lock := _take(port)) is None and time.monotonic() < deadline and (holder(url) or {BRIEF: True}).get(BRIEF):
        time.sleep(0.01)
    return lock


def _take(port: str) -> Lock | None:
    """The lock of a port, by its device alone where no folder has room for a file; None where another has it."""
    for path in dict.fromkeys((_lock_file(port), own_folder() / _lock_file(port).name)):
        with suppress(OSError):
            file = locks.take(path)
            return None if file is None else Lock(port, path, file)
    return Lock(port, _lock_file(port), None)


def _take_device(url: str, lock: Lock) -> None:
    try:
        lock.take_device()
    except BlockingIOError as error:
        raise _opened(url, lock.port) from error


def _say(lock: Lock, card: dict[str, Any]) -> None:
    """Whoever dies before he has brought to zero what was driven here leaves behind what he found."""
    if lock.file is not None:
        before = {} if DRIVEN in card else _driving(locks.read(lock.file))
        locks.write(lock.file, card | ({BEFORE: before} if before else {}))


def _driving(card: dict[str, Any]) -> dict[str, Any]:
    """This card, or the one before it, of a guardian; {} where neither is."""
    before = card.get(BEFORE)
    found = card if DRIVEN in card else before
    return found if isinstance(found, dict) else {}


def _in_use(url: str, card: dict[str, Any]) -> InstrumentError:
    """Another labcal has the lock file. What the file says is believed only where the kernel says nothing."""
    other, path = process(locker(_lock_file(port_of(url)))), _lock_file(port_of(url))
    program, remedy = (f"{card['program']!r}", PROGRAM) if "program" in card else ("a guardian", GUARDIAN)
    since = ""
    with suppress(OSError):
        since = _since(datetime.fromtimestamp(path.stat().st_mtime, UTC))
    whose, pid = ("", card.get("pid", "unknown")) if other is None else (other.whose, other.pid)
    return InstrumentError(
        f"{url}: {program}{whose} (process {pid}) holds this port{since}.",
        fault="in use",
        remedy=remedy,
    )


def _opened(url: str, port: str) -> InstrumentError:
    """Another program, or a labcal of a user who shares no folder with this one, has the device."""
    other = process(locker(port))
    named = "" if other is None else f": {other.program!r}{other.whose} (process {other.pid}){_since(other.begun)}"
    ask = "End that program" if other is None or not other.whose else f"Ask{other.whose.removeprefix(' of')} to end it"
    return InstrumentError(
        f"{url}: another program has opened it{named}.", fault="in use", remedy=f"{ask}, then try again."
    )


def _since(when: datetime) -> str:
    return f" since {when:%Y-%m-%d %H:%M} UTC"


def _lock_files(port: str) -> list[Path]:
    here = _lock_file(port)
    return list(dict.fromkeys([here, *(folder / here.name for folder in folders())]))


def _lock_file(port: str) -> Path:
    return runtime_folder() / f"port-{hashlib.sha256(port.encode()).hexdigest()[:16]}.lock"

"""Hosts of this network by any of their spellings: localhost, 127.1, LAB.local. and the address are one.

A name is looked up by a thread of its own: where nobody answers, zero waits for that no longer than `PATIENCE_S` in
all. What has no address by then goes by its name, and nothing is opened there.
"""

from __future__ import annotations

import socket
import threading
import time
from contextlib import suppress
from ipaddress import IPv6Address, ip_address

PATIENCE_S = 1.0  # of this process with all names together, until one answers again
AGAIN_S = 5.0  # until a name that had no address is looked up again
HERE, HERE_6 = "127.0.0.1", "::1"
ANY = ("", "0.0.0.0", "::")  # connected to, or listened at, they are this computer


class _Lookup:
    """One question for the addresses of a name."""

    def __init__(self, name: str) -> None:
        self.begun_s, self.addresses, self.answered = time.monotonic(), tuple[str, ...](), threading.Event()
        try:
            threading.Thread(target=self._ask, args=(name,), daemon=True).start()
        except RuntimeError:  # no room for a thread
            self.answered.set()

    @property
    def is_vain(self) -> bool:
        """Whether it is time to ask again."""
        return self.answered.is_set() and not self.addresses and time.monotonic() - self.begun_s > AGAIN_S

    def _ask(self, name: str) -> None:
        with suppress(OSError, UnicodeError):
            self.addresses = tuple(dict.fromkeys(resolve(name)))
        self.answered.set()


class KnownNames:
    """What has been asked, and the patience that is left."""

    def __init__(self) -> None:
        self._lookups = dict[str, _Lookup]()
        self._left_s = PATIENCE_S

    def addresses(self, name: str) -> tuple[str, ...]:
        """The addresses of a name; () where it has none, or none in time."""
        lookup = self._lookups.get(name)
        if lookup is None or lookup.is_vain:
            lookup = self._lookups[name] = _Lookup(name)
        begun_s = time.monotonic()
        if lookup.answered.wait(self._left_s):
            self._left_s = PATIENCE_S
            return lookup.addresses
        self._left_s = max(0.0, self._left_s - (time.monotonic() - begun_s))
        return ()

    def forget(self, name: str) -> None:
        """Ask again next time: nobody was there."""
        self._lookups.pop(name, None)


known_names = KnownNames()


def one_of(host: str) -> str:
    """What all spellings of a host have in common: an address, or a name in small letters that has none."""
    found = [address for address in addresses(host) if address != HERE_6]
    return min(found, key=_by_kind, default=HERE if addresses(host) else _plain(host))


def addresses(host: str) -> tuple[str, ...]:
    """The addresses under which a host is reached, in the order to try them; () where none is known."""
    name = _plain(host)
    if name in ANY or name == "localhost" or name.endswith(".localhost"):
        return HERE, HERE_6
    literal = _literal(name)
    return (literal,) if literal else known_names.addresses(name)


def forget(host: str) -> None:
    """Nobody answered there: look its name up again the next time."""
    known_names.forget(_plain(host))


def _plain(host: str) -> str:
    return host.lower().strip("[]").rstrip(".")


def _literal(name: str) -> str:
    """A written address in its one form; "" where it is a name."""
    with suppress(ValueError):
        address = ip_address(name)
        mapped = address.ipv4_mapped if isinstance(address, IPv6Address) else None
        return str(mapped or address)
    with suppress(OSError):  # 127.1, 0x7f000001 and the like
        return socket.inet_ntoa(socket.inet_aton(name)) if name[:1].isdigit() else ""
    return ""


def resolve(name: str) -> list[str]:
    """The addresses of a name, as this computer looks them up. Raises OSError."""
    return [str(found[4][0]) for found in socket.getaddrinfo(name, None, type=socket.SOCK_STREAM)]


def _by_kind(address: str) -> tuple[bool, str]:
    """IPv4 before IPv6."""
    return ":" in address, address

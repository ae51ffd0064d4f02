"""A line whose other end follows a script: what a driver must send, byte for byte, and what it is answered."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from datetime import UTC, datetime
from typing import Any, get_type_hints

from labcal.bench.clock import VirtualClock
from labcal.bench.links import EmulatedLink
from labcal.bench.links.modbus import ModbusLink
from labcal.errors import InstrumentError

SILENT, UNPLUGGED = None, "unplugged"
Exchange = tuple[bytes, bytes | Sequence[bytes] | str | None]  # sent, answered (pieces 5 ms apart) or SILENT, UNPLUGGED


class Script:
    """The other end: takes each request in its turn and puts the reply on the line; `echo`: the request before it."""

    def __init__(self, wire: Sequence[Exchange], *, echo: bool = False) -> None:
        self.left, self._taken, self._waiting = list(wire), b"", list[tuple[float, bytes]]()
        self._echo = echo

    def take(self, t_s: float, data: bytes) -> None:
        """Bytes from the driver: they must be what the script says next."""
        self._taken += data
        self._waiting += [(t_s + 0.001, data)] * self._echo
        if not self.left:
            raise AssertionError(f"{data!r} was sent after the script's end")
        expected, reply = self.left[0]
        if self._taken != expected:
            assert expected.startswith(self._taken), f"sent {self._taken!r}, the script says {expected!r}"
            return
        self.left.pop(0)
        self._taken = b""
        if reply == UNPLUGGED:
            raise InstrumentError("the link was lost", fault="link lost")
        pieces = [reply] if isinstance(reply, bytes) else [p for p in reply or () if isinstance(p, bytes)]
        self._waiting += [(t_s + 0.005 * number, piece) for number, piece in enumerate(pieces, 1)]

    def emit(self, until_s: float) -> list[tuple[float, bytes]]:
        """Replies that are due."""
        due = [piece for piece in self._waiting if piece[0] <= until_s]
        self._waiting = [piece for piece in self._waiting if piece[0] > until_s]
        return sorted(due, key=lambda piece: piece[0])


@contextmanager
def scripted(
    driver: Any, wire: Sequence[Exchange], *, link: str = "emulated://script", echo: bool = False, **settings: Any
) -> Iterator[Any]:
    """A driver on a scripted line; at the end everything in the script must have been sent. `echo`: an adapter on it
    hears what it sends; `link` says so (echo=1) or does not.
    """
    clock, script = VirtualClock(datetime(2026, 1, 1, tzinfo=UTC)), Script(wire, echo=echo)
    line, hints = EmulatedLink(link, script, clock), get_type_hints(driver.__init__)
    modbus, stated = hints["link"] is ModbusLink, hints["settings"](**settings)
    line.never.add(driver.never, stated.address if modbus else None)
    yield driver("under test", ModbusLink(line, clock) if modbus else line, clock, stated)
    assert not script.left, f"never sent: {[sent for sent, _ in script.left]}"

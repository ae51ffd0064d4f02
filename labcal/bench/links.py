"""Links: how bytes reach an instrument. The only module that imports serial and pymodbus."""

from __future__ import annotations

from typing import Protocol

from labcal.bench.clock import Clock
from labcal.errors import InputError, InstrumentError

ASK_STEP_S = 0.001


class Link(Protocol):
    """A byte line to one instrument, on the bench's clock."""

    url: str
    emulated: bool

    def send(self, data: bytes) -> None:
        """Put bytes on the line. Raises InstrumentError (fault "link lost") when it is gone."""
        ...

    def receive(self, until_s: float) -> list[tuple[float, bytes]]:
        """All bytes that arrive up to `until_s`, in pieces stamped at their first byte; waits on the clock."""
        ...

    def ask(self, request: bytes, *, end: bytes | int, timeout_s: float) -> bytes:
        """Send, then return the reply up to and with `end` (bytes), or `end` bytes. Raises InstrumentError (silent)."""
        ...

    def flush(self) -> None:
        """Drop what has arrived and was not read."""
        ...

    def close(self) -> None:
        """Let go of the line."""
        ...


class Emulator(Protocol):
    """The instrument's own side of the wire."""

    def take(self, t_s: float, data: bytes) -> None:
        """Bytes from the host arrive at `t_s`."""
        ...

    def emit(self, until_s: float) -> list[tuple[float, bytes]]:
        """What it has put on the line up to `until_s` and not emitted before, stamped, in order."""
        ...


class EmulatedLink:
    """A line whose other end is an emulator in this process: only the wire is exchanged, never the driver."""

    emulated = True

    def __init__(self, url: str, emulator: Emulator, clock: Clock) -> None:
        self.url, self._emulator, self._clock = url, emulator, clock
        self._arrived: list[tuple[float, bytes]] = []

    def send(self, data: bytes) -> None:
        """Put bytes on the line."""
        self._emulator.take(self._clock.now(), data)

    def receive(self, until_s: float) -> list[tuple[float, bytes]]:
        """All that the emulator sent up to `until_s`; waits on the clock."""
        self._clock.wait_until(until_s)
        pieces = self._arrived + self._emulator.emit(self._clock.now())
        self._arrived = []
        return pieces

    def ask(self, request: bytes, *, end: bytes | int, timeout_s: float) -> bytes:
        """Send, then return the reply up to and with `end`, or `end` bytes. Raises InstrumentError (silent)."""
        self.send(request)
        return read_reply(self, self._clock, end=end, timeout_s=timeout_s)

    def give_back(self, t_s: float, data: bytes) -> None:
        """Put bytes that were read too far back at the head of the line."""
        self._arrived.insert(0, (t_s, data))

    def flush(self) -> None:
        """Drop what has arrived and was not read."""
        self.receive(self._clock.now())

    def close(self) -> None:
        """Nothing to let go of."""


class _Readable(Protocol):
    url: str

    def receive(self, until_s: float) -> list[tuple[float, bytes]]: ...

    def give_back(self, t_s: float, data: bytes) -> None: ...


def read_reply(link: _Readable, clock: Clock, *, end: bytes | int, timeout_s: float) -> bytes:
    """The next reply on `link`, up to and with `end` (bytes) or `end` bytes long; what follows it stays on the line."""
    reply, deadline, stamp = b"", clock.now() + timeout_s, clock.now()
    while (length := _complete(reply, end)) is None:
        if clock.now() >= deadline:
            got = f"only {reply!r}" if reply else "nothing"
            raise InstrumentError(
                f"{link.url}: no reply in {timeout_s:g} s, {got} came.",
                fault="silent",
                remedy="Is it switched on, and is the link in bench.toml the right one?",
            )
        for came_s, piece in link.receive(min(deadline, clock.now() + ASK_STEP_S)):
            stamp, reply = came_s, reply + piece
    if reply[length:]:
        link.give_back(stamp, reply[length:])
    return reply[:length]


def _complete(reply: bytes, end: bytes | int) -> int | None:
    if isinstance(end, int):
        return end if len(reply) >= end else None
    at = reply.find(end)
    return at + len(end) if at >= 0 else None


def open_link(url: str, clock: Clock) -> Link:
    """Open a link by its URL. Raises InputError for a scheme that is not known."""
    raise InputError(f"link {url!r}: only emulated:// is known yet")

"""What a link is: a byte line to one instrument, on the bench's clock."""

from __future__ import annotations

from typing import Protocol

from labcal.bench.clock import Clock
from labcal.bench.links.deny import DenyList
from labcal.bench.links.heard_before import LINE, heard, remedy
from labcal.bench.links.quoting import SHOWN, quoted
from labcal.errors import InstrumentError

ASK_STEP_S = 0.001
LONGEST = 4096  # bytes of a reply up to its end; no instrument says so much
QUIET_S, BABBLE_S = 0.3, 1.0
DROP_S, DROP_BYTES = 0.1, 4 << 20  # of a line that floods no more is dropped at once


class Link(Protocol):
    """A byte line to one instrument, on the bench's clock."""

    url: str
    emulated: bool
    never: DenyList  # what this line refuses to send

    def send(self, data: bytes) -> None:
        """Put bytes on the line. Raises InstrumentError: "link lost" when it is gone, "forbidden" by `never`."""
        ...

    def receive(self, until_s: float) -> list[tuple[float, bytes]]:
        """All bytes that arrive up to `until_s`, in pieces stamped at their first byte; waits on the clock."""
        ...

    def ask(self, request: bytes, *, end: bytes | int, timeout_s: float) -> bytes:
        """Send, then return the reply up to and with `end` (bytes), or `end` bytes. Raises InstrumentError (silent)."""
        ...

    def reopen(self) -> None:
        """Open a line that was lost. Whoever does it asks the instrument again who it is."""
        ...

    def flush(self) -> None:
        """Drop what has arrived and was not read."""
        ...

    def give_back(self, t_s: float, data: bytes) -> None:
        """Put bytes that were read too far back at the head of the line."""
        ...

    def close(self) -> None:
        """Let go of the line."""
        ...


class _Receives(Protocol):
    def receive(self, until_s: float) -> list[tuple[float, bytes]]: ...


class _Readable(_Receives, Protocol):
    url: str

    def give_back(self, t_s: float, data: bytes) -> None: ...


def read_reply(link: _Readable, clock: Clock, *, end: bytes | int, timeout_s: float) -> bytes:
    """The next reply on `link`, up to and with `end` (bytes) or `end` bytes long; what follows it stays on the line.

    Raises InstrumentError: silent where it does not come in time; babbles, at once, where `LONGEST` bytes have no end.
    """
    reply, deadline, stamp, looked = b"", clock.now() + timeout_s, clock.now(), False
    while (length := _complete(reply, end)) is None:
        if len(reply) > LONGEST and isinstance(end, bytes):
            raise babbles(link.url, reply)
        if looked:
            wait_for_quiet(link, clock, QUIET_S)  # so that a late reply does not answer the next question
            raise InstrumentError(
                f"{link.url}: no reply in {timeout_s:g} s, {f'only {quoted(reply)}' if reply else 'nothing'} came.",
                fault="silent",
                remedy=remedy(LINE, link.url),
            )
        looked = clock.now() >= deadline  # once more: it may have come while this computer did not look
        for came_s, piece in link.receive(min(deadline, clock.now() + ASK_STEP_S)):
            stamp, reply = came_s, reply + piece
    heard(link.url)
    if reply[length:]:
        link.give_back(stamp, reply[length:])
    return reply[:length]


def babbles(url: str, came: bytes) -> InstrumentError:
    """The error for a line that brings bytes and no end of a reply."""
    return InstrumentError(
        f"{url}: it babbles: more than {LONGEST // 1024} KiB came without an end, beginning with {came[:SHOWN]!r}.",
        fault="babbles",
        remedy="Is it the instrument that bench.toml names? Pull its cable and plug it in again, or switch it off.",
    )


def wait_for_quiet(link: _Receives, clock: Clock, quiet_s: float) -> None:
    """Drop what comes until nothing has come for `quiet_s`; a line that never falls quiet is left after a second."""
    deadline, dropped = clock.now() + BABBLE_S, 0
    while (pieces := link.receive(clock.now() + quiet_s)) and clock.now() < deadline and dropped <= DROP_BYTES:
        dropped += _length(pieces)


def drop(link: _Receives, clock: Clock) -> bytes:
    """Drop what has arrived, as far as it has an end; returns the last of it."""
    deadline, dropped, last = clock.now() + DROP_S, 0, b""
    while (pieces := link.receive(clock.now())) and clock.now() < deadline and dropped <= DROP_BYTES:
        last, dropped = pieces[-1][1], dropped + _length(pieces)
    return pieces[-1][1] if pieces else last


def _length(pieces: list[tuple[float, bytes]]) -> int:
    return sum(len(data) for _, data in pieces)


def _complete(reply: bytes, end: bytes | int) -> int | None:
    if isinstance(end, int):
        return end if len(reply) >= end else None
    at = reply.find(end, 0, LONGEST)
    return at + len(end) if at >= 0 else None

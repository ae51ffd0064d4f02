"""A gate in every line of the guardian: when zero is ordered, whatever the session has asked there ends at once.

A question that nobody answers would keep the line from who brings its coils down. While the gate is closed only that
thread passes; what others have under way ends within a hundredth of a second, and they can send nothing more. The reply
to a question that was given up is still on its way: it must not be taken for the answer to the next. Where replies have
an end, they are counted here; a driver that asks for a number of bytes waits for it itself before it asks again.
"""

from __future__ import annotations

import threading
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field

from labcal.bench.clock import Clock
from labcal.bench.links import Link
from labcal.bench.links.line import drop, read_reply
from labcal.bench.loading import Loader
from labcal.errors import InstrumentError

LOOK_S = 0.01
OWED_S = 0.3  # that a second reply is waited for, where a question was given up before


class Gate:
    """Who may use a line. Closed by anybody who orders zero, passed by the thread that carries it out."""

    def __init__(self) -> None:
        self._closed = threading.Event()
        self._owner: int | None = None
        self._why = ""
        self.owed = False  # a question was given up, whose reply may still come
        self.asks_until_s = float("inf")  # on the line's clock: what is asked ends then, answered or not

    def close(self, why: str = "") -> None:
        """From now on the line belongs to whoever passes; `why`, who ordered zero, is sent to whoever gives way."""
        self._why = why.removesuffix(".") or self._why
        self._closed.set()

    @contextmanager
    def passing(self) -> Iterator[None]:
        """This thread has the line; afterwards the gate is open."""
        self._owner = threading.get_ident()
        try:
            yield
        finally:
            self._owner = None
            self._closed.clear()

    @contextmanager
    def asking_until(self, t_s: float) -> Iterator[None]:
        """Within, no question is waited for beyond `t_s` on the line's clock."""
        self.asks_until_s = t_s
        try:
            yield
        finally:
            self.asks_until_s = float("inf")

    def check(self, now_s: float) -> None:
        """Raise InstrumentError (taken to zero) where this thread has to leave the line to another."""
        if self._closed.is_set() and self._owner != threading.get_ident():
            who = f" ({self._why})" if self._why else ""
            raise InstrumentError(
                f"zero was ordered{who}; what was being asked of this line was given up.", fault="taken to zero"
            )
        if now_s > self.asks_until_s:
            raise InstrumentError("it did not answer in the time that there is on the way to zero.", fault="silent")


class GatedLink:
    """A Link whose waits end when its gate closes."""

    def __init__(self, link: Link, gate: Gate, clock: Clock) -> None:
        self._link, self._gate, self._clock = link, gate, clock
        self.url, self.emulated, self.never = link.url, link.emulated, link.never

    def send(self, data: bytes) -> None:
        """Put bytes on the line."""
        self._gate.check(self._clock.now())
        self._link.send(data)

    def receive(self, until_s: float) -> list[tuple[float, bytes]]:
        """All that arrives up to `until_s`, in pieces stamped at their first byte."""
        arrived = list[tuple[float, bytes]]()
        while True:
            self._check_waiting()
            arrived += self._link.receive(min(until_s, self._clock.now() + LOOK_S))
            if self._clock.now() >= until_s:
                return arrived

    def ask(self, request: bytes, *, end: bytes | int, timeout_s: float) -> bytes:
        """Send, then return the reply up to and with `end`, or `end` bytes. Raises InstrumentError (silent)."""
        if request:
            self.send(request)
        reply = read_reply(self, self._clock, end=end, timeout_s=timeout_s)
        return self._newest(reply, end) if self._gate.owed and isinstance(end, bytes) else reply

    def give_back(self, t_s: float, data: bytes) -> None:
        """Put bytes that were read too far back at the head of the line."""
        self._link.give_back(t_s, data)

    def reopen(self) -> None:
        """Open it again."""
        self._link.reopen()
        self._gate.owed = False

    def flush(self) -> None:
        """Drop what has arrived and was not read."""
        self._gate.check(self._clock.now())
        if drop(self._link, self._clock).endswith((b"\r", b"\n")):
            self._gate.owed = False

    def close(self) -> None:
        """Let go of it."""
        self._link.close()

    def _check_waiting(self) -> None:
        try:
            self._gate.check(self._clock.now())
        except InstrumentError:
            self._gate.owed = True
            raise

    def _newest(self, reply: bytes, end: bytes) -> bytes:
        """The reply to what was asked last: the first that came may belong to what was given up."""
        self._gate.owed = False
        until_s = self._clock.now() + OWED_S
        while (now_s := self._clock.now()) < until_s:
            if pieces := self.receive(min(until_s, now_s + LOOK_S)):
                self.give_back(pieces[0][0], b"".join(data for _, data in pieces))
                return read_reply(self, self._clock, end=end, timeout_s=OWED_S)
        return reply


@dataclass
class GatedLoader(Loader):
    """Opens the instruments of one line, with its gate between each driver and the line."""

    gate: Gate = field(default_factory=Gate)
    gated: dict[str, Link] = field(default_factory=dict)

    def link(self, name: str) -> Link:
        """The gated link of one instrument; one for all on a line, by which a driver knows whom it addressed last."""
        line = self.line_of(name)
        if line not in self.gated:
            self.gated[line] = GatedLink(super().link(name), self.gate, self.clock)
        return self.gated[line]

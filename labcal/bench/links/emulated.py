"""emulated:// the other end of the wire is in this process."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Protocol, runtime_checkable

from labcal.bench.clock import Clock, VirtualClock
from labcal.bench.links.deny import DenyList
from labcal.bench.links.echo import Echo
from labcal.bench.links.line import ASK_STEP_S, read_reply


class Emulator(Protocol):
    """The instrument's own side of the wire."""

    def take(self, t_s: float, data: bytes) -> None:
        """Bytes from the host arrive at `t_s`."""
        ...

    def emit(self, until_s: float) -> list[tuple[float, bytes]]:
        """What it has put on the line up to `until_s` and not emitted before, stamped, in order."""
        ...


@runtime_checkable
class Foresees(Emulator, Protocol):
    """An emulator that knows when its next bytes are on the line."""

    def due_s(self) -> float:
        """That time; inf where none are on their way, one in the past where that is not known."""
        ...


class SharedWire:
    """Several emulators on one line, as on an RS-485 pair: all hear everything."""

    def __init__(self, ends: Sequence[Emulator]) -> None:
        self._ends = ends
        self._foreseeing = [end for end in ends if isinstance(end, Foresees)]

    def take(self, t_s: float, data: bytes) -> None:
        """Bytes from the host arrive at `t_s`."""
        for end in self._ends:
            end.take(t_s, data)

    def emit(self, until_s: float) -> list[tuple[float, bytes]]:
        """What they have put on the line up to `until_s`, in order."""
        return sorted(piece for end in self._ends for piece in end.emit(until_s))

    def due_s(self) -> float:
        """When the first of them is heard."""
        if len(self._foreseeing) < len(self._ends):
            return -math.inf
        return min(end.due_s() for end in self._foreseeing)


class EmulatedLink:
    """A line whose other end is an emulator in this process: only the wire is exchanged, never the driver."""

    emulated = True

    def __init__(self, url: str, emulator: Emulator, clock: Clock) -> None:
        self.url, self._emulator, self._clock = url, emulator, clock
        self._foresees = emulator if isinstance(emulator, Foresees) and isinstance(clock, VirtualClock) else None
        self.never = DenyList()
        self._echo = Echo(url) if "echo=1" in url else None
        self._arrived: list[tuple[float, bytes]] = []

    def send(self, data: bytes) -> None:
        """Put bytes on the line."""
        self.never.check(self.url, data)
        if self._echo is not None:
            self._echo.sent(data)
        self._emulator.take(self._clock.now(), data)

    def receive(self, until_s: float) -> list[tuple[float, bytes]]:
        """All that the emulator sent up to `until_s`; waits on the clock."""
        self._clock.wait_until(until_s)
        arrived, self._arrived = self._arrived, []
        emitted = self._emulator.emit(self._clock.now())
        return arrived + (emitted if self._echo is None else self._echo.taken_off(emitted))

    def ask(self, request: bytes, *, end: bytes | int, timeout_s: float) -> bytes:
        """Send, then return the reply up to and with `end`, or `end` bytes. Raises InstrumentError (silent)."""
        if request:
            self.send(request)
        self._wait_for_the_reply(timeout_s)
        return read_reply(self, self._clock, end=end, timeout_s=timeout_s)

    def _wait_for_the_reply(self, timeout_s: float) -> None:
        """On a virtual clock straight to the step in which the reply is due: nobody looks at the line before."""
        now = self._clock.now()
        if self._foresees is not None and now < (due_s := self._foresees.due_s()) <= now + timeout_s:
            self._clock.wait_until(now + int((due_s - now) / ASK_STEP_S) * ASK_STEP_S)

    def reopen(self) -> None:
        """It cannot be lost."""

    def give_back(self, t_s: float, data: bytes) -> None:
        """Put bytes that were read too far back at the head of the line."""
        self._arrived.insert(0, (t_s, data))

    def flush(self) -> None:
        """Drop what has arrived and was not read."""
        self.receive(self._clock.now())

    def close(self) -> None:
        """Nothing to let go of."""

"""The instrument's side of a line: requests collected to their end, replies on the line after a delay."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any, Protocol

from labcal.bench.driver_kit.framing import Lines

Pieces = list[tuple[float, bytes]]
QUEUE = 20  # errors that an instrument keeps


class Lab(Protocol):
    """What emulators use of the simulated lab (labcal.twin.Lab)."""

    coils: Any
    platform: Any
    reference_nT_per_unit: float

    def reference_nT(self, t_s: Any) -> Any:
        """Readings (n, 3) of the reference in its own unit."""
        ...

    def dut_reading(self, t_s: Any) -> Any:
        """Readings (n, 3) of the DUT, and its housekeeping (n,) by name."""
        ...


class Replies:
    """What an instrument has said and is not yet on the line."""

    def __init__(self) -> None:
        self._waiting = Pieces()

    def say(self, t_s: float, data: bytes) -> None:
        """`data` is on the line at `t_s`, not before what was said earlier."""
        self._waiting.append((t_s, data))

    def due_s(self) -> float:
        """When its next reply is on the line; inf where none is on its way."""
        return self._waiting[0][0] if self._waiting else math.inf

    def emit(self, until_s: float) -> Pieces:
        """Replies that are due."""
        due = [piece for piece in self._waiting if piece[0] <= until_s]
        if due:
            self._waiting = self._waiting[len(due) :]
        return due


class Answers(Replies):
    """Gives each request line to `answer(t, text)` and puts its reply on the line `delay_s` later."""

    def __init__(self, answer: Callable[[float, str], bytes], *, end: bytes = b"\n", delay_s: float = 0.01) -> None:
        super().__init__()
        self._answer, self._delay_s, self._lines, self._free_s = answer, delay_s, Lines(end), 0.0

    def take(self, t_s: float, data: bytes) -> None:
        """Bytes from the host; requests are worked off one after another."""
        for _, line in self._lines.feed([(t_s, data)]):
            self._free_s = max(self._free_s, t_s) + self._delay_s
            if reply := self._answer(self._free_s, line.decode("ascii", "replace").strip()):
                self.say(self._free_s, reply)

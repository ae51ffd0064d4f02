"""A Velmex VXM with a rotary table that has a switch at its zero: programs of indexes, run one after another."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping
from typing import Any

from drivers.emulators.line import Lab, Pieces, Replies

AT_ONCE = "VXYZTDKFECNRQ"  # commands of one letter, which need no end
ENTRY = re.compile(r"(S|SA|A|I|IA)(\d)M(-?\d{1,7})", re.ASCII)
REPLY_S, LONGEST, SWITCH_DEG, FAR_DEG, COUNTED = 0.004, 64, 0.0, 1e4, 240


class VelmexEmulator(Replies):
    """Deaf until it is taken online (E with an echo, F without). A ^ says that a program has ended.

    An index of -0 goes to the negative switch, one of 0 to the positive, which this table has not; IA of -0 sets zero.
    """

    baud = 9600

    def __init__(self, lab: Lab, roles: Mapping[str, Mapping[str, Any]], settings: Any) -> None:
        super().__init__()
        self._platform, self._motor, per_turn = lab.platform, settings.motor, settings.steps_per_turn
        self._per_deg: float = per_turn / 360
        self._online, self._echo, self._came, self._speed = False, False, "", 2000
        self._zero, self._program, self._left = -COUNTED, list[tuple[str, str]](), list[tuple[str, str]]()
        self._runs = False

    def take(self, t_s: float, data: bytes) -> None:
        """Bytes from the host; a comma or CR ends a command of more than one letter."""
        for letter in data.decode("latin-1"):
            if self._echo:
                self.say(t_s + REPLY_S, letter.encode("latin-1"))
            if not self._came and letter in AT_ONCE:
                self._do(t_s, letter)
            elif letter in ",\r\n":
                self._enter(self._came)
                self._came = ""
            else:
                self._came = (self._came + letter)[:LONGEST]

    def due_s(self) -> float:
        """When it says something next, or goes on in its program."""
        return min(super().due_s(), self._rests_s())

    def emit(self, until_s: float) -> Pieces:
        """Answers, and the end of a program."""
        pieces = super().emit(until_s)
        while (rests_s := self._rests_s()) <= until_s:
            if self._left:
                self._go_on(rests_s)
            else:
                self._runs = False
                pieces.append((rests_s, b"^"))
        return sorted(pieces, key=lambda piece: piece[0])

    def _rests_s(self) -> float:
        return float(self._platform.pieces[-1][0]) if self._runs else math.inf

    def _enter(self, text: str) -> None:
        """Into the program; what is no entry is passed over."""
        found = ENTRY.fullmatch(text)
        if self._online and found and int(found[2]) == self._motor:
            self._program.append((found[1], found[3]))

    def _do(self, t_s: float, letter: str) -> None:
        if letter in "EF":
            self._online, self._echo = True, letter == "E"
        if not self._online:
            return
        if letter == "V":
            self.say(t_s + REPLY_S, b"B" if self._runs else b"R")
        elif letter in "XYZT":
            steps = self._steps(t_s) if "XYZT".index(letter) == self._motor - 1 else 0
            self.say(t_s + REPLY_S, b"%+08d\r" % steps)
        elif letter in "DK":
            self._platform.stop(t_s)
            self._left.clear()
        elif letter == "C":
            self._program.clear()
        elif letter == "N":
            self._zero = 0
            self._zero = self._steps(t_s)
        elif letter == "R" and not self._runs:
            self._left, self._runs = list(self._program), True
            self._go_on(t_s)
        elif letter == "Q":
            self._online = self._echo = False

    def _go_on(self, t_s: float) -> None:
        """The next entries, up to one that moves."""
        self._platform.stop(t_s)
        while self._left:
            kind, value = self._left.pop(0)
            if kind in ("S", "SA"):
                self._speed = min(max(int(value), 1), 6000)
            elif (kind, value) == ("IA", "-0"):
                self._zero = 0
                self._zero = self._steps(t_s)
            elif kind in ("I", "IA"):
                self._platform.move(t_s, self._target_deg(t_s, kind, value), self._speed / self._per_deg)
                return

    def _target_deg(self, t_s: float, kind: str, value: str) -> float:
        if kind == "I" and int(value) == 0:
            return SWITCH_DEG if value.startswith("-") else FAR_DEG
        origin = self._steps(t_s) if kind == "I" else 0
        return (origin + int(value) + self._zero) / self._per_deg

    def _steps(self, t_s: float) -> int:
        return round(float(self._platform.now(t_s)[0]) * self._per_deg) - self._zero

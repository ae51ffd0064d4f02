"""An HMR2300: polled or continuous, ASCII or binary, with its write-enable."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping
from functools import cache
from typing import Any

import numpy as np

from drivers.emulators.line import Answers, Lab, Pieces
from drivers.emulators.streaming import SampleClock

COMMAND = re.compile(r"\*(\d\d)(.+)")
RATE = re.compile(r"R=(0?[1-6]0|0?25|100|123|154)")
SWITCHES = {"A": "ASCII ON", "B": "BINARY ON", "ZF": "ZERO OFF", "ZN": "ZERO ON", "VF": "AVG OFF", "VN": "AVG ON",
            "TN": "S/R ON", "TF": "S/R OFF", "Y": "OK", "N": "OK", "SP": "DONE"}  # fmt: skip
SAYS = {"WE": "OK", "#": "SER# 0000000000012345", "F": "S/W vers: 00104", "H": "H/W vers: 00021",
        "]S": "SET", "]R": "RST"}  # fmt: skip
TOGGLES = ("T", "Z", "V")
ESC = b"\x1b"


class Hmr2300Emulator(Answers):
    """Streams the twin's reference; every change of setting needs the write-enable just before it."""

    def __init__(self, lab: Lab, roles: Mapping[str, Mapping[str, Any]], settings: Any) -> None:
        super().__init__(self._reply, end=b"\r", delay_s=0.004)
        self._lab, self._id, self.baud = lab, settings.id, getattr(settings, "baud", 9600)
        self._format, self._rate, self._may_write = "A", 20, False
        self._on = {"T": True, "Z": False, "V": False}
        self._beat: SampleClock | None = None

    def take(self, t_s: float, data: bytes) -> None:
        """ESC ends the stream at once."""
        if ESC in data:
            self._beat = None
            data = data.replace(ESC, b"")
        super().take(t_s, data)

    def due_s(self) -> float:
        """When its next reply or sample is on the line."""
        return min(super().due_s(), self._beat.next_s() if self._beat else math.inf)

    def emit(self, until_s: float) -> Pieces:
        """Replies, then the samples that are due."""
        pieces = super().emit(until_s)
        if self._beat is None or not len(times := self._beat.due(until_s)):
            return pieces
        return pieces + list(zip(times.tolist(), self._frames(times), strict=True))

    def _reply(self, t_s: float, text: str) -> bytes:
        found = COMMAND.fullmatch(text.upper())
        if found is not None and int(found[1]) not in (self._id, 99):
            return b""
        may_write, self._may_write = self._may_write, False
        if found is None or len(text) > 10:
            return b"Re-enter\r"
        words = found[2]
        self._may_write = words == "WE"
        if words in SWITCHES or words in TOGGLES or RATE.fullmatch(words):
            return self._change(words) if may_write else b"WE OFF\r"
        if words == "C":
            self._beat = SampleClock(self._rate, t_s)
            return b""
        if words == "P":
            return self._frames(np.array([t_s]))[0]
        says = {**SAYS, **dict.fromkeys(("ID", "ID="), f"ID= {self._id:02d}"), "Q": self._setup()}
        return says.get(words, "Re-enter").encode() + b"\r"

    def _change(self, words: str) -> bytes:
        if words.startswith("R="):
            self._rate = int(words[2:])
            return b"OK\r"
        if words in TOGGLES:
            words += "F" if self._on[words] else "N"
        if words in "AB":
            self._format = words
        elif words[0] in TOGGLES:
            self._on[words[0]] = words[1] == "N"
        return SWITCHES[words].encode() + b"\r"

    def _setup(self) -> str:
        form, mode = "ASCII" if self._format == "A" else "BINARY", "CONT" if self._beat else "POLLED"
        sr, zero, average = ("ON" if self._on[what] else "OFF" for what in "TZV")
        return f"{form} {mode} S/R {sr} ZERO {zero} AVG {average} R ON ID= {self._id:02d} {self._rate} sps"

    def _frames(self, times: Any) -> list[bytes]:
        counts = self._lab.reference_nT(times)
        if self._format == "B":
            return [row.tobytes() + b"\r" for row in counts.astype(">i2")]
        return ["  ".join(map(column, row)).encode() + b"  \r" for row in counts.astype(int).tolist()]


@cache  # there are 40 000 counts
def column(count: int) -> str:
    """`- 1,234` or `-   123`: the sign, and six places with blanks for what is not there."""
    return f"{'-' if count < 0 else ' '}{abs(count):6,d}"

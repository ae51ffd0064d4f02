"""An Aim-TTi PL303QMT-P: the supply's own side of its line."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from drivers.emulators.line import Answers, Lab

COMMAND = re.compile(r"(V|I|OP)(\d)(O?)(\?| -?[\d.]+)")
MAX = {"V": 30.0, "I": 3.0}


@dataclass
class Output:
    """One output and the coil behind it."""

    coil: Any
    V: float = 0.0
    I: float = 0.0  # noqa: E741  the symbol on its panel
    on: bool = False


class TtiEmulator(Answers):
    """Answers as the supply does; settings act on the coil of the twin."""

    wire = "tcp"

    def __init__(self, lab: Lab, roles: Mapping[str, Mapping[str, Any]], settings: Any) -> None:
        super().__init__(self._reply, delay_s=0.008)
        self._outputs = {int(s.get("output", 1)): Output(lab.coils[role[-1]]) for role, s in roles.items()}
        self._events, self._error, self._locked = 128, 0, False
        self._serial = 512_340 + sum(ord(role[-1]) - ord("x") for role in roles)

    def _reply(self, t_s: float, text: str) -> bytes:
        if text == "*IDN?":
            return f"THURLBY THANDAR, PL303QMT-P, {self._serial}, 3.02-4.06\r\n".encode()
        if text in ("IFLOCK", "IFLOCK?", "IFUNLOCK"):
            self._locked = self._locked if text.endswith("?") else text == "IFLOCK"
            return b"%d\r\n" % self._locked
        if text == "*ESR?":
            events, self._events = self._events, 0
            return b"%d\r\n" % events
        if text == "EER?":
            error, self._error = self._error, 0
            return b"%d\r\n" % error
        if (found := COMMAND.fullmatch(text)) is None or int(found[2]) not in self._outputs:
            self._events |= 32
            return b""
        output = self._outputs[int(found[2])]
        if found[4] == "?":
            return self._read(t_s, output, found)
        self._set(t_s, output, found[1], float(found[4]))
        return b""

    def _read(self, t_s: float, output: Output, found: re.Match[str]) -> bytes:
        what, number = found[1], found[2]
        if what == "OP":
            return b"%d\r\n" % output.on
        if not found[3]:
            digits = 4 if what == "I" else 3
            return f"{what}{number} {getattr(output, what):.{digits}f}\r\n".encode()
        current = output.coil.current.now(t_s)
        return (f"{current:.3f}A\r\n" if what == "I" else f"{current * output.coil.resistance_ohm:.3f}V\r\n").encode()

    def _set(self, t_s: float, output: Output, what: str, value: float) -> None:
        if what == "OP":
            output.on = bool(value)
        elif not 0 <= value <= MAX[what]:
            self._events, self._error = self._events | 16, 100
        else:
            setattr(output, what, round(value, 4))
        output.coil.drive(t_s, output.I, output.V, output.on)

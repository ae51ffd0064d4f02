"""A Keysight E36312A: three outputs on one line, addressed by channel lists."""

from __future__ import annotations

import re
from collections import deque
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from drivers.emulators.line import QUEUE, Answers, Lab

COMMAND = re.compile(
    r"(VOLT|CURR|OUTP|MEAS:CURR|MEAS:VOLT)(?:(\?) | (\d+\.?\d*|\.\d+|ON|OFF),)\(@([123])\)", re.IGNORECASE
)
LONG = re.compile(r"(CURR|VOLT|OUTP|MEAS|SYST|ERR)(?:ENT|AGE|UT|URE|EM|OR)\b")
MAX = {1: {"VOLT": 6.18, "CURR": 5.15}, 2: {"VOLT": 25.75, "CURR": 1.03}, 3: {"VOLT": 25.75, "CURR": 1.03}}


@dataclass
class Output:
    """One output and the coil behind it."""

    coil: Any
    VOLT: float = 0.0
    CURR: float = 0.0
    on: bool = False


class KeysightEmulator(Answers):
    """Numbers come as `+1.23456000E+00`; `pairing` and `tracking` can be switched on at its panel."""

    wire = "tcp"

    def __init__(self, lab: Lab, roles: Mapping[str, Mapping[str, Any]], settings: Any) -> None:
        super().__init__(self._reply, delay_s=0.005)
        self._outputs = {int(s.get("output", 1)): Output(lab.coils[role[-1]]) for role, s in roles.items()}
        self._serial = f"MY5912{ord(min(roles)[-1])}"
        self._errors = deque[str](maxlen=QUEUE)
        self.pairing, self.tracking = "OFF", "0"

    def _reply(self, t_s: float, text: str) -> bytes:
        said = self._do(t_s, text)
        return said.encode() + b"\n" if said else b""

    def _do(self, t_s: float, text: str) -> str:
        short = LONG.sub(r"\1", text.upper().lstrip(":"))
        match short:
            case "*IDN?":
                return f"Keysight Technologies,E36312A,{self._serial},1.0.3-1.0.4-1.01"
            case "SYST:ERR?":
                return self._errors.popleft() if self._errors else '+0,"No error"'
            case "OUTP:PAIR?":
                return self.pairing
            case "OUTP:TRAC?":
                return self.tracking
        if (found := COMMAND.fullmatch(short)) is None or int(found[4]) not in self._outputs:
            return self._fault('-113,"Undefined header"')
        what, number = found[1].upper(), int(found[4])
        if found[2]:
            return self._read(t_s, self._outputs[number], what)
        return self._set(t_s, number, what, found[3].upper())

    def _read(self, t_s: float, output: Output, what: str) -> str:
        current = output.coil.current.now(t_s)
        if what == "OUTP":
            return f"{output.on:d}"
        if what.startswith("MEAS"):
            return f"{current if what.endswith('CURR') else current * output.coil.resistance_ohm:+.8E}"
        return f"{getattr(output, what):+.8E}"

    def _set(self, t_s: float, number: int, what: str, value: str) -> str:
        output = self._outputs[number]
        if what == "OUTP":
            output.on = value in ("1", "ON")
        elif what in MAX[number] and value not in ("ON", "OFF") and float(value) <= MAX[number][what]:
            setattr(output, what, float(value))
        else:
            return self._fault('-222,"Data out of range"')
        output.coil.drive(t_s, output.CURR, output.VOLT, output.on)
        return ""

    def _fault(self, text: str) -> str:
        self._errors.append(text)
        return ""

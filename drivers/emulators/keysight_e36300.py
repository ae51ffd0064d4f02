"""A Keysight E36312A: three outputs on one line, addressed by channel lists."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from drivers.emulators.line import Answers, Lab
from drivers.emulators.scpi import RANGE, Messages

NUMBER = r"\d+\.?\d*|\.\d+"
COMMAND = re.compile(
    rf"(VOLT|CURR|OUTP|MEAS:CURR|MEAS:VOLT)(?:(\?)(?: \(@([123])\))?| ({NUMBER}|ON|OFF)(?:,\(@([123])\))?)"
)
TRIPPED = re.compile(r"(VOLT|CURR):PROT:TRIP\?(?: \(@([123])\))?")
WATCH = re.compile(r"OUTP:PROT:WDOG(:DEL)?(?:(\?)| (\d+|ON|OFF))")
SELECT = re.compile(r"INST(?::NSEL |(?::SEL)? (?:CH|OUTP(?:UT)?))([123])")
APPLY = re.compile(rf"APPL (?:(?:CH|OUTP(?:UT)?)([123]),)?({NUMBER}),({NUMBER})(?:,\(@([123])\))?")
MAX = {1: {"VOLT": 6.18, "CURR": 5.15}, 2: {"VOLT": 25.75, "CURR": 1.03}, 3: {"VOLT": 25.75, "CURR": 1.03}}


@dataclass
class Output:
    """One output and the coil behind it."""

    coil: Any
    VOLT: float = 0.0
    CURR: float = 0.0
    on: bool = False


class KeysightEmulator(Answers):
    """Numbers come as `+1.23456000E+00`; `pairing` and `tracking` can be switched on at its panel.

    What names no output is for the selected one. `has_watchdog`: whether it knows the commands of its watchdog, which
    latches every output off until it is cleared.
    """

    wire = "tcp"

    def __init__(self, lab: Lab, roles: Mapping[str, Mapping[str, Any]], settings: Any) -> None:
        self._outputs = {int(s.get("output", 1)): Output(lab.coils[role[-1]]) for role, s in roles.items()}
        who = f"Keysight Technologies,E36312A,MY5912{ord(min(roles)[-1])},1.0.3-1.0.4-1.01"
        self._scpi = Messages(who, self._do, self._reset, none='+0,"No error"')
        super().__init__(self._line, delay_s=0.005)
        self.tripped = ""  # by which of VOLT and CURR
        self.has_watchdog, self._watching, self._delay_wd_s, self._ends_s = True, False, 60, math.inf
        self.pairing, self.tracking, self._selected = "OFF", "0", min(self._outputs)

    def _line(self, t_s: float, text: str) -> bytes:
        self._hear(t_s)
        return self._scpi.line(t_s, text)

    def _reset(self, t_s: float) -> None:
        self._watching, self._ends_s = False, math.inf
        for output in self._outputs.values():
            output.VOLT, output.CURR, output.on = 0.0, 0.0, False
            output.coil.drive(t_s, 0.0, 0.0, False)
        self._hear(t_s)

    def _hear(self, t_s: float) -> None:
        """Whatever it hears puts the watchdog off, unless it has tripped."""
        if t_s <= self._ends_s:
            self._ends_s = t_s + self._delay_wd_s if self._watching else math.inf
            for output in self._outputs.values():
                output.coil.close(t_s, "watchdog", self._ends_s)

    def _watch(self, t_s: float, delay: str | None, ask: str | None, value: str | None) -> str:
        if ask:
            return f"{self._delay_wd_s if delay else int(self._watching)}"
        if delay and value not in ("ON", "OFF") and 1 <= int(value or 0) <= 3600:
            self._delay_wd_s = int(value or 0)
        elif not delay and value in ("0", "1", "ON", "OFF"):
            self._watching = value in ("1", "ON")
        else:
            return self._scpi.fault(RANGE)
        self._hear(t_s)
        return ""

    def _do(self, t_s: float, short: str) -> str | None:
        match short:
            case "OUTP:PAIR?":
                return self.pairing
            case "OUTP:TRAC?":
                return self.tracking
            case "INST:NSEL?":
                return f"{self._selected}"
            case "SYST:LOC" | "SYST:REM" | "SYST:RWL":
                return ""
        if found := TRIPPED.fullmatch(short):
            self._wired(found[2])
            return f"{self.tripped == found[1]:d}"
        if short == "OUTP:PROT:CLE":
            self._ends_s = math.inf
            self._hear(t_s)
        elif self.has_watchdog and (found := WATCH.fullmatch(short)):
            return self._watch(t_s, found[1], found[2], found[3])
        elif found := SELECT.fullmatch(short):
            self._selected = self._wired(found[1])
        elif found := APPLY.fullmatch(short):
            number = self._wired(found[1] or found[4])
            return self._set(t_s, number, "VOLT", found[2]) or self._set(t_s, number, "CURR", found[3])
        elif found := COMMAND.fullmatch(short):
            number = self._wired(found[3] or found[5])
            return self._read(t_s, number, found[1]) if found[2] else self._set(t_s, number, found[1], found[4])
        else:
            return None
        return ""

    def _wired(self, stated: str | None) -> int:
        """The output that is stated, or the selected one."""
        number = int(stated or self._selected)
        if number not in self._outputs:
            raise KeyError(number)
        return number

    def _read(self, t_s: float, number: int, what: str) -> str:
        output = self._outputs[number]
        current = output.coil.current.now(t_s)
        if what == "OUTP":
            return f"{output.on:d}"
        if what.startswith("MEAS"):
            return f"{round(current * (1 if what.endswith('CURR') else output.coil.resistance_ohm), 5):+.8E}"
        return f"{getattr(output, what):+.8E}"

    def _set(self, t_s: float, number: int, what: str, value: str) -> str:
        output = self._outputs[number]
        if what == "OUTP":
            output.on = value in ("1", "ON")
        elif what in MAX[number] and value not in ("ON", "OFF") and float(value) <= MAX[number][what]:
            setattr(output, what, float(value))
        else:
            return self._scpi.fault(RANGE)
        output.coil.drive(t_s, output.CURR, output.VOLT, output.on)
        return ""

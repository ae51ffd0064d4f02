"""A Kepco BOP 36-12 with a BIT 4886 card: signed current, and an off that is zero and not open."""

from __future__ import annotations

import re
from collections import deque
from collections.abc import Mapping
from typing import Any

from drivers.emulators.line import QUEUE, Answers, Lab

SET = re.compile(r"(CURR|VOLT) ([+-]?(?:\d+\.?\d*|\.\d+))")
LONG = re.compile(r"(CURR|VOLT|OUTP|MEAS|FUNC|SYST|ERR)(?:ENT|AGE|UT|URE|TION|EM|OR)\b")
MAX = {"CURR": 12.0, "VOLT": 36.0}


class KepcoEmulator(Answers):
    """Starts in voltage mode, as the supply does when it is switched on."""

    def __init__(self, lab: Lab, roles: Mapping[str, Mapping[str, Any]], settings: Any) -> None:
        super().__init__(self._reply, delay_s=0.01)
        (role,) = roles
        self._coil, self._serial = lab.coils[role[-1]], f"E{ord(role[-1]) * 1117}"
        self._values, self._current_mode, self._on = {"CURR": 0.0, "VOLT": 0.0}, False, False
        self._errors = deque[str](maxlen=QUEUE)

    def _reply(self, t_s: float, text: str) -> bytes:
        said = self._do(t_s, text.upper())
        self._coil.drive(t_s, self._values["CURR"], self._values["VOLT"], self._on and self._current_mode)
        return said.encode() + b"\n" if said else b""

    def _do(self, t_s: float, text: str) -> str:
        if set_ := SET.fullmatch(LONG.sub(r"\1", text)):
            return self._set(set_[1], float(set_[2]))
        match LONG.sub(r"\1", text).replace(":", " ").split():
            case ["*IDN?"]:
                return f"KEPCO,BOP 36-12,{self._serial},4.04-1.82"
            case ["SYST", "ERR?"]:
                return self._errors.popleft() if self._errors else '0,"No error"'
            case ["CURR?" | "VOLT?" as what]:
                return f"{self._values[what[:4]]:.4f}"
            case ["MEAS", "CURR?"]:
                return f"{self._coil.current.now(t_s):.4f}"
            case ["MEAS", "VOLT?"]:
                return f"{self._coil.current.now(t_s) * self._coil.resistance_ohm:.3f}"
            case ["FUNC", "MODE?"]:
                return f"{self._current_mode:d}"
            case ["FUNC", "MODE", "CURR" | "VOLT" as mode]:
                self._current_mode = mode == "CURR"
            case ["OUTP?"]:
                return f"{self._on:d}"
            case ["OUTP", "0" | "1" | "ON" | "OFF" as on]:
                self._on = on in ("1", "ON")
            case ["SYST", "BEEP"]:
                pass
            case _:
                self._errors.append('-113,"Undefined header"')
        return ""

    def _set(self, what: str, value: float) -> str:
        if abs(value) > MAX[what]:
            self._errors.append('-222,"Data out of range"')
        else:
            self._values[what] = value
        return ""

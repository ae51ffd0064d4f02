"""An HP 603x: numbers behind their words, an error register by number, foldback, and protections that latch."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import Any

from drivers.emulators.line import Answers, Lab
from drivers.hp_603x import MOST

SET = re.compile(r"(VSET|ISET|VMAX|IMAX) *([+-]?\d*\.?\d+(?:E[+-]?\d+)?) *(M?[VA])?")
SWITCH = re.compile(r"(OUT|FOLD|HOLD) *(0|1|2|OFF|ON|CV|CC)")
STATES = {"OFF": "0", "ON": "1", "CV": "1", "CC": "2"}
CV, CC, OVER_VOLTAGE, FOLDBACK, ERROR = 1, 2, 8, 64, 128
UNKNOWN, SYNTAX, RANGE, SOFT_LIMIT = 3, 4, 5, 6


class Hp603xEmulator(Answers):
    """A protection that has tripped leaves the output off until RST, whatever OUT says."""

    baud = 9600

    def __init__(self, lab: Lab, roles: Mapping[str, Mapping[str, Any]], settings: Any) -> None:
        (role,) = roles
        self._coil, self._model = lab.coils[role[-1]], settings.model
        volts, amps = MOST[settings.model]
        self._most = {"VSET": 1.02375 * volts, "ISET": 1.02375 * amps}
        self._held = {"VSET": 0.0, "ISET": 0.0, "VMAX": self._most["VSET"], "IMAX": self._most["ISET"]}
        self._states = {"OUT": "1", "FOLD": "0", "HOLD": "0"}
        self._error = self._tripped = 0
        super().__init__(self._heard, delay_s=0.01)

    def trip(self, t_s: float, fault: int = OVER_VOLTAGE) -> None:
        """A protection ends its output."""
        self._tripped |= fault
        self._drive(t_s)

    def _heard(self, t_s: float, line: str) -> bytes:
        said = ""
        for message in filter(None, (part.strip() for part in line.upper().split(";"))):
            said = self._one(t_s, message) or said  # a talker sends what was asked for last
        return f"{said}\r\n".encode() if said else b""

    def _one(self, t_s: float, message: str) -> str:
        if message.endswith("?"):
            return self._asked(t_s, message[:-1].strip())
        if found := SET.fullmatch(message):
            self._set(t_s, found[1], float(found[2]) / (1000 if (found[3] or "").startswith("M") else 1))
        elif found := SWITCH.fullmatch(message):
            self._states[found[1]] = STATES.get(found[2], found[2])
        elif message in ("RST", "CLR"):
            self._tripped = 0
            if message == "CLR":
                self._held |= {"VSET": 0.0, "ISET": 0.0}
        else:
            self._error = SYNTAX if message[:4] in self._held else UNKNOWN
        self._drive(t_s)
        return ""

    def _asked(self, t_s: float, word: str) -> str:
        amps = self._coil.current.now(t_s)
        volts = amps * self._coil.resistance_ohm
        if word in ("ERR", "ID"):
            told, self._error = f"ERR {self._error}", self._error if word == "ID" else 0
            return f"ID HP{self._model}" if word == "ID" else told
        numbers = {**self._held, "IOUT": amps, "VOUT": volts}
        if word in numbers:
            return f"{word} {numbers[word]:8.4f}"
        if word in self._states:
            return f"{word} {self._states[word]}"
        if word in ("STS", "ASTS", "FAULT"):
            limited = volts > self._held["VSET"] - 0.01
            return f"{word} {(CV if limited else CC) * self._on | self._tripped | ERROR * bool(self._error)}"
        self._error = UNKNOWN
        return ""

    @property
    def _on(self) -> bool:
        return self._states["OUT"] == "1" and not self._tripped

    def _set(self, t_s: float, word: str, value: float) -> None:
        setting = word.replace("MAX", "SET")
        if not 0 <= value <= self._most[setting]:
            self._error = RANGE
        elif word == setting and value > self._held[word.replace("SET", "MAX")]:
            self._error = SOFT_LIMIT
        else:
            step = self._most[setting] / 4095
            self._held[word] = round(value / step) * step

    def _drive(self, t_s: float) -> None:
        amps, volts = self._held["ISET"], self._held["VSET"]
        limited = amps * self._coil.resistance_ohm > volts
        if self._on and ((self._states["FOLD"] == "2" and not limited) or (self._states["FOLD"] == "1" and limited)):
            self._tripped |= FOLDBACK
        self._coil.drive(t_s, amps, volts, self._on)

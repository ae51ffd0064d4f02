"""A Kepco BOP 36-12 with a BIT 4886 card: signed current, and an off that is zero and not open."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import Any

from drivers.emulators.line import Answers, Lab
from drivers.emulators.scpi import RANGE, Messages

SET = re.compile(r"(CURR|VOLT) ([+-]?(?:\d+\.?\d*|\.\d+)(?:E[+-]?\d+)?)")
MAX = {"CURR": 12.0, "VOLT": 36.0}
LOCAL = '-221,"Settings conflict"'


class KepcoEmulator(Answers):
    """Starts in voltage mode and local, as the supply does when it is switched on; local, it does nothing it is told.

    `echoes`: it sends every message back before anything else, as a BIT 802E does on its network port.
    """

    baud = 9600

    def __init__(self, lab: Lab, roles: Mapping[str, Mapping[str, Any]], settings: Any) -> None:
        super().__init__(self._line, delay_s=0.01)
        (role,) = roles
        who = f"KEPCO,BIT 4886 36-12  08-04-2023,H{ord(role[-1]) * 1117},4.04-1.82"
        self._scpi, self._coil = Messages(who, self._do, self._reset), lab.coils[role[-1]]
        self.echoes = self._remote = False
        self._values, self._current_mode, self._on = {"CURR": 0.0, "VOLT": 0.0}, False, False

    def _line(self, t_s: float, text: str) -> bytes:
        echo = f"{text}\r\n".encode() if self.echoes else b""
        said = self._scpi.line(t_s, text)
        self._coil.drive(t_s, self._values["CURR"], self._values["VOLT"], self._on and self._current_mode)
        return echo + said

    def _reset(self, t_s: float) -> None:
        self._values, self._current_mode, self._on = {"CURR": 0.0, "VOLT": 0.0}, False, False

    def _do(self, t_s: float, message: str) -> str | None:
        match message.replace(":", " ").split():
            case ["CURR?" | "VOLT?" as what]:
                return _number(self._values[what[:4]])
            case ["MEAS", "CURR?"]:
                return _number(self._coil.current.now(t_s))
            case ["MEAS", "VOLT?"]:
                return _number(self._coil.current.now(t_s) * self._coil.resistance_ohm)
            case ["FUNC", "MODE?"]:
                return f"{self._current_mode:d}"
            case ["OUTP?"]:
                return f"{self._on:d}"
            case ["SYST", "REM?"]:
                return f"{self._remote:d}"
            case ["SYST", "REM", "0" | "1" | "ON" | "OFF" as on]:
                self._remote = on in ("1", "ON")
                return ""
            case ["SYST", "BEEP"]:
                return ""
        return self._act(message)

    def _act(self, message: str) -> str | None:
        """What it does only under remote control."""
        set_, words = SET.fullmatch(message), message.replace(":", " ").split()
        known = set_ or words[:1] == ["OUTP"] or words[:2] == ["FUNC", "MODE"]
        if not known:
            return None
        if not self._remote:
            return self._scpi.fault(LOCAL)
        if set_ and abs(float(set_[2])) <= MAX[set_[1]]:
            self._values[set_[1]] = float(set_[2])
        elif words[0] == "OUTP" and words[-1] in ("0", "1", "ON", "OFF"):
            self._on = words[-1] in ("1", "ON")
        elif words[0] == "FUNC" and words[-1][:4] in ("CURR", "VOLT"):
            self._current_mode = words[-1].startswith("CURR")
        else:
            return self._scpi.fault(RANGE)
        return ""


def _number(value: float) -> str:
    """`9.989E-2`, with four digits as the card sends them."""
    return f"{value:.3E}".replace("E-0", "E-").replace("E+0", "E")

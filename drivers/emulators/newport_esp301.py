"""A Newport ESP301 with a URS100 rotary stage on axis 1."""

from __future__ import annotations

import re
from collections import deque
from collections.abc import Mapping
from typing import Any

from drivers.emulators.line import QUEUE, Answers, Lab

COMMAND = re.compile(r"(\d?)([A-Z]{2})(\?|-?\d+\.?\d*|)")
OUT_OF_RANGE, MOTOR_OFF, UNKNOWN, MISSING = 7, 113, 6, 38
MAX_RATE = 40.0
TEXTS = {
    OUT_OF_RANGE: "PARAMETER OUT OF RANGE",
    MOTOR_OFF: "MOTOR NOT ENABLED",
    UNKNOWN: "COMMAND DOES NOT EXIST",
    MISSING: "COMMAND PARAMETER MISSING",
}


class Esp301Emulator(Answers):
    """Moves the twin's turntable; its motor is off until it is switched on.

    WS: what comes after it is worked off when it has stopped, and so many milliseconds later.
    """

    baud = 19200

    def __init__(self, lab: Lab, roles: Mapping[str, Mapping[str, Any]], settings: Any) -> None:
        super().__init__(self._reply, end=b"\r", delay_s=0.004)
        self._platform, self._on = lab.platform, False
        self._rates = {"VA": 10.0, "OH": 10.0, "OL": 1.0}
        self._errors = deque[int](maxlen=QUEUE)

    def _reply(self, t_s: float, text: str) -> bytes:
        said = [self._do(max(t_s, self._free_s), one.strip()) for one in text.split(";")]
        return b"".join(one.encode() + b"\r\n" for one in said if one)

    def _do(self, t_s: float, text: str) -> str:
        found = COMMAND.fullmatch(text.upper())
        match (found[1], found[2], found[3]) if found else ():
            case ("", "VE", "?"):
                return "ESP301 Version 3.0.1 6/1/99"
            case ("", "TB", "?"):
                code = self._errors.popleft() if self._errors else 0
                return f"{code}, {int(t_s * 400)}, {TEXTS.get(code, 'NO ERROR DETECTED')}"
            case ("1", "ID", "?"):
                return "URS100BPP, SN1263"
            case ("1", "SN", "?"):
                return "7"
            case ("1", "TP", _):
                return f"{self._platform.now(t_s)[0]:.4f}"
            case ("1", "MD", "?"):
                return f"{not self._platform.moving(t_s):d}"
            case ("1", "VA" | "OH" | "OL" as speed, "?"):
                return f"{self._rates[speed]:.4f}"
            case ("", "TE", "?"):
                return str(self._errors.popleft() if self._errors else 0)
            case ("1", "MO", "?"):
                return f"{self._on:d}"
            case ("1", "SL" | "SR" as side, "?"):
                return "-720" if side == "SL" else "720"
            case ("1", "PA", "?"):
                return f"{self._platform.now(t_s)[0]:.4f}"
            case ("1", what, value):
                self._act(t_s, what, value)
            case _:
                self._errors.append(UNKNOWN)
        return ""

    def _act(self, t_s: float, what: str, value: str) -> None:
        match what:
            case "MO":
                self._on = True
            case "MF":
                self._on = False
            case "ST":
                self._platform.stop(t_s)
            case "WS":
                self._free_s = max(t_s, self._platform.pieces[-1][0]) + float(value or 0) / 1000
            case "VA" | "OH" | "OL" | "PA" if value in ("", "?"):
                self._errors.append(MISSING)
            case "VA" | "OH" | "OL" if 0 < float(value) <= MAX_RATE:
                self._rates[what] = float(value)
            case "PA" | "OR" if not self._on:
                self._errors.append(MOTOR_OFF)
            case "PA":
                self._platform.move(t_s, float(value), self._rates["VA"])
            case "OR":
                self._platform.move(t_s, 0.0, self._rates["OH"])
            case "VA" | "OH" | "OL":
                self._errors.append(OUT_OF_RANGE)
            case _:
                self._errors.append(UNKNOWN)

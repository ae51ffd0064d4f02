"""A Newport ESP301 with a URS100 rotary stage on axis 1."""

from __future__ import annotations

import re
from collections import deque
from collections.abc import Mapping
from typing import Any

from drivers.emulators.line import QUEUE, Answers, Lab

COMMAND = re.compile(r"(\d?)([A-Z]{2})(\?|-?\d+\.?\d*|)")
UNKNOWN, OUT_OF_RANGE, NO_SUCH_AXIS, AXIS_MISSING, MISSING = 6, 7, 9, 37, 38
BEYOND_PLUS, BEYOND_MINUS, TOO_FAST, MOTOR_OFF = 106, 107, 110, 113  # of axis 1
MAX_RATE, FARTHEST = 40.0, 720.0
OF_AN_AXIS = ("ID", "SN", "TP", "MD", "VA", "OH", "OL", "SL", "SR", "PA", "PR", "OR", "MO", "MF")
TEXTS = {
    OUT_OF_RANGE: "PARAMETER OUT OF RANGE",
    NO_SUCH_AXIS: "AXIS NUMBER OUT OF RANGE",
    AXIS_MISSING: "AXIS NUMBER MISSING",
    BEYOND_PLUS: "POSITIVE SOFTWARE LIMIT EXCEEDED",
    BEYOND_MINUS: "NEGATIVE SOFTWARE LIMIT EXCEEDED",
    TOO_FAST: "MAXIMUM VELOCITY EXCEEDED",
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
                return f"{-FARTHEST if side == 'SL' else FARTHEST:g}"
            case ("1", "PA", "?"):
                return f"{self._platform.now(t_s)[0]:.4f}"
            case ("1", what, value):
                self._act(t_s, what, value)
            case (axis, what, _) if what in OF_AN_AXIS:
                self._errors.append(NO_SUCH_AXIS if axis else AXIS_MISSING)
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
            case "VA" | "OH" | "OL" | "PA" | "PR" if value in ("", "?"):
                self._errors.append(MISSING)
            case "VA" | "OH" | "OL" if 0 < float(value) <= MAX_RATE:
                self._rates[what] = float(value)
            case "PA" | "PR" | "OR" if not self._on:
                self._errors.append(MOTOR_OFF)
            case "PA" | "PR":
                self._move(t_s, float(value) + (float(self._platform.now(t_s)[0]) if what == "PR" else 0.0))
            case "OR":
                self._platform.move(t_s, 0.0, self._rates["OH"])
            case "VA" | "OH" | "OL":
                self._errors.append(TOO_FAST if float(value) > 0 else OUT_OF_RANGE)
            case _:
                self._errors.append(UNKNOWN)

    def _move(self, t_s: float, to_deg: float) -> None:
        if abs(to_deg) > FARTHEST:
            self._errors.append(BEYOND_PLUS if to_deg > 0 else BEYOND_MINUS)
        else:
            self._platform.move(t_s, to_deg, self._rates["VA"])

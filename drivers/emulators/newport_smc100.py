"""A Newport SMC100CC with a rotary stage: not referenced until it has homed."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import Any

from drivers.emulators.line import Answers, Lab

COMMAND = re.compile(r"(\d+)([A-Z]{2})(\?|-?\d+\.?\d*|)")
NOT_REFERENCED, HOMING, MOVING, HAS_HOMED, HAS_MOVED = 0x0A, 0x1E, 0x28, 0x32, 0x33
READY = (HAS_HOMED, HAS_MOVED)
REFUSED = {NOT_REFERENCED: "H", HOMING: "L", MOVING: "M", HAS_HOMED: "K", HAS_MOVED: "K"}
MAX_RATE = HOME_RATE = 20.0
ACCELERATION, FAR_DEG = 80, 10_000


class Smc100Emulator(Answers):
    """Replies repeat address and command; the letter of the last error is asked for with TE."""

    baud = 57600

    def __init__(self, lab: Lab, roles: Mapping[str, Mapping[str, Any]], settings: Any) -> None:
        super().__init__(self._reply, end=b"\r\n", delay_s=0.005)
        self._platform, self._address, self._rate = lab.platform, settings.address, 20.0
        self._homed, self._homing, self._error = False, False, "@"

    def _reply(self, t_s: float, text: str) -> bytes:
        found = COMMAND.fullmatch(text.upper())
        if found is None or int(found[1]) != self._address:
            return b""
        said = self._do(t_s, found[2], found[3])
        return f"{self._address}{found[2]}{said}\r\n".encode() if said else b""

    def _do(self, t_s: float, what: str, value: str) -> str:
        match what, value:
            case "VE", _:
                return " SMC_CC - Controller-driver version  3. 1. 2"
            case "ID", "?":
                return "URS50BCC_SN0042"
            case "TS", _:
                return f"{0:04X}{self._state(t_s):02X}"
            case "TP", _:
                return f"{self._platform.now(t_s)[0]:.5f}"
            case "VA", "?":
                return f"{self._rate:.4f}"
            case ("PA", "?") | ("TH", _):
                return f"{self._platform.now(t_s)[0]:.5f}"
            case "OH", "?":
                return f"{HOME_RATE:g}"
            case "AC", "?":
                return f"{ACCELERATION}"
            case (("SL" | "SR"), "?"):
                return f"{-FAR_DEG if what == 'SL' else FAR_DEG}"
            case "PT", way if way and way != "?":  # of a trapezium
                return f"{abs(float(way)) / self._rate + self._rate / ACCELERATION:.4f}"
            case "PW", "?":
                return "0"
            case "TE", _:
                error, self._error = self._error, "@"
                return error
            case _:
                self._error = self._act(t_s, what, value)
        return ""

    def _state(self, t_s: float) -> int:
        if not self._homed:
            return NOT_REFERENCED
        if self._platform.moving(t_s):
            return HOMING if self._homing else MOVING
        return HAS_HOMED if self._homing else HAS_MOVED

    def _act(self, t_s: float, what: str, value: str) -> str:
        """The error letter."""
        match what:
            case "ST":
                self._platform.stop(t_s)
            case "VA" | "PA" | "PR" if value in ("", "?"):
                return "C"
            case "OR" if self._state(t_s) == NOT_REFERENCED:
                self._homed = self._homing = True
                self._platform.move(t_s, 0.0, HOME_RATE)
            case "VA" if 0 < float(value) <= MAX_RATE:
                self._rate = float(value)
            case "PA" | "PR" if self._state(t_s) in READY:
                here = float(self._platform.now(t_s)[0]) if what == "PR" else 0.0
                self._homing = False
                self._platform.move(t_s, here + float(value), self._rate)
            case "OR" | "PA" | "PR":
                return REFUSED[self._state(t_s)]
            case "VA":
                return "C"
            case _:
                return "A"
        return "@"

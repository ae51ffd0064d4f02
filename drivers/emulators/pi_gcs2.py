"""A PI C-863 with an M-060.DG rotation stage: GCS 2, one error kept until it is asked for."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from drivers.emulators.line import Answers, Lab

IDN = "(c)2015 Physik Instrumente (PI) GmbH & Co. KG, C-863.11, 0115500620, 1.2.1.0"
SYNTAX, UNKNOWN, NOT_NOW, LIMITS, STOPPED, NO_AXIS, RANGE, NO_PARAMETER = 1, 2, 5, 7, 10, 15, 17, 54
MIN_DEG, MAX_DEG, MAX_RATE = -3600.0, 3600.0, 40.0
VELOCITY, FASTEST, REFERENCE_VELOCITY, UNIT, STAGE = 0x49, 0xA, 0x50, 0x7000601, 0x3C
MOTION, READY, STOP = 5, 7, 24  # single characters, worked off at once


class PiEmulator(Answers):
    """Axes are named after the setting `axis`; what is asked without one is asked of it."""

    baud = 115200

    def __init__(self, lab: Lab, roles: Mapping[str, Mapping[str, Any]], settings: Any) -> None:
        super().__init__(self._reply, delay_s=0.003)
        self._platform = lab.platform
        self._axis: str = settings.axis
        self.error, self.servo, self._target = 0, False, 0.0
        self._referenced, self._seeking = False, False
        self.held: dict[int, float | str] = {
            VELOCITY: 10.0, FASTEST: MAX_RATE, REFERENCE_VELOCITY: 10.0, UNIT: "DEG", STAGE: "M-060.DG",
        }  # fmt: skip

    def take(self, t_s: float, data: bytes) -> None:
        """Single characters are no part of a line: they are worked off where they stand."""
        for byte in data:
            if byte in (MOTION, READY, STOP):
                if said := self._at_once(t_s, byte):
                    self.say(t_s + self._delay_s, said)
            else:
                super().take(t_s, bytes([byte]))

    def _at_once(self, t_s: float, byte: int) -> bytes:
        moving = self._platform.moving(t_s)
        if byte == STOP:
            self._stop(t_s)
            return b""
        return b"%x\n" % int(moving) if byte == MOTION else bytes([0xB1, 0x0A])

    def _knows_its_place(self, t_s: float) -> bool:
        if self._seeking and not self._platform.moving(t_s):
            self._referenced, self._seeking = True, False
        return self._referenced

    def _stop(self, t_s: float) -> None:
        self._knows_its_place(t_s)
        self._seeking = False
        self._platform.stop(t_s)
        self.error = STOPPED

    def _reply(self, t_s: float, text: str) -> bytes:
        words, *stated = text.split() or [""]
        said = self._do(t_s, words.upper(), stated)
        return f"{said}\n".encode("latin-1", "replace") if said else b""

    def _do(self, t_s: float, words: str, stated: list[str]) -> str:
        match words:
            case "":
                return ""
            case "*IDN?":
                return IDN
            case "ERR?":
                code, self.error = self.error, 0
                return str(code)
            case "SAI?":
                return self._axis
            case "CSV?":
                return "2.0"
            case "SPA" | "SPA?":
                return self._parameter(words, stated)
            case "STP":
                self._stop(t_s)
                return ""
        if stated and stated[0].upper() != self._axis.upper():
            self.error = NO_AXIS
        elif words.endswith("?"):
            return self._asked(t_s, words)
        else:
            self.error = self._execute(t_s, words, stated[1:]) or self.error
        return ""

    def _asked(self, t_s: float, words: str) -> str:
        angle, moving = self._platform.now(t_s)[0], self._platform.moving(t_s)
        known = {
            "POS?": f"{angle:.6f}", "MOV?": f"{self._target:.6f}", "SVO?": f"{self.servo:d}",
            "FRF?": f"{self._knows_its_place(t_s):d}", "RON?": "1", "TRS?": "1", "LIM?": "0",
            "ONT?": f"{not moving and abs(angle - self._target) < 0.01:d}", "VEL?": f"{self.held[VELOCITY]:.6f}",
            "TMN?": f"{MIN_DEG:.6f}", "TMX?": f"{MAX_DEG:.6f}", "CST?": str(self.held[STAGE]), "PUN?": "DEG",
        }  # fmt: skip
        if words not in known:
            self.error = UNKNOWN
            return ""
        return f"{self._axis}={known[words]}"

    def _execute(self, t_s: float, words: str, values: list[str]) -> int:
        """The error's number, or 0."""
        try:
            value = float(values[0]) if values else None
        except ValueError:
            return SYNTAX
        match words:
            case "SVO" if value in (0.0, 1.0):
                self.servo = value == 1.0
            case "HLT":
                self._stop(t_s)
            case "FRF" if not self.servo:
                return NOT_NOW
            case "FRF":
                self._referenced, self._seeking, self._target = False, True, 0.0
                self._platform.move(t_s, 0.0, float(self.held[REFERENCE_VELOCITY]))
            case "VEL" if value is not None:
                if not 0 < value <= MAX_RATE:
                    return RANGE
                self.held[VELOCITY] = value
            case "MOV" | "MVR" if value is not None:
                return self._move(t_s, value + (self._target if words == "MVR" else 0.0))
            case "SVO" | "VEL" | "MOV" | "MVR":
                return SYNTAX
            case _:
                return UNKNOWN
        return 0

    def _move(self, t_s: float, to_deg: float) -> int:
        if not (self.servo and self._knows_its_place(t_s)):
            return NOT_NOW
        if not MIN_DEG <= to_deg <= MAX_DEG:
            return LIMITS
        self._target = to_deg
        self._platform.move(t_s, to_deg, float(self.held[VELOCITY]))
        return 0

    def _parameter(self, words: str, stated: list[str]) -> str:
        try:
            axis, number, value = stated[0], int(stated[1], 0), float(stated[2]) if stated[2:] else None
        except (ValueError, IndexError):
            self.error = SYNTAX
            return ""
        if axis.upper() != self._axis.upper() or number not in self.held:
            self.error = NO_PARAMETER if axis.upper() == self._axis.upper() else NO_AXIS
        elif words == "SPA?":
            return f"{self._axis} {number:#X}={self.held[number]}".replace("0X", "0x")
        elif value is None or not 0 < value <= MAX_RATE or isinstance(self.held[number], str):
            self.error = RANGE
        else:
            self.held[number] = value
        return ""

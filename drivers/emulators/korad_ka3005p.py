"""A Korad KA3005P of the old firmware: no line ends, a stray sixth byte, and deaf while it is busy."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import Any

from drivers.emulators.line import Lab, Replies

BUSY_S, REPLY_S = 0.08, 0.015
MAX = {"V": 31.0, "I": 5.1}
SET = re.compile(r"([VI])SET1:(\d+\.?\d*)")


class KoradEmulator(Replies):
    """Each arrival is one command; what comes within 80 ms of the last one is dropped without a word."""

    baud = 9600

    def __init__(self, lab: Lab, roles: Mapping[str, Mapping[str, Any]], settings: Any) -> None:
        super().__init__()
        (role,) = roles
        self._coil, self._end = lab.coils[role[-1]], settings.terminator
        self._values, self._on = {"V": 0.0, "I": 0.0}, False
        self._free_s = 0.0

    def take(self, t_s: float, data: bytes) -> None:
        """Bytes from the host."""
        if t_s < self._free_s:
            return
        self._free_s = t_s + BUSY_S
        if reply := self._reply(t_s, data.decode("ascii", "replace").removesuffix(self._end)):
            self.say(t_s + REPLY_S, reply)

    def _reply(self, t_s: float, text: str) -> bytes:
        current = self._coil.current.now(t_s)
        voltage = current * self._coil.resistance_ohm
        limited = self._on and voltage > self._values["V"] - 0.01
        replies = {
            "*IDN?": b"KORADKA3005PV2.0",
            "VSET1?": b"%05.2f" % self._values["V"],
            "ISET1?": b"%05.3fK" % self._values["I"],
            "VOUT1?": b"%05.2f" % voltage,
            "IOUT1?": b"%05.3f" % current,
            "STATUS?": bytes([limited | self._on << 6]),
        }
        if text in replies:
            return replies[text]
        if (found := SET.fullmatch(text)) and float(found[2]) <= MAX[found[1]]:
            self._values[found[1]] = float(found[2])
        elif text in ("OUT0", "OUT1"):
            self._on = text == "OUT1"
        self._coil.drive(t_s, self._values["I"], self._values["V"], self._on)
        return b""

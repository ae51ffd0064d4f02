"""An AlphaLab milligauss meter: requests of six bytes, lists in chunks of twenty, readings of 31."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from drivers.emulators.line import Lab, Replies

NT_PER_TENTH_MG = 10.0
LISTS = {
    0x01: b"MODEL=MR3:SERIAL=12345:FIRMWARE=1.6:UNITS=MILLIGAUSS:",
    0x02: b"BACKLIGHT=1:RELATIVE=0:ZERO=0:RATE=20:",
}
DELAY_S, SILENCE_S, NEXT_S = 0.005, 0.1, 0.045


class AlphaLabEmulator(Replies):
    """Answers one request at a time; the magnitude is that of the three axes as sent.

    It is deaf for the next chunk for 45 ms after the one before. `lists`: what it says of itself. `gauss`: its unit.
    """

    def __init__(self, lab: Lab, roles: Mapping[str, Mapping[str, Any]], settings: Any) -> None:
        super().__init__()
        self._lab, self._asked, self._list, self._heard_s, self._said_s = lab, b"", b"", 0.0, 0.0
        self.lists, self.gauss = dict(LISTS), False

    def take(self, t_s: float, data: bytes) -> None:
        """Requests of six bytes; a silence ends one that was cut short."""
        if t_s > self._heard_s + SILENCE_S:
            self._asked = b""
        self._asked, self._heard_s = self._asked + data, t_s
        while len(self._asked) >= 6:
            code, self._asked = self._asked[0], self._asked[6:]
            if code == 0x08 and t_s < self._said_s + NEXT_S:
                continue
            if reply := self._reply(t_s, code):
                self._said_s = t_s + DELAY_S
                self.say(self._said_s, reply)

    def _reply(self, t_s: float, code: int) -> bytes:
        if code == 0x03:
            return self._reading(t_s)
        if code in self.lists:
            self._list = self.lists[code]
        elif code != 0x08 or not self._list:
            return b""
        chunk, self._list = self._list[:19], self._list[19:]
        return chunk + (b"\x08" if self._list else b"\x07")

    def _reading(self, t_s: float) -> bytes:
        field_nT = self._lab.reference_nT(np.array([t_s]))[0] * self._lab.reference_nT_per_unit
        tenths = np.round(field_nT / NT_PER_TENTH_MG)
        magnitude = round(float(np.linalg.norm(tenths)))
        places = 4 if self.gauss else 1
        blocks = [(0, round(t_s * 1000)), *((places, int(v)) for v in tenths), (places, magnitude)]
        return b"".join(_block(places, value) for places, value in blocks) + b"\x08"


def _block(places: int, value: int) -> bytes:
    return bytes([0x10, places | (0x08 if value < 0 else 0)]) + abs(value).to_bytes(4, "big")

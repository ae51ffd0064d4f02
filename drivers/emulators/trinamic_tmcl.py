"""A Trinamic TMCM-1260: direct mode, speeds in microsteps a second, no parameter 154."""

from __future__ import annotations

import math
import struct
from collections.abc import Mapping
from typing import Any

from drivers.emulators.line import Lab, Replies
from drivers.framing import tmcl

MODULE, REPLY_S, PAUSE_S, FAR_DEG = 1260 << 16 | 0x0106, 0.003, 0.1, 1e4
TARGET, POSITION, TARGET_SPEED, SPEED, MOST_SPEED, REACHED, MICROSTEPS = 0, 1, 2, 3, 4, 8, 140
READ_ONLY = {SPEED, REACHED, 9, 10, 11, 206, 207, 208}


class TmclEmulator(Replies):
    """One module with one motor; frames to other addresses are passed over, a wrong sum is told (1)."""

    baud = 9600

    def __init__(self, lab: Lab, roles: Mapping[str, Mapping[str, Any]], settings: Any) -> None:
        super().__init__()
        self._platform, self._address, self._host = lab.platform, settings.address, settings.host
        self._axis, per_turn = settings.axis, settings.microsteps_per_turn
        self._per_deg: float = per_turn / 360
        self._came, self._last_s, self._searching = b"", -math.inf, False
        ten = round(10 * self._per_deg)
        self.held: dict[int, int] = {
            TARGET: 0, MOST_SPEED: ten, 5: ten, 6: 128, 7: 8, MICROSTEPS: 8, 12: 0, 13: 0, 193: 1, 194: ten,
            195: ten // 10, 9: 0, 10: 0, 11: 0, 206: 0, 207: 0, 208: 0,
        }  # fmt: skip

    def take(self, t_s: float, data: bytes) -> None:
        """Bytes from the host; what a pause leaves unfinished is dropped."""
        self._came = data if t_s > self._last_s + PAUSE_S else self._came + data
        self._last_s = t_s
        while len(self._came) >= tmcl.SIZE:
            frame, self._came = self._came[: tmcl.SIZE], self._came[tmcl.SIZE :]
            if frame[0] == self._address:
                self._answer(t_s, frame)

    def _answer(self, t_s: float, frame: bytes) -> None:
        _, command, kind, axis, value = struct.unpack(tmcl.FORM, frame[:-1])
        if sum(frame[:-1]) & 0xFF != frame[-1]:
            status, held = tmcl.WRONG_CHECKSUM, 0
        elif command in (136, 10):  # of the module, not of an axis
            status, held = self._of_module(command, kind)
        elif axis != self._axis:
            status, held = tmcl.INVALID_VALUE, 0
        else:
            status, held = self._do(t_s, command, kind, value)
        if (command, kind) == (136, 0):
            self.say(t_s + REPLY_S, bytes([self._host]) + b"1260V106")
        else:
            self.say(t_s + REPLY_S, tmcl.summed(self._host, self._address, status, command, held))

    def _of_module(self, command: int, kind: int) -> tuple[int, int]:
        known = {(136, 0): 0, (136, 1): MODULE, (10, 65): 0, (10, 66): self._address, (10, 76): self._host}
        return (tmcl.FINE, known[command, kind]) if (command, kind) in known else (tmcl.WRONG_TYPE, 0)

    def _do(self, t_s: float, command: int, kind: int, value: int) -> tuple[int, int]:
        """Status and value of the reply."""
        match command, kind:
            case ((1 | 2), _):
                self._searching = False
                self._platform.move(t_s, FAR_DEG if command == 1 else -FAR_DEG, abs(value) / self._per_deg)
            case 3, _:
                self._searching = False
                self._platform.stop(t_s)
            case 4, (0 | 1):
                value = self.held[TARGET] = value + (self._position(t_s) if kind else 0)
                self._searching = False
                self._platform.move(t_s, value / self._per_deg, self.held[MOST_SPEED] / self._per_deg)
            case 5, _:
                return self._set(kind, value), value
            case 6, _:
                return self._get(t_s, kind)
            case 13, (0 | 1 | 2):
                return tmcl.FINE, self._search(t_s, kind)
            case ((4 | 13), _):
                return tmcl.WRONG_TYPE, value
            case _:
                return tmcl.INVALID_COMMAND, value
        return tmcl.FINE, value

    def _search(self, t_s: float, kind: int) -> int:
        if kind == 0:
            self._searching, self.held[TARGET] = True, 0
            self._platform.move(t_s, 0.0, self.held[194] / self._per_deg)
        elif kind == 1 and self._searching:
            self._searching = False
            self._platform.stop(t_s)
        return int(kind == 2 and self._seeks(t_s))

    def _seeks(self, t_s: float) -> bool:
        self._searching = self._searching and self._platform.moving(t_s)
        return self._searching

    def _set(self, kind: int, value: int) -> int:
        if kind not in self.held or kind in READ_ONLY:
            return tmcl.WRONG_TYPE
        if value < 0 or kind == TARGET:
            return tmcl.INVALID_VALUE
        self.held[kind] = value
        return tmcl.FINE

    def _get(self, t_s: float, kind: int) -> tuple[int, int]:
        rests = not self._platform.moving(t_s)
        speed = round(float(self._platform.now(t_s)[1]) * self._per_deg)
        known = self.held | {
            POSITION: self._position(t_s), SPEED: 0 if rests else speed or 1, TARGET_SPEED: speed,
            REACHED: int(rests and self._position(t_s) == self.held[TARGET]),
        }  # fmt: skip
        if kind == 207:  # told once
            self.held[207] = 0
        return (tmcl.FINE, known[kind]) if kind in known else (tmcl.WRONG_TYPE, 0)

    def _position(self, t_s: float) -> int:
        return round(float(self._platform.now(t_s)[0] * self._per_deg))

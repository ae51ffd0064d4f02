"""A Thorlabs K10CR1: the stage's own side of the APT protocol, with what it tells unasked when it comes to rest."""

from __future__ import annotations

import math
import struct
from collections.abc import Mapping
from typing import Any

from drivers.emulators.line import Lab, Pieces, Replies
from drivers.framing import apt

COUNTS_PER_DEG, VELOCITY = 409_600 / 3, 53.68
HOMED, CONNECTED, HOMING, FORWARD, BACKWARD, ENABLED = 0x400, 0x100, 0x200, 0x10, 0x20, 0x80000000
REPLY_S, PAUSE_S, FAR_DEG, ACCELERATION = 0.002, 0.1, 1e4, 15_020
RELATIVE, UPDATE, UPDATES_S = 0x0448, 0x0481, 0.1
LONG = {apt.SET_VELOCITY: "<Hiii", apt.SET_HOMING: "<HHHii", apt.MOVE_ABSOLUTE: "<Hi", RELATIVE: "<Hi", 0x043A: "<Hi"}


class AptEmulator(Replies):
    """One motor. It answers what it knows, and nothing to what it does not.

    A move may be told by its number alone: then it goes where it was told last.
    """

    baud = 115200

    def __init__(self, lab: Lab, roles: Mapping[str, Mapping[str, Any]], settings: Any) -> None:
        super().__init__()
        self._platform, self._came, self._ends = lab.platform, b"", 0
        self._last_s, self._update_s = -math.inf, math.inf
        self._counts = settings.counts_per_deg or COUNTS_PER_DEG
        self.homed, self.enabled, self.faults, self._backlash = False, False, 0, 0
        per_s = self._counts * VELOCITY
        self._velocity = (0, ACCELERATION, round(10 * per_s))
        self._homing, self._last = (
            (2, 1, round(10 * per_s), round(4 * self._counts)),
            {apt.MOVE_ABSOLUTE: 0, RELATIVE: 0},
        )

    def take(self, t_s: float, data: bytes) -> None:
        """Bytes from the host, whole messages or parts; what a pause leaves unfinished is dropped."""
        self._came = data if t_s > self._last_s + PAUSE_S else self._came + data
        self._last_s = t_s
        while len(self._came) >= apt.HEAD:
            number, length, to, _ = struct.unpack("<HHBB", self._came[: apt.HEAD])
            behind = length if to & apt.WITH_DATA else 0
            if len(self._came) < apt.HEAD + behind:
                return
            came, self._came = self._came[apt.HEAD : apt.HEAD + behind], self._came[apt.HEAD + behind :]
            if to & ~apt.WITH_DATA == apt.USB:
                self._do(t_s, number, came, length >> 8)

    def due_s(self) -> float:
        """When it says something next: an answer, how it stands, or that it has come to rest."""
        return min(super().due_s(), self._rests_s(), self._update_s)

    def emit(self, until_s: float) -> Pieces:
        """Answers, how it stands ten times a second where that was asked for, and that a move is over."""
        pieces = super().emit(until_s)
        while self._update_s <= until_s:
            pieces.append((self._update_s, self._message(UPDATE, self._status(self._update_s))))
            self._update_s += UPDATES_S
        if (rests_s := self._rests_s()) <= until_s:
            number, self._ends = self._ends, 0
            self.homed |= number == apt.HOMED
            pieces.append((rests_s, self._message(number, b"" if number == apt.HOMED else self._status(rests_s))))
        return sorted(pieces, key=lambda piece: piece[0])

    def _rests_s(self) -> float:
        return float(self._platform.pieces[-1][0]) if self._ends else math.inf

    def _do(self, t_s: float, number: int, came: bytes, second: int) -> None:
        if number in LONG and came and len(came) != struct.calcsize(LONG[number]):
            return
        values = struct.unpack(LONG[number], came)[1:] if came and number in LONG else ()
        match number, values:
            case apt.SET_VELOCITY, (least, ramp, most):
                self._velocity = (least, ramp, most)
            case apt.SET_HOMING, (way, switch, velocity, offset):
                self._homing = (way, switch, velocity, offset)
            case 0x043A, (backlash,):
                self._backlash = backlash
            case apt.SET_ENABLED, ():
                self.enabled = second == 1
            case apt.HOME, ():
                self.homed = False
                self._begin(t_s, 0.0, self._homing[2], apt.HOMED)
            case ((apt.MOVE_ABSOLUTE | 0x0448), _):
                self._last[number] = values[0] if values else self._last[number]
                here = self._position(t_s) if number == RELATIVE else 0
                self._begin(t_s, (here + self._last[number]) / self._counts, self._velocity[2], apt.COMPLETED)
            case 0x0457, ():
                self._begin(t_s, FAR_DEG if second == 1 else -FAR_DEG, self._velocity[2], apt.COMPLETED)
            case ((apt.START_UPDATES | apt.STOP_UPDATES), ()):
                self._update_s = t_s + UPDATES_S if number == apt.START_UPDATES else math.inf
            case apt.STOP, ():
                self._platform.stop(t_s)
                self._ends = apt.STOPPED
            case _:
                if said := self._answer(t_s, number):
                    self.say(t_s + REPLY_S, said)

    def _answer(self, t_s: float, number: int) -> bytes:
        match number:
            case apt.REQ_INFO:
                who = struct.pack("<I8sH4B60s3H", 55_000_042, b"K10CR1", 16, 3, 0, 1, 0, b"rotation stage", 1, 3, 1)
                return self._message(apt.GET_INFO, who)
            case apt.REQ_POSITION | 0x040A:
                return self._message(number + 1, struct.pack("<Hi", 1, self._position(t_s)))
            case apt.REQ_VELOCITY:
                return self._message(apt.GET_VELOCITY, struct.pack("<Hiii", 1, *self._velocity))
            case 0x043B:
                return self._message(number + 1, struct.pack("<Hi", 1, self._backlash))
            case apt.REQ_HOMING:
                return self._message(apt.GET_HOMING, struct.pack("<HHHii", 1, *self._homing))
            case apt.REQ_BITS:
                return self._message(apt.GET_BITS, struct.pack("<HI", 1, self._bits(t_s)))
            case 0x0480 | 0x0490:
                return self._message(number + 1, self._status(t_s))
            case 0x0211:
                return apt.short(0x0212, 1, 1 if self.enabled else 2, to=apt.HOST, source=apt.USB)
        return b""

    def _begin(self, t_s: float, to_deg: float, velocity: int, ends: int) -> None:
        self._platform.move(t_s, to_deg, velocity / VELOCITY / self._counts)
        self._ends = ends

    def _message(self, number: int, data: bytes) -> bytes:
        if number == apt.HOMED:
            return apt.short(number, 1, to=apt.HOST, source=apt.USB)
        return apt.long(number, data, to=apt.HOST, source=apt.USB)

    def _status(self, t_s: float) -> bytes:
        return struct.pack("<HiiI", 1, self._position(t_s), 0, self._bits(t_s))

    def _position(self, t_s: float) -> int:
        return round(float(self._platform.now(t_s)[0]) * self._counts)

    def _bits(self, t_s: float) -> int:
        bits = CONNECTED | self.faults | (HOMED if self.homed else 0) | (ENABLED if self.enabled else 0)
        if self._platform.moving(t_s):
            homing = HOMING if self._ends == apt.HOMED else 0
            bits |= homing | (FORWARD if self._platform.now(t_s)[1] >= 0 else BACKWARD)
        return bits

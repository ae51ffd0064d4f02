"""A Standa 8SMC5 with an 8MR190-2-28: commands of four letters, answers with a CRC, a count that homing leaves."""

from __future__ import annotations

import math
import struct
from collections.abc import Mapping
from typing import Any

from drivers.emulators.line import Lab, Replies
from drivers.framing import ximc

REPLY_S, PAUSE_S, FAR_DEG = 0.002, 0.4, 1e4
DIVISION, MODE, STEPPER = 256, 9, (3, 2)  # a stepper on the controller's own driver
MOVE, MOVR, LEFT, RIGHT, STOP, HOME, SOFT = 1, 2, 3, 4, 5, 6, 8  # names of commands in the state
RUNNING, ERROR, MOVING, AT_SPEED, HOMED, ERRC, ERRD = 0x80, 0x40, 0x01, 0x02, 0x20, 0x01, 0x02
SIZES = {"smov": 24, "shom": 27, "move": 12, "movr": 12}  # of data from the host, without CRC
POWERED = 3  # its motor, as always while it holds or moves
SWITCH_DEG = 3.0  # what it counts at its switch after power-up


class StandaEmulator(Replies):
    """Zeros between commands are answered by a zero each, so that a host finds the beginning of one."""

    baud = 115200

    def __init__(self, lab: Lab, roles: Mapping[str, Mapping[str, Any]], settings: Any) -> None:
        super().__init__()
        self._platform, per_turn = lab.platform, settings.steps_per_turn
        self._per_deg: float = per_turn / 360
        self._came, self._last_s = b"", -math.inf
        self._count_deg, self._command, self._homed, self._wrong = SWITCH_DEG, 0, False, 0
        self.flags = 0
        ten = round(10 * self._per_deg)
        self.held: dict[str, tuple[int, ...]] = {
            "gmov": (ten, 0, ten, ten, ten // 10, 0, 0), "ghom": (ten, 0, ten // 10, 0, 0, 0, 0x172),
            "geng": (0, 670, 4 * ten, 0, 0xA4, 1800, MODE, 200), "gent": STEPPER,
        }  # fmt: skip

    def take(self, t_s: float, data: bytes) -> None:
        """Bytes from the host; what a pause leaves unfinished is dropped."""
        self._came = data if t_s > self._last_s + PAUSE_S else self._came + data
        self._last_s = t_s
        while self._came:
            if self._came[:1] == b"\0":
                self._came = self._came[1:]
                self.say(t_s + REPLY_S, b"\0")
                continue
            name = self._came[: ximc.NAME].decode("latin-1")
            size = ximc.NAME + (SIZES[name] + ximc.CRC if name in SIZES else 0)
            if len(self._came) < size:
                return
            came, self._came = self._came[ximc.NAME : size], self._came[size:]
            self.say(t_s + REPLY_S, self._answer(t_s, name, came))

    def _answer(self, t_s: float, name: str, came: bytes) -> bytes:
        if ximc.packed(came[: -ximc.CRC]) != came:
            self._wrong |= ERRD
            return b"errd"
        values = struct.unpack(ximc.TELLS[name], came[: -ximc.CRC]) if came else ()
        if name in ximc.ANSWERS:
            said = struct.pack(ximc.ANSWERS[name], *self._asked(t_s, name))
            return name.encode() + ximc.packed(said)
        if not self._do(t_s, name, values):
            self._wrong |= ERRC
            return b"errc"
        return name.encode()

    def _asked(self, t_s: float, name: str) -> tuple[Any, ...]:
        if name == "geti":
            return b"XIMC", b"SM", b"8SMC5-US", 2, 3, 4
        if name == "gser":
            return (17_342,)
        if name in self.held:
            return self.held[name]
        angle, rate = (float(value) for value in self._platform.now(t_s))
        place = self._steps(angle + self._count_deg)
        if name == "gpos":
            return *place, 0
        motion, command, flags = self._state(t_s)
        flags, self._wrong = flags | self._wrong, 0
        return motion, command, POWERED, 0, 0, *place, 0, *self._steps(rate), 0, 2400, 0, 500, 250, flags, 0, 8

    def _state(self, t_s: float) -> tuple[int, int, int]:
        moving = bool(self._platform.moving(t_s))
        if self._command == HOME and not moving:
            self._homed = True
        return MOVING * moving, self._command | RUNNING * moving, self.flags | HOMED * self._homed

    def _do(self, t_s: float, name: str, values: tuple[int, ...]) -> bool:
        """Whether it knows the command."""
        self._state(t_s)
        match name:
            case "smov" | "shom":
                self.held["g" + name[1:]] = values
            case "zero":
                self._count_deg = -float(self._platform.now(t_s)[0])
            case "move" | "movr":
                here = self._angle(*self._steps(float(self._platform.now(t_s)[0]) + self._count_deg))
                to_deg = self._angle(*values) + (here if name == "movr" else 0.0)
                self._begin(t_s, to_deg - self._count_deg, MOVE if name == "move" else MOVR, self.held["gmov"])
            case "home":
                self._homed = False
                self._begin(t_s, 0.0, HOME, self.held["ghom"])
            case "left" | "rigt":
                far = FAR_DEG if name == "rigt" else -FAR_DEG
                self._begin(t_s, far, RIGHT if name == "rigt" else LEFT, self.held["gmov"])
            case "stop" | "sstp":
                self._platform.stop(t_s)
                self._command = STOP if name == "stop" else SOFT
            case _:
                return False
        return True

    def _begin(self, t_s: float, to_deg: float, command: int, speed: tuple[int, ...]) -> None:
        self._command = command
        self._platform.move(t_s, to_deg, self._angle(*speed[:2]))

    def _angle(self, steps: int, parts: int) -> float:
        return (steps + parts / DIVISION) / self._per_deg

    def _steps(self, deg: float) -> tuple[int, int]:
        parts = round(deg * self._per_deg * DIVISION)
        steps, rest = divmod(abs(parts), DIVISION)
        return (steps, rest) if parts >= 0 else (-steps, -rest)

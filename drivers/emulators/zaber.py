"""A Zaber X-RSW60A: the stage's own side of the ASCII protocol."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import Any

from drivers.emulators.line import Answers, Lab
from drivers.framing.zaber import SPEED_DATA, checksum

REQUEST = re.compile(r"/((?:(\d+)(?: (\d+)(?: (\d\d|--))?)?)?\s*([^:]*))(?::([0-9A-F]{2}))?", re.ASCII)
STEPS = re.compile(r"-?\d{1,9}", re.ASCII)
STEPS_PER_TURN, FAR_DEG = 1_536_000, 1e6
FLAGS = ("FD", "FQ", "FS", "FT", "FB", "FP", "FE", "WH", "WR", "NC", "NI")  # the first that is up stands in replies
CLEARED_BY_A_MOVEMENT, ACKNOWLEDGED = {"NC", "NI"}, {"FS", "FT", "FB", "FE"}


class ZaberEmulator(Answers):
    """Moves the twin's turntable; its reference position is known once it has come home.

    A message ends with CR, LF or both, and may leave out message id, axis and address; 0 is for all.
    `written`: how often `maxspeed`, which older firmware keeps in memory that wears, was set.
    """

    def __init__(self, lab: Lab, roles: Mapping[str, Mapping[str, Any]], settings: Any) -> None:
        super().__init__(self._reply, delay_s=0.003)
        self._platform, self._address, self.written = lab.platform, settings.address, 0
        self._flags, self._homing = {"WR"}, False
        self.held = {
            "deviceid": "50117",
            "system.serial": "98765",
            "system.axiscount": "1",
            "version": "7.38",
            "comm.alert": "0",
            "comm.checksum": "1",
            "resolution": "64",
            "limit.min": "-1536000000",
            "limit.max": "1536000000",
            "limit.cycle.dist": str(STEPS_PER_TURN),
            "maxspeed": str(round(20 * STEPS_PER_TURN / 360 * SPEED_DATA)),
        }

    def take(self, t_s: float, data: bytes) -> None:
        """CR alone ends a message as well."""
        super().take(t_s, data.replace(b"\r", b"\n"))

    def turn_knob(self, t_s: float, to_deg: float) -> None:
        """Somebody turns it by hand."""
        self._flags |= {"NC"} | ({"NI"} if self._platform.moving(t_s) else set())
        self._platform.move(t_s, to_deg, self._rate)

    def stall(self, t_s: float) -> None:
        """Something holds it fast: it stops, and does not know where it is."""
        self._platform.stop(t_s)
        self._flags |= {"FS", "WR"}
        self._homing = False

    def _reply(self, t_s: float, text: str) -> bytes:
        found = REQUEST.fullmatch(text)
        if found is None or int(found[2] or 0) not in (0, self._address):
            return b""
        if found[6] not in (None, checksum(found[1].encode())):
            return b""
        self._come_home(t_s)
        flag, data = self._do(t_s, found[5].split())
        self._come_home(t_s)
        state, warning = "BUSY" if self._platform.moving(t_s) else "IDLE", (*self._up(), "--")[0]
        number = "" if found[4] in (None, "--") else f" {found[4]}"
        body = f"{self._address:02d} {int(found[3] or 0)}{number} {flag} {state} {warning} {data}"
        return f"@{body}:{checksum(body.encode())}\r\n".encode()

    def _up(self) -> list[str]:
        return [flag for flag in FLAGS if flag in self._flags]

    def _come_home(self, t_s: float) -> None:
        if self._homing and not self._platform.moving(t_s):
            self._homing = False
            self._flags -= {"WR", "WH"}

    def _do(self, t_s: float, words: list[str]) -> tuple[str, str]:
        match words:
            case ["get", "pos" | "encoder.pos"]:
                return "OK", str(self._steps(t_s))
            case ["warnings", *clear] if clear in ([], ["clear"]):
                flags = self._up()
                self._flags -= ACKNOWLEDGED if clear else set()
                return "OK", " ".join([f"{len(flags):02d}", *flags])
            case ["home"]:
                self._homing = True
                self._begin(t_s, 0.0)
            case ["stop" | "estop"]:
                self._flags |= {"NI"} if self._platform.moving(t_s) else set()
                self._homing = False
                self._platform.stop(t_s)
            case ["move", "abs" | "rel" as how, steps, *speed]:
                return self._move(t_s, steps, self._steps(t_s) if how == "rel" else 0, speed)
            case ["move", "vel", speed] if STEPS.fullmatch(speed):
                self._begin(t_s, FAR_DEG if int(speed) > 0 else -FAR_DEG, abs(int(speed)))
            case ["get", name] if name in self.held:
                return "OK", self.held[name]
            case ["set", "maxspeed", value]:
                if not (value.isdigit() and int(value)):
                    return "RJ", "BADDATA"
                self.held["maxspeed"] = value
                self.written += 1
            case []:
                pass
            case _:
                return "RJ", "BADCOMMAND"
        return "OK", "0"

    def _move(self, t_s: float, steps: str, origin: int, speed: list[str]) -> tuple[str, str]:
        """A move states its own speed from firmware 7.25 on."""
        if len(speed) > (self._firmware >= (7, 25)):
            return "RJ", "BADCOMMAND"
        if (
            "WR" in self._flags
            or not all(map(STEPS.fullmatch, (steps, *speed)))
            or int(speed[0] if speed else "1") <= 0
        ):
            return "RJ", "BADDATA"
        self._begin(t_s, (origin + int(steps)) * 360 / STEPS_PER_TURN, *map(int, speed))
        return "OK", "0"

    def _begin(self, t_s: float, to_deg: float, speed: int = 0) -> None:
        cut_short = self._platform.moving(t_s)
        self._flags -= CLEARED_BY_A_MOVEMENT
        self._flags |= {"NI"} if cut_short else set()
        self._platform.move(t_s, to_deg, _rate(speed) if speed else self._rate)

    def _steps(self, t_s: float) -> int:
        return round(float(self._platform.now(t_s)[0]) / 360 * STEPS_PER_TURN)

    @property
    def _firmware(self) -> tuple[int, ...]:
        return tuple(map(int, self.held["version"].split(".")))

    @property
    def _rate(self) -> float:
        return _rate(int(self.held["maxspeed"]))


def _rate(speed: int) -> float:
    return speed / SPEED_DATA * 360 / STEPS_PER_TURN

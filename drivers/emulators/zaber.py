"""A Zaber X-RSW60A: the stage's own side of the ASCII protocol."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import Any

from drivers.emulators.line import Answers, Lab

REQUEST = re.compile(r"/(\d+) (\d+) (\d\d) ?(.*)")
STEPS_PER_TURN = 1_536_000
SPEED_DATA = 1.6384  # of `maxspeed`, per microstep/s


class ZaberEmulator(Answers):
    """Moves the twin's turntable; `home` clears the flag that the reference position is not known."""

    def __init__(self, lab: Lab, roles: Mapping[str, Mapping[str, Any]], settings: Any) -> None:
        super().__init__(self._reply, end=b"\r\n", delay_s=0.003)
        self._platform, self._homed, self._sign = lab.platform, False, 1
        self._settings = {
            "deviceid": "50117",
            "system.serial": "98765",
            "version": "7.38",
            "limit.cycle.dist": str(STEPS_PER_TURN),
            "maxspeed": str(round(20 * STEPS_PER_TURN / 360 * SPEED_DATA)),
        }

    def _reply(self, t_s: float, text: str) -> bytes:
        if (found := REQUEST.fullmatch(text)) is None:
            return b""
        address, axis, number, words = found.groups()
        flag, data = self._do(t_s, words)
        state = "BUSY" if self._platform.moving(t_s) else "IDLE"
        body = f"{int(address):02d} {axis} {number} {flag} {state} {'--' if self._homed else 'WR'} {data}"
        return f"@{body}:{-sum(body.encode()) & 0xFF:02X}\r\n".encode()

    def _do(self, t_s: float, words: str) -> tuple[str, str]:
        match words.split():
            case ["get", "pos"]:
                return "OK", str(round(self._platform.now(t_s)[0] / 360 * STEPS_PER_TURN))
            case []:
                return "OK", "0"
            case ["home"]:
                self._homed = True
                self._platform.move(t_s, 0.0, self._rate)
            case ["stop"]:
                self._platform.stop(t_s)
            case ["move", "abs", steps] if self._homed:
                self._platform.move(t_s, int(steps) * 360 / STEPS_PER_TURN, self._rate)
            case ["get", name] if name in self._settings:
                return "OK", self._settings[name]
            case ["set", "maxspeed", value]:
                self._settings["maxspeed"] = value
            case ["move", *_]:
                return "RJ", "BADDATA"
            case _:
                return "RJ", "BADCOMMAND"
        return "OK", "0"

    @property
    def _rate(self) -> float:
        return int(self._settings["maxspeed"]) / SPEED_DATA * 360 / STEPS_PER_TURN

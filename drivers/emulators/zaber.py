"""A Zaber X-RSW60A: the stage's own side of the ASCII protocol."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import Any

from drivers.emulators.line import Answers, Lab
from drivers.framing.zaber import SPEED_DATA, checksum

REQUEST = re.compile(r"/((?:(\d+)(?: (\d+)(?: (\d\d|--))?)?)?\s*([^:]*))(?::([0-9A-F]{2}))?", re.ASCII)
STEPS_PER_TURN = 1_536_000


class ZaberEmulator(Answers):
    """Moves the twin's turntable; `home` clears the flag that the reference position is not known.

    A message ends with CR, LF or both, and may leave out message id, axis and address; 0 is for all.
    """

    def __init__(self, lab: Lab, roles: Mapping[str, Mapping[str, Any]], settings: Any) -> None:
        super().__init__(self._reply, delay_s=0.003)
        self._platform, self._address, self._homed = lab.platform, settings.address, False
        self._settings = {
            "deviceid": "50117",
            "system.serial": "98765",
            "version": "7.38",
            "comm.alert": "0",
            "comm.checksum": "1",
            "resolution": "64",
            "limit.cycle.dist": str(STEPS_PER_TURN),
            "maxspeed": str(round(20 * STEPS_PER_TURN / 360 * SPEED_DATA)),
        }

    def take(self, t_s: float, data: bytes) -> None:
        """CR alone ends a message as well."""
        super().take(t_s, data.replace(b"\r", b"\n"))

    def _reply(self, t_s: float, text: str) -> bytes:
        found = REQUEST.fullmatch(text)
        if found is None or int(found[2] or 0) not in (0, self._address):
            return b""
        if found[6] not in (None, checksum(found[1].encode())):
            return b""
        flag, data = self._do(t_s, found[5].split())
        state, warning = "BUSY" if self._platform.moving(t_s) else "IDLE", "--" if self._homed else "WR"
        number = "" if found[4] in (None, "--") else f" {found[4]}"
        body = f"{self._address:02d} {int(found[3] or 0)}{number} {flag} {state} {warning} {data}"
        return f"@{body}:{checksum(body.encode())}\r\n".encode()

    def _do(self, t_s: float, words: list[str]) -> tuple[str, str]:
        match words:
            case ["get", "pos" | "encoder.pos"]:
                return "OK", str(self._steps(t_s))
            case [] | ["warnings"]:
                return "OK", "0" if not words else "00" if self._homed else "01 WR"
            case ["home"]:
                self._homed = True
                self._platform.move(t_s, 0.0, self._rate)
            case ["stop" | "estop"]:
                self._platform.stop(t_s)
            case ["move", "abs" | "rel" as how, steps]:
                return self._move(t_s, steps, self._steps(t_s) if how == "rel" else 0)
            case ["get", name] if name in self._settings:
                return "OK", self._settings[name]
            case ["set", "maxspeed", value]:
                if not (value.isdigit() and int(value)):
                    return "RJ", "BADDATA"
                self._settings["maxspeed"] = value
            case _:
                return "RJ", "BADCOMMAND"
        return "OK", "0"

    def _move(self, t_s: float, steps: str, origin: int) -> tuple[str, str]:
        if not self._homed or not re.fullmatch(r"-?\d{1,9}", steps):
            return "RJ", "BADDATA"
        self._platform.move(t_s, (origin + int(steps)) * 360 / STEPS_PER_TURN, self._rate)
        return "OK", "0"

    def _steps(self, t_s: float) -> int:
        return round(float(self._platform.now(t_s)[0]) / 360 * STEPS_PER_TURN)

    @property
    def _rate(self) -> float:
        return int(self._settings["maxspeed"]) / SPEED_DATA * 360 / STEPS_PER_TURN

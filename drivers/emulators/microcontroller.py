"""A board with three H-bridges that speaks labcal-coil/1: what the firmware in examples/microcontroller does."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from drivers.emulators.line import Answers, Lab
from drivers.framing.coil_line import crc8

REQUEST = re.compile(r"(\d{1,3}) ([^*]*)\*([0-9A-F]{2})", re.ASCII)
CHANNEL, NUMBER, LONGEST = re.compile("[0-9]"), re.compile("-?[0-9]{1,9}"), 48
ARGUMENTS = {"WHO": 0, "BEAT": 0, "SET?": 1, "MEAS?": 1, "OUT?": 1, "TRIP?": 1, "SET": 2, "OUT": 2}
CHANNELS, MICRO, SUPPLY_V = 3, 1_000_000, 24.0
LIMIT = {"uA": 3 * MICRO, "ppm": MICRO}


@dataclass
class Channel:
    """One bridge and the coil behind it, where one is wired; `value` in µA or millionths of the duty."""

    coil: Any = None
    value: int = 0
    on: bool = False
    tripped: bool = False


class CoilBoardEmulator(Answers):
    """Says nothing to a line that is cut, too long or wrong; falls to zero and open after its own time of silence."""

    baud = 115_200

    def __init__(self, lab: Lab, roles: Mapping[str, Mapping[str, Any]], settings: Any) -> None:
        super().__init__(self._line, delay_s=0.002)
        alone = settings.channel if len(roles) == 1 else 1
        self.channels = {number: Channel() for number in range(1, CHANNELS + 1)}
        for role, stated in roles.items():
            self.channels[int(stated.get("channel", alone))].coil = lab.coils[role[-1]]
        self._full_A, self._unit = settings.full_scale_A or 1.0, "ppm" if settings.full_scale_A else "uA"
        self._watchdog_s, self._sense, self._ends_s = settings.watchdog_s, not settings.unsensed, math.inf
        self._left_ms, self._number = 0, 1 + min("xyz".index(role[-1]) for role in roles)

    def _line(self, t_s: float, text: str) -> bytes:
        found = REQUEST.fullmatch(text)
        if found is None or len(text) > LONGEST or crc8(text.rpartition("*")[0].encode()) != int(found[3], 16):
            return b""
        self._hear(t_s)
        why, words = self._obey(t_s, *found[2].split(" "))
        said = f"{int(found[1])} {'ERR' if why else 'OK'} {why or words}"
        return f"{said}*{crc8(said.encode()):02X}\n".encode()

    def _hear(self, t_s: float) -> None:
        """A whole, valid line: the watchdog's time begins anew, unless it is over."""
        self._left_ms = max(0, round(1000 * (self._ends_s - t_s))) if self._ends_s < math.inf else 0
        if t_s > self._ends_s:
            for channel in self.channels.values():
                channel.tripped = channel.tripped or channel.on
                channel.value, channel.on = 0, False
                self._drive(t_s, channel)
        self._ends_s = t_s + self._watchdog_s if self._watchdog_s else math.inf
        for channel in self.channels.values():
            if channel.coil is not None:
                channel.coil.close(t_s, "watchdog", self._ends_s)

    def _obey(self, t_s: float, word: str, *rest: str) -> tuple[str, str]:
        """Why it refuses, or what it answers."""
        if word not in ARGUMENTS:
            return "word", ""
        known = [form.fullmatch(text) for form, text in zip((CHANNEL, NUMBER), rest, strict=False)]
        if len(rest) != ARGUMENTS[word] or not all(known):
            return "number", ""
        if not rest:
            return self._of_all(word)
        if int(rest[0]) not in self.channels:
            return "channel", ""
        bridge = self.channels[int(rest[0])]
        return self._execute(t_s, bridge, word, int(rest[1])) if len(rest) > 1 else self._state_reply(t_s, bridge, word)

    def _of_all(self, word: str) -> tuple[str, str]:
        if word == "BEAT":
            return ("watchdog", "") if any(c.tripped for c in self.channels.values()) else ("", f"{self._left_ms}")
        facts = (
            f"channels={CHANNELS} unit={self._unit} limit={LIMIT[self._unit]} "
            f"watchdog_ms={round(1000 * self._watchdog_s)} sense={self._sense:d}"
        )
        return "", f"labcal-coil/1 labcal emulated-board {self._number:04d} 1.0 {facts}"

    def _state_reply(self, t_s: float, bridge: Channel, word: str) -> tuple[str, str]:
        match word:
            case "SET?":
                return "", f"{bridge.value}"
            case "OUT?":
                return "", f"{bridge.on:d}"
            case "TRIP?":
                return "", "watchdog" if bridge.tripped else "none"
        flows_A = bridge.coil.current.now(t_s) if bridge.coil is not None else 0.0
        return "", f"{round(MICRO * flows_A) if self._sense else bridge.value}"

    def _execute(self, t_s: float, bridge: Channel, word: str, value: int) -> tuple[str, str]:
        if word == "OUT":
            if value not in (0, 1):
                return "number", ""
            bridge.on, bridge.tripped = value == 1, bridge.tripped and value == 0
            bridge.value *= bridge.on
        elif abs(value) > LIMIT[self._unit]:
            return "range", ""
        elif value and not bridge.on:
            return "watchdog" if bridge.tripped else "off", ""
        else:
            bridge.value = value
        self._drive(t_s, bridge)
        return "", f"{value}"

    def _drive(self, t_s: float, bridge: Channel) -> None:
        if bridge.coil is not None:
            scale = self._full_A if self._unit == "ppm" else 1.0
            bridge.coil.drive(t_s, bridge.value * scale / MICRO, SUPPLY_V, bridge.on)

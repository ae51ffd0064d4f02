"""A Rigol DP832: three channels on one line."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from drivers.emulators.line import Answers, Lab

SOURCE = re.compile(r":?SOUR(?:CE)?(\d):(VOLT|CURR)(?:AGE|ENT)?(\?| [\d.]+)", re.IGNORECASE)
OUTPUT = re.compile(r":?OUTP(?:UT)?(\?)? CH(\d)(?:,(ON|OFF))?", re.IGNORECASE)
MEASURE = re.compile(r":?MEAS(?:URE)?:(VOLT|CURR|ALL)(?:AGE|ENT)?\? CH(\d)", re.IGNORECASE)
MODE = re.compile(r":?OUTP(?:UT)?:MODE\? CH(\d)", re.IGNORECASE)
MAX = {"VOLT": 32.0, "CURR": 3.2}


@dataclass
class Channel:
    """One channel and the coil behind it."""

    coil: Any
    VOLT: float = 0.0
    CURR: float = 0.0
    on: bool = False
    limited: bool = False


class RigolEmulator(Answers):
    """Accepts long and short words with or without the first colon; a bad command is queued and not answered."""

    wire = "tcp"

    def __init__(self, lab: Lab, roles: Mapping[str, Mapping[str, Any]], settings: Any) -> None:
        super().__init__(self._reply, delay_s=0.01)
        self._channels = {int(s.get("channel", 1)): Channel(lab.coils[role[-1]]) for role, s in roles.items()}
        self._errors: list[str] = []

    def _reply(self, t_s: float, text: str) -> bytes:
        try:
            said = self._do(t_s, text)
        except KeyError:
            said = self._fault('-222,"Data out of range"')
        return said.encode() + b"\n" if said else b""

    def _do(self, t_s: float, text: str) -> str:
        if text.upper() == "*IDN?":
            return "RIGOL TECHNOLOGIES,DP832,DP8A000001,00.01.16"
        if text.upper() in (":SYST:ERR?", "SYST:ERR?"):
            return self._errors.pop(0) if self._errors else '0,"No error"'
        if found := SOURCE.fullmatch(text):
            return self._source(t_s, self._channels[int(found[1])], found[2].upper(), found[3].strip())
        if found := OUTPUT.fullmatch(text):
            return self._output(t_s, self._channels[int(found[2])], found[1], found[3])
        if found := MEASURE.fullmatch(text):
            return self._measure(t_s, self._channels[int(found[2])], found[1].upper())
        if found := MODE.fullmatch(text):
            return "CV" if self._channels[int(found[1])].limited else "CC"
        return self._fault('-113,"Undefined header"')

    def _source(self, t_s: float, channel: Channel, what: str, value: str) -> str:
        if value == "?":
            return f"{getattr(channel, what):.3f}"
        if float(value) > MAX[what]:
            return self._fault('-222,"Data out of range"')
        setattr(channel, what, round(float(value), 3))
        return self._act(t_s, channel)

    def _output(self, t_s: float, channel: Channel, asked: str | None, to: str | None) -> str:
        if asked:
            return "ON" if channel.on else "OFF"
        channel.on = (to or "").upper() == "ON"
        return self._act(t_s, channel)

    def _measure(self, t_s: float, channel: Channel, what: str) -> str:
        current = channel.coil.current.now(t_s)
        voltage = current * channel.coil.resistance_ohm
        values = {"CURR": [current], "VOLT": [voltage], "ALL": [voltage, current, voltage * current]}[what]
        return ",".join(f"{value:.4f}" if what == "CURR" else f"{value:.3f}" for value in values)

    def _act(self, t_s: float, channel: Channel) -> str:
        channel.limited = channel.coil.drive(t_s, channel.CURR, channel.VOLT, channel.on)
        return ""

    def _fault(self, text: str) -> str:
        self._errors.append(text)
        return ""

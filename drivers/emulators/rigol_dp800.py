"""A Rigol DP832: three channels on one line."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from drivers.emulators.line import Answers, Lab
from drivers.emulators.scpi import RANGE, Messages

NUMBER = r"\d+\.?\d*|\.\d+"
SOURCE = re.compile(rf"(?:SOUR(\d):)?(VOLT|CURR)(\?| (?:{NUMBER}))")
APPLY = re.compile(rf"APPL(?:(\?)(?: CH(\d))?| CH(\d),({NUMBER}),({NUMBER}))")
TRIP = re.compile(rf"OUTP:(OVP|OCP)(?::(VAL|QUES|CLE))?(\?)?(?: CH(\d))?(?:[ ,](ON|OFF|{NUMBER}))?")
ISUM = re.compile(r"STAT:QUES:INST:ISUM(\d):COND\?")
PANEL = re.compile(r"SYST:(?:REM|LOC|RWL(?: (?:ON|OFF))?)")
OUTPUT = re.compile(r"OUTP(\?)?(?: CH(\d))?(?:[ ,](ON|OFF|1|0))?")
MEASURE = re.compile(r"MEAS:(VOLT|CURR|ALL)\?(?: CH(\d))?")
MODE = re.compile(r"OUTP:MODE\?(?: CH(\d))?")
SELECT = re.compile(r"INST(?::N?SEL)?(\?| (?:CH)?(\d))")
NOT_ALLOWED = '-108,"Parameter not allowed"'
MAX = {"VOLT": 32.0, "CURR": 3.2}


@dataclass
class Channel:
    """One channel and the coil behind it."""

    coil: Any
    VOLT: float = 0.0
    CURR: float = 0.0
    on: bool = False
    limited: bool = False
    trips: dict[str, str] = field(default_factory=lambda: {"OVP": "33.000", "OCP": "3.300"})
    tripped: set[str] = field(default_factory=set)
    armed: dict[str, str] = field(default_factory=lambda: {"OVP": "OFF", "OCP": "OFF"})


class RigolEmulator(Answers):
    """What names no channel is for the selected one; a bad command is queued and not answered."""

    wire = "tcp"

    def __init__(self, lab: Lab, roles: Mapping[str, Mapping[str, Any]], settings: Any) -> None:
        self._channels = {int(s.get("channel", 1)): Channel(lab.coils[role[-1]]) for role, s in roles.items()}
        self._selected = min(self._channels)
        who = f"RIGOL TECHNOLOGIES,DP832,DP8A{ord(min(roles)[-1]) - ord('w'):06d},00.01.16"
        self._scpi = Messages(who, self._do, self._reset)
        super().__init__(self._scpi.line, delay_s=0.01)

    def _reset(self, t_s: float) -> None:
        for number, channel in self._channels.items():
            self._channels[number] = Channel(channel.coil)
            self._act(t_s, self._channels[number])

    def _do(self, t_s: float, text: str) -> str | None:
        if found := SELECT.fullmatch(text):
            return self._select(text, found[2])
        if found := SOURCE.fullmatch(text):
            return self._source(t_s, self._at(found[1]), found[2], found[3].strip())
        if found := OUTPUT.fullmatch(text):
            return self._output(t_s, self._at(found[2]), found[1], found[3])
        if found := MEASURE.fullmatch(text):
            return self._measure(t_s, self._at(found[2]), found[1])
        if found := MODE.fullmatch(text):
            return "CV" if self._at(found[1]).limited else "CC"
        if found := ISUM.fullmatch(text):
            return self._condition(self._at(found[1]))
        if found := APPLY.fullmatch(text):
            return self._apply(t_s, int(found[2] or found[3] or self._selected), found)
        if found := TRIP.fullmatch(text):
            return self._trip(self._at(found[4]), found)
        return "" if PANEL.fullmatch(text) else None

    def _at(self, stated: str | None) -> Channel:
        return self._channels[int(stated or self._selected)]

    def _select(self, text: str, to: str | None) -> str:
        if to is None:
            return f"{self._selected}" if "NSEL" in text else f"CH{self._selected}"
        if int(to) not in self._channels:
            return self._scpi.fault(RANGE)
        self._selected = int(to)
        return ""

    def _condition(self, channel: Channel) -> str:
        tripped = sum(bit for bit, which in ((4, "OVP"), (8, "OCP")) if which in channel.tripped)
        return f"{tripped | channel.on * (2 if channel.limited else 1)}"

    def _source(self, t_s: float, channel: Channel, what: str, value: str) -> str:
        if value == "?":
            return f"{getattr(channel, what):.3f}"
        if float(value) > MAX[what]:
            return self._scpi.fault(RANGE)
        setattr(channel, what, round(float(value), 3))
        return self._act(t_s, channel)

    def _apply(self, t_s: float, number: int, found: re.Match[str]) -> str:
        channel = self._channels[number]
        if found[1]:
            return f"CH{number}:30V/3A,{channel.VOLT:.3f},{channel.CURR:.4f}"
        return self._source(t_s, channel, "VOLT", found[4]) or self._source(t_s, channel, "CURR", found[5])

    def _trip(self, channel: Channel, found: re.Match[str]) -> str:
        which, what, value = found[1], (found[2] or "")[:3], found[5] or ""
        table = {"": channel.armed, "VAL": channel.trips}.get(what)
        if found[3]:
            return ("YES" if which in channel.tripped else "NO") if table is None else table[which]
        if table is not None and (value in ("ON", "OFF")) == (what == "") and value:
            table[which] = value if what == "" else f"{float(value):.3f}"
            return ""
        channel.tripped -= {which} if what == "CLE" else set()
        return "" if what == "CLE" else self._scpi.fault(NOT_ALLOWED)

    def _output(self, t_s: float, channel: Channel, asked: str | None, to: str | None) -> str:
        if asked:
            return "ON" if channel.on else "OFF"
        channel.on = to in ("ON", "1")
        return self._act(t_s, channel)

    def _measure(self, t_s: float, channel: Channel, what: str) -> str:
        current = channel.coil.current.now(t_s)
        voltage = current * channel.coil.resistance_ohm
        values = {"CURR": [current], "VOLT": [voltage], "ALL": [voltage, current, voltage * current]}[what]
        return ",".join(f"{value:.4f}" if what == "CURR" else f"{value:.3f}" for value in values)

    def _act(self, t_s: float, channel: Channel) -> str:
        for which, value in (("OVP", channel.VOLT), ("OCP", channel.CURR)):
            if channel.on and channel.armed[which] == "ON" and value > float(channel.trips[which]):
                channel.on = False
                channel.tripped |= {which}
        channel.limited = channel.coil.drive(t_s, channel.CURR, channel.VOLT, channel.on)
        return ""

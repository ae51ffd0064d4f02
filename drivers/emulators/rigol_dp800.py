"""A Rigol DP832: three channels on one line."""

from __future__ import annotations

import re
from collections import deque
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from drivers.emulators.line import QUEUE, Answers, Lab

NUMBER = r"\d+\.?\d*|\.\d+"
SOURCE = re.compile(rf":?SOUR(?:CE)?(\d):(VOLT|CURR)(?:AGE|ENT)?(\?| (?:{NUMBER}))", re.IGNORECASE)
APPLY = re.compile(rf":?APPL(?:Y)?(?:(\?) CH(\d)| CH(\d),({NUMBER}),({NUMBER}))", re.IGNORECASE)
TRIP = re.compile(
    rf":?OUTP(?:UT)?:(OVP|OCP)(?::(VAL(?:UE)?|QUES|CLEAR))?(\?)? CH(\d)(?:,(ON|OFF|{NUMBER}))?", re.IGNORECASE
)
ISUM = re.compile(r":?STAT(?:US)?:QUES(?:TIONABLE)?:INST(?:RUMENT)?:ISUM(\d):COND(?:ITION)?\?", re.IGNORECASE)
ERROR = re.compile(r":?SYST(?:EM)?:ERR(?:OR)?\?", re.IGNORECASE)
PANEL = re.compile(r":?SYST(?:EM)?:(?:REM|REMOTE|LOC|LOCAL|RWL(?:OCK)?(?: (?:ON|OFF))?)", re.IGNORECASE)
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
    trips: dict[str, str] = field(default_factory=lambda: {"OVP": "33.000", "OCP": "3.300"})
    armed: dict[str, str] = field(default_factory=lambda: {"OVP": "OFF", "OCP": "OFF"})


class RigolEmulator(Answers):
    """Accepts long and short words with or without the first colon; a bad command is queued and not answered."""

    wire = "tcp"

    def __init__(self, lab: Lab, roles: Mapping[str, Mapping[str, Any]], settings: Any) -> None:
        super().__init__(self._reply, delay_s=0.01)
        self._channels = {int(s.get("channel", 1)): Channel(lab.coils[role[-1]]) for role, s in roles.items()}
        self._serial = f"DP8A{ord(min(roles)[-1]) - ord('w'):06d}"
        self._errors = deque[str](maxlen=QUEUE)

    def _reply(self, t_s: float, text: str) -> bytes:
        try:
            said = self._do(t_s, text)
        except KeyError:
            said = self._fault('-222,"Data out of range"')
        return said.encode() + b"\n" if said else b""

    def _do(self, t_s: float, text: str) -> str:
        if text.upper() == "*IDN?":
            return f"RIGOL TECHNOLOGIES,DP832,{self._serial},00.01.16"
        if ERROR.fullmatch(text):
            return self._errors.popleft() if self._errors else '0,"No error"'
        if found := SOURCE.fullmatch(text):
            return self._source(t_s, self._channels[int(found[1])], found[2].upper(), found[3].strip())
        if found := OUTPUT.fullmatch(text):
            return self._output(t_s, self._channels[int(found[2])], found[1], found[3])
        if found := MEASURE.fullmatch(text):
            return self._measure(t_s, self._channels[int(found[2])], found[1].upper())
        if found := MODE.fullmatch(text):
            return "CV" if self._channels[int(found[1])].limited else "CC"
        if found := ISUM.fullmatch(text):
            channel = self._channels[int(found[1])]
            return f"{channel.on * (2 if channel.limited else 1)}"
        if found := APPLY.fullmatch(text):
            return self._apply(t_s, int(found[2] or found[3]), found)
        if found := TRIP.fullmatch(text):
            return self._trip(self._channels[int(found[4])], found)
        return "" if PANEL.fullmatch(text) else self._fault('-113,"Undefined header"')

    def _source(self, t_s: float, channel: Channel, what: str, value: str) -> str:
        if value == "?":
            return f"{getattr(channel, what):.3f}"
        if float(value) > MAX[what]:
            return self._fault('-222,"Data out of range"')
        setattr(channel, what, round(float(value), 3))
        return self._act(t_s, channel)

    def _apply(self, t_s: float, number: int, found: re.Match[str]) -> str:
        channel = self._channels[number]
        if found[1]:
            return f"CH{number}:30V/3A,{channel.VOLT:.3f},{channel.CURR:.4f}"
        return self._source(t_s, channel, "VOLT", found[4]) or self._source(t_s, channel, "CURR", found[5])

    def _trip(self, channel: Channel, found: re.Match[str]) -> str:
        which, what, value = found[1].upper(), (found[2] or "")[:3].upper(), (found[5] or "").upper()
        told = {"": channel.armed, "VAL": channel.trips}.get(what)
        if found[3]:
            return "NO" if told is None else told[which]
        if told is not None and (value in ("ON", "OFF")) == (what == "") and value:
            told[which] = value if what == "" else f"{float(value):.3f}"
            return ""
        return "" if what == "CLE" else self._fault('-108,"Parameter not allowed"')

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

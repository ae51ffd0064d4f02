"""A Genesys GEN40-38: hears once its address was called, answers OK or an error number; foldback ends its output."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import Any

from drivers.emulators.line import Answers, Lab

MOST = {"PV": 40.0, "PC": 38.0}
SET = re.compile(r"(PV|PC) (\d{0,9}\.?\d*)")
SWITCH = re.compile(r"(OUT|FLD|AST) (1|0|ON|OFF)")
ADDRESS = re.compile(r"ADR (\d{1,2})")
MODES = {"0": "LOC", "1": "REM", "2": "LLO"} | {mode: mode for mode in ("LOC", "REM", "LLO")}
FOLDBACK, OVER_VOLTAGE, OUTPUT_OFF = 1 << 3, 1 << 4, 1 << 6


class GenesysEmulator(Answers):
    """It leaves the factory with foldback off and safe start; what it was told is read back as it was told."""

    baud = 9600

    def __init__(self, lab: Lab, roles: Mapping[str, Mapping[str, Any]], settings: Any) -> None:
        super().__init__(self._heard, end=b"\r", delay_s=0.015)
        (role,) = roles
        self._coil, self._address = lab.coils[role[-1]], settings.address
        self._who = f"GEN-{ord(role[-1]):03d}A0{settings.address:02d}"
        self._addressed, self._mode, self._faults = False, "LOC", OUTPUT_OFF
        self._set_points = {"PV": "00.000", "PC": "00.000"}
        self._on = {"OUT": False, "FLD": False, "AST": False}
        self._above = {"OVP": 1.1 * MOST["PV"], "UVL": 0.0}

    def _heard(self, t_s: float, line: str) -> bytes:
        text = line.upper()
        if found := ADDRESS.fullmatch(text):
            self._addressed = int(found[1]) == self._address
        reply = "" if not self._addressed else "OK" if found else self._reply(t_s, text)
        return reply.encode() + b"\r" if reply else b""

    def _reply(self, t_s: float, text: str) -> str:
        if text.endswith("?"):
            return self._asked(t_s, text[:-1])
        if found := SET.fullmatch(text):
            return self._set(t_s, found[1], found[2])
        if found := SWITCH.fullmatch(text):
            return self._switch(t_s, found[1], found[2] in ("1", "ON"))
        word, _, rest = text.partition(" ")
        if word == "RMT":
            self._mode = MODES.get(rest, self._mode)
            return "OK" if rest in MODES else "C03"
        if word in ("PV", "PC", "OUT", "FLD", "AST"):
            return "C03" if rest else "C02"
        return "OK" if text in ("", "CLS") else "C01"

    def _asked(self, t_s: float, word: str) -> str:
        amps = self._coil.current.now(t_s)
        volts = amps * self._coil.resistance_ohm
        limited = volts > float(self._set_points["PV"]) - 0.01
        on = self._on["OUT"]
        return {
            "IDN": "LAMBDA,GEN40-38", "REV": "REV:1U:4.3", "SN": self._who, "DATE": "2019/05/14", "MDAV": "0",
            "RMT": self._mode, "MV": f"{volts:06.3f}", "MC": f"{amps:06.3f}", **self._set_points,
            "MODE": ("CV" if limited else "CC") if on else "OFF", "FLT": f"{self._faults:02X}",
            "STAT": f"{(1 if limited else 2) * on | 4 | 16 * self._on['AST'] | 32 * self._on['FLD']:02X}",
            "OVP": f"{self._above['OVP']:.3f}", "UVL": f"{self._above['UVL']:.3f}",
            **{name: "ON" if state else "OFF" for name, state in self._on.items()},
        }.get(word, "C01")  # fmt: skip

    def _set(self, t_s: float, word: str, number: str) -> str:
        if not number.strip("."):
            return "C03"
        if float(number) > 1.05 * MOST[word] or (word == "PV" and float(number) > 0.95 * self._above["OVP"]):
            return "E01" if word == "PV" else "C05"
        self._set_points[word] = number
        self._drive(t_s)
        return "OK"

    def _switch(self, t_s: float, word: str, on: bool) -> str:
        self._on[word] = on
        if word == "OUT":
            self._faults = 0 if on else self._faults
        self._drive(t_s)
        return "OK"

    def _drive(self, t_s: float) -> None:
        amps, volts = float(self._set_points["PC"]), float(self._set_points["PV"])
        if self._on["OUT"] and self._on["FLD"] and amps * self._coil.resistance_ohm < volts:
            self._faults, self._on["OUT"] = self._faults | FOLDBACK, False  # sooner than the 250 ms of a real one
        self._coil.drive(t_s, amps, volts, self._on["OUT"])

    def trip(self, t_s: float, fault: int = OVER_VOLTAGE) -> None:
        """A protection ends its output."""
        self._faults, self._on["OUT"] = self._faults | fault, False
        self._drive(t_s)

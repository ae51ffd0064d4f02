"""A LabJack U6 with an analogue fluxgate on three of its inputs, as its link answers."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import Any

import numpy as np

from drivers.emulators.line import Answers, Lab

ASKED = re.compile(r"ain (\d+),(\d+),(\d+) (single|differential) ([\d.]+) (\d+)")
RANGES, BEYOND = ("10", "1", "0.1", "0.01"), 1.01


class DaqEmulator(Answers):
    """An input that nothing is wired to reads 0 V; above its range it reads the range's end."""

    wire = "tcp"  # its real one is the maker's own

    def __init__(self, lab: Lab, roles: Mapping[str, Mapping[str, Any]], settings: Any) -> None:
        super().__init__(self._heard, delay_s=0.002)
        self._lab, self._settings = lab, settings

    def _heard(self, t_s: float, line: str) -> bytes:
        if line == "who":
            return b"LabJack,U6,360018234,1.45\n"
        if not (found := ASKED.fullmatch(line)):
            return b"? not known\n"
        if found[5] not in RANGES:
            return b"? a U6 has the ranges 10, 1, 0.1, 0.01 V\n"
        s = self._settings
        field_uT = (self._lab.reference_nT(np.array([t_s])) * self._lab.reference_nT_per_unit / 1000)[0]
        wired = dict(zip(s.inputs, field_uT / np.array(s.uT_per_V) + np.array(s.zero_V), strict=True))
        most = BEYOND * float(found[5])
        volts = [min(max(wired.get(int(one), 0.0), -most), most) for one in found.groups()[:3]]
        return (",".join(f"{one:.7f}" for one in volts) + "\n").encode()

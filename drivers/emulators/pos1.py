"""A POS-1: one reading for each `run`, in picotesla, 44 bytes with the zero that ends it."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import Any

import numpy as np

from drivers.emulators.line import Answers, Lab

LEAST_nT, MOST_nT, WITHIN_nT = 20_000, 100_000, 15_000
RANGE = re.compile(r"range (\d{4,6})")


class Pos1Emulator(Answers):
    """A reading takes it 0.8 s. Out of its range, or 15 µT off where it is tuned, its code says so."""

    baud = 9600

    def __init__(self, lab: Lab, roles: Mapping[str, Mapping[str, Any]], settings: Any) -> None:
        super().__init__(self._heard, end=b"\0", delay_s=min(0.8, settings.period_s / 2))
        self._lab, self._centre_nT = lab, 0

    def _heard(self, t_s: float, text: str) -> bytes:
        match text:
            case "mode text":
                return b"ok\0"
            case "about":
                return b"POS-1 Overhauser magnetometer N 117\0"
            case "range":
                return f"{self._centre_nT}\0".encode()
            case "run":
                return self._reading(t_s)
        if found := RANGE.fullmatch(text):
            self._centre_nT = int(found[1])
            return b"ok\0"
        return b"error\0"

    def _reading(self, t_s: float) -> bytes:
        field = self._lab.reference_nT(np.array([t_s])) * self._lab.reference_nT_per_unit
        f_nT = float(np.linalg.norm(field))
        tuned = not self._centre_nT or abs(f_nT - self._centre_nT) <= WITHIN_nT
        code = "80" if LEAST_nT <= f_nT <= MOST_nT and tuned else "10"
        clock = f"{int(t_s) // 3600 % 24:02d}:{int(t_s) // 60 % 60:02d}:{t_s % 60:05.2f}"
        return f"{round(1000 * f_nT):9d} +- 0021 [{code}] 01-01-26 {clock}\0".encode()

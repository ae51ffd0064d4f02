"""A Metrolab TFM1186: SCPI, one triggered reading at a time, values with their unit."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import Any

import numpy as np

from drivers.emulators.line import Answers, Lab
from drivers.emulators.scpi import Messages

FETCH = re.compile(r"(FETC|READ)(:ARR)?(?::FLUX)?(?::([XYZ]))?\?(?: (\d+))?(?:,(\d\d?))?")
TEMPERATURE = 8123  # raw counts, as they come
SETTINGS = {
    "INIT:CONT": "OFF", "FORM:DATA": "ASCII", "FORM": "ASCII", "AVER:COUN": "1", "TRIG:SOUR": "IMM", "TRIG:COUN": "1",
    "TRIG:TIM": "0.1S", "SENS:FLUX:RANG": "0.1T",
}  # fmt: skip
MOST, DIGITS = 2048, 9  # values of an array; what is not said


class MetrolabEmulator(Answers):
    """What it does not know becomes an error in its queue. `blank`: between a value and its unit."""

    def __init__(self, lab: Lab, roles: Mapping[str, Mapping[str, Any]], settings: Any) -> None:
        self._scpi = Messages("Metrolab Technology SA,TFM1186,0000123,EL v2.0 C v3.0", self._one, self._reset)
        super().__init__(self._scpi.line, delay_s=0.01)
        self._lab, self._field_T, self._taken_s, self._set, self.blank = lab, np.zeros(3), 0.0, dict(SETTINGS), ""

    def _reset(self, t_s: float) -> None:
        self._set = dict(SETTINGS)

    def _one(self, t_s: float, words: str) -> str | None:
        header, _, value = words.partition(" ")
        match header:
            case "INIT":
                self._measure(t_s)
            case "ABOR":
                pass
            case "FETC:TIM?":
                return f"{round(self._taken_s * 1e9):#x}"
            case "FETC:TEMP?":
                return f"{TEMPERATURE}"
            case _ if header.removesuffix("?") in self._set:
                if header.endswith("?"):
                    return self._set[header[:-1]]
                self._set[header] = value
            case _ if found := FETCH.fullmatch(words):
                return self._values(t_s, found)
            case _:
                return None
        return ""

    def _values(self, t_s: float, found: re.Match[str]) -> str:
        """One value, or an array of as many as are asked for, apart by commas; READ measures first."""
        if found[1] == "READ":
            self._measure(t_s)
        count, digits = (found[4], found[5]) if found[2] else ("1", found[4])
        value = self._field_T["XYZ".index(found[3] or "X")]
        return ",".join([f"{value:.{digits or DIGITS}f}{self.blank}T"] * min(int(count or 1), MOST))

    def _measure(self, t_s: float) -> None:
        self._field_T = self._lab.reference_nT(np.array([t_s]))[0] * self._lab.reference_nT_per_unit * 1e-9
        self._taken_s = t_s

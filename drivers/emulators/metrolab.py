"""A Metrolab TFM1186: SCPI, one triggered reading at a time, values with their unit."""

from __future__ import annotations

import re
from collections import deque
from collections.abc import Mapping
from typing import Any

import numpy as np

from drivers.emulators.line import QUEUE, Answers, Lab

FETCH = re.compile(r":(FETC|READ)(?::ARR:([XYZ])\? 1,|(?::SCAL)?:([XYZ])\? )(\d\d?)")
TEMPERATURE = 8123  # raw counts, as they come
SETTINGS = (":ABOR", ":INIT:CONT ", ":FORM:DATA ", ":AVER:COUN ", ":TRIG:SOUR ", ":TRIG:COUN ", ":SENS:FLUX:RANG ")


class MetrolabEmulator(Answers):
    """What it does not know becomes an error in its queue."""

    def __init__(self, lab: Lab, roles: Mapping[str, Mapping[str, Any]], settings: Any) -> None:
        super().__init__(self._reply, delay_s=0.01)
        self._lab, self._field_T, self._taken_s, self._errors = lab, np.zeros(3), 0.0, deque[str](maxlen=QUEUE)

    def _reply(self, t_s: float, text: str) -> bytes:
        answers = [self._one(t_s, words) for words in text.split(";")]
        told = [answer for answer in answers if answer]
        return ";".join(told).encode() + b"\n" if told else b""

    def _one(self, t_s: float, words: str) -> str:
        match words.split():
            case ["*IDN?"]:
                return "Metrolab Technology SA,TFM1186,0000123,EL v2.0 C v3.0"
            case [":SYST:ERR?"]:
                return self._errors.popleft() if self._errors else '0,"No error"'
            case ["*STB?"]:
                return "4" if self._errors else "0"
            case [":INIT"]:
                self._measure(t_s)
            case [":FETC:TIM?"]:
                return f"{round(self._taken_s * 1e9):#x}"
            case [":FETC:TEMP?"]:
                return f"{TEMPERATURE}"
            case _ if found := FETCH.fullmatch(words):
                if found[1] == "READ":
                    self._measure(t_s)
                return f"{self._field_T['XYZ'.index(found[2] or found[3])]:.{found[4]}f}T"
            case _ if not words.startswith(SETTINGS):
                self._errors.append('-113,"Undefined header"')
        return ""

    def _measure(self, t_s: float) -> None:
        self._field_T = self._lab.reference_nT(np.array([t_s]))[0] * self._lab.reference_nT_per_unit * 1e-9
        self._taken_s = t_s

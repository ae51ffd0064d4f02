"""The made-up supply's own side of the wire: it answers as its manual says, faults included."""

from __future__ import annotations

import re
from collections import deque
from collections.abc import Mapping
from typing import Any

from drivers.emulators.line import QUEUE, Answers, Lab

SET = re.compile(r"(CURR|VOLT|OUTP) (\d+\.?\d*)")
MOST = {"CURR": 3.0, "VOLT": 30.0, "OUTP": 1.0}


class ExampleEmulator(Answers):
    """One output on one coil; a command that it does not know is queued as an error and not answered."""

    baud = 9600  # of its serial line, as its manual says

    def __init__(self, lab: Lab, roles: Mapping[str, Mapping[str, Any]], settings: Any) -> None:
        super().__init__(self._reply, delay_s=0.005)
        (role,) = roles
        self._coil, self._serial = lab.coils[role[-1]], f"00{ord(role[-1])}"  # each unit has its own
        self._values = {"CURR": 0.0, "VOLT": 0.0, "OUTP": 0.0}
        self._errors = deque[str](maxlen=QUEUE)

    def _reply(self, t_s: float, text: str) -> bytes:
        said = self._do(t_s, text)
        return said.encode() + b"\n" if said else b""

    def _do(self, t_s: float, text: str) -> str:
        if text == "*IDN?":
            return f"Example,CS-1,{self._serial},1.0"
        if text == "SYST:ERR?":
            return self._errors.popleft() if self._errors else '0,"No error"'
        if text == "MEAS:CURR?":
            return f"{self._coil.current.now(t_s):.4f}"
        if text.removesuffix("?") in self._values and text.endswith("?"):
            return f"{self._values[text[:-1]]:.4f}"
        if (found := SET.fullmatch(text)) and float(found[2]) <= MOST[found[1]]:
            self._values[found[1]] = float(found[2])
            self._coil.drive(t_s, self._values["CURR"], self._values["VOLT"], bool(self._values["OUTP"]))
        else:
            self._errors.append('-113,"Undefined header"' if not found else '-222,"Data out of range"')
        return ""

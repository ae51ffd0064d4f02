"""An Aim-TTi PL303QMT-P: the supply's own side of its line."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from drivers.emulators.line import Answers, Lab
from drivers.emulators.scpi import COMMAND_ERROR, EXECUTION_ERROR, Messages

NUMBER = r"[+-]?(?:\d+\.?\d*|\.\d+)(?:E[+-]?\d+)?"  # the manual's NRF
COMMAND = re.compile(rf"(V|I|OP|OVP|OCP|LSR|IRANGE)(\d)([OV]?)(\?| {NUMBER})")
STEP = re.compile(rf"(INC|DEC|DELTA)(V|I)(\d)(\?| {NUMBER})?")
OUT_OF_RANGE, WITH_OUTPUT_ON = 100, 104
MAX = {"V": 30.0, "I": 3.0, "OVP": 40.0, "OCP": 3.5}


@dataclass
class Output:
    """One output and the coil behind it."""

    coil: Any
    V: float = 0.0
    I: float = 0.0  # noqa: E741  the symbol on its panel
    OVP: float = 40.0
    OCP: float = 3.5
    on: bool = False
    limited: bool = False
    IRANGE: int = 2
    tripped: int = 0  # bits of its limit event register
    steps: dict[str, float] = field(default_factory=lambda: {"V": 0.0, "I": 0.0})


class TtiEmulator(Answers):
    """Answers as the supply does; settings act on the coil of the twin."""

    wire = "tcp"

    def __init__(self, lab: Lab, roles: Mapping[str, Mapping[str, Any]], settings: Any) -> None:
        self._outputs = {int(s.get("output", 1)): Output(lab.coils[role[-1]]) for role, s in roles.items()}
        self._error, self._locked = 0, False
        serial = 512_340 + sum(ord(role[-1]) - ord("x") for role in roles)
        who = f"THURLBY THANDAR, PL303QMT-P, {serial}, 3.02-4.06"
        self.words = Messages(who, self._do, self._reset, none="", end="\r\n", words=str.upper)
        super().__init__(self.words.line, delay_s=0.008)

    def _reset(self, t_s: float) -> None:
        for output in self._outputs.values():
            output.V, output.I, output.OVP, output.OCP, output.on, output.tripped = 0.0, 0.0, 40.0, 3.5, False, 0
            output.coil.drive(t_s, 0.0, 0.0, False)

    def _do(self, t_s: float, text: str) -> str | None:
        match text:
            case "IFLOCK" | "IFLOCK?" | "IFUNLOCK":
                self._locked = self._locked if text.endswith("?") else text == "IFLOCK"
                return f"{self._locked:d}"
            case "EER?":
                error, self._error = self._error, 0
                return f"{error}"
            case "QER?":
                return "0"
            case "TRIPRST":
                for output in self._outputs.values():
                    output.tripped = 0
                return ""
            case "LOCAL":
                return ""
            case "OPALL 0" | "OPALL 1":
                for output in self._outputs.values():
                    self._set(t_s, output, "OP", float(text[-1]))
                return ""
        return self._of_one_output(t_s, text)

    def _of_one_output(self, t_s: float, text: str) -> str | None:
        found, step = COMMAND.fullmatch(text), STEP.fullmatch(text)
        number = int(found[2]) if found else int(step[3]) if step else 0
        if number not in self._outputs:
            return None
        output = self._outputs[number]
        if step and step[1] == "DELTA" and step[4] == "?":
            return f"DELTA{step[2]}{number} {output.steps[step[2]]:.3f}"
        if step:
            self._step(t_s, output, step)
        elif found and found[4] == "?":
            return self._read(t_s, output, found)
        elif found:
            self._set(t_s, output, found[1], float(found[4]))
        return ""

    def _read(self, t_s: float, output: Output, found: re.Match[str]) -> str:
        what, number = found[1], found[2]
        if what == "OP":
            return f"{output.on:d}"
        if what == "IRANGE":
            return f"{output.IRANGE}"
        if what == "LSR":
            tripped, output.tripped = output.tripped, 0
            return f"{tripped | output.on * (1 if output.limited else 2)}"
        if found[3] != "O":
            prefix, digits = what.removeprefix("O"), 4 if what == "I" else 3
            return f"{prefix}{number} {getattr(output, what):.{digits}f}"
        current = output.coil.current.now(t_s)
        return f"{current:.3f}A" if what == "I" else f"{current * output.coil.resistance_ohm:.3f}V"

    def _step(self, t_s: float, output: Output, step: re.Match[str]) -> None:
        how, what = step[1], step[2]
        if how == "DELTA" and step[4]:
            output.steps[what] = float(step[4])
        elif how != "DELTA" and not step[4]:
            self._set(t_s, output, what, getattr(output, what) + output.steps[what] * (1 if how == "INC" else -1))
        else:
            self.words.events |= COMMAND_ERROR

    def _set(self, t_s: float, output: Output, what: str, value: float) -> None:
        if what == "OP":
            output.on = bool(value)
        elif what == "IRANGE" and output.on:
            self._refuse(WITH_OUTPUT_ON)
        elif what == "IRANGE" and value in (1, 2):
            output.IRANGE = int(value)
        elif what not in MAX:
            self.words.events |= COMMAND_ERROR
        elif not 0 <= value <= MAX[what]:
            self._refuse(OUT_OF_RANGE)
        else:
            setattr(output, what, round(value, 4))
        if output.on and (output.V > output.OVP or output.I > output.OCP):
            output.on, output.tripped = False, 4 if output.V > output.OVP else 8
        output.limited = output.coil.drive(t_s, output.I, output.V, output.on)

    def _refuse(self, error: int) -> None:
        self.words.events, self._error = self.words.events | EXECUTION_ERROR, error

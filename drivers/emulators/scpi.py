"""What SCPI instruments answer alike: IEEE 488.2's words, several messages a line, long forms, errors in a queue."""

from __future__ import annotations

import re
from collections import deque
from collections.abc import Callable
from dataclasses import dataclass, field

from drivers.emulators.line import QUEUE

POWER_ON, COMMAND_ERROR, EXECUTION_ERROR, COMPLETE = 128, 32, 16, 1  # of the event register
ERROR_QUEUED = 4  # of the status byte
UNKNOWN, RANGE = '-113,"Undefined header"', '-222,"Data out of range"'
ERRORS = ("SYST:ERR?", "SYST:ERR:NEXT?")
WORD = re.compile(r"[A-Z]+")
OWN = {"CUR": "CURR", "VOL": "VOLT"}  # Delta Elektronika's short forms
IMPLIED = re.compile(r":(?:LEV|IMM|AMPL|DC|SCAL|STAT)(?=[:?]|$)")  # nodes that may be left out


def short(message: str) -> str:
    """Upper case, its header's words in short form (SCPI 1999, 6.2.1), implied nodes and needless blanks left out."""
    header, _, rest = message.upper().strip().partition(" ")
    header = WORD.sub(lambda word: _short(word[0]), header).removeprefix("SOUR:")
    return " ".join(filter(None, (IMPLIED.sub("", header), re.sub(r"\s*,\s*", ",", rest.strip()))))


def _short(word: str) -> str:
    return OWN.get(word, word) if len(word) <= 4 else word[:3] if word[3] in "AEIOU" else word[:4]


@dataclass
class Messages:
    """Lines for a device that answers one message with `do`: its text, "" where none is due, None where unknown.

    `reset` is for *RST. `none`: the reply of an empty queue of errors; "" where the device has no such queue.
    """

    who: str
    do: Callable[[float, str], str | None]
    reset: Callable[[float], object]
    none: str = '0,"No error"'
    end: str = "\n"
    words: Callable[[str], str] = short
    events: int = field(default=POWER_ON, init=False)
    errors: deque[str] = field(default_factory=lambda: deque(maxlen=QUEUE), init=False)
    _masks: dict[str, str] = field(default_factory=lambda: {"*ESE": "0", "*SRE": "0"}, init=False)

    def line(self, t_s: float, text: str) -> bytes:
        """The replies to a line, apart by semicolons; a header without a colon goes on where the one before was."""
        said, path = list[str](), ""
        for message in filter(None, map(str.strip, text.split(";"))):
            if message.startswith("*"):
                said.append(self._common(t_s, message.upper()))
                continue
            whole = self.words(message.removeprefix(":"))
            relative = "" if message.startswith(":") else path
            answer = self._execute(t_s, relative + whole) if relative else None
            path = (relative + whole).partition(" ")[0].rpartition(":")[0]
            path += ":" if path else ""
            said.append(answer if answer is not None else self._from_the_root(t_s, whole))
        replies = ";".join(filter(None, said))
        return f"{replies}{self.end}".encode() if replies else b""

    def fault(self, error: str) -> str:
        """Into the queue with it; no reply."""
        self.errors.append(error)
        self.events |= COMMAND_ERROR if error.startswith("-1") else EXECUTION_ERROR
        return ""

    def _from_the_root(self, t_s: float, message: str) -> str:
        answer = self._execute(t_s, message)
        return self.fault(UNKNOWN) if answer is None else answer

    def _execute(self, t_s: float, message: str) -> str | None:
        if self.none and message in ERRORS:
            return self.errors.popleft() if self.errors else self.none
        try:
            return self.do(t_s, message)
        except KeyError:  # nothing is wired to that output
            return self.fault(RANGE)

    def _common(self, t_s: float, message: str) -> str:
        word, _, value = message.partition(" ")
        match word:
            case "*IDN?":
                return self.who
            case "*OPC?":
                return "1"
            case "*TST?" | "*OPT?":
                return "0"
            case "*STB?":
                return f"{ERROR_QUEUED * bool(self.errors)}"
            case "*ESR?":
                events, self.events = self.events, 0
                return f"{events}"
            case "*ESE?" | "*SRE?":
                return self._masks[word[:-1]]
            case "*ESE" | "*SRE" if value.isdigit():
                self._masks[word] = value
            case "*CLS":
                self.errors.clear()
                self.events = 0
            case "*RST":
                self.reset(t_s)
            case "*OPC":
                self.events |= COMPLETE
            case "*WAI":
                pass
            case _:
                return self.fault(UNKNOWN)
        return ""

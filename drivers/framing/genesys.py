"""How a Genesys is spoken to: several on one line, of which the one that was addressed last hears, and answers all."""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from weakref import WeakKeyDictionary

from drivers.framing.in_step import InStep
from labcal.bench.clock import Clock
from labcal.bench.links import Link, quoted
from labcal.bench.links.line import wait_for_quiet
from labcal.errors import InstrumentError

END, OK, REMOTE = b"\r", "OK", "RMT REM"
QUIET_S = 0.1  # by then the answers to what was told without waiting have come
MOST_CALLS = 4  # of a supply that asks for service, before an answer
ERROR = re.compile(r"[CE]\d\d")
ERRORS = {
    "E01": "the voltage is above its range, or above 95 % of its over-voltage protection",
    "E02": "the voltage is below its under-voltage limit",
    "E07": "a protection tripped, or an input of its rear panel bars it",
    "C01": "it does not know this",
    "C05": "that is beyond what it delivers",
}


@dataclass(eq=False)
class Bus:
    """What is known of a line: which address hears, and whether answers may still come that nobody waits for."""

    selected: int | None = None
    owed: bool = False


BUSES: WeakKeyDictionary[Link, Bus] = WeakKeyDictionary()  # supplies on one line share it


@dataclass
class Conversation:
    """With the supply at `address`, which is addressed anew before it is told anything."""

    name: str
    link: Link
    clock: Clock
    address: int
    gap_s: float
    timeout_s: float
    _free_s: float = field(default=float("-inf"), init=False)

    def __post_init__(self) -> None:
        self._in_step = InStep(self.name, self.link, self.clock)
        self._bus = BUSES.setdefault(self.link, Bus())
        self.refuse_earlier = self._in_step.refuse_earlier

    def select(self) -> None:
        """Have this one listen, and no other on the line."""
        self._bus.selected = None
        self._acknowledged(f"ADR {self.address}")
        self._bus.selected = self.address

    def ask(self, question: str) -> str:
        """Its answer. Raises InstrumentError: silent, or refused."""
        if self._bus.selected != self.address:
            self.select()
        return self._in_step.heard(question, self._answer(question))

    def command(self, text: str) -> None:
        """Tell, under remote control. Raises InstrumentError with what the supply says."""
        self.select()
        self._acknowledged(REMOTE)
        self._acknowledged(text)

    def send(self, text: str) -> None:
        """Tell, under remote control, and wait for nothing."""
        self._bus.selected, self._bus.owed = None, True
        for one in (f"ADR {self.address}", REMOTE, text):
            self._put(one)

    def _acknowledged(self, text: str) -> None:
        reply = self._answer(text)
        if reply != OK:
            self.refuse_earlier(text, reply)
            raise InstrumentError(f"{self.name}: {text!r} was answered {quoted(reply)}.", fault="wrong reply",
                                  remedy="Does another program talk on its line? Try again.")  # fmt: skip

    def _answer(self, text: str) -> str:
        if self._bus.owed:
            wait_for_quiet(self.link, self.clock, QUIET_S)
            self._bus.owed = False
        self._in_step.settle()
        self._put(text)
        reply = self._line()
        for _ in range(MOST_CALLS):
            reply = self._line() if reply.startswith("!") else reply
        self._free_s = self.clock.now() + self.gap_s
        if ERROR.fullmatch(reply):
            why = f": {ERRORS[reply]}" if reply in ERRORS else ""
            raise InstrumentError(f"{self.name}: {text!r} failed: {reply}{why}.", fault="refused",
                                  remedy="Look at the supply's panel.")  # fmt: skip
        return reply

    def _put(self, text: str) -> None:
        self.clock.wait_until(self._free_s)
        self.link.flush()
        self.link.send(text.encode() + END)
        self._free_s = self.clock.now() + self.gap_s

    def _line(self) -> str:
        return self.link.ask(b"", end=END, timeout_s=self.timeout_s).decode("latin-1").strip()

"""SCPI over one line: questions, and commands whose errors are asked for."""

from __future__ import annotations

import math
import re
from collections import deque
from collections.abc import Callable
from dataclasses import dataclass, field

from drivers.framing.in_step import InStep
from labcal.bench.clock import Clock
from labcal.bench.driver_kit.roles import Identity
from labcal.bench.links import Link, abridged, quoted
from labcal.errors import InstrumentError

LONGEST_QUEUE = 64
MOST_ECHOES = 8  # that may still be on their way
FLOW = b"\x11\x13"  # XON, XOFF that an adapter let through
NAK = b"\x15"  # of a Kepco whose input queue overran
CODE = re.compile(r"[+-]?\d+(,| +[A-Za-z])")  # with which an answer to "which errors?" begins
NO_ERROR = '0,"No error"'


@dataclass
class Scpi:
    """`gap_s`: the least pause after each message. `errors`: what asks for the oldest error in its queue.

    `may_echo`: it may send back what it is told before it answers; that is no answer, whenever it comes. `end` closes
    what it is told, and its last byte what it says. `no_error`: how an empty queue reads, if not as a 0 and a comma.
    """

    name: str
    link: Link
    clock: Clock
    timeout_s: float
    gap_s: float = 0.0
    errors: str = "SYST:ERR?"
    may_echo: bool = False
    end: bytes = b"\n"
    no_error: str = NO_ERROR
    _free_s: float = field(default=float("-inf"), init=False)
    _sent: deque[bytes] = field(default_factory=lambda: deque(maxlen=MOST_ECHOES), init=False)

    def __post_init__(self) -> None:
        self._in_step = InStep(self.name, self.link, self.clock)
        self.refuse_earlier = self._in_step.refuse_earlier

    def query(self, text: str, within_s: float = math.inf) -> str:
        """Ask and return the reply, waited for `within_s` where that is less than `timeout_s`.

        Raises InstrumentError: silent, or refused where the question was lost.
        """
        self._in_step.settle()
        self.send(text)
        reply = self._line(within_s)
        for _ in range(MOST_ECHOES * self.may_echo):
            if reply in self._sent:
                reply = self._line(within_s)
        self._free_s = self.clock.now() + self.gap_s
        if NAK in reply:
            raise InstrumentError(f"{self.name}: it lost {text!r}: its input queue overran.", fault="refused")
        return self._in_step.heard(text, reply.decode("utf-8", "replace"))

    def command(self, text: str) -> None:
        """Tell, then ask for errors. Raises InstrumentError with what the supply says."""
        self.send(text)
        if self._none(error := self.query(self.errors)):
            return
        if not CODE.match(error):
            self.refuse_earlier(self.errors, error)
            error = f"asked for errors it answered {quoted(error)}"
        raise refused(self.name, text, error)

    def send(self, text: str) -> None:
        """Tell, once it is ready to hear; what was left on the line is dropped."""
        self.clock.wait_until(self._free_s)
        self.link.flush()
        self.link.send(text.encode() + self.end)
        self._sent.append(text.encode())
        self._free_s = self.clock.now() + self.gap_s

    def _line(self, within_s: float) -> bytes:
        timeout_s = min(self.timeout_s, within_s)
        return self.link.ask(b"", end=self.end[-1:], timeout_s=timeout_s).strip(FLOW + b"\r\n ")

    def _none(self, error: str) -> bool:
        return error.startswith(("0,", "+0,")) or _evenly(error) == _evenly(self.no_error)

    def identify(self, fits: Callable[[str, str], bool], kind: str) -> Identity:
        """Who it says it is. Raises InstrumentError where maker and model do not fit: it is no `kind`.

        An answer that names nobody is not the last word: it may be late, or said twice.
        """
        said = self.query("*IDN?")
        if self._in_step.ask_again(said):
            said = self.query("*IDN?")
        maker, model, serial, firmware = (*map(_evenly, said.split(",")), "", "", "")[:4]
        if not fits(maker.upper(), model):
            self.refuse_earlier("*IDN?", said)
            raise InstrumentError(
                f"{self.name}: {abridged(f'{maker} {model}')} answered, not {kind}.", fault="another instrument"
            )
        return Identity(maker, model, serial, firmware)

    def empty_errors(self) -> None:
        """Read away the errors of the time before. Raises InstrumentError where its queue has no end."""
        for _ in range(LONGEST_QUEUE):
            if self._none(error := self.query(self.errors)):
                return
        raise InstrumentError(f"{self.name}: its queue of errors has no end: {abridged(error)}.", fault="wrong reply")


def refused(name: str, text: str, why: str) -> InstrumentError:
    """The error for a command that a supply did not take."""
    remedy = "Look at the supply's panel."
    return InstrumentError(f"{name}: {text!r} failed: {abridged(why)}.", fault="refused", remedy=remedy)


def _evenly(words: str) -> str:
    """One blank between words: some makers pad them."""
    return " ".join(words.split())

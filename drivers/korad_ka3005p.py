"""Korad KA3005P and its clones (Tenma 72-2540, Velleman), serial ASCII without terminators, unipolar."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from drivers.framing.in_step import MAKER
from drivers.framing.korad import Conversation
from drivers.framing.supply import CurrentSource
from labcal.bench.clock import Clock
from labcal.bench.driver_kit.quantity import quantity
from labcal.bench.driver_kit.roles import Identity
from labcal.bench.driver_kit.settings import NotNegative, Positive
from labcal.bench.links import Link, quoted
from labcal.errors import InstrumentError

IDENTITY = re.compile(r"(KORAD|TENMA|VELLEMAN|RND)\s*(.*?)\s*V?(\d+\.\d+)?\s*(?:SN:?\s*(\w+))?")
OUTPUT_BIT, LENGTH = 6, 5  # of its status; of its numbers


@dataclass(frozen=True, slots=True)
class Settings:
    """`terminator`: "" for old firmware, "\\n" for some of version 5 and later.

    `gap_s`: the least pause between commands; at 60 ms sets are lost, Tenma's own program waits 200.
    """

    terminator: str = ""
    max_current_A: Positive = 3.0
    compliance_V: Positive = 20.0
    zero_current_A: float = 0.005
    ramp_A_per_s: float = 4.0
    gap_s: NotNegative = 0.1
    timeout_s: Positive = 0.5


class KoradSupply(CurrentSource):
    """A unipolar supply that reports no errors and drops what comes while it is busy: every set is read back.

    A question that nothing answers is put once more; a set never is. What is left of the answer to a question that was
    given up, as zero was ordered, is waited for before the next question, and dropped; a set does not wait for it.
    Zero and off are told once more where their read-back denies them: it may have been deaf.
    """

    roles = ("coil",)
    never = (rb"SAV\d", rb"RCL\d", rb"TRACK")
    bipolar, can_open = False, True

    current = quantity(
        "ISET1?", "ISET1:{value:.3f}", unit="A", doc="Control the current set-point.",
        limits=lambda s: (0.0, s.max_current_A), tolerance=0.00051, read=lambda reply: _decimal(reply, 3),
    )  # fmt: skip
    compliance = quantity(
        "VSET1?", "VSET1:{value:05.2f}", unit="V", doc="Control the voltage that may drive the coil.",
        limits=lambda s: (0.0, 31.0), tolerance=0.0051, read=lambda reply: _decimal(reply, 2),
    )  # fmt: skip
    enabled = quantity(
        "STATUS?", "OUT{value:d}", unit="1", doc="Control whether the output is on.", limits=lambda s: (0, 1),
        read=lambda reply: ord(reply) >> OUTPUT_BIT & 1,
    )  # fmt: skip
    sensed = quantity("IOUT1?", unit="A", doc="Measure the delivered current.", read=lambda reply: _decimal(reply, 3))

    def __init__(self, name: str, link: Link, clock: Clock, settings: Settings) -> None:
        self.name, self.settings, self._link = name, settings, link
        self.zero_current_A, self.ramp_A_per_s = settings.zero_current_A, settings.ramp_A_per_s
        self._line = Conversation(name, link, clock, settings.terminator, settings.gap_s, settings.timeout_s)
        self.write, self.refuse_earlier = self._line.command, self._line.in_step.refuse_earlier

    def identify(self) -> Identity:
        """Ask who it is."""
        reply = self._line.words("*IDN?")
        if IDENTITY.fullmatch(reply) is None and MAKER.match(reply) is None:  # of an earlier question, or cut off
            reply = self._line.words("*IDN?")
        self._line.in_step.refuse_number("*IDN?", reply)
        if not reply:
            raise InstrumentError(
                f"{self.name}: '*IDN?' was answered by nothing that can be read.", fault="wrong reply"
            )
        if (found := IDENTITY.fullmatch(reply)) is None:
            raise InstrumentError(
                f"{self.name}: {quoted(reply)} answered, not a Korad or a clone.", fault="another instrument"
            )
        self._line.in_step.heard("*IDN?", reply[:LENGTH])
        return Identity(found[1].title(), found[2], found[4] or "", found[3] or "")

    def close(self) -> None:
        """Let go of the link."""
        self._link.close()

    def query(self, text: str) -> str:
        """Ask; one byte of status or five characters are the reply, whatever strays in after them."""
        return self._line.answer(text, 1 if text == "STATUS?" else LENGTH)

    def set_current(self, current_A: float) -> None:
        """Set the current and read the set-point back."""
        self._rest_twice(super().set_current, current_A)

    def output(self, on: bool) -> None:
        """Switch the output, confirmed; before it goes on, the compliance voltage is set."""
        self._rest_twice(super().output, on)

    def trip(self) -> str:
        """It says that its output is off, and not by which of its two protections."""
        return "" if self.enabled else "over-voltage or over-current"

    def command(self, text: str) -> None:
        """Tell. It never says whether it heard."""
        self.write(text)

    def _rest_twice(self, command: Callable[[Any], None], value: float) -> None:
        try:
            command(value)
        except InstrumentError as fault:
            if value or fault.fault != "read-back":
                raise
            command(value)


def _decimal(reply: str, places: int) -> float:
    """Five characters such as `12.34` or `1.234`; anything else is no number of this supply."""
    if not re.fullmatch(rf"\d{{{4 - places}}}\.\d{{{places}}}", reply):
        raise ValueError(reply)
    return float(reply)

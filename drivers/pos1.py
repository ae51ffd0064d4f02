"""A POS-1 Overhauser magnetometer: an absolute scalar reference, asked for each reading (RS-232, 9600 8N1)."""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import Annotated

import numpy as np
from pydantic import Field

from drivers.framing.mishaps import Mishaps
from drivers.framing.polling import Polled, Polls
from labcal.bench.clock import Clock
from labcal.bench.driver_kit.framing import Lines
from labcal.bench.driver_kit.roles import Identity
from labcal.bench.driver_kit.settings import NotNegative, Positive
from labcal.bench.links import Link, abridged
from labcal.errors import InstrumentError
from labcal.record.stream import Block, Event

END = b"\0"
# field and its scatter in pT, a code in brackets, date, time
READING = re.compile(rb"\s*(\d{5,9})\s+\S+\s+(\d+)\s+\[(\d)(\d)\]\s+(\d\d-\d\d-\d\d)\s+(\d\d:\d\d:\d\d\S*)\s*")
FINE = b"8"
FAULTS = {1: "the field is out of its range", 2: "no signal", 4: "low power"}  # bits of the code's first digit
REMEDY = "It needs 20 to 100 uT, even over its volume, and to be tuned near that (range_nT)."
TALKS_S = 2.0  # an answer in words


@dataclass(frozen=True, slots=True)
class Settings:
    """`period_s` between readings, each of which takes it about a second. `range_nT`: the centre it is tuned to; 0
    leaves its own. `delay_s`: from the middle of a measurement to its answer.

    `most_scatter_nT`: a reading of more is noted and dropped. `about`: a word of what it says of itself.
    """

    period_s: Positive = 3.0
    range_nT: Annotated[float, Field(ge=0, le=100_000)] = 0.0
    delay_s: NotNegative = 0.5
    most_scatter_nT: Positive = 10.0
    about: str = "POS"


class Pos1(Polled):
    """A reading whose own code tells of an error is noted and gives no value."""

    roles = ("reference",)
    never = (rb"^(?!(about|mode text|run|range \d{5,6})\0\Z)",)  # its clock, its power state and its own beat stay

    def __init__(self, name: str, link: Link, clock: Clock, settings: Settings) -> None:
        self.name, self.settings, self._link, self._clock = name, settings, link, clock
        self._polls, self._mishaps, self._lines = Polls(clock, 1 / settings.period_s), Mishaps(name), Lines(END)

    def identify(self) -> Identity:
        """Have it talk in text, and ask what it says of itself."""
        self._say("mode text")
        said = self._say("about")
        if self.settings.about.upper() not in said.upper():
            told = f"{self.name}: {abridged(said)!r} answered, not a POS-1."
            raise InstrumentError(told, fault="another instrument")
        number = re.search(r"(?:N|SN|No)\W*(\d+)", said)
        return Identity("QMLab", "POS-1", number[1] if number else "", "")

    def start(self) -> None:
        """Tune it where a range is stated, and begin to ask."""
        self._say("mode text")
        if self.settings.range_nT:
            self._say(f"range {self.settings.range_nT:.0f}")
        self._lines = Lines(END)
        self._polls.start()

    def read_until(self, t_s: float) -> list[Block]:
        """Magnitudes that came up to `t_s` [nT]."""
        for _ in self._polls.due(t_s):
            self._link.send(b"run" + END)
        taken = [(stamp, line, self._value(stamp, line)) for stamp, line in self._lines.feed(self._link.receive(t_s))]
        good = [(stamp, line, value) for stamp, line, value in taken if value is not None]
        if not good:
            return []
        stamps = np.array([stamp for stamp, _, _ in good]) - self.settings.delay_s
        values = np.array([[value] for _, _, value in good])
        return [Block("reference", self.name, ("ref_f",), stamps, values, b"\n".join(line for _, line, _ in good))]

    def events(self) -> list[Event]:
        """Readings that were no good."""
        return self._mishaps.events()

    def stop(self) -> None:
        """Ask no more."""
        self._polls.stop()

    def make_safe(self) -> None:
        """Ask no more."""
        self.stop()

    def close(self) -> None:
        """Let go of the link."""
        self._link.close()

    def _value(self, stamp: float, line: bytes) -> float | None:
        """The field [nT]; None, noted, where it is none. Raises InstrumentError where it cannot measure."""
        found = READING.fullmatch(line)
        if found is None or float(found[2]) > 1000 * self.settings.most_scatter_nT:
            self._mishaps.note("bad frame", stamp)
            return None
        if found[3] != FINE:
            why = " and ".join(words for bit, words in FAULTS.items() if int(found[3]) & bit) or f"code {found[3]!r}"
            fault = "overloaded" if int(found[3]) & 1 else "no signal"
            raise InstrumentError(f"{self.name}: it cannot measure: {why}.", fault=fault, remedy=REMEDY)
        return int(found[1]) / 1000

    def _say(self, words: str) -> str:
        self._link.flush()
        reply = self._link.ask(words.encode() + END, end=END, timeout_s=TALKS_S)
        return reply.rstrip(END).decode("ascii", "replace").strip()

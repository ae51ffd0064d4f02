"""GSM-19 and GSM-90 Overhauser magnetometers: an absolute scalar reference that sends a line a reading (RS-232)."""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import Annotated

import numpy as np
from pydantic import Field

from drivers.framing.listener import ParsedListener, Pieces
from drivers.framing.mishaps import Mishaps
from drivers.framing.sent_lines import SentLines
from labcal.bench.clock import Clock
from labcal.bench.driver_kit.roles import Identity
from labcal.bench.driver_kit.settings import NotNegative, Positive
from labcal.bench.links import Link
from labcal.record.stream import Block

LINE = re.compile(  # date and time where it sends them, the field in nT, the quality of its signal
    rb"(?:(?:\d\d-\d\d-\d{4} +)?\d{5,7}(?:\.\d+)? +)?(\d{5,6}\.\d{1,3})(?: +(\d{2,3}))?"
)
WHY = {  # of whole lines that are no good readings
    rb"\d+\.\d +(\d{5,6}\.\d{1,3})\r?\n": "It says no quality: least_quality = 0 takes its readings all the same.",
    rb"\d{5,6}\.\d{1,3} +[+-]?\d{1,4}\.\d+( +\d\d)?\r?\n": (
        "It sends a gradient too, as a gradiometer: set it to send one sensor alone."
    ),
    rb"\d{5,6}\.\d{1,3} +\d\d\r?\n": "Their quality is below least_quality: tune it, or look for what disturbs it.",
}
LEAST_nT, MOST_nT = 10_000.0, 120_000.0
LONGEST, PATIENT_PERIODS = 80, 3.0


@dataclass(frozen=True, slots=True)
class Settings:
    """`period_s`: how often it has been set to measure. `delay_s`: from the middle of a measurement to its line.

    A reading whose quality (99 is the best) is below `least_quality` is noted and dropped, and so is one that says
    none, unless `least_quality` is 0.
    """

    period_s: Positive = 3.0
    delay_s: NotNegative = 0.5
    least_quality: Annotated[int, Field(ge=0, le=99)] = 50
    model: str = "GSM"
    serial: str = ""


class Parser:
    """Lines in any cutting, into blocks; the first after the start may be cut and is dropped."""

    def __init__(self, source: str, settings: Settings, mishaps: Mishaps) -> None:
        self._source, self._settings, self._mishaps = source, settings, mishaps
        self._lines = SentLines(mishaps, LONGEST)

    def feed(self, pieces: Pieces) -> list[Block]:
        """The block of the lines that these pieces complete [nT]."""
        stamps, values, raw = self._lines.rows(pieces, self._row)
        if not values:
            return []
        t = np.array(stamps) - self._settings.delay_s
        return [Block("reference", self._source, ("ref_f",), t, np.array(values), raw)]

    def _row(self, stamp: float, line: bytes) -> list[float] | None:
        """The field [nT]; None, noted, where it is none, or not a good one."""
        found = LINE.fullmatch(line.strip(b"\r \t\0"))
        least = self._settings.least_quality
        if found and LEAST_nT <= float(found[1]) <= MOST_nT and (not least or int(found[2] or 0) >= least):
            return [float(found[1])]
        self._mishaps.note("bad frame", stamp)
        return None


class Gsm(ParsedListener):
    """It is set on its keys to measure at a steady beat and to send as it measures; nothing is sent to it."""

    roles = ("reference",)
    parser = Parser

    def __init__(self, name: str, link: Link, clock: Clock, settings: Settings) -> None:
        who = Identity("GEM Systems", settings.model, settings.serial)
        super().__init__(name, link, clock, settings, who)
        self.first_s = max(self.first_s, PATIENT_PERIODS * settings.period_s)

    def why(self, came: bytes) -> str:
        """What its lines are, where they are no good readings."""
        return next((f" {told}" for line, told in WHY.items() if re.search(line, came)), "")

"""A PNI RM3100 behind a microcontroller that sends its raw counts as `x,y,z` lines (115200 baud)."""

from __future__ import annotations

from dataclasses import dataclass

from drivers.framing.listener import ParsedListener, Pieces
from drivers.framing.mishaps import Mishaps
from drivers.text_line import Parser as TextParser
from drivers.text_line import Settings as TextSettings
from labcal.bench.clock import Clock
from labcal.bench.driver_kit.roles import Identity
from labcal.bench.links import Link
from labcal.errors import InstrumentError
from labcal.record.stream import Block

RANGE_NT = 800_000.0
CYCLES = range(30, 401)


@dataclass(frozen=True, slots=True)
class Settings:
    """`cycle_count` as the bridge sets it: another one is another scale. `counts_per_uT` where it was measured."""

    cycle_count: int = 200
    counts_per_uT: float | None = None
    delay_s: float = 0.0
    serial: str = ""

    def __post_init__(self) -> None:
        if self.cycle_count not in CYCLES:
            raise ValueError(f"cycle_count is {CYCLES[0]} to {CYCLES[-1]}")

    @property
    def nT_per_count(self) -> float:
        """The stated gain, or the manual's 0.3671 × cycle count + 1.5 counts per µT, good to about 0.1 %."""
        return 1000 / (self.counts_per_uT or 0.3671 * self.cycle_count + 1.5)


class Parser:
    """Counts in any cutting, into blocks [nT]."""

    def __init__(self, source: str, settings: Settings, mishaps: Mishaps) -> None:
        text = TextSettings(scale=settings.nT_per_count, delay_s=settings.delay_s, full_scale_nT=RANGE_NT)
        self._source, self._text = source, TextParser(source, text, mishaps)

    def feed(self, pieces: Pieces) -> list[Block]:
        """The blocks of the lines that these pieces complete."""
        blocks = self._text.feed(pieces)
        if any(b"." in block.raw or b"e" in block.raw.lower() for block in blocks):
            raise InstrumentError(
                f"{self._source}: the bridge sends fractions, not the sensor's counts.",
                fault="wrong mode",
                remedy="Switch off the calibration in the bridge's firmware: labcal needs raw counts.",
            )
        return blocks


class Rm3100(ParsedListener):
    """Refuses a bridge that sends fractions: it has applied a calibration of its own, and counts are needed."""

    roles = ("reference",)
    parser = Parser

    def __init__(self, name: str, link: Link, clock: Clock, settings: Settings) -> None:
        scale = f"cycle count {settings.cycle_count}, {settings.nT_per_count:.4f} nT a count"
        who = Identity("PNI", "RM3100 bridge", settings.serial, scale)
        super().__init__(name, link, clock, settings, who)

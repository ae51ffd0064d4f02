"""A DUT that sends one line of text a sample: numbers between delimiters, in the order of a column map."""

from __future__ import annotations

from dataclasses import dataclass

from drivers.framing.columns import Columns, Table, channels
from drivers.framing.listener import ParsedListener, Pieces
from drivers.framing.mishaps import Mishaps
from drivers.framing.text import Text, TextRows
from labcal.bench.clock import Clock
from labcal.bench.driver_kit.roles import Identity
from labcal.bench.links import Link
from labcal.record.stream import Block


@dataclass(frozen=True, slots=True)
class Settings(Columns, Text):
    """The column map and how its numbers are written."""

    def __post_init__(self) -> None:
        Columns.__post_init__(self)
        Text.__post_init__(self)


class Parser:
    """Text in any cutting, into blocks."""

    def __init__(self, source: str, settings: Settings, mishaps: Mishaps) -> None:
        self._rows = TextRows(settings, settings, mishaps)
        self._table = Table(source, settings, mishaps)

    def feed(self, pieces: Pieces) -> list[Block]:
        """The blocks of the lines that these pieces complete."""
        return self._table.blocks(*self._rows.feed(pieces))


class CsvLine(ParsedListener):
    """Lines that are not the numbers of the column map (headers, cut or noisy lines) are dropped and reported.

    Text has no checksum: digits lost on the way cannot be noticed. `pmag` and `ccsds` notice them.
    """

    roles = ("dut",)
    parser = Parser

    def __init__(self, name: str, link: Link, clock: Clock, settings: Settings) -> None:
        self.channels = channels(settings)
        who = Identity("", "text line", settings.serial)
        super().__init__(name, link, clock, settings, who)

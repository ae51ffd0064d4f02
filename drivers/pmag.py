"""A DUT that sends `$PMAG,t,x,y,z,T*HH`: a sentence after NMEA-0183, whose checksum finds broken digits."""

from __future__ import annotations

from dataclasses import dataclass

from drivers.framing import nmea
from drivers.framing.columns import Columns, Table, channels, numbers
from drivers.framing.listener import ParsedListener, Pieces
from drivers.framing.mishaps import Mishaps
from drivers.framing.sent_lines import SentLines
from labcal.bench.clock import Clock
from labcal.bench.driver_kit.roles import Identity
from labcal.bench.links import Link
from labcal.record.stream import Block

LONGEST = 500  # what may stand before a sentence on its line, which has 82 signs at most


@dataclass(frozen=True, slots=True)
class Settings(Columns):
    """The column map of the fields behind the name `sentence`; other sentences are skipped."""

    columns: tuple[str, ...] = ("t", "x", "y", "z", "temp_dut")
    sentence: str = "PMAG"


class Parser:
    """Sentences in any cutting, into blocks."""

    def __init__(self, source: str, settings: Settings, mishaps: Mishaps) -> None:
        self._settings, self._mishaps = settings, mishaps
        self._lines, self._table = SentLines(mishaps, LONGEST), Table(source, settings, mishaps)

    def feed(self, pieces: Pieces) -> list[Block]:
        """The blocks of the sentences that these pieces complete."""
        return self._table.blocks(*self._lines.rows(pieces, self._row))

    def _row(self, stamp: float, line: bytes) -> list[float] | None:
        sentence = nmea.fields(line)
        if sentence is None:
            self._mishaps.note("checksum" if nmea.looks_whole(line) else "bad frame", stamp)
            return None
        name, values = sentence
        if name != self._settings.sentence:
            return None
        if (row := numbers(values, self._settings)) is None:
            self._mishaps.note("bad frame", stamp)
        return row


class Pmag(ParsedListener):
    """Sentences with a wrong checksum, cut ones and those longer than 82 signs are dropped and reported."""

    roles = ("dut",)
    parser = Parser

    def __init__(self, name: str, link: Link, clock: Clock, settings: Settings) -> None:
        self.channels = channels(settings)
        who = Identity("", f"${settings.sentence} sentence", settings.serial)
        super().__init__(name, link, clock, settings, who)

"""An observatory's or variometer's IAGA-2002 rows, as they are written: a remote reference for the ambient field."""

from __future__ import annotations

import math
import re
from dataclasses import dataclass, replace
from datetime import UTC, datetime
from typing import Literal

import numpy as np

from drivers.framing.columns import OwnClock
from drivers.framing.listener import ParsedListener, Pieces
from drivers.framing.mishaps import Mishaps
from drivers.framing.sent_lines import SentLines
from labcal.bench.clock import Clock
from labcal.bench.driver_kit.roles import Identity
from labcal.bench.driver_kit.settings import NotNegative, Positive
from labcal.bench.links import Link, quoted
from labcal.errors import InstrumentError
from labcal.record.stream import Block

VALUE = rb" +(-?\d{1,6}\.\d{1,3})"
ROW = re.compile(rb"(\d{4}-\d\d-\d\d) (\d\d:\d\d:\d\d(?:\.\d{1,6})?) (\d{3})" + 4 * VALUE)
COLUMNS = re.compile(rb"DATE +TIME +DOY +([A-Z0-9 ]+?) *\|")
NOT_THERE = 88_888.0  # and beyond: 88888 was not recorded, 99999 is missing
LONGEST, PATIENT_PERIODS = 120, 3.0


@dataclass(frozen=True, slots=True)
class Settings:
    """`elements`: of its four columns, by their last letters; a head that says others is refused. D is in minutes.

    `reads`: "XYZ" or "HDZ" of them, which become north, east and down, or "F" alone, for `kind = "scalar"`.
    `station`: its IAGA code; a head that says another is refused. `period_s`: between two rows.
    `stamp`: "host" puts the row that came the quickest of the first `delay_s` before its arrival, and keeps the rows'
    spacing; "utc" takes their own time, on a computer whose clock is kept right.
    """

    elements: str = "XYZF"
    reads: Literal["XYZ", "HDZ", "F"] = "XYZ"
    station: str = ""
    period_s: Positive = 1.0
    stamp: Literal["host", "utc"] = "host"
    delay_s: NotNegative = 0.0

    def __post_init__(self) -> None:
        if len(self.elements) != 4 or len(set(self.elements)) != 4 or not set(self.reads) <= set(self.elements):
            raise ValueError(f"elements must be four letters, such as XYZF, with {self.reads} among them")


class Parser:
    """Lines in any cutting, into blocks, stamped on the bench's clock or, where that is stated, in UTC [s]."""

    def __init__(self, source: str, settings: Settings, mishaps: Mishaps) -> None:
        self._source, self._settings, self._mishaps = source, settings, mishaps
        self._lines, self._clock = SentLines(mishaps, LONGEST), OwnClock(mishaps)
        self._columns = [settings.elements.index(e) for e in settings.reads]
        self._last_s = math.inf  # of the row before [s since 1970]

    def feed(self, pieces: Pieces) -> list[Block]:
        """The block of the rows that these pieces complete [nT]. Raises InstrumentError (another instrument)."""
        stamps, rows, raw = self._lines.rows(pieces, self._row)
        if not rows:
            return []
        table, s = np.array(rows), self._settings
        own_s, values = table[:, 0], table[:, 1:]
        tied = s.stamp == "host"
        t = self._clock.tie(np.array(stamps) - s.delay_s, own_s) if tied else own_s
        if s.reads == "HDZ":
            angle = np.radians(values[:, 1] / 60)
            values = np.column_stack([values[:, 0] * np.cos(angle), values[:, 0] * np.sin(angle), values[:, 2]])
        columns = ("ref_f",) if s.reads == "F" else ("ref_x", "ref_y", "ref_z")
        return [Block("reference", self._source, columns, t, values, raw)]

    def _row(self, stamp: float, line: bytes) -> list[float] | None:
        """Its own time [s since 1970] and what is read of it; None where it is of the head, or, noted, no good."""
        line = line.strip(b"\r \t\0")
        if columns := COLUMNS.fullmatch(line):
            self._refuse_another(columns[1].decode().split())
            return None
        if line.endswith(b"|"):
            return None
        try:
            date, time_, day, *cells = (part.decode() for part in _parts(line))
            moment = datetime.fromisoformat(f"{date}T{time_}").replace(tzinfo=UTC)
            values = [float(cells[k]) for k in self._columns]
            if moment.timetuple().tm_yday != int(day):
                raise ValueError
        except ValueError:
            self._mishaps.note("bad frame", stamp)
            return None
        self._note_gap(stamp, moment.timestamp())
        if max(map(abs, values)) >= NOT_THERE:
            self._mishaps.note("gap", stamp)
            return None
        return [moment.timestamp(), *values]

    def _note_gap(self, stamp: float, own_s: float) -> None:
        missing = round((own_s - self._last_s) / self._settings.period_s) - 1 if math.isfinite(self._last_s) else 0
        if 0 < missing * self._settings.period_s < 86_400:
            self._mishaps.note("gap", stamp, missing)
        self._last_s = own_s

    def _refuse_another(self, names: list[str]) -> None:
        s, elements = self._settings, "".join(name[-1] for name in names)
        if elements != s.elements or (s.station and any(name[:-1] != s.station for name in names)):
            raise InstrumentError(
                f"{self._source}: its head says {quoted(' '.join(names))}, the settings {s.station} {s.elements}.",
                fault="another instrument",
                remedy="Correct station and elements in bench.toml, or the file's name.",
            )


class Iaga2002(ParsedListener):
    """It is only read, from a port or from the file of the day. A row in which what is read is missing gives none."""

    roles = ("reference",)
    parser = Parser

    def __init__(self, name: str, link: Link, clock: Clock, settings: Settings) -> None:
        who = Identity("IAGA-2002", settings.station or settings.elements, "")
        super().__init__(name, link, clock, settings, who)
        self.first_s = max(self.first_s, PATIENT_PERIODS * settings.period_s)

    def read_until(self, t_s: float) -> list[Block]:
        """What arrived up to `t_s`, on the bench's clock."""
        blocks = super().read_until(t_s)
        if self.settings.stamp == "host":
            return blocks
        bench_less_utc = self._clock.now() - self._clock.utc().timestamp()
        return [replace(block, t_s=block.t_s + bench_less_utc) for block in blocks]


def _parts(line: bytes) -> tuple[bytes, ...]:
    """Date, time, day of the year and the four cells of a row. Raises ValueError."""
    if (found := ROW.fullmatch(line)) is None:
        raise ValueError(line)
    return found.groups()

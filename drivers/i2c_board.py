"""A magnetometer chip on I2C behind a microcontroller with labcal's sketch (labcal-mag/1): its counts, as a DUT."""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import Literal

import numpy as np

from drivers.framing.columns import JUMP_S, OwnClock
from drivers.framing.crc16 import crc16
from drivers.framing.listener import ParsedListener, Pieces
from drivers.framing.mishaps import Mishaps, overloaded
from drivers.framing.sent_lines import SentLines
from labcal.bench.clock import Clock
from labcal.bench.driver_kit.roles import ChannelSpec, Identity
from labcal.bench.driver_kit.settings import NotNegative
from labcal.bench.links import Link
from labcal.errors import InstrumentError
from labcal.record.stream import Block

NT_PER_COUNT = {  # x, y, z, as the sketch sets each chip
    "rm3100": (1000 / (0.3671 * 200 + 1.5),) * 3,  # cycle count 200
    "mmc5983": (1e5 / 32_768,) * 3,  # SET less RESET: 2 × 16384 a gauss
    "lis3mdl": (1e5 / 6842,) * 3,  # ± 4 G
    "qmc5883": (1e5 / 12_000,) * 3,  # ± 2 G
    "bmm350": (7.0699, 7.0699, 7.1750),  # typical: each chip's own corrections stay unused
}
LINE = re.compile(rb"(\d{1,3}) ([a-z0-9]{1,12}) (\d{1,10}) (full|none|-?\d{1,8} -?\d{1,8} -?\d{1,8})\*([0-9A-F]{4})\r?")
NUMBERS, WRAPS_S, LONGEST = 1000, 2**32 / 1000, 64


def sealed(text: str) -> bytes:
    """A line of the protocol with its checksum."""
    return b"%s*%04X\r\n" % (text.encode(), crc16(text.encode()))


@dataclass(frozen=True, slots=True)
class Settings:
    """`chip` as the sketch has it; `nT_per_count` in place of its typical scale, an axis each.

    `unit`: "count" hands on what the chip sends, for `[dut] unit = "count"`. `stamp`: "host" is the arrival less
    `delay_s`, "device" the board's milliseconds.
    """

    chip: Literal["rm3100", "mmc5983", "lis3mdl", "qmc5883", "bmm350"] = "rm3100"
    nT_per_count: tuple[float, float, float] | None = None
    unit: Literal["nT", "count"] = "nT"
    stamp: Literal["host", "device"] = "host"
    delay_s: NotNegative = 0.0
    serial: str = ""

    def __post_init__(self) -> None:
        if self.nT_per_count is not None and not all(0 < abs(one) < 1e4 for one in self.nT_per_count):
            raise ValueError("nT_per_count must be three numbers other than zero")

    @property
    def scale(self) -> tuple[float, float, float]:
        """From counts to what is handed on."""
        return (1.0, 1.0, 1.0) if self.unit == "count" else self.nT_per_count or NT_PER_COUNT[self.chip]


class Parser:
    """Lines in any cutting, into blocks; the first after the start may be cut and is dropped."""

    def __init__(self, source: str, settings: Settings, mishaps: Mishaps) -> None:
        self._source, self._settings, self._mishaps = source, settings, mishaps
        self._lines = SentLines(mishaps, LONGEST)
        self._clock, self._number, self._ms, self._wraps_s = OwnClock(mishaps), -1, 0, 0.0

    def feed(self, pieces: Pieces) -> list[Block]:
        """The block of the lines that these pieces complete, in the unit of the settings."""
        stamps, rows, raw = self._lines.rows(pieces, self._row)
        if not rows:
            return []
        table, t = np.array(rows), np.array(stamps)
        if self._settings.stamp == "device":
            t = self._clock.tie(t, table[:, 0])
        values = table[:, 1:] * np.array(self._settings.scale)
        return [Block("dut", self._source, ("dut_x", "dut_y", "dut_z"), t - self._settings.delay_s, values, raw)]

    def _row(self, stamp: float, line: bytes) -> list[float] | None:
        """The board's time [s] and counts; None, noted, where the line is no good."""
        found = LINE.fullmatch(line)
        if found is None or crc16(line.rpartition(b"*")[0]) != int(found[5], 16):
            self._mishaps.note("bad frame" if found is None else "checksum", stamp)
            return None
        if (chip := found[2].decode()) != self._settings.chip:
            raise InstrumentError(f"{self._source}: a {chip} answers, not a {self._settings.chip}.",
                                  fault="another instrument", remedy="State its chip in bench.toml.")  # fmt: skip
        if found[4] == b"none":
            raise InstrumentError(f"{self._source}: the board sends, and hears no {chip}.", fault="silent",
                                  remedy="Look at the wires between chip and board, and at its address.")  # fmt: skip
        if found[4] == b"full":
            raise overloaded(self._source)
        self._count(stamp, int(found[1]))
        return [self._time_s(int(found[3])), *map(float, found[4].split())]

    def _count(self, stamp: float, number: int) -> None:
        if self._number >= 0 and (lost := (number - self._number - 1) % NUMBERS):
            self._mishaps.note("gap", stamp, lost)
        self._number = number

    def _time_s(self, ms: int) -> float:
        """The board's clock goes on where its counter begins again (49.7 days); else it was switched on anew."""
        if self._ms - ms > 1000 * (WRAPS_S - JUMP_S):
            self._wraps_s += WRAPS_S
        self._ms = ms
        return ms / 1000 + self._wraps_s


class I2cBoard(ParsedListener):
    """A line with a wrong checksum gives no value; numbers that are missing are a gap.

    Raises InstrumentError where another chip answers, where the board hears none, and at the end of its converter.
    """

    roles = ("dut",)
    parser = Parser
    channels: tuple[ChannelSpec, ...] = ()

    def __init__(self, name: str, link: Link, clock: Clock, settings: Settings) -> None:
        scale = " ".join(f"{one:g}" for one in settings.nT_per_count or NT_PER_COUNT[settings.chip])
        who = Identity("labcal-mag/1", settings.chip, settings.serial, f"{scale} nT a count")
        super().__init__(name, link, clock, settings, who)

"""A reference magnetometer that sends one line of text a sample, with a column map: vector or magnitude."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np

from drivers.framing.columns import NT, SECONDS, OwnClock
from drivers.framing.listener import ParsedListener, Pieces
from drivers.framing.mishaps import Mishaps, overloaded
from drivers.framing.text import Text, TextRows
from labcal.bench.clock import Clock
from labcal.bench.driver_kit.roles import Identity
from labcal.bench.links import Link
from labcal.record.stream import Block


@dataclass(frozen=True)
class Settings(Text):
    """`columns`: x y z, or f alone for a magnitude; t is the sensor's own clock [`t_unit`], "-" is skipped.

    Readings times `scale` are in `unit`; counts are a scale with unit nT. At `full_scale_nT` it is overloaded.
    `stamp`: "host" takes the time of the first byte less `delay_s`, "device" the column t on the bench's clock.
    """

    columns: tuple[str, ...] = ("x", "y", "z")
    unit: Literal["nT", "uT", "mG", "G"] = "nT"
    scale: float = 1.0
    t_unit: Literal["s", "ms", "us", "iso"] = "s"
    stamp: Literal["host", "device"] = "host"
    delay_s: float = 0.0
    full_scale_nT: float = 1e6
    serial: str = ""

    def __post_init__(self) -> None:
        Text.__post_init__(self)
        named = sorted(set(self.columns) - {"-", "t"})
        if named not in (["x", "y", "z"], ["f"]) or any(self.columns.count(c) > 1 for c in (*named, "t")):
            raise ValueError("columns must have x, y and z once, or f once, and t at most once")
        if self.stamp == "device" and "t" not in self.columns:
            raise ValueError("columns must have t where stamp is device")

    @property
    def axes(self) -> tuple[str, ...]:
        """What is read: x y z, or f."""
        return ("f",) if "f" in self.columns else ("x", "y", "z")


class Parser:
    """Text in any cutting, into blocks."""

    def __init__(self, source: str, settings: Settings, mishaps: Mishaps) -> None:
        self._source, self._settings = source, settings
        self._rows, self._clock = TextRows(settings, settings, mishaps), OwnClock(mishaps)
        self._reading = [settings.columns.index(axis) for axis in settings.axes]

    def feed(self, pieces: Pieces) -> list[Block]:
        """The blocks of the lines that these pieces complete [nT, its own axes]."""
        stamps, rows, raw = self._rows.feed(pieces)
        if not rows:
            return []
        s, table, t = self._settings, np.array(rows), np.array(stamps)
        if s.stamp == "device":
            t = self._clock.tie(t, table[:, s.columns.index("t")] * SECONDS[s.t_unit])
        values = table[:, self._reading] * (s.scale * NT[s.unit])
        if np.abs(values).max() >= s.full_scale_nT:
            raise overloaded(self._source)
        columns = tuple(f"ref_{axis}" for axis in s.axes)
        return [Block("reference", self._source, columns, t - s.delay_s, values, raw)]


class TextLine(ParsedListener):
    """Lines that are not the numbers of the column map are dropped and reported; text has no checksum."""

    roles = ("reference",)
    parser = Parser

    def __init__(self, name: str, link: Link, clock: Clock, settings: Settings) -> None:
        who = Identity("", "text line", settings.serial)
        super().__init__(name, link, clock, settings, who)

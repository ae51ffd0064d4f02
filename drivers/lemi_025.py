"""LEMI-025 and LEMI-036 observatory fluxgates: one binary record a second, ten samples in it, listened to."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from drivers.framing import lemi
from drivers.framing.columns import OwnClock
from drivers.framing.listener import ParsedListener, Pieces
from drivers.framing.mishaps import Mishaps
from labcal.bench.clock import Clock
from labcal.bench.driver_kit.roles import Identity
from labcal.bench.links import Link
from labcal.record.stream import Block

NT_PER_UT = 1000.0


@dataclass(frozen=True, slots=True)
class Settings:
    """`gps_delay_s` (data sheet): a sample is that much older than the GPS second its record names.

    `sent_after_s`: from the record's GPS second to its first byte on the line. It depends on the logger: find it with
    `sync-check`. Without a GPS fix the time of arrival stands for it.
    A record with a field beyond `full_scale_uT` is taken for noise.
    """

    tag: str = "L025"
    serial: str = ""
    gps_delay_s: float = 0.3
    sent_after_s: float = 1.0
    full_scale_uT: float = 100.0

    def __post_init__(self) -> None:
        if len(self.tag) != lemi.TAG:
            raise ValueError(f"tag must have {lemi.TAG} letters, such as L025")


class Parser:
    """Records in any cutting, into blocks."""

    def __init__(self, source: str, settings: Settings, mishaps: Mishaps) -> None:
        self._source, self._settings, self._mishaps = source, settings, mishaps
        self._records = lemi.Records(settings.tag.encode(), settings.full_scale_uT)
        self._gps, self._before_s = OwnClock(mishaps), 0.0

    def feed(self, pieces: Pieces) -> list[Block]:
        """The blocks of the records that these pieces complete."""
        records = self._records.feed(pieces)
        for stamp in self._records.taken_bad():
            self._mishaps.note("bad frame", stamp)
        return [self._block(stamp, record) for stamp, record in records]

    def _block(self, stamp: float, record: lemi.Record) -> Block:
        s = self._settings
        self._note_gap(stamp, record)
        second_s = stamp - s.sent_after_s
        if record.gps:
            second_s = float(self._gps.tie(np.array([second_s]), np.array([record.second_s]))[0])
        t = second_s - s.gps_delay_s + np.arange(lemi.SAMPLES) / lemi.SAMPLES
        columns = ("ref_x", "ref_y", "ref_z")
        return Block("reference", self._source, columns, t, record.xyz_uT * NT_PER_UT, record.raw)

    def _note_gap(self, stamp: float, record: lemi.Record) -> None:
        missing = round(record.second_s - self._before_s) - 1
        if self._before_s and 0 < missing < 3600:
            self._mishaps.note("gap", stamp, missing * lemi.SAMPLES)
        self._before_s = record.second_s


class Lemi025(ParsedListener):
    """Readings keep the spacing of GPS seconds; a second that is missing is reported as a gap of ten samples."""

    roles = ("reference",)
    parser = Parser
    before = b""
    period_s = 1.0  # between two records

    def __init__(self, name: str, link: Link, clock: Clock, settings: Settings) -> None:
        who = Identity("LEMI", settings.tag, settings.serial)
        super().__init__(name, link, clock, settings, who)

    def why(self, came: bytes) -> str:
        """Where its records begin with another tag, which."""
        other = lemi.tag_in(came)
        if other in ("", self.settings.tag):
            return ""
        return f" Its records begin with {other!r}: state that as tag."

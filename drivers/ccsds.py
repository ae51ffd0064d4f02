"""A DUT that sends CCSDS space packets: over serial in SLIP or COBS, or one a datagram; lost ones are counted."""

from __future__ import annotations

import struct
from dataclasses import dataclass, replace
from typing import Literal

from drivers.framing import ccsds, cobs, slip
from drivers.framing.columns import Columns, Table, channels, complete
from drivers.framing.crc16 import crc16
from drivers.framing.listener import Array, ParsedListener, Pieces, values_again
from drivers.framing.mishaps import Mishaps
from labcal.bench.clock import Clock
from labcal.bench.driver_kit.framing import Lines
from labcal.bench.driver_kit.roles import Identity
from labcal.bench.links import Link
from labcal.errors import InputError
from labcal.record.stream import Block

UNFRAMED = ("udp://", "emulated://")  # where one piece is one packet


@dataclass(frozen=True, slots=True)
class Settings(Columns):
    """`layout`: struct format of the columns behind the secondary header, which holds `time` where there is one.

    CUC time has 4 bytes of seconds and `cuc_fine` bytes of fraction, CDS 2 of days and 4 of milliseconds; either is
    the DUT's own clock, so `columns` then has no t. `crc`: the last two bytes of a packet are its CRC-16-CCITT;
    without it, bits that turned over on the way cannot be noticed.
    """

    columns: tuple[str, ...] = ("x", "y", "z")
    layout: str = ">3f"
    framing: Literal["slip", "cobs", "datagram"] = "slip"
    apid: int = 100
    crc: bool = True
    time: Literal["none", "cuc", "cds"] = "cuc"
    cuc_fine: int = 2
    longest: int = 2048

    def __post_init__(self) -> None:
        _column_map(self)
        try:
            numbers = len(struct.unpack(self.layout, bytes(struct.calcsize(self.layout))))
        except struct.error as error:
            raise ValueError(f"layout: {error}") from error
        if numbers != len(self.columns) or self.layout[:1] not in "<>!":
            raise ValueError(f"layout must begin with > or < and give the {len(self.columns)} numbers of columns")
        if not 0 <= self.apid < ccsds.IDLE or not 0 <= self.cuc_fine <= 3:
            raise ValueError("apid is 0 to 2046, cuc_fine 0 to 3")


class Parser:
    """Packets in any cutting (but datagrams, which come whole), into blocks."""

    def __init__(self, source: str, settings: Settings, mishaps: Mishaps) -> None:
        self._settings, self._mishaps, self._counter = settings, mishaps, ccsds.Counter()
        self._decode, end = (cobs.decode, cobs.END) if settings.framing == "cobs" else (slip.decode, slip.END)
        self._lines = Lines(end, longest=settings.longest, skip_first=True)
        self._header = {"none": 0, "cuc": 4 + settings.cuc_fine, "cds": 6}[settings.time]
        self._layout = struct.Struct(settings.layout)
        self._columns = _column_map(settings)
        self._table = Table(source, self._columns, mishaps)

    def feed(self, pieces: Pieces) -> list[Block]:
        """The blocks of the packets that these pieces complete."""
        stamps, rows, raw = list[float](), list[tuple[float, ...]](), list[bytes]()
        for stamp, frame in self._frames(pieces):
            packet = self._packet(stamp, frame)
            if packet is not None and (row := self._row(stamp, packet)) is not None:
                stamps.append(stamp)
                rows.append(row)
                raw.append(frame)
        return self._table.blocks(stamps, rows, b"".join(raw))

    def _frames(self, pieces: Pieces) -> list[tuple[float, bytes]]:
        if self._settings.framing == "datagram":
            return list(pieces)
        frames = [(stamp, self._decode(line)) for stamp, line in self._lines.feed(pieces) if line]
        for stamp, frame in frames:
            if frame is None:
                self._mishaps.note("bad frame", stamp)
        return [(stamp, frame) for stamp, frame in frames if frame is not None]

    def _packet(self, stamp: float, frame: bytes) -> ccsds.Packet | None:
        """The packet in `frame` if it is whole and ours."""
        if self._settings.crc and len(frame) > 2 and crc16(frame):
            self._mishaps.note("checksum", stamp)
            return None
        packet = ccsds.parse(frame, crc_bytes=2 * self._settings.crc)
        if packet is None:
            self._mishaps.note("bad frame", stamp)
            return None
        return packet if packet.apid == self._settings.apid else None

    def _row(self, stamp: float, packet: ccsds.Packet) -> tuple[float, ...] | None:
        """Its numbers, if it is the next one, or after a gap, and not one that came late or twice."""
        body = packet.data[self._header :]
        if len(body) != self._layout.size or packet.secondary != (self._header > 0) or not packet.unsegmented:
            self._mishaps.note("bad frame", stamp)
            return None
        step, missing = self._counter.step(packet.count)
        if step != "next":
            self._mishaps.note(step, stamp, {"gap": missing, "late": 1, "restart": 0}[step])
        row = (*self._time(packet.data[: self._header]), *map(float, self._layout.unpack(body)))
        if not complete(row, self._columns):
            self._mishaps.note("bad frame", stamp)
            return None
        return row if step != "late" else None

    def _time(self, field: bytes) -> tuple[float, ...]:
        if self._settings.time == "none":
            return ()
        return (ccsds.cds_s(field),) if self._settings.time == "cds" else (ccsds.cuc_s(field, self._settings.cuc_fine),)


class Ccsds(ParsedListener):
    """Packets with a wrong CRC, length or layout are dropped and reported, and so is each gap in the count."""

    roles = ("dut",)
    parser = Parser

    def __init__(self, name: str, link: Link, clock: Clock, settings: Settings) -> None:
        if settings.framing == "datagram" and not link.url.startswith(UNFRAMED):
            raise InputError(f"{name}: framing datagram needs a link udp://, not {link.url}")
        self.channels = channels(settings)
        who = Identity("", f"CCSDS packets, APID {settings.apid}", settings.serial)
        super().__init__(name, link, clock, settings, who)

    @classmethod
    def parse_again(cls, settings: Settings, raw: bytes) -> Array:
        """The samples (n, 3) of packets as a record keeps them, by the parser that read them."""
        whole = replace(settings, framing="datagram")
        return values_again(Parser("", whole, Mishaps("")), [(0.0, packet) for packet in ccsds.packets(raw)])


def _column_map(s: Settings) -> Columns:
    """All numbers of a packet in their order: the time of its secondary header first, then those of the layout."""
    if s.time == "none":
        return Columns(s.columns, s.unit, s.scale, s.t_unit, s.stamp, s.delay_s, s.quantities)
    return Columns(("t", *s.columns), s.unit, s.scale, "s", s.stamp, s.delay_s, s.quantities)

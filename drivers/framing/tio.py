"""Twinleaf's packets: a head of type and lengths, a payload, CRC-32, in SLIP; requests, and what describes a stream."""

from __future__ import annotations

import re
import struct
import zlib
from collections.abc import Callable, Sequence
from dataclasses import dataclass

from drivers.framing import slip

REQUEST, REPLY, REFUSAL, HEARTBEAT, TIMEBASE, SOURCE, STREAM, DATA = 2, 3, 4, 5, 6, 7, 8, 128
HEAD, NAMED, LONGEST = struct.Struct("<BBH"), 0x8000, 512
SUM, NUMBER = 4, 4
A_TIMEBASE, A_SOURCE = struct.Struct("<HBBQLLLf16x"), struct.Struct("<HHLLIHHB")
A_STREAM, A_PART = struct.Struct("<HHLLQHH"), struct.Struct("<HHLL")
NUMBERS = {0x10: "B", 0x11: "b", 0x20: "H", 0x21: "h", 0x40: "I", 0x41: "i", 0x80: "Q", 0x81: "q", 0x42: "f",
           0x82: "d"}  # fmt: skip


def packet(kind: int, payload: bytes = b"") -> bytes:
    """A packet on the line."""
    whole = HEAD.pack(kind, 0, len(payload)) + payload
    return slip.encode(whole + zlib.crc32(whole).to_bytes(SUM, "little"))


def request(number: int, name: bytes, data: bytes = b"") -> bytes:
    """A question, or where there is `data` an order, by its name."""
    return packet(REQUEST, struct.pack("<HH", number, NAMED | len(name)) + name + data)


def all_but(names: Sequence[bytes]) -> bytes:
    """A pattern of whatever is no heartbeat and none of these questions."""
    asked = (re.escape(HEAD.pack(REQUEST, 0, 4 + len(n))) + b".." + re.escape(bytes([len(n), 0x80]) + n) for n in names)
    either = b"|".join((re.escape(HEAD.pack(HEARTBEAT, 0, 0)), *asked))
    return rb"^(?!\xc0(?:" + either + rb")[^\xc0]{4,8}\xc0\Z)"


def parse(frame: bytes) -> tuple[int, bytes] | None:
    """Type and payload between two ENDs; None where escape, sum, length or way are not right."""
    whole = slip.decode(frame)
    if (
        whole is None
        or len(whole) < HEAD.size + SUM
        or zlib.crc32(whole[:-SUM]).to_bytes(SUM, "little") != whole[-SUM:]
    ):
        return None
    kind, hops, length = HEAD.unpack_from(whole)
    if length > LONGEST or length + HEAD.size + hops + SUM != len(whole):
        return None
    return (kind, whole[HEAD.size : -SUM]) if not hops else (-1, b"")  # of another device, behind a hub


def number_of(row: bytes) -> int:
    """Which sample of the stream this is."""
    return int.from_bytes(row[:NUMBER], "little")


@dataclass(frozen=True)
class RowLayout:
    """Where three numbers stand in a row of the stream, in which unit, and how long from one row to the next."""

    at: int
    numbers: struct.Struct
    unit: str
    period_s: float

    @property
    def least(self) -> int:
        """Bytes of a row that has them; its own number comes first."""
        return NUMBER + self.at + self.numbers.size

    def of(self, data: bytes) -> tuple[float, ...]:
        """The three of a row that is long enough."""
        return self.numbers.unpack_from(data, NUMBER + self.at)


class Description:
    """What the device says of its stream 0, in any order."""

    def __init__(self) -> None:
        self._periods_s = dict[int, float]()  # of each timebase
        self._sources = dict[int, tuple[str, str, str]]()  # name, format, unit
        self._stream: tuple[int, int, tuple[int, ...]] | None = None  # timebase, periods of it, sources

    def take(self, kind: int, payload: bytes) -> None:
        """A packet that describes something; what is too short or unknown is passed over."""
        known: dict[int, Callable[[bytes], None]] = {
            TIMEBASE: self._timebase, SOURCE: self._source, STREAM: self._parts,
        }  # fmt: skip
        try:
            if kind in known:
                known[kind](payload)
        except (struct.error, KeyError, ZeroDivisionError):
            return

    def place(self, name: str) -> RowLayout | None:
        """Of a source of three numbers; None as long as that is not described."""
        if self._stream is None or self._stream[0] not in self._periods_s:
            return None
        timebase, periods, sources = self._stream
        at = 0
        for number in sources:
            if number not in self._sources:
                return None
            called, form, unit = self._sources[number]
            if called == name and len(form) == 3:
                return RowLayout(at, struct.Struct("<" + form), unit, periods * self._periods_s[timebase])
            at += struct.calcsize("<" + form)
        return None

    def names(self) -> str:
        """The sources that it has spoken of."""
        return ", ".join(sorted(name for name, _, _ in self._sources.values())) or "nothing"

    def _timebase(self, payload: bytes) -> None:
        number, _, _, _, counts_us, parts, *_ = A_TIMEBASE.unpack_from(payload)
        self._periods_s[number] = counts_us / parts * 1e-6

    def _source(self, payload: bytes) -> None:
        number, *_, channels, kind = A_SOURCE.unpack_from(payload)
        words = payload[A_SOURCE.size :].decode("utf-8", "replace").rstrip("\0").split("\t")
        self._sources[number] = words[0], NUMBERS[kind] * channels, words[3] if len(words) > 3 else ""

    def _parts(self, payload: bytes) -> None:
        stream, timebase, periods, _, _, parts, _ = A_STREAM.unpack_from(payload)
        if stream == 0 and len(payload) > A_STREAM.size:
            places = range(A_STREAM.size, A_STREAM.size + parts * A_PART.size, A_PART.size)
            self._stream = timebase, periods, tuple(A_PART.unpack_from(payload, at)[0] for at in places)

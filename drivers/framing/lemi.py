"""LEMI-025 records: 153 bytes, begun by a tag, without end sign or checksum.

Tag, a byte, six of BCD time, eight words (temperatures, biases), a byte, 10 × (x, y, z) as floats [µT], two bytes,
supply, GPS state, a byte; little-endian.
"""

from __future__ import annotations

import re
import struct
from collections.abc import Iterable
from dataclasses import dataclass
from datetime import UTC, datetime

import numpy as np
from numpy.typing import NDArray

LAYOUT = struct.Struct("<4sb6B8hb30f3BcB")
TAG, SAMPLES, LENGTH = 4, 10, 153
TAGS = re.compile(rb"(L\d{3}).(.{6})", re.DOTALL)
TIME, FIELD, STATE = slice(2, 8), slice(17, 47), 50


@dataclass(frozen=True, slots=True, eq=False)
class Record:
    """One second: `xyz_uT` (10, 3), the GPS second as s since 1970, and whether GPS has a fix."""

    second_s: float
    gps: bool
    xyz_uT: NDArray[np.float64]
    sensor_C: float
    electronics_C: float
    supply_V: float
    raw: bytes


def parse(frame: bytes, most_uT: float) -> Record | None:
    """The record in 153 bytes; None where time, GPS state or a field beyond `most_uT` say that it is none.

    A record that lost bytes holds the beginning of the next: a second tag inside is refused too. Digits of a float
    that turned over on the way cannot be noticed.
    """
    numbers = LAYOUT.unpack(frame)
    second_s, state = _second(numbers[TIME]), numbers[STATE]
    xyz = np.array(numbers[FIELD], dtype=float).reshape(SAMPLES, 3)
    inside = frame.find(frame[:TAG], 1) >= 0
    if second_s is None or state not in (b"A", b"P") or inside or not (np.abs(xyz) <= most_uT).all():
        return None
    return Record(second_s, state == b"A", xyz, numbers[8] / 100, numbers[9] / 100, numbers[49] / 10, frame)


class Records:
    """Cuts stamped pieces at the tags; what is no record costs the bytes up to the next tag."""

    def __init__(self, tag: bytes, most_uT: float) -> None:
        self._tag, self._most_uT = tag, most_uT
        self._rest, self._stamps = b"", list[tuple[int, float]]()  # where in `rest` each piece began, and when
        self._bad = list[float]()

    def feed(self, pieces: Iterable[tuple[float, bytes]]) -> list[tuple[float, Record]]:
        """Records stamped at their first byte."""
        records = list[tuple[float, Record]]()
        for stamp, data in pieces:
            self._stamps.append((len(self._rest), stamp))
            self._rest += data
            while (taken := self._take()) is not None:
                records += [taken] if isinstance(taken, tuple) else []
        return records

    def taken_bad(self) -> list[float]:
        """When tags came that began no record, since this was asked last."""
        bad, self._bad = self._bad, []
        return bad

    def _take(self) -> tuple[float, Record] | bool | None:
        """The next record, True where a tag began none, None where more bytes are needed."""
        at = self._rest.find(self._tag)
        if at < 0:
            self._drop(max(len(self._rest) - TAG + 1, 0))
            return None
        self._drop(at)
        if len(self._rest) < LENGTH:
            return None
        stamp = self._stamps[0][1]
        record = parse(self._rest[:LENGTH], self._most_uT)
        self._drop(1 if record is None else LENGTH)
        if record is None:
            self._bad.append(stamp)
            return True
        return stamp, record

    def _drop(self, count: int) -> None:
        self._rest = self._rest[count:]
        moved = [(at - count, stamp) for at, stamp in self._stamps]
        before = [stamp for at, stamp in moved if at <= 0]
        self._stamps = ([(0, before[-1])] if before else []) + [m for m in moved if m[0] > 0]


def build(tag: bytes, second_s: float, gps: bool, xyz_uT: NDArray[np.float64]) -> bytes:
    """A record of the ten samples `xyz_uT` (10, 3)."""
    moment = datetime.fromtimestamp(second_s, UTC)
    digits = (moment.year - 2000, moment.month, moment.day, moment.hour, moment.minute, moment.second)
    time = [value // 10 * 16 + value % 10 for value in digits]
    field = xyz_uT.ravel().tolist()
    return LAYOUT.pack(tag, 0, *time, 2150, 2480, 0, 0, 0, 0, 0, 0, 0, *field, 0, 0, 120, b"A" if gps else b"P", 0)


def tag_in(came: bytes) -> str:
    """A tag with a moment behind it; "" where there is none."""
    found = (tag for tag in TAGS.finditer(came) if _second(tuple(tag[2])) is not None)
    return next((tag[1].decode() for tag in found), "")


def _second(bcd: tuple[int, ...]) -> float | None:
    if any(digit >> 4 > 9 or digit & 15 > 9 for digit in bcd):
        return None
    year, month, day, hour, minute, second = ((digit >> 4) * 10 + (digit & 15) for digit in bcd)
    try:
        return datetime(2000 + year, month, day, hour, minute, second, tzinfo=UTC).timestamp()
    except ValueError:
        return None

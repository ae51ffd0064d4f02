"""HMR2300 samples: 28 characters, or seven bytes whose end sign occurs inside them too."""

from __future__ import annotations

import re
import struct
from collections.abc import Iterable

from labcal.errors import InstrumentError

END = b"\r"
LENGTH, SURE = 7, 28  # bytes of a binary frame, and how many are looked at to find its place again
LOST = 1400  # bytes in which two places for the end sign stay as good as each other
AXIS = rb"([ +-])([ \d]\d),(\d{3})"
ASCII_FRAME = re.compile(rb"%b  %b  %b  \r" % (AXIS, AXIS, AXIS))  # a byte that is lost or too much is noticed

Counts = list[int]
Taken = tuple[Counts | None, bytes] | None  # counts of a frame (None where it is no good) and its bytes; None: not yet


class Frames:
    """Cuts stamped pieces into samples, in any cutting, and leaves the first `skip` out.

    `bad` collects when frames came that were no good.
    """

    def __init__(self, name: str, *, binary: bool, skip: int = 0) -> None:
        self._name, self._skip = name, skip
        self._take = self._take_binary if binary else self._take_ascii
        self._rest, self._stamp, self._in_step = b"", 0.0, True
        self.bad: list[float] = []

    def feed(self, pieces: Iterable[tuple[float, bytes]]) -> list[tuple[float, Counts, bytes]]:
        """Samples stamped at their first byte: x, y, z in counts, and the frame."""
        samples = []
        for stamp, data in pieces:
            if not self._rest:
                self._stamp = stamp
            self._rest += data
            while (taken := self._take()) is not None:
                counts, frame = taken
                if counts is None:
                    self.bad.append(self._stamp)
                else:
                    samples.append((self._stamp, counts, frame))
                self._stamp = stamp
        skipped = min(self._skip, len(samples))
        self._skip -= skipped
        return samples[skipped:]

    def _take_ascii(self) -> Taken:
        frame, end, rest = self._rest.partition(END)
        if not end:
            return None
        self._rest = rest
        found = ASCII_FRAME.fullmatch(frame + end)
        if found is None:
            return None, frame
        parts = found.groups()
        return [(-1 if parts[k] == b"-" else 1) * int(parts[k + 1] + parts[k + 2]) for k in (0, 3, 6)], frame + end

    def _take_binary(self) -> Taken:
        if len(self._rest) < LENGTH or not (self._in_step or self._find_step()):
            return None
        if self._rest[LENGTH - 1 : LENGTH] != END:
            self._in_step = False
            return None, b""
        frame, self._rest = self._rest[:LENGTH], self._rest[LENGTH:]
        return list(struct.unpack(">3h", frame[:6])), frame

    def _find_step(self) -> bool:
        """After a slip: drop bytes up to a frame, once only one of the seven places has all its end signs.

        What stands behind no end sign may hold the byte that came too much: it is dropped too.
        """
        while len(self._rest) >= SURE:
            places = self._places()
            if len(places) > 1:
                return False
            if len(places) == 1:
                begin = places[0]
                self._rest = self._rest[begin if self._rest[begin - 1 : begin] == END else begin + LENGTH :]
                self._in_step = True
                return True
            self._rest = self._rest[LENGTH:]
        return False

    def _places(self) -> list[int]:
        """Where frames may begin, by as few of the bytes as tell; more than one where all of them do not."""
        places: list[int] = []
        for length in range(SURE, len(self._rest) + 1):
            seen = self._rest[:length]
            places = [p for p in range(LENGTH) if not seen[p + LENGTH - 1 :: LENGTH].strip(END)]
            if len(places) < 2:
                return places
        if len(self._rest) > LOST:
            raise InstrumentError(f"{self._name}: its frames cannot be told apart.", fault="wrong reply")
        return places

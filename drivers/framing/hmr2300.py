"""HMR2300 samples: 28 characters, or seven bytes whose end sign occurs inside them too."""

from __future__ import annotations

import re
import struct
from collections import deque
from collections.abc import Iterable
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

NT_PER_COUNT = 1e5 / 15000
END = b"\r"
LENGTH = 7  # of a binary frame, its end sign included
COLUMNS = (slice(7), slice(9, 16), slice(18, 25))  # of a frame's 28 bytes; a byte lost or too much is noticed
BETWEEN = re.compile(rb".{7}  .{7}  .{7}  \r", re.DOTALL)
COUNT = re.compile(rb" *([+-]?) *(\d\d?,\d{3}|\d{1,5})")  # below 1000 blanks stand for digits and comma
UPPER = frozenset((0, 2, 4))  # places of the bytes that stand still where the field does
LONG, SHORT = 16, 4  # frames that are waited for where places are in doubt, and where they are as before

Counts = list[int]
Sample = tuple[float, Counts, bytes]
Pieces = Iterable[tuple[float, bytes]]
Places = frozenset[int]
NOWHERE = Places()


class TextFrames:
    """Cuts stamped pieces into samples, in any cutting, and leaves the first `skip` out.

    `bad` collects when frames came that were no good.
    """

    lost, familiar = False, NOWHERE  # text shows where it ends

    def __init__(self, skip: int = 0) -> None:
        self._skip, self._rest, self._stamp = skip, b"", 0.0
        self.bad: list[float] = []

    def feed(self, pieces: Pieces) -> list[Sample]:
        """Samples stamped at their first byte: x, y, z in counts, and the frame."""
        samples: list[Sample] = []
        for stamp, data in pieces:
            self._stamp = self._stamp if self._rest else stamp
            *frames, self._rest = (self._rest + data).split(END)
            for frame in frames:
                self._take(frame + END, samples)
                self._stamp = stamp
        self._skip, skipped = max(0, self._skip - len(samples)), self._skip
        return samples[skipped:]

    def _take(self, frame: bytes, samples: list[Sample]) -> None:
        found = [one for column in COLUMNS if (one := COUNT.fullmatch(frame[column]))]
        if len(found) < len(COLUMNS) or not BETWEEN.fullmatch(frame):
            self.bad.append(self._stamp)
            return
        samples.append((self._stamp, [int(one[1] + one[2].replace(b",", b"")) for one in found], frame))


class BinaryFrames:
    """Cuts a stream whose first byte begins a frame; a frame is given once those behind it say that it is in step.

    Bytes that are lost or too much shift every place of the frames that follow, that of the end sign too. So a frame
    is in step where no other place has had 0Dh in all the frames since. Where one has (a field whose bytes are 0Dh
    stands still), the places that have it are held against those of the frames before: no shift of some of seven
    places gives the same places again, so they are the same only where nothing was shifted. Where there were none
    before and now are upper bytes', a field has come there. In all other cases it is `lost` and gives no more: the
    stream must be begun again. At first there is nothing to hold them against but `familiar`, where 0Dh stood when the
    one before this was lost: two beginnings that agree are no shift.
    `bad` collects when the frames came that were not given.
    """

    def __init__(self, skip: int = 0, familiar: Places = NOWHERE) -> None:
        self._skip, self.familiar = skip, familiar
        self._rest, self._stamp, self.lost = b"", 0.0, False
        self._held: deque[tuple[float, bytes, Places]] = deque()
        self._before: deque[Places] = deque(maxlen=LONG)
        self.bad: list[float] = []

    def feed(self, pieces: Pieces) -> list[Sample]:
        """Samples stamped at their first byte: x, y, z in counts, and the frame; none any more once it is lost."""
        samples: list[Sample] = []
        for stamp, data in pieces:
            self._stamp = self._stamp if self._rest else stamp
            self._rest += data
            while len(self._rest) >= LENGTH and not self.lost:
                frame, self._rest = self._rest[:LENGTH], self._rest[LENGTH:]
                self._held.append((self._stamp, frame, _places(frame)))
                self._stamp = stamp
                if frame[-1:] == END:
                    self._give(samples)
                else:
                    self._lose(NOWHERE)
        self._skip, skipped = max(0, self._skip - len(samples)), self._skip
        return samples[skipped:]

    def _give(self, samples: list[Sample]) -> None:
        """The frames that are in step by what has come since."""
        while len(self._held) > 1 and not self.lost:
            (stamp, frame, places), *since = self._held
            if _common(later for *_, later in since):
                settled = _common(later for *_, later in since[1:] or since)  # the first may hold what was put in
                if len(since) < (SHORT if settled == self._usual else LONG):
                    return
                if not self._unshifted(settled):
                    self._lose(settled)
                    return
            self._held.popleft()
            self._before.append(places)
            samples.append((stamp, list(struct.unpack(">3h", frame[:6])), frame))

    @property
    def _usual(self) -> Places:
        """Places, but the end sign's, that had 0Dh in all of the last frames."""
        return _common(self._before) if len(self._before) == LONG else NOWHERE

    def _unshifted(self, places: Places) -> bool:
        """Whether 0Dh stands where it does without a shift."""
        if len(self._before) < LONG:
            return places == self.familiar
        return places <= UPPER if not self._usual else places == self._usual

    def _lose(self, also: Places) -> None:
        self.lost, self.familiar = True, self._usual or also
        self.bad += [stamp for stamp, *_ in self._held]
        self._held.clear()


class BinaryReplies:
    """Replies that were asked for, each a piece of its own: one that is longer or shorter than a frame is no good."""

    lost, familiar = False, NOWHERE

    def __init__(self, skip: int = 0) -> None:
        self._skip = skip
        self.bad: list[float] = []

    def feed(self, pieces: Pieces) -> list[Sample]:
        """Samples stamped as the pieces are: x, y, z in counts, and the frame."""
        samples: list[Sample] = []
        for stamp, data in pieces:
            if len(data) == LENGTH and data.endswith(END):
                samples.append((stamp, list(struct.unpack(">3h", data[:6])), data))
            else:
                self.bad.append(stamp)
        self._skip, skipped = max(0, self._skip - len(samples)), self._skip
        return samples[skipped:]


class Format(Protocol):
    """What reading frames again needs of the settings."""

    @property
    def format(self) -> str:
        """The word ascii, or binary."""
        ...


def samples_again(settings: Format, raw: bytes) -> NDArray[np.float64]:
    """The samples (n, 3) [nT] of frames that stand in `raw` one after the other, as a record keeps them."""
    binary = settings.format == "binary"
    cuts = [raw[k : k + LENGTH] for k in range(0, len(raw), LENGTH)] if binary else [raw]
    found = (BinaryReplies() if binary else TextFrames()).feed([(0.0, cut) for cut in cuts])
    return np.array([counts for _, counts, _ in found], dtype=float).reshape(-1, 3) * NT_PER_COUNT


def _common(places: Iterable[Places]) -> Places:
    return frozenset.intersection(*places)


def _places(frame: bytes) -> Places:
    return frozenset(place for place in range(LENGTH - 1) if frame[place : place + 1] == END)

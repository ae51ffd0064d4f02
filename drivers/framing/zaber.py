"""How a Zaber stage is spoken to: requests with an id, what it says with every reply and unasked, its checksum."""

from __future__ import annotations

import re
from dataclasses import dataclass, field

from labcal.bench.links import Link, quoted
from labcal.errors import InstrumentError

REPLY = re.compile(rb"@(\d\d) (\d) (?:(\d\d) )?(OK|RJ) (IDLE|BUSY) ([!-~]{2}) ([ -9;-~]*)(?::([0-9A-F]{2}))?\r\n")
WHOLE = re.compile(r"-?\d+", re.ASCII)
FLAGS = re.compile(r"\d\d(?: [A-Z]{2})*", re.ASCII)  # how many, and which
MOST_OLD = 20  # older replies and what nobody asked for, before the reply to a request

UNASKED = (b"!", b"#")  # how alerts (where comm.alert is 1) and lines of information begin
SPEED_DATA = 1.6384  # speed data = microsteps/s · 1.6384
NOT_HOMED, TURNED, INTERRUPTED = ("WR", "WH"), "NC", "NI"  # no reference position; by its knob; a move cut short


@dataclass(frozen=True, slots=True)
class Reply:
    """What the device said, and the state that it says with everything; of its flags the one that goes first."""

    data: str
    busy: bool
    warning: str


@dataclass
class Conversation:
    """Requests to one axis, and of all that comes the reply to each. `summed`: every reply must have a checksum."""

    name: str
    link: Link
    address: int
    axis: int
    timeout_s: float
    summed: bool = False  # it has sent one
    _id: int = field(default=0, init=False)

    def number(self, words: str) -> tuple[int, Reply]:
        """The whole number that is asked for, and what came with it."""
        reply = self.ask(words)
        if not WHOLE.fullmatch(reply.data):
            raise self.wrong(words, reply)
        return int(reply.data), reply

    def flags(self) -> set[str]:
        """All that are up: a reply shows only the first of them."""
        reply = self.ask("warnings")
        if not FLAGS.fullmatch(reply.data):
            raise self.wrong("warnings", reply)
        return set(reply.data.split()[1:])

    def ask(self, words: str) -> Reply:
        """Tell or ask, once. Raises InstrumentError: silent, refused, wrong reply."""
        self._id = (self._id + 1) % 96
        request = f"/{self.address} {self.axis} {self._id:02d} {words}".rstrip().encode() + b"\r\n"
        for _ in range(MOST_OLD):
            frame = self.link.ask(request, end=b"\r\n", timeout_s=self.timeout_s).lstrip(b"\r\n")
            if (reply := self._matched(frame, words)) is not None:
                return reply
            request = b""  # an older reply, another device's, or an alert: the one to this request is still to come
        raise InstrumentError(f"{self.name}: it says much, but does not answer {words!r}.", fault="wrong reply")

    def wrong(self, words: str, reply: Reply) -> InstrumentError:
        """The error for a reply that is none to `words`."""
        return InstrumentError(f"{self.name}: {words!r} was answered {quoted(reply.data)}.", fault="wrong reply")

    def _matched(self, frame: bytes, words: str) -> Reply | None:
        if frame.startswith(UNASKED):
            return None
        found = REPLY.fullmatch(frame)
        if found is None or not self._sound(frame, found[8]):
            raise InstrumentError(f"{self.name}: {quoted(frame)} is no valid reply.", fault="wrong reply")
        if found[3] is None or (int(found[1]), int(found[3])) != (self.address, self._id):
            return None
        if found[4] == b"RJ":
            raise InstrumentError(f"{self.name}: {words!r} was rejected: {quoted(found[7])}.", fault="refused")
        return Reply(found[7].decode(), found[5] == b"BUSY", found[6].decode())

    def _sound(self, frame: bytes, sum_: bytes | None) -> bool:
        fits = sum_ is not None and checksum(frame[1:-5]) == sum_.decode()
        self.summed = self.summed or fits
        return fits or (sum_ is None and not self.summed)


def checksum(body: bytes) -> str:
    """The protocol's LRC: the negated sum of all bytes after the first character, as two hex digits."""
    return f"{-sum(body) & 0xFF:02X}"

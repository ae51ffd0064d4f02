"""The line protocol labcal-coil/1 of boards that drive coils (docs/microcontroller.md): numbered, with a checksum."""

from __future__ import annotations

import re

from labcal.bench.clock import Clock
from labcal.bench.links import Link, quoted
from labcal.errors import InstrumentError

LINE = re.compile(rb"(\d{1,3}) (OK|ERR) ([ -)+-~]+)\*([0-9A-F]{2})\r?\n")
LATE = 32  # lines with other numbers that may come before an answer
WHY = {
    "watchdog": "its watchdog has taken it to zero",
    "off": "its output is off",
    "range": "that is more than it may drive",
    "channel": "it has no such channel",
    "word": "it does not know that word",
    "number": "it does not take that number",
}


def crc8(data: bytes) -> int:
    """CRC-8 with polynomial 07h from 0, unreflected: F4h for "123456789"."""
    value = 0
    for byte in data:
        value ^= byte
        for _ in range(8):
            value = (value << 1 ^ 0x07) & 0xFF if value & 0x80 else value << 1
    return value


def sealed(text: str) -> bytes:
    """A line with its checksum."""
    return b"%s*%02X\n" % (text.encode(), crc8(text.encode()))


def opened(line: bytes) -> tuple[int, bool, str] | None:
    """Number, whether it is an OK, and the words of an answer; None where it is none, or its checksum is wrong."""
    found = LINE.fullmatch(line)
    if found is None or crc8(line.rpartition(b"*")[0]) != int(found[4], 16):
        return None
    return int(found[1]), found[2] == b"OK", found[3].decode()


class CoilLine:
    """Questions to one channel of a board; several channels may share its line, each with numbers of its own."""

    def __init__(self, name: str, link: Link, clock: Clock, channel: int, timeout_s: float) -> None:
        self._name, self._link, self._clock = name, link, clock
        self._channel, self._timeout_s, self._count = channel, timeout_s, 0

    def send(self, words: str) -> int:
        """Put it on the line and wait for nothing; what was left there is dropped. Returns its number."""
        self._count = (self._count + 1) % 32
        number = self._count << 3 | self._channel & 7
        self._link.flush()
        self._link.send(sealed(f"{number} {words}"))
        return number

    def ask(self, words: str) -> str:
        """What it answers. Raises InstrumentError: silent; wrong reply; refused or tripped, in its own words."""
        number, until_s = self.send(words), self._clock.now() + self._timeout_s
        for _ in range(LATE):
            line = self._link.ask(b"", end=b"\n", timeout_s=max(until_s - self._clock.now(), 0.0))
            answer = opened(line)
            if answer is None:
                raise InstrumentError(f"{self._name}: {quoted(line)} came to {words!r}.", fault="wrong reply")
            if answer[0] == number:
                return answer[2] if answer[1] else self._refused(words, answer[2])
        message = f"{self._name}: only late answers came to {words!r}."
        raise InstrumentError(message, fault="out of step", remedy="Does another program talk on its line?")

    def _refused(self, words: str, why: str) -> str:
        message = f"{self._name}: {words!r} failed: {WHY.get(why, quoted(why))}."
        if why == "watchdog":
            raise InstrumentError(message, fault="tripped", remedy="Try again: its output has to go on anew.")
        raise InstrumentError(message, fault="refused")

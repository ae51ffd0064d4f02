"""Messages of Thorlabs' APT protocol: a head of six bytes, and behind some of them data; little-endian throughout."""

from __future__ import annotations

import struct
from dataclasses import dataclass
from typing import Any

from labcal.bench.links import Link, quoted
from labcal.errors import InstrumentError

HOST, USB = 0x01, 0x50  # places: this computer, a controller of one motor
WITH_DATA = 0x80  # set in the destination where data follow, whose length stands in the place of two parameters
HEAD, LONGEST = 6, 128
REQ_INFO, GET_INFO, START_UPDATES, STOP_UPDATES = 0x0005, 0x0006, 0x0011, 0x0012
RICH_RESPONSE = 0x0081  # a fault, told unasked
SET_ENABLED = 0x0210
REQ_POSITION, GET_POSITION = 0x0411, 0x0412
SET_VELOCITY, REQ_VELOCITY, GET_VELOCITY = 0x0413, 0x0414, 0x0415  # least, acceleration, greatest
REQ_BITS, GET_BITS = 0x0429, 0x042A
SET_HOMING, REQ_HOMING, GET_HOMING = 0x0440, 0x0441, 0x0442  # direction, switch, velocity, offset
HOME, HOMED, MOVE_ABSOLUTE, COMPLETED, STOP, STOPPED = 0x0443, 0x0444, 0x0453, 0x0464, 0x0465, 0x0466
UNASKED = {HOMED, COMPLETED, STOPPED, 0x0481, 0x0491}  # told when they happen, and status updates
MOST_UNASKED = 100  # of them before an answer: ten seconds of status updates
CHANNEL = 1
FORMS = {  # of their data
    GET_POSITION: "<Hi", GET_VELOCITY: "<Hiii", GET_BITS: "<HI", GET_HOMING: "<HHHii", GET_INFO: "<I8sH4s60s3H",
    SET_VELOCITY: "<Hiii", SET_HOMING: "<HHHii", MOVE_ABSOLUTE: "<Hi",
}  # fmt: skip


STEPPER, BRUSHED = 53.68, 2048 / 6e6 * 65536  # counts of velocity to a count a second
MODELS = {  # counts a degree where the controller tells the stage, and how it counts velocity
    "K10CR1": (409_600 / 3, STEPPER), "KDC101": (1919.6418578623391, BRUSHED), "TDC001": (1919.6418578623391, BRUSHED),
    "KST101": (0.0, STEPPER),
}  # fmt: skip
FAULTS = {  # bits of its status
    14: "it lost its way (motion error)", 17: "its motor is too hot", 18: "its supply is too low",
    24: "its motor's current limit was reached", 25: "its encoder failed", 26: "its motor's current is too high",
    30: "an error",
}  # fmt: skip


def short(number: int, first: int = 0, second: int = 0, to: int = USB, source: int = HOST) -> bytes:
    """A message without data."""
    return struct.pack("<HBBBB", number, first, second, to, source)


def long(number: int, data: bytes, to: int = USB, source: int = HOST) -> bytes:
    """A message with data."""
    return struct.pack("<HHBB", number, len(data), to | WITH_DATA, source) + data


@dataclass
class Conversation:
    """Questions to a controller of one motor, and their answers."""

    name: str
    link: Link
    timeout_s: float

    def send(self, number: int, second: int = 0) -> None:
        """Send a message without data; nothing answers. Those of the controller itself name no channel."""
        self.link.send(short(number, CHANNEL if number > 0xFF else 0, second))

    def set(self, number: int, *values: int) -> None:
        """Send a message with the values of its form behind the channel; nothing answers."""
        self.link.send(long(number, struct.pack(FORMS[number], CHANNEL, *values)))

    def ask(self, number: int) -> tuple[int, ...]:
        """The values behind the channel in the answer, whose number is the next."""
        channel, *values = self.exchange(number)
        if channel != CHANNEL:
            raise self._wrong(f"channel {channel} answered")
        return tuple(values)

    def exchange(self, asked: int) -> tuple[Any, ...]:
        """Ask, and take the data of the answer; what is told unasked is passed over, but for faults."""
        wanted = asked + 1
        self.link.flush()
        self.send(asked)
        number, data = self._answer(wanted)
        if number == RICH_RESPONSE:
            text = data[4:].split(b"\0")[0].decode("ascii", "replace")
            raise InstrumentError(f"{self.name}: it reports {quoted(text)}.", fault="stage fault")
        if number != wanted or len(data) != struct.calcsize(FORMS[wanted]):
            raise self._wrong(f"message {number:04X} with {len(data)} bytes is not {wanted:04X}")
        return struct.unpack(FORMS[wanted], data)

    def _answer(self, wanted: int) -> tuple[int, bytes]:
        """The first message that is not told unasked; of those no more than so many are waited through."""
        for _ in range(MOST_UNASKED):
            if (got := self._message(wanted))[0] not in UNASKED:
                return got
        raise self._wrong(f"it tells {MOST_UNASKED} things unasked and does not answer {wanted - 1:04X}")

    def _message(self, wanted: int) -> tuple[int, bytes]:
        head = self.link.ask(b"", end=HEAD, timeout_s=self.timeout_s)
        number, length, to, _ = struct.unpack("<HHBB", head)
        if to == HOST and number in UNASKED:
            return number, b""
        if to != HOST | WITH_DATA or number not in {wanted, RICH_RESPONSE, *UNASKED} or not 0 < length <= LONGEST:
            self._pass_over(head, wanted)
            number, length = wanted, struct.calcsize(FORMS[wanted])
        return number, self.link.ask(b"", end=length, timeout_s=self.timeout_s)

    def _pass_over(self, head: bytes, wanted: int) -> None:
        """Up to the data of the answer: what is told unasked may have lost its beginning before the question."""
        self.link.give_back(0.0, head)
        answer = struct.pack("<HHBB", wanted, struct.calcsize(FORMS[wanted]), HOST | WITH_DATA, USB)
        try:
            self.link.ask(b"", end=answer, timeout_s=self.timeout_s)
        except InstrumentError as error:
            if error.fault != "silent":
                raise
            raise self._wrong(f"{quoted(head)} begins no message to this computer") from error

    def _wrong(self, what: str) -> InstrumentError:
        return InstrumentError(f"{self.name}: {what}.", fault="wrong reply")

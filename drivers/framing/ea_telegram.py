"""Telegrams of EA's PS 2000 B: start, node, object, up to 16 bytes of data, and the sum of all before as two bytes."""

from __future__ import annotations

from dataclasses import dataclass, field

from labcal.bench.clock import Clock
from labcal.bench.links import Link, quoted
from labcal.errors import InstrumentError

SEND, QUERY, ANSWER = 0xF0, 0x70, 0x80  # the upper half of a start; the lower is the length less one
ERROR = 0xFF  # the object of an acknowledgement (0) or a refusal
HEAD, SUM = 3, 2
TYPE, SERIAL, VOLTS, AMPS, WATTS, MAKER, VERSION = 0, 1, 2, 3, 4, 8, 9
OVP, OCP = 38, 39
SET_VOLTAGE, SET_CURRENT, CONTROL, STATE = 50, 51, 54, 71
LENGTHS = {SET_VOLTAGE: 2, SET_CURRENT: 2, STATE: 6, VOLTS: 4, AMPS: 4}  # of texts 16 at most
FULL = 25600  # counts of the nominal voltage or current
WHY = {
    3: "wrong checksum", 4: "wrong start", 5: "wrong node", 7: "no such object", 8: "wrong length",
    9: "no access: not under remote control", 15: "locked", 0x30: "above its limit", 0x31: "below its limit",
}  # fmt: skip


def telegram(start: int, node: int, number: int, data: bytes = b"", *, length: int | None = None) -> bytes:
    """A telegram; a query states the `length` of the data that it asks for."""
    body = bytes([start + (len(data) if length is None else length) - 1, node, number]) + data
    return body + sum(body).to_bytes(SUM, "big")


def data_of(answer: bytes) -> tuple[int, bytes] | None:
    """Object and data of an answer; None where its sum or its length is wrong."""
    body, said = answer[:-SUM], answer[-SUM:]
    if len(body) != HEAD + (answer[0] & 0x0F) + 1 or sum(body).to_bytes(SUM, "big") != said:
        return None
    return body[2], body[HEAD:]


@dataclass
class Conversation:
    """Telegrams to one node and their answers; `gap_s` is the least pause between two."""

    name: str
    link: Link
    clock: Clock
    node: int
    gap_s: float
    timeout_s: float
    _free_s: float = field(default=-1e9, init=False)

    def text(self, number: int) -> str:
        """An object that is text, up to its zero."""
        return self.ask(number).split(b"\0")[0].decode("latin-1").strip()

    def ask(self, number: int) -> bytes:
        """The data of an object."""
        length = LENGTHS.get(number, 16)
        found, data = self.exchange(telegram(QUERY, self.node, number, length=length))
        if found != number or (number in LENGTHS and len(data) != length):
            raise InstrumentError(f"{self.name}: object {found} answered, not {number}.", fault="wrong reply")
        return data

    def exchange(self, said: bytes) -> tuple[int, bytes]:
        """Send, and take object and data of the answer. Raises InstrumentError (refused) with its own word for it."""
        self.clock.wait_until(self._free_s)
        self.link.flush()  # what acknowledged telegrams that nobody waited for has come by now
        self.send(said)
        head = self.link.ask(b"", end=HEAD, timeout_s=self.timeout_s)
        if not ANSWER <= head[0] <= ANSWER + 15 or head[1] != self.node:
            self.link.flush()
            raise InstrumentError(f"{self.name}: {quoted(head)} begins no answer.", fault="wrong reply")
        rest = self.link.ask(b"", end=(head[0] & 0x0F) + 1 + SUM, timeout_s=self.timeout_s)
        if (found := data_of(head + rest)) is None:
            raise InstrumentError(f"{self.name}: an answer with a wrong checksum.", fault="wrong reply")
        if found[0] == ERROR and found[1] != b"\0":
            why = WHY.get(found[1][0], f"error {found[1][0]}")
            raise InstrumentError(f"{self.name}: it refuses: {why}.", fault="refused")
        return found

    def send(self, said: bytes) -> None:
        """Send, once it is ready to hear, and wait for nothing."""
        self.clock.wait_until(self._free_s)
        self.link.send(said)
        self._free_s = self.clock.now() + self.gap_s

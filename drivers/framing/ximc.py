"""Standa's 8SMC protocol: four letters, and behind some of them data with a CRC-16; little-endian."""

from __future__ import annotations

import struct
from dataclasses import dataclass
from typing import Any

from drivers.framing.rtu_crc import rtu_crc
from labcal.bench.links import Link, quoted
from labcal.errors import InstrumentError

NAME, CRC = 4, 2
REFUSALS = {b"errc": "it does not know the command", b"errd": "the data came damaged", b"errv": "a value was wrong"}
ANSWERS = {  # data of answers, as the protocol's tables have them
    "geti": "<4s2s8sBBH12x", "gser": "<I", "gets": "<5BihqihhhhhhIIB4x", "gpos": "<ihq6x", "gmov": "<IBHHIBB9x",
    "ghom": "<IBIBihH9x", "geng": "<HHIBHhBH12x", "gent": "<BB6x",
}  # fmt: skip
TELLS = {"move": "<ih6x", "movr": "<ih6x", "smov": "<IBHHIBB9x", "shom": "<IBIBihH9x"}


def packed(data: bytes) -> bytes:
    """Data and their CRC; nothing for none."""
    return data + rtu_crc(data) if data else b""


@dataclass
class Conversation:
    """Commands to a controller, each answered with its own name."""

    name: str
    link: Link
    timeout_s: float

    def ask(self, command: str) -> tuple[Any, ...]:
        """The data of the answer."""
        self._exchange(command.encode())
        form = ANSWERS[command]
        came = self.link.ask(b"", end=struct.calcsize(form) + CRC, timeout_s=self.timeout_s)
        if packed(came[:-CRC]) != came:
            self.link.flush()
            raise InstrumentError(f"{self.name}: {command}: an answer with a wrong checksum.", fault="wrong reply")
        return struct.unpack(form, came[:-CRC])

    def command(self, command: str, *values: int) -> None:
        """Tell, and see that it is acknowledged. Raises InstrumentError (refused) with its own word for it."""
        self._exchange(command.encode() + packed(struct.pack(TELLS[command], *values) if values else b""))

    def _exchange(self, said: bytes) -> None:
        self.link.flush()
        named = self.link.ask(said, end=NAME, timeout_s=self.timeout_s)
        if named in REFUSALS:
            message = f"{self.name}: {said[:NAME].decode()}: {REFUSALS[named]}."
            raise InstrumentError(message, fault="refused")
        if named != said[:NAME]:
            self.link.flush()
            message = f"{self.name}: {said[:NAME].decode()} was answered {quoted(named)}."
            raise InstrumentError(message, fault="wrong reply")

"""TMCL in its binary form: nine bytes each way, big-endian, the last the sum of the others."""

from __future__ import annotations

import struct
from dataclasses import dataclass

from labcal.bench.links import Link
from labcal.errors import InstrumentError

SIZE, FORM = 9, ">BBBBi"
FINE, LOADED = 100, 101
WRONG_CHECKSUM, INVALID_COMMAND, WRONG_TYPE, INVALID_VALUE = 1, 2, 3, 4
WHY = {
    WRONG_CHECKSUM: "wrong checksum", INVALID_COMMAND: "it does not know the command",
    WRONG_TYPE: "it does not know the parameter", INVALID_VALUE: "it does not take the value",
    5: "its memory is locked", 6: "not available", 9: "too much of it",
}  # fmt: skip

GET = 6
WHY_IT_STANDS = {  # a parameter of an axis: what its bits say
    10: {0: "its right limit switch is closed"}, 11: {0: "its left limit switch is closed"},
    207: {0: "it stalled", 1: "its encoder was too far off"},
    208: {1: "its driver is too hot", 3: "a short circuit of coil A", 4: "a short circuit of coil B"},
}  # fmt: skip


def summed(first: int, second: int, third: int, fourth: int, value: int) -> bytes:
    """A request (module, command, type, axis, value) or a reply (host, module, status, command, value)."""
    body = struct.pack(FORM, first, second, third, fourth, value)
    return body + bytes([sum(body) & 0xFF])


class Refused(InstrumentError):
    """The module answered, and did not do it; `status` is its own word for why."""

    def __init__(self, message: str, status: int) -> None:
        super().__init__(message, fault="refused")
        self.status = status


@dataclass
class Conversation:
    """Requests to one axis of a module, and their replies."""

    name: str
    link: Link
    address: int
    host: int
    axis: int
    timeout_s: float

    def ask(self, command: int, kind: int, value: int = 0) -> int:
        """The value of the reply. Raises Refused where its status is no success."""
        self.link.flush()
        said = summed(self.address, command, kind, self.axis, value)
        reply = self.link.ask(said, end=SIZE, timeout_s=self.timeout_s)
        host, module, status, echoed, held = struct.unpack(FORM, reply[:-1])
        if sum(reply[:-1]) & 0xFF != reply[-1] or (host, module, echoed) != (self.host, self.address, command):
            self.link.flush()
            raise InstrumentError(f"{self.name}: {reply.hex(' ')} is no reply to {said.hex(' ')}.", fault="wrong reply")
        if status not in (FINE, LOADED):
            message = f"{self.name}: command {command}, type {kind}: {WHY.get(status, f'status {status}')}."
            raise Refused(message, status)
        return int(held)

    def parameter(self, number: int) -> int | None:
        """A parameter of the axis; None where this module has none of that number."""
        try:
            return self.ask(GET, number)
        except Refused as refused:
            if refused.status != WRONG_TYPE:
                raise
            return None

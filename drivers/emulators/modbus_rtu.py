"""The slave's side of Modbus RTU, byte for byte: frames with CRC, silence to what is not its own."""

from __future__ import annotations

from collections.abc import Callable, Iterable

from drivers.emulators.line import Pieces, Replies

READ_COILS, READ_HOLDING, READ_INPUT, WRITE_COIL, WRITE_REGISTER, WRITE_REGISTERS = 1, 3, 4, 5, 6, 16
DIAGNOSTICS, WRITE_COILS = 8, 15
SILENCE_S = 0.1  # ends a frame, however short it is
ILLEGAL_FUNCTION, ILLEGAL_ADDRESS, ILLEGAL_VALUE = 1, 2, 3


class Refused(Exception):
    """The device answers with this exception code."""

    def __init__(self, code: int) -> None:
        super().__init__(code)
        self.code = code


def crc(frame: bytes) -> bytes:
    """CRC-16/MODBUS, low byte first."""
    value = 0xFFFF
    for byte in frame:
        value ^= byte
        for _ in range(8):
            value = (value >> 1) ^ 0xA001 if value & 1 else value >> 1
    return value.to_bytes(2, "little")


class RtuSlave(Replies):
    """Collects frames, checks them, asks `read`/`write` and answers after `delay_s`.

    `read(t, function, address, count)` gives bits or words, `write(t, function, address, values)` takes them; both
    raise Refused. `more`: functions that it knows beside these. `of_all`: those that it answers when all are asked.
    """

    more: tuple[int, ...] = ()
    of_all: tuple[int, ...] = ()

    def __init__(
        self,
        device: int,
        read: Callable[[float, int, int, int], list[int]],
        write: Callable[[float, int, int, list[int]], None],
        *,
        delay_s: float = 0.02,
    ) -> None:
        super().__init__()
        self.device, self._read, self._write, self._delay_s = device, read, write, delay_s
        self._frame, self._heard_s = b"", 0.0

    def take(self, t_s: float, data: bytes) -> None:
        """Bytes from the master; each frame that is whole, sound and meant for this device is answered."""
        if t_s > self._heard_s + SILENCE_S:
            self._frame = b""
        self._frame, self._heard_s = self._frame + data, t_s
        while len(self._frame) >= (length := self._length()):
            frame, self._frame = self._frame[:length], self._frame[length:]
            self._frame_came(t_s, frame)

    def _length(self) -> int:
        """Of the frame that has begun."""
        if self._frame[1:2] not in (b"\x0f", b"\x10"):
            return 8
        return 9 + (self._frame[6] if len(self._frame) > 6 else 256)

    def _frame_came(self, t_s: float, frame: bytes) -> None:
        if crc(frame[:-2]) != frame[-2:]:
            self._frame = b""  # what follows it is out of step
            return
        if frame[0] not in (0, self.device):
            return
        reply = self._answer(t_s, bytes([self.device]) + frame[1:-2])
        if frame[0] or not self.device or frame[1] in self.of_all:  # 0 is for all, and not answered as a rule
            self.say(t_s + self._delay_s, reply + crc(reply))

    def _answer(self, t_s: float, frame: bytes) -> bytes:
        function, address, value = frame[1], int.from_bytes(frame[2:4]), int.from_bytes(frame[4:6])
        try:
            if function in (READ_COILS, READ_HOLDING, READ_INPUT):
                return frame[:2] + self._packed(function, self._read(t_s, function, address, value))
            if function not in (WRITE_COIL, WRITE_REGISTER, WRITE_REGISTERS, *self.more):
                raise Refused(ILLEGAL_FUNCTION)
            if function != DIAGNOSTICS:
                self._write(t_s, function, address, _values(function, value, frame[7:]))
            elif address:
                raise Refused(ILLEGAL_FUNCTION)  # all but the echo
            return frame[:6]
        except Refused as refused:
            return bytes([frame[0], function | 0x80, refused.code])

    def _packed(self, function: int, values: list[int]) -> bytes:
        if function == READ_COILS:
            bits = sum(bit << k for k, bit in enumerate(values))
            data = bits.to_bytes((len(values) + 7) // 8, "little")
        else:
            data = b"".join(word.to_bytes(2) for word in values)
        return bytes([len(data)]) + data


def _values(function: int, value: int, data: bytes) -> list[int]:
    """What is written: one word, or as many words or bits as `value` says."""
    if function == WRITE_REGISTERS:
        return [int.from_bytes(data[2 * k : 2 * k + 2]) for k in range(value)]
    if function != WRITE_COILS:
        return [value]
    if len(data) != (value + 7) // 8:
        raise Refused(ILLEGAL_VALUE)
    return [data[k // 8] >> k % 8 & 1 for k in range(value)]


class RtuPair:
    """Several slaves on one RS-485 pair: all hear everything."""

    def __init__(self, slaves: Iterable[RtuSlave]) -> None:
        self._slaves = list(slaves)

    def take(self, t_s: float, data: bytes) -> None:
        """Bytes from the master."""
        for slave in self._slaves:
            slave.take(t_s, data)

    def emit(self, until_s: float) -> Pieces:
        """Replies that are due."""
        return sorted(piece for slave in self._slaves for piece in slave.emit(until_s))

    def due_s(self) -> float:
        """When the first of them is heard."""
        return min(slave.due_s() for slave in self._slaves)

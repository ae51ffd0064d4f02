"""Modbus TCP in front of an emulator that speaks RTU: the same requests behind another head, and no checksum."""

from __future__ import annotations

from collections import deque

from drivers.emulators.line import Pieces
from drivers.emulators.modbus_rtu import RtuSlave, crc

HEAD, LONGEST, STALE_S = 6, 254, 1.0


class NetworkPort:
    """Whatever unit a request names is this one; what is no Modbus TCP is dropped, half a request after a second."""

    wire = "modbus-tcp"

    def __init__(self, slave: RtuSlave) -> None:
        self._slave, self._came, self._heard_s = slave, b"", 0.0
        self._asked = deque[tuple[bytes, int]]()  # head and unit of a request, with its function

    def take(self, t_s: float, data: bytes) -> None:
        """Bytes from the host, of one request, a part of one, or several."""
        self._came = data if t_s > self._heard_s + STALE_S else self._came + data
        self._heard_s = t_s
        while len(self._came) > HEAD + 1:
            length = int.from_bytes(self._came[4:HEAD])
            if self._came[2:4] != b"\0\0" or not 2 <= length <= LONGEST:
                self._came = b""
            if len(self._came) < HEAD + length:
                return
            request, self._came = self._came[: HEAD + length], self._came[HEAD + length :]
            frame = bytes([self._slave.device]) + request[HEAD + 1 :]
            self._asked.append((request[:4] + request[HEAD : HEAD + 1], frame[1]))
            self._slave.take(t_s, frame + crc(frame))

    def emit(self, until_s: float) -> Pieces:
        """Replies that are due, each behind the head of its request."""
        return [(t_s, self._behind_its_head(frame[:-2])) for t_s, frame in self._slave.emit(until_s)]

    def due_s(self) -> float:
        """When the next of them is on the line."""
        return self._slave.due_s()

    def _behind_its_head(self, frame: bytes) -> bytes:
        head, function = self._asked.popleft()
        while function != frame[1] & 0x7F:  # one before it was not answered
            head, function = self._asked.popleft()
        return head[:4] + len(frame).to_bytes(2) + head[4:] + frame[1:]

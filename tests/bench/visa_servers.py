"""Stand-ins for instruments on the network: HiSLIP (IVI-6.1) and VXI-11 (its core channel), in front of an emulator."""

from __future__ import annotations

import socket
import struct
import threading
import time
from collections.abc import Callable
from contextlib import suppress
from typing import Any

from labcal.bench.clock import RealClock

MAV = 0x10


class Device:
    """An emulator asked by messages: what it says is kept until it is read."""

    def __init__(self, emulator: Any) -> None:
        self._emulator, self._clock, self._said, self._lock = emulator, RealClock(), b"", threading.Lock()

    def write(self, message: bytes) -> None:
        with self._lock:
            self._emulator.take(self._clock.now(), message)

    def waiting(self) -> bytes:
        """What it has said by now."""
        with self._lock:
            self._said += b"".join(piece for _, piece in self._emulator.emit(self._clock.now()))
            return self._said

    def read(self, within_s: float) -> bytes:
        until_s = time.monotonic() + within_s
        while not self.waiting().endswith(b"\n") and time.monotonic() < until_s:
            time.sleep(0.002)
        said, self._said = self._said, b""
        return said

    def status(self) -> int:
        return MAV if self.waiting() else 0

    def clear(self) -> None:
        self.waiting()
        self._said = b""


class Server:
    """Serves each connection in a thread of its own until it is closed."""

    def __init__(self, device: Device) -> None:
        self.device, self._open = device, list[socket.socket]()
        self._listener = socket.create_server(("127.0.0.1", 0))
        self.port = self._listener.getsockname()[1]
        threading.Thread(target=self._accept, daemon=True).start()

    def close(self) -> None:
        """No instrument any more."""
        self._listener.close()
        for connection in self._open:
            with suppress(OSError):
                connection.shutdown(socket.SHUT_RDWR)
            connection.close()

    def _accept(self) -> None:
        with suppress(OSError):
            while True:
                connection, _ = self._listener.accept()
                connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
                self._open.append(connection)
                threading.Thread(target=self._serve_one, args=(connection,), daemon=True).start()

    def _serve_one(self, connection: socket.socket) -> None:
        with suppress(OSError, EOFError), connection:
            self.serve(lambda count: exactly(connection, count), connection.sendall)

    def serve(self, take: Callable[[int], bytes], send: Callable[[bytes], None]) -> None:
        raise NotImplementedError


def exactly(connection: socket.socket, count: int) -> bytes:
    data = connection.recv(count, socket.MSG_WAITALL) if count else b""
    if len(data) != count:
        raise EOFError
    return data


class Hislip(Server):
    """IVI-6.1, chapter 6: both channels by their messages; the sub-address is told from others by its letters.

    A reply is announced (MAV) from when it is sent until the host says, by the lowest bit of a control code, that it
    has it (RMT-delivered).
    """

    name, sent = b"hislip0", False

    def serve(self, take: Callable[[int], bytes], send: Callable[[bytes], None]) -> None:
        message = b""
        while True:
            _, kind, control, parameter, length = struct.unpack("!2sBBIQ", take(16))
            payload = take(length)
            match kind:
                case 0 if payload == self.name:  # Initialize
                    reply = 1, 0, 0x0100_0007, b""
                case 0:
                    reply = 2, 3, 0, b"no such device"
                case 17:  # AsyncInitialize
                    reply = 18, 0, 0, b""
                case 15:  # AsyncMaximumMessageSize
                    reply = 16, 0, 0, payload
                case 21:  # AsyncStatusQuery
                    self.sent = self.sent and not control & 1
                    reply = 22, MAV if self.sent else 0, 0, b""
                case 19:  # AsyncDeviceClear
                    self.device.clear()
                    self.sent = False
                    reply = 23, 0, 0, b""
                case 8:  # DeviceClearComplete
                    reply = 9, 0, 0, b""
                case 6 | 7:  # Data, DataEnd
                    message, self.sent = message + payload, False
                    if kind == 6:
                        continue
                    self.device.write(message)
                    said = self.device.read(5.0) if b"?" in message else b""
                    message = b""
                    if not said:
                        continue
                    self.sent, reply = True, (7, 0, parameter, said)
                case _:
                    reply = 3, 1, 0, b"not known"
            send(struct.pack("!2sBBIQ", b"HS", *reply[:3], len(reply[3])) + reply[3])


class Vxi11(Server):
    """VXI-11, B.6: the core channel's calls over ONC RPC on TCP; no portmapper, for its port needs a privilege."""

    name = b"inst0"

    def serve(self, take: Callable[[int], bytes], send: Callable[[bytes], None]) -> None:
        while True:
            (mark,) = struct.unpack("!I", take(4))
            call = take(mark & 0x7FFF_FFFF)
            number, _, _, _, _, procedure = struct.unpack("!6I", call[:24])
            at = 24
            for _ in range(2):  # credentials and verifier
                (length,) = struct.unpack("!I", call[at + 4 : at + 8])
                at += 8 + (length + 3) // 4 * 4
            answer = struct.pack("!6I", number, 1, 0, 0, 0, 0) + self._answer(procedure, call[at:])
            send(struct.pack("!I", 0x8000_0000 | len(answer)) + answer)

    def _answer(self, procedure: int, given: bytes) -> bytes:
        match procedure:
            case 10:  # create_link: client, lock, lock's time, name
                (length,) = struct.unpack("!I", given[12:16])
                known = given[16 : 16 + length] == self.name
                return struct.pack("!iiII", 0 if known else 3, 7, 0, 1024)
            case 11:  # device_write
                (length,) = struct.unpack("!I", given[16:20])
                self.device.write(given[20 : 20 + length])
                return struct.pack("!iI", 0, length)
            case 12:  # device_read: link, size, times
                said = self.device.read(struct.unpack("!I", given[8:12])[0] / 1000)
                if not said:
                    return struct.pack("!iiI", 15, 0, 0)
                return struct.pack("!iiI", 0, 4, len(said)) + said + bytes(-len(said) % 4)
            case 13:  # device_readstb
                return struct.pack("!iI", 0, self.device.status())
            case 15:  # device_clear
                self.device.clear()
        return struct.pack("!i", 0)

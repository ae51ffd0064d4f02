"""can:// frames of a CAN bus, through python-can: can://socketcan/can0, can://virtual/NAME; listened to, never sent."""

from __future__ import annotations

import errno
import struct
from contextlib import suppress
from importlib import import_module
from typing import Any

from labcal.errors import InputError

HOW = "can:// needs python-can and cantools; install them: pip install 'labcal[can]'"
EXTENDED = 0x80000000  # set in the id of a frame with 29 bits
HEAD = struct.Struct(">IB")  # id, number of bytes; the bytes follow


class CanPort:
    """Each piece is one frame: its id (4 bytes, the first bit for an extended one), its length, its data."""

    byte_s = 0.0

    def __init__(self, address: str, options: dict[str, str]) -> None:
        interface, _, channel = address.partition("/")
        if not interface or not channel:
            raise InputError(f"link 'can://{address}': expected can://INTERFACE/CHANNEL, such as can://socketcan/can0")
        try:
            self._can: Any = import_module("can")
        except ImportError as error:
            raise InputError(f"link 'can://{address}': {HOW}") from error
        stated = {"bitrate": int(options["bitrate"])} if "bitrate" in options else {}
        try:
            self._bus = self._can.Bus(interface=interface, channel=channel, **stated)
        except OSError:
            raise
        except Exception as error:  # each interface says in its own way what it lacks
            if isinstance(error, self._can.CanInitializationError):
                raise OSError(errno.ENXIO, str(error)) from error
            raise InputError(f"link 'can://{address}': {error}") from error

    def read(self) -> bytes:
        """The next frame with data. Raises OSError when the bus is gone."""
        try:
            while (frame := self._bus.recv(timeout=0)) is not None:
                if not (frame.is_error_frame or frame.is_remote_frame):
                    number = frame.arbitration_id | (EXTENDED if frame.is_extended_id else 0)
                    return HEAD.pack(number, len(frame.data)) + bytes(frame.data)
        except self._can.CanError as error:
            raise OSError(errno.EIO, str(error)) from error
        return b""

    def write(self, data: bytes) -> None:
        """Nothing is ever sent."""
        raise OSError(errno.EPERM, "labcal only listens to a CAN bus")

    def there(self) -> bool:
        """It is, unless an error says otherwise."""
        return True

    def close(self) -> None:
        """Let go."""
        with suppress(self._can.CanError):
            self._bus.shutdown()

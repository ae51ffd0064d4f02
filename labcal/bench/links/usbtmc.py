"""usbtmc:// one instrument on USB 488.2, through the device file that Linux' own driver makes of it (/dev/usbtmc0)."""

from __future__ import annotations

import errno
import os
import stat
import struct
import sys

from labcal.bench.links.gone import stands
from labcal.bench.links.messages import TIMEOUT_S, Replies

LONGEST = 1 << 20
# linux/usb/tmc.h: _IO(91, 2), _IOW(91, 10, __u32) and _IOR(91, 18, unsigned char)
CLEAR, SET_TIMEOUT, READ_STB = 0x5B02, 0x40045B0A, 0x80015B12


class UsbtmcPort:
    """Messages, not bytes: one write is one message, and a reply may be read only after a message that asks for it."""

    byte_s = 0.0

    def __init__(self, path: str) -> None:
        self._file, self._path = _device(path), path
        self._replies = Replies(self)
        self._control(SET_TIMEOUT, struct.pack("I", round(1000 * TIMEOUT_S)))

    def read(self) -> bytes:
        """The reply that was asked for, once it is there. Raises OSError when the instrument is gone."""
        return self._replies.look()

    def write(self, data: bytes) -> None:
        """One message, which asks for a reply where it has a question mark."""
        os.write(self._file, data)
        self._replies.written(data)

    def status_byte(self) -> int | None:
        """As the kernel asks for it; None where kernel or instrument cannot."""
        status = self._control(READ_STB, b"\0")
        return status[0] if status else None

    def read_message(self) -> bytes:
        """One reply; b"" where none came in time."""
        try:
            return os.read(self._file, LONGEST)
        except OSError as error:
            if error.errno not in (errno.ETIMEDOUT, errno.EAGAIN):
                raise
            return b""

    def drop_reply(self) -> None:
        """A device clear."""
        self._control(CLEAR, b"")

    def there(self) -> bool:
        """Whether it is the device of its name yet."""
        return stands(self._file, self._path)

    def close(self) -> None:
        """Let go."""
        os.close(self._file)

    def _control(self, request: int, argument: bytes) -> bytes:
        """What the kernel answers; b"" where it refuses: older ones, and files that stand in for the device."""
        if sys.platform == "win32":
            return b""
        import fcntl

        try:
            return fcntl.ioctl(self._file, request, argument)
        except OSError:
            return b""


def _device(path: str) -> int:
    """The open device file. Raises ValueError for any other, into which messages would be written."""
    file = os.open(path, os.O_RDWR)
    if not stat.S_ISCHR(os.fstat(file).st_mode):
        os.close(file)
        raise ValueError(f"{path} is no device file")
    return file

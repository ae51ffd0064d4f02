"""usbtmc:// one instrument on USB 488.2, through the device file that Linux' own driver makes of it (/dev/usbtmc0)."""

from __future__ import annotations

import errno
import os
import stat
import struct
import sys
from contextlib import suppress

from labcal.bench.links.gone import stands

TIMEOUT_S = 2.0
LONGEST = 1 << 20
# linux/usb/tmc.h: _IO(91, 2) and _IOW(91, 10, __u32)
CLEAR, SET_TIMEOUT = 0x5B02, 0x40045B0A


class UsbtmcPort:
    """Messages, not bytes: one write is one message, and a reply may be read only after a message that asks for it.

    The read waits for the reply, at most `TIMEOUT_S`, and nothing else is done meanwhile.
    """

    byte_s = 0.0

    def __init__(self, path: str) -> None:
        self._file, self._path = _device(path), path
        self._asked = False
        self._control(SET_TIMEOUT, struct.pack("I", round(1000 * TIMEOUT_S)))

    def read(self) -> bytes:
        """The reply that was asked for. Raises OSError when the instrument is gone."""
        if not self._asked:
            return b""
        self._asked = False
        try:
            if reply := os.read(self._file, LONGEST):
                return reply
        except OSError as error:
            if error.errno not in (errno.ETIMEDOUT, errno.EAGAIN):
                raise
        self._control(CLEAR, b"")  # a reply that comes later must not answer the next question
        return b""

    def write(self, data: bytes) -> None:
        """One message, which asks for a reply where it has a question mark."""
        os.write(self._file, data)
        self._asked = b"?" in data

    def there(self) -> bool:
        """Whether it is the device of its name yet."""
        return stands(self._file, self._path)

    def close(self) -> None:
        """Let go."""
        os.close(self._file)

    def _control(self, request: int, argument: bytes) -> None:
        if sys.platform == "win32":
            return
        import fcntl

        with suppress(OSError):  # older kernels, and files that stand in for the real one, do not know it
            fcntl.ioctl(self._file, request, argument)


def _device(path: str) -> int:
    """The open device file. Raises ValueError for any other, into which messages would be written."""
    file = os.open(path, os.O_RDWR)
    if not stat.S_ISCHR(os.fstat(file).st_mode):
        os.close(file)
        raise ValueError(f"{path} is no device file")
    return file

"""file:// a text file that another program goes on writing: what is put at its end."""

from __future__ import annotations

import errno
import os
import stat
import time
from glob import glob
from typing import BinaryIO

LOOK_S, PIECE_BYTES = 0.05, 1 << 16


class FollowedFile:
    """Where `pattern` has a * it is the last by name that is followed: a new file is read from its beginning.

    It is opened anew at each look and read on from where the last one ended, for programs that write the whole file
    again, under another name first. One that has become shorter was begun anew.
    """

    byte_s = 0.0

    def __init__(self, pattern: str) -> None:
        self._pattern, self._next_s = pattern, 0.0
        self._path = self._newest()
        with _plain(self._path) as file:  # whether it may be read is known now
            self._at = file.seek(0, os.SEEK_END)

    def read(self) -> bytes:
        """What was written since the last look. Raises FileNotFoundError where no such file is there any more."""
        if time.monotonic() < self._next_s:
            return b""
        newest = self._newest()
        data = self._piece()
        if len(data) < PIECE_BYTES:
            self._next_s = time.monotonic() + LOOK_S
            if newest != self._path:
                self._path, self._at, self._next_s = newest, 0, 0.0
        return data

    def write(self, data: bytes) -> None:
        """Nothing is ever written: raises PermissionError."""
        raise PermissionError(errno.EACCES, "a file that is followed is never written to")

    def there(self) -> bool:
        """Whether it is."""
        return os.path.exists(self._path)

    def close(self) -> None:
        """Nothing is kept open."""

    def _newest(self) -> str:
        if found := sorted(glob(self._pattern)):
            return found[-1]
        raise FileNotFoundError(errno.ENOENT, os.strerror(errno.ENOENT), self._pattern)

    def _piece(self) -> bytes:
        """What follows what was read; b"" of a file that has just made way for the next."""
        try:
            with _plain(self._path) as file:
                if file.seek(0, os.SEEK_END) < self._at:
                    self._at = 0
                file.seek(self._at)
                data = file.read(PIECE_BYTES)
        except FileNotFoundError:
            return b""
        self._at += len(data)
        return data


def _plain(path: str) -> BinaryIO:
    """The file, opened for reading. Raises OSError where it is none: a pipe is waited for, a device has no end."""
    handle = os.open(path, os.O_RDONLY | getattr(os, "O_NONBLOCK", 0) | getattr(os, "O_BINARY", 0))
    if not stat.S_ISREG(os.fstat(handle).st_mode):
        os.close(handle)
        raise OSError(errno.EINVAL, "is no plain file", path)
    return os.fdopen(handle, "rb")

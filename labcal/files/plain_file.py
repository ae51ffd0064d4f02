"""Files of others, read in bounded time: a pipe would be waited for, a device has no end."""

from __future__ import annotations

import os
import stat
from pathlib import Path

from labcal.errors import InputError


def first_bytes(path: Path, most: int) -> bytes:
    """The first bytes of a regular file, `most` of them. Raises InputError where it is none, and OSError."""
    handle = os.open(path, os.O_RDONLY | getattr(os, "O_NONBLOCK", 0) | getattr(os, "O_BINARY", 0))
    if not stat.S_ISREG(os.fstat(handle).st_mode):
        os.close(handle)
        raise InputError("is not a regular file", file=path)
    with os.fdopen(handle, "rb") as file:
        return file.read(most) or b""  # None where the kernel's own file has nothing to say now


def read_limited(path: Path, largest: int) -> bytes:
    """The whole of a regular file of at most `largest` bytes. Raises InputError, and OSError."""
    content = first_bytes(path, largest + 1)
    if len(content) > largest:
        raise InputError(f"is larger than {largest} bytes", file=path)
    return content

"""The lock that lies on a serial or USB device itself, which every user of the computer meets.

It is on a descriptor of its own, beside the link's: it stays while the link is opened again.
"""

from __future__ import annotations

import os
import sys

if sys.platform != "win32":
    import errno
    import fcntl
    import select
    import stat
    import termios
    import time
    from contextlib import suppress

    from labcal.bench.links.holders import users_of
    from labcal.bench.links.locks import PATIENCE_S

    NAMED_TERMINAL = (
        "/dev/pts/"  # its other end keeps it open: shut to others, it would stay so when its holder is dead
    )

    def lock(port: str, patience_s: float = PATIENCE_S) -> int | None:
        """Lock the device `port`; returns what holds the lock until it is closed.

        None where there is no such device, or this user may not open it: its link says so. Raises BlockingIOError
        where another process has it to itself.
        """
        try:
            if not port.startswith("/") or not stat.S_ISCHR(os.stat(port).st_mode):
                return None
            device = os.open(port, os.O_RDWR | os.O_NOCTTY | os.O_NONBLOCK)
        except OSError as error:
            if error.errno == errno.EBUSY:
                raise BlockingIOError(error.errno, error.strerror) from error
            return None
        if not _locked_in_time(device, patience_s):
            os.close(device)
            raise BlockingIOError(errno.EAGAIN, os.strerror(errno.EAGAIN))
        return device

    def still(device: int, port: str) -> bool:
        """Whether this is the device of that name yet: after a replug it is another, and the old one must be let go."""
        try:
            there = os.stat(port)
        except OSError:
            return False
        hung_up = select.poll()
        hung_up.register(device, 0)
        return os.path.samestat(there, os.fstat(device)) and not hung_up.poll(0)

    def shut(device: int, port: str) -> None:
        """Let nobody else open this terminal, until `unlocked`; not where somebody has it open: it would stay shut."""
        port = os.path.realpath(port)
        if not port.startswith(NAMED_TERMINAL) and users_of(port) <= {os.getpid()}:
            with suppress(OSError):  # no terminal
                fcntl.ioctl(device, termios.TIOCEXCL)

    def reopen(device: int) -> None:
        """Let it be opened, by this process."""
        with suppress(OSError):
            fcntl.ioctl(device, termios.TIOCNXCL)

    def unlock(device: int) -> None:
        """Give it back."""
        reopen(device)
        with suppress(OSError):
            os.close(device)

    def _locked_in_time(device: int, patience_s: float) -> bool:
        """A process that has just been killed keeps its lock for a moment."""
        deadline = time.monotonic() + patience_s
        while True:
            with suppress(OSError):
                fcntl.flock(device, fcntl.LOCK_EX | fcntl.LOCK_NB)
                return True
            if time.monotonic() > deadline:
                return False
            time.sleep(0.01)
else:

    def lock(port: str, patience_s: float = 0.0) -> int | None:
        """None: Windows opens a port once."""
        return None

    def still(device: int, port: str) -> bool:
        """It is."""
        return True

    def shut(device: int, port: str) -> None:
        """It is."""

    def reopen(device: int) -> None:
        """It is."""

    def unlock(device: int) -> None:
        """Nothing is held."""

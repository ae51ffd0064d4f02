"""What became of a line on which the computer reports an error: gone, in use, or there yet while one call failed."""

from __future__ import annotations

import errno
import os
import sys

from labcal.bench.links import devices
from labcal.bench.links.permission import not_allowed
from labcal.errors import InstrumentError

FORBIDDEN = (errno.EACCES, errno.EPERM)
BUSY = (errno.EAGAIN, errno.EBUSY, errno.EADDRINUSE)
GONE = (
    errno.ENODEV, errno.ENXIO, errno.ENOENT, errno.EPIPE, errno.ENOTCONN, errno.ECONNRESET, errno.ECONNABORTED,
    errno.ECONNREFUSED, errno.EHOSTUNREACH, errno.ENETUNREACH, errno.ENETDOWN, errno.ESHUTDOWN,
)  # fmt: skip
HUNG_UP = "returned no data"  # as pyserial says it, who states no number
NOT_GONE = "Try again; if it comes again, look at its cable and its adapter."


def not_open(url: str, error: OSError | None = None) -> InstrumentError:
    """The error for a line that does not open; without `error`, for one that has been closed."""
    why = f" ({_words(error)})" if error else ""
    if error is not None and error.errno in BUSY:
        remedy = "End that program, then try again."
        return InstrumentError(f"{url}: another program has opened it{why}.", fault="in use", remedy=remedy)
    if error is None or _number(error) in GONE:
        return InstrumentError(f"{url}: the link was lost{why}.", fault="link lost")
    if _number(error) in FORBIDDEN and (remedy := not_allowed(url.partition("://")[2].partition("?")[0])):
        return InstrumentError(f"{url}: this user may not open it{why}.", fault="link lost", remedy=remedy)
    return InstrumentError(f"{url}: the link does not open{why}.", fault="link lost")


def failed(url: str, call: str, error: OSError, there: bool) -> InstrumentError:
    """The error for a line that was closed because `call` (reading, writing) failed; `there`: its port is there yet."""
    if not there or is_gone(error):
        why = "its other end has hung up" if HUNG_UP in str(error) else _words(error)
        return InstrumentError(f"{url}: the link was lost ({why}).", fault="link lost")
    return InstrumentError(
        f"{url}: {call} failed ({_words(error)}); its port is there.", fault="link lost", remedy=NOT_GONE
    )


def is_gone(error: OSError) -> bool:
    """Whether the computer says by this error that the other end, or the port, is gone."""
    return isinstance(error, ConnectionError) or _number(error) in GONE or HUNG_UP in str(error)


def stands(device: int, port: str) -> bool:
    """Whether the open `device` is the port of that name yet. True of what has no name, False on Windows: not known."""
    try:
        return sys.platform != "win32" and (not os.path.isabs(port) or devices.still(device, port))
    except OSError:
        return False


def _words(error: OSError) -> str:
    """What the system says, without its number and the place, which stand there already."""
    number, said = _number(error), error.strerror or str(error)
    return said if number is None or "[Errno" not in str(said) else os.strerror(number)


def _number(error: BaseException) -> int | None:
    """That of the call that failed: pyserial raises an error of its own for it, which has none."""
    number = getattr(error, "errno", None)
    return number if number is not None or error.__context__ is None else _number(error.__context__)

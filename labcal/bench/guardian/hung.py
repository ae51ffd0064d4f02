"""A guardian that hangs, or was stopped: it is found out and ended, so that another brings the coils down."""

from __future__ import annotations

import os
import signal
from contextlib import suppress
from pathlib import Path

from labcal.bench.guardian.logbook import note
from labcal.bench.links.places import user_name
from labcal.errors import InstrumentError

STOPPED = "T"  # by a signal; one that a tracer holds for a moment ("t") goes on by itself


def stands_still(pid: int | None) -> bool:
    """Whether this process was stopped; False where the system does not tell."""
    if pid is None:
        return False
    with suppress(OSError, IndexError):
        return Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()[0] == STOPPED
    return False


def ended(pid: int | None, uid: int | None, why: str) -> None:
    """Kill the guardian `pid`, whose user is `uid`; `why`: what it was asked for in vain.

    Raises InstrumentError where this process cannot.
    """
    whose = "" if uid is None else f" of user {user_name(uid)}"
    if pid is None or pid == os.getpid():
        raise _lost("a guardian holds the ports and hangs, or was stopped.", "Have it ended, then say off again.")
    try:
        os.kill(pid, getattr(signal, "SIGKILL", signal.SIGTERM))
    except ProcessLookupError:
        return
    except OSError as error:
        what = f"guardian {pid}{whose} hangs, or was stopped, and may not be ended from here ({error.strerror})."
        raise _lost(what, f"To end it: kill -9 {pid}. Then say off again.") from error
    note(f"guardian {pid} {why} and hangs, or was stopped: it was killed by process {os.getpid()}")


def _lost(what: str, mends: str) -> InstrumentError:
    return InstrumentError(
        f"{what} How the coils are is not known.",
        fault="guardian lost",
        remedy="Switch the supplies off by hand.",
        mends=mends,
    )

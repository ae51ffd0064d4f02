"""What the guardian did, when and why: one line each in `guardian.log` of the user's data folder.

A disk may be full, or far away and silent: a thread of its own writes, and nothing that brings coils to zero waits.
"""

from __future__ import annotations

import os
import threading
from collections.abc import Callable
from contextlib import suppress
from datetime import UTC, datetime
from functools import cache, partial
from queue import SimpleQueue

from labcal.errors import InputError
from labcal.files.home import file_at_home
from labcal.files.text_safety import one_line

_jobs: SimpleQueue[Callable[[], None]] = SimpleQueue()


def note(text: str) -> None:
    """Append a line with the UTC time of now and the process."""
    later(partial(_append, f"{datetime.now(UTC):%Y-%m-%dT%H:%M:%S.%f}Z [{os.getpid()}] {one_line(text)}\n"))


def later(write: Callable[[], None]) -> None:
    """Have something written when the disk allows it, in turn; where there is room for no thread, by `written`."""
    _jobs.put(write)
    with suppress(RuntimeError):
        _start_writer()


def written(at_most_s: float) -> bool:
    """Wait until all that was noted so far is written; False where it took longer than `at_most_s`."""
    done = threading.Event()
    later(done.set)
    try:
        _start_writer()
    except RuntimeError:  # no room for a thread: from here
        while not done.is_set():
            _write_next()
    return done.wait(at_most_s)


@cache
def _start_writer() -> None:
    threading.Thread(target=_write, daemon=True).start()


def _write() -> None:
    while True:
        _write_next()


def _write_next() -> None:
    with suppress(OSError, InputError):
        _jobs.get()()


def _append(line: str) -> None:
    with file_at_home("guardian.log").open("a", encoding="utf-8") as log:
        log.write(line)

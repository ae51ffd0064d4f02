"""A way to zero that one killed process does not break off: a second one goes it, and whoever is left ends it."""

from __future__ import annotations

import json
import os
import sys
import threading
from collections.abc import Callable
from contextlib import suppress
from typing import NoReturn

from labcal.bench.coils.at_zero import AtZero
from labcal.bench.guardian.wire import zero_message, zero_of
from labcal.bench.links import ports

Work = Callable[[], list[AtZero]]


def outlived(work: Work) -> Callable[[], list[AtZero]]:
    """Begin `work` in a process of its own session; what is returned waits for its end, and works where that one died.

    Where no such process can be made (Windows, no memory, other threads in this one) the work is done when waited for.
    """
    if sys.platform == "win32" or threading.active_count() > 1:
        return work
    reading, writing = os.pipe()
    try:
        child = os.fork()
    except OSError:
        os.close(reading)
        os.close(writing)
        return work
    if child == 0:
        _as_the_child(work, writing)
    os.close(writing)
    return lambda: _result_of_child(child, reading) or work()


def _as_the_child(work: Work, writing: int) -> NoReturn:
    """Do it and write how it ended, in one line; nothing where it failed: the other process tries, and says why."""
    try:
        if sys.platform != "win32":  # there is no child there
            os.setsid()
        ports.announce({"pid": os.getpid()})
        with os.fdopen(writing, "w", encoding="utf-8") as pipe:
            pipe.write(json.dumps([zero_message(end) for end in work()]) + "\n")
    finally:
        os._exit(0)  # what the other process has open, and its words that are not printed yet, stay its own


def _result_of_child(child: int, reading: int) -> list[AtZero]:
    """How it ended for the child; [] where it ended before it could say all of it."""
    with os.fdopen(reading, encoding="utf-8") as pipe:
        said = pipe.read()
    with suppress(ChildProcessError):
        os.waitpid(child, 0)
    if not said.endswith("\n"):
        return []
    return [zero_of(message) for message in json.loads(said)]

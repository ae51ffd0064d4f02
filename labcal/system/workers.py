"""Processes that work for this one: with one thread of linear algebra, without its secrets, gone when it is gone."""

from __future__ import annotations

import multiprocessing
import os
import signal
import sys
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from multiprocessing.connection import wait as wait_for

from labcal.files.home import SECRETS

THREADS = ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS", "MKL_NUM_THREADS", "VECLIB_MAXIMUM_THREADS")
LAST_IN_LINE = 19  # nice
IDLE = 0x40  # SetPriorityClass: runs when nobody else wants to


@contextmanager
def environment_of_workers() -> Iterator[None]:
    """Processes that begin inside have one thread of linear algebra, whatever was said of it before, and no secret."""
    before = dict(os.environ)
    os.environ.update(dict.fromkeys(THREADS, "1"))
    for name in before.keys() & SECRETS:
        del os.environ[name]
    try:
        yield
    finally:
        for name in {*THREADS} - before.keys():
            del os.environ[name]
        os.environ.update({name: before[name] for name in before.keys() & {*THREADS, *SECRETS}})


def end_with_parent() -> None:
    """A worker ends at Ctrl-C without a word, and at once when the process that it works for is gone."""
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    parent = multiprocessing.parent_process()
    assert parent is not None
    threading.Thread(target=_end_after, args=(parent.sentinel,), daemon=True).start()


def stand_back() -> None:
    """From now on every other process comes first: nobody who records on this computer waits for this one."""
    if sys.platform == "win32":
        import ctypes

        kernel = ctypes.windll.kernel32
        kernel.GetCurrentProcess.restype = ctypes.c_void_p
        kernel.SetPriorityClass.argtypes = ctypes.c_void_p, ctypes.c_uint32
        kernel.SetPriorityClass(kernel.GetCurrentProcess(), IDLE)
    else:
        os.nice(LAST_IN_LINE)


def cores() -> int:
    """How many cores this process may work on."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def _end_after(sentinel: int) -> None:
    wait_for([sentinel])
    os._exit(1)

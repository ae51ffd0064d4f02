"""Independent parts of the work on two cores: the result is the same on one."""

from __future__ import annotations

import os
import threading
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from typing import TypeVar

from labcal.errors import Stopped

Item = TypeVar("Item")
Outcome = TypeVar("Outcome")
CORES = min(os.cpu_count() or 1, 2)
_thread = threading.local()


def parallel_map(work: Callable[[Item], Outcome], items: Iterable[Item]) -> list[Outcome]:
    """`work` done on each item, in their order; serially where a worker of this very function asks for it.

    Where it ends early, by Ctrl-C say, workers stop at their next item, and nobody waits for the rest.
    """
    items = list(items)
    if min(CORES, len(items)) < 2 or getattr(_thread, "is_worker", False):
        return [work(item) for item in items if _goes_on()]
    ends = threading.Event()
    with ThreadPoolExecutor(CORES, "loop", initializer=_mark_as_worker, initargs=(ends,)) as workers:
        try:
            return list(workers.map(work, items))
        except BaseException:
            ends.set()
            raise


def _mark_as_worker(ends: threading.Event) -> None:
    _thread.is_worker, _thread.ends = True, ends


def _goes_on() -> bool:
    """True; raises Stopped in a worker whose work nobody waits for any more."""
    if (ends := getattr(_thread, "ends", None)) is not None and ends.is_set():
        raise Stopped
    return True


@contextmanager
def serially() -> Iterator[None]:
    """What this thread does inside is done on one core: another worker has the next."""
    before, _thread.is_worker = getattr(_thread, "is_worker", False), True
    try:
        yield
    finally:
        _thread.is_worker = before

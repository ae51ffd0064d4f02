"""Independent parts of the work on two cores: the result is the same on one."""

from __future__ import annotations

import os
import threading
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from typing import TypeVar

Item = TypeVar("Item")
Outcome = TypeVar("Outcome")
CORES = min(os.cpu_count() or 1, 2)
_thread = threading.local()


def parallel_map(work: Callable[[Item], Outcome], items: Iterable[Item]) -> list[Outcome]:
    """`work` done on each item, in their order; serially where a worker of this very function asks for it."""
    items = list(items)
    if min(CORES, len(items)) < 2 or getattr(_thread, "is_worker", False):
        return list(map(work, items))
    with ThreadPoolExecutor(CORES, "loop", initializer=_mark_as_worker) as workers:
        return list(workers.map(work, items))


def _mark_as_worker() -> None:
    _thread.is_worker = True


@contextmanager
def serially() -> Iterator[None]:
    """What this thread does inside is done on one core: another worker has the next."""
    before, _thread.is_worker = getattr(_thread, "is_worker", False), True
    try:
        yield
    finally:
        _thread.is_worker = before

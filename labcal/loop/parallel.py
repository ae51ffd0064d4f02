"""Parts of the work that do not depend on each other, on two cores: what comes out is the same on one."""

from __future__ import annotations

import os
import threading
from collections.abc import Callable, Iterable
from concurrent.futures import ThreadPoolExecutor
from typing import TypeVar

Part = TypeVar("Part")
Done = TypeVar("Done")
CORES = min(os.cpu_count() or 1, 2)
_here = threading.local()


def each(work: Callable[[Part], Done], parts: Iterable[Part]) -> list[Done]:
    """`work` done on each part, in their order; one after the other where one of two workers asks for it."""
    parts = list(parts)
    if min(CORES, len(parts)) < 2 or getattr(_here, "is_worker", False):
        return list(map(work, parts))
    with ThreadPoolExecutor(CORES, "loop", initializer=_begin) as workers:
        return list(workers.map(work, parts))


def _begin() -> None:
    _here.is_worker = True

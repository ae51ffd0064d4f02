"""One thread of linear algebra for as long as a call lasts: the matrices are small, and threads would only wait.

The command line says so in its environment before NumPy is loaded; a notebook has loaded it long before.
"""

from __future__ import annotations

import os
from collections.abc import Iterator
from contextlib import contextmanager
from importlib import import_module
from threading import Lock
from typing import Any


class _Calls:
    """The calls that are at work, of whatever thread: the limits are the whole process's."""

    def __init__(self) -> None:
        self._lock, self._count = Lock(), 0
        self._limits: Any = None

    def begin(self) -> None:
        """The first one sets the limits."""
        from threadpoolctl import threadpool_limits

        import_module("scipy.linalg")  # it brings a library of its own, which would come later with many threads
        with self._lock:
            if self._count == 0:
                self._limits = threadpool_limits(1, user_api="blas")
            self._count += 1

    def end(self) -> None:
        """The last one puts them back."""
        with self._lock:
            self._count -= 1
            if self._count == 0:
                self._limits.restore_original_limits()


_CALLS = _Calls()


@contextmanager
def one_thread() -> Iterator[None]:
    """Limit the linear algebra to one thread, and give back what was; nothing where OPENBLAS_NUM_THREADS is set."""
    if "OPENBLAS_NUM_THREADS" in os.environ:
        yield
        return
    _CALLS.begin()
    try:
        yield
    finally:
        _CALLS.end()

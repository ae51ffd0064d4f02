"""A thread for each line of the coils, so that a silent instrument delays no other line."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from concurrent.futures import ThreadPoolExecutor
from threading import Event
from typing import TypeVar

Given = TypeVar("Given")
Found = TypeVar("Found")


class LineWorkers:
    """As many threads as lines, begun now: when it counts there may be no memory for a new one.

    Where the system gives this user no further thread (a limit on processes) the lines are worked on one after the
    other: a silent instrument then delays those after it, and they come to zero all the same.
    """

    def __init__(self, number: int) -> None:
        self._pool: ThreadPoolExecutor | None = ThreadPoolExecutor(number)
        all_there = Event()  # until then none is idle, and each task begins a thread
        try:
            for _ in range(number):
                self._pool.submit(all_there.wait)
        except RuntimeError:
            self._pool.shutdown(wait=False)
            self._pool = None
        finally:
            all_there.set()

    def each(self, work: Callable[[Given], Found], lines: Iterable[Given]) -> list[Found]:
        """What `work` gives for each; raises what the first of them raises."""
        return [work(line) for line in lines] if self._pool is None else list(self._pool.map(work, lines))

    def let_go(self) -> None:
        """End the threads, as soon as they have nothing to do; waits for none."""
        if self._pool is not None:
            self._pool.shutdown(wait=False)

"""Runs made ready ahead of the one that is being put into the archive: in this process, or in several for many.

The processes stand back for every other on this computer, hold no secret, and end with this one. Where one of them
is killed, what is left is done here, one at a time.
"""

from __future__ import annotations

import multiprocessing
from collections import deque
from collections.abc import Callable, Generator, Sequence
from concurrent.futures import Future, ProcessPoolExecutor, ThreadPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from typing import TypeVar

from labcal.system.workers import cores, end_with_parent, environment_of_workers, stand_back

FEW = 24  # for so many runs a process is not worth its start, some 0.3 s
MOST = 6  # processes: what is done here, one run after the other, takes a fifth of a process's time
WAITING = 2  # runs a process: made ready, or begun
T = TypeVar("T")
Work = Callable[[str], T]


def worth_it(number: int) -> int:
    """How many processes are to make so many runs ready: one a core, 0 where they are not worth it."""
    return min(cores(), MOST) if number > FEW and cores() > 1 else 0


def ahead(
    work: Work[T],
    names: Sequence[str],
    processes: int = 0,
    large: Callable[[str], bool] = lambda name: False,
    threads: int = 1,
) -> Generator[tuple[str, Future[T]], None, None]:
    """Each name with its work, in order; the next are worked on meanwhile, by 0 processes in `threads` of this one.

    What a process returns is short (a few kB): one that is killed inside a longer answer is waited for for ever.
    What is `large` has the computer's memory to itself: nothing else is begun before it is done.
    """
    left = deque(names)
    if processes:
        yield from _by_processes(work, left, processes, large)
    yield from _by_threads(work, left, threads)


def _by_processes(
    work: Work[T], left: deque[str], processes: int, large: Callable[[str], bool]
) -> Generator[tuple[str, Future[T]], None, None]:
    """Until nothing is left, or a process was killed."""
    begun, alone = deque[Future[T]](), False
    pool = ProcessPoolExecutor(processes, multiprocessing.get_context("spawn"), _begin)
    try:
        while left:
            while len(begun) < min(len(left), WAITING * processes) and not alone:
                name = left[len(begun)]
                if begun and large(name):
                    break
                alone = large(name)
                with environment_of_workers():
                    begun.append(pool.submit(work, name))
            if isinstance(begun[0].exception(), BrokenProcessPool):
                return
            alone = False
            yield left.popleft(), begun.popleft()
    except BrokenProcessPool:  # no more is taken
        return
    finally:
        pool.shutdown(wait=not left, cancel_futures=True)  # who is stopped waits for no run


def _by_threads(work: Work[T], left: deque[str], threads: int) -> Generator[tuple[str, Future[T]], None, None]:
    with ThreadPoolExecutor(threads) as pool:
        begun = deque[tuple[str, Future[T]]]()
        while left:
            begun.append((name := left.popleft(), pool.submit(work, name)))
            if len(begun) > threads:
                yield begun.popleft()
        yield from begun


def _begin() -> None:
    stand_back()
    end_with_parent()

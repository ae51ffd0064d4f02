"""The engine that a study runs on by itself: processes of this computer, each with one thread of linear algebra.

A worker that is killed is replaced and its job done again; a job at hand when three ended ends the study.
"""

from __future__ import annotations

import multiprocessing
from collections import Counter
from collections.abc import Iterator, Sequence
from concurrent.futures import FIRST_COMPLETED, Future, ProcessPoolExecutor, wait
from concurrent.futures.process import BrokenProcessPool

from labcal.errors import InputError
from labcal.study.job import Job, Row
from labcal.study.work import work
from labcal.system.workers import end_with_parent, environment_of_workers

DEATHS = 3  # of workers at one job
AHEAD = 2  # jobs a worker that wait for it
Done = Iterator[tuple[Job, Row]]


def on_processes(jobs: Sequence[Job], processes: int) -> Done:
    """Each job with its row, as they are done. Raises what a job raised, and InputError where one kills its workers."""
    left, deaths = {job.key: job for job in jobs}, Counter[str]()
    with environment_of_workers():
        while left:
            try:
                for job, row in _one_pool(list(left.values()), min(processes, len(left)), deaths):
                    del left[job.key]
                    yield job, row
            except BrokenProcessPool:
                _refuse_deadly(left, deaths)


def _one_pool(jobs: Sequence[Job], processes: int, at_work: Counter[str]) -> Done:
    """Until the jobs are done, or a worker dies; `at_work` counts the jobs that were handed out when one did."""
    waiting, running = iter(jobs), dict[Future[Row], Job]()
    context = multiprocessing.get_context("spawn")
    pool = ProcessPoolExecutor(processes, mp_context=context, initializer=end_with_parent)
    try:
        while True:
            for job in waiting:
                running[pool.submit(work, job)] = job
                if len(running) >= AHEAD * processes:
                    break
            if not running:
                return
            for future in wait(running, return_when=FIRST_COMPLETED).done:
                row = future.result()
                yield running.pop(future), row
    except BrokenProcessPool:
        at_work.update(job.key for job in running.values())
        raise
    finally:
        pool.shutdown(wait=False, cancel_futures=True)


def _refuse_deadly(left: dict[str, Job], deaths: Counter[str]) -> None:
    deadly = [job for key, job in left.items() if deaths[key] >= DEATHS]
    if deadly:
        names = "; ".join(job.name for job in deadly)
        text = f"{DEATHS} workers ended while these jobs were at hand (too little memory?): {names}"
        raise InputError(f"{text}; what was done is kept, the same command goes on with it")

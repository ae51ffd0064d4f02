"""Work in pieces: as many in a turn of the event loop as hold up no key and no click."""

from __future__ import annotations

import time
from collections.abc import Callable

from PySide6.QtCore import QObject, QTimer

Job = Callable[[], object]
TIME_SLICE_S = 0.01  # of a turn before another piece is begun in it


class IdleQueue(QObject):
    """Does its jobs in the order in which they were asked for; what waits already is not asked for twice."""

    def __init__(self, parent: QObject) -> None:
        super().__init__(parent)
        self._jobs: dict[object, Job] = {}
        self._timer = QTimer(self, interval=0, singleShot=True)
        self._timer.timeout.connect(self._run_slice)

    def add(self, *jobs: Job) -> None:
        """Do these when it is their turn."""
        for job in jobs:
            self.put(job, job)

    def put(self, name: object, job: Job) -> None:
        """Do this when it is its turn, and not what waits under the same name."""
        self._jobs.pop(name, None)
        self._jobs[name] = job
        self._timer.start()

    @property
    def waits(self) -> bool:
        """Whether anything is still to be done."""
        return bool(self._jobs)

    def finish(self) -> None:
        """Do all that waits, now."""
        while self._jobs:
            self._run_next()

    def _run_slice(self) -> None:
        until = time.monotonic() + TIME_SLICE_S
        try:
            while self._jobs and time.monotonic() <= until:
                self._run_next()
        finally:  # a job that breaks holds up none of the others
            if self._jobs:
                self._timer.start()

    def _run_next(self) -> None:
        self._jobs.pop(next(iter(self._jobs)))()

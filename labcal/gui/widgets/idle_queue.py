"""Work in pieces: as many in a turn of the event loop as hold up no key and no click."""

from __future__ import annotations

import time
from collections.abc import Callable

from PySide6.QtCore import QObject, QTimer

Job = Callable[[], object]
AT_MOST_S = 0.01  # of a turn before another piece is begun in it


class IdleQueue(QObject):
    """Does its jobs in the order in which they were asked for; what waits already is not asked for twice."""

    def __init__(self, parent: QObject) -> None:
        super().__init__(parent)
        self._waiting: dict[object, Job] = {}
        self._next = QTimer(self, interval=0, singleShot=True)
        self._next.timeout.connect(self._do)

    def add(self, *jobs: Job) -> None:
        """Do these when it is their turn."""
        for job in jobs:
            self.put(job, job)

    def put(self, name: object, job: Job) -> None:
        """Do this when it is its turn, and not what waits under the same name."""
        self._waiting.pop(name, None)
        self._waiting[name] = job
        self._next.start()

    def finish(self) -> None:
        """Do all that waits, now."""
        while self._waiting:
            self._one()

    def _do(self) -> None:
        until = time.monotonic() + AT_MOST_S
        while self._waiting:
            self._one()
            if time.monotonic() > until:
                self._next.start()
                return

    def _one(self) -> None:
        self._waiting.pop(next(iter(self._waiting)))()

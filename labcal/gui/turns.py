"""Work in pieces: as many in a turn of the event loop as hold up no key and no click."""

from __future__ import annotations

import time
from collections.abc import Callable

from PySide6.QtCore import QObject, QTimer

Job = Callable[[], object]
AT_MOST_S = 0.01  # of a turn before another piece is begun in it


class Turns(QObject):
    """Does its jobs in the order in which they were asked for; what waits already is not asked for twice."""

    def __init__(self, parent: QObject) -> None:
        super().__init__(parent)
        self._waiting: dict[Job, None] = {}
        self._next = QTimer(self, interval=0, singleShot=True)
        self._next.timeout.connect(self._do)

    def add(self, *jobs: Job) -> None:
        """Do these when it is their turn."""
        self._waiting.update(dict.fromkeys(jobs))
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
        job = next(iter(self._waiting))
        del self._waiting[job]
        job()

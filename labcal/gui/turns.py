"""Work in pieces: each in a turn of the event loop of its own, so that none of them holds up a key or a click."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import QObject, QTimer

Job = Callable[[], object]


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
            self._do()

    def _do(self) -> None:
        if not self._waiting:
            return
        job = next(iter(self._waiting))
        del self._waiting[job]
        if self._waiting:
            self._next.start()
        job()

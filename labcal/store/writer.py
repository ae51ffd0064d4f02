"""Writing a run while it happens: what is handed in is on the disk within half a second, whatever happens then."""

from __future__ import annotations

import threading
from collections.abc import Sequence
from contextlib import suppress
from datetime import UTC, datetime
from pathlib import Path
from types import TracebackType
from typing import Self

from labcal.errors import InputError, InstrumentError, Stopped
from labcal.record.stream import Block, Item
from labcal.store.database import connect, transaction
from labcal.store.items import Row, merged, to_row
from labcal.store.liveness import Alive

COMMIT_EVERY_S = 0.25  # of wall time
ROWS_BUFFERED = 5_000
INSERT_ITEM = "INSERT INTO item (run, kind, t_s, content, stamps, samples, raw) VALUES (?, ?, ?, ?, ?, ?, ?)"
INSERT_STATUS = "INSERT INTO status (run, status, utc) VALUES (?, ?, ?)"


def utc_now() -> str:
    """The system's time, ISO 8601."""
    return datetime.now(UTC).isoformat(timespec="milliseconds").replace("+00:00", "Z")


class RunWriter:
    """Takes a run's items and commits them at least every half second, by a thread of its own.

    Use it as a context manager: a run that is left without `finish` ends `finished`, `stopped` or `failed: …` as it
    was left. A writer that dies without leaving shows as `interrupted`.
    """

    def __init__(self, path: Path, run: int, run_id: str, alive: Alive) -> None:
        self.run_id = run_id
        self._path, self._run, self._alive = path, run, alive
        self._connection = connect(path)
        self._pending: list[Row] = []
        self._hand, self._committing = threading.Lock(), threading.Lock()
        self._fault: Exception | None = None
        self._closing = threading.Event()
        self._clockwork = threading.Thread(target=self._commit_in_time, name=f"record {run_id}", daemon=True)
        self._clockwork.start()

    def write(self, item: Item) -> None:
        """Take one item. Raises InstrumentError ("disk full", "store locked") when an earlier one cannot be kept."""
        if self._fault is not None:
            raise self._fault
        if isinstance(item, Block) and not len(item):
            return
        row = to_row(item)
        with self._hand:
            self._pending.append(row)
        if len(self._pending) >= ROWS_BUFFERED:
            self.commit()

    def commit(self) -> None:
        """Bring everything written so far to the disk now."""
        with self._committing:
            with self._hand:
                rows = tuple(self._pending)
            if rows:
                self._insert(rows)
                with self._hand:
                    del self._pending[: len(rows)]

    def finish(self, status: str) -> None:
        """Commit what is left and state how it ended: `finished`, `stopped`, `failed: why`, `interrupted` as before."""
        if status not in ("finished", "stopped", "interrupted") and not status.startswith("failed: "):
            raise ValueError(f"a run ends finished, stopped, interrupted or failed: why; not {status!r}")
        if self._closing.is_set():
            return
        self._closing.set()
        self._clockwork.join()
        try:
            self.commit()
            with transaction(self._connection, self._path):
                self._connection.execute(INSERT_STATUS, (self._run, status, utc_now()))
        finally:
            self._connection.close()
            self._alive.end()

    def __enter__(self) -> Self:
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, _: TracebackType | None) -> None:
        if error is None:
            self.finish("finished")
            return
        with suppress(InstrumentError, InputError):  # the first fault is the one to tell
            self.finish(_ending(error))

    def _insert(self, rows: Sequence[Row]) -> None:
        with transaction(self._connection, self._path):
            self._connection.executemany(INSERT_ITEM, ((self._run, *row) for row in merged(rows)))

    def _commit_in_time(self) -> None:
        while not self._closing.wait(COMMIT_EVERY_S):
            try:
                self.commit()
            except Exception as error:  # told to whoever writes next
                self._fault = error


def _ending(error: BaseException) -> str:
    if isinstance(error, Stopped | KeyboardInterrupt):
        return "stopped"
    return f"failed: {str(error) or type(error).__name__}"

"""Writing a run while it happens: what is handed in is on the disk within half a second, unless the disk is busy."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable, Sequence
from contextlib import suppress
from datetime import UTC, datetime
from pathlib import Path
from types import TracebackType
from typing import Self

from labcal.errors import InputError, InstrumentError, Stopped
from labcal.record.stream import Block, Item
from labcal.store import chain
from labcal.store.database import connect, transaction
from labcal.store.items import ItemRow, merged, to_row, whole
from labcal.store.liveness import Alive
from labcal.store.place import require_same

COMMIT_EVERY_S = 0.25  # of wall time
ASK_AGAIN_MS = 100  # while another program holds the store
LATE_S = 15.0  # a row that waits so long for the disk is reported; with real coils on, sooner: see `RunWriter.late_s`
PATIENCE_S = 10.0  # at the end, with nothing energised any more: by then a lock or a full disk may be gone
SAY_S = 1.0  # so long nobody hears that the end of a run waits for the disk
TOLD_S = 0.1  # a row that has waited less has not waited
PASSING = ("store locked", "disk full")  # faults that may go away by themselves
ROWS_BUFFERED = 5_000
Utc = Callable[[], str]


def iso(moment: datetime) -> str:
    """A moment of UTC as a record states it, ISO 8601."""
    return moment.isoformat(timespec="milliseconds").replace("+00:00", "Z")


def utc_now() -> str:
    """The system's time, ISO 8601."""
    return iso(datetime.now(UTC))


class RunWriter:
    """Takes a run's items and commits them at least every half second, by a thread of its own.

    Use it as a context manager: a run that is left without `finish` ends `finished`, `stopped` or `failed: …` as it
    was left. A writer that dies without leaving shows as `interrupted`. `late_s`: how long a row may wait for the disk
    before `write` and `check` say that it does; nobody who hands items in ever waits for the disk itself. `waits` hears
    what `finish` waits for. `utc` tells the time of a status. With `repeats`, which rows blocks are merged into depends
    on what is handed in alone and not on when it is committed: the last blocks wait for what comes after them.
    """

    def __init__(self, path: Path, run: int, run_id: str, alive: Alive, utc: Utc = utc_now) -> None:
        self.run_id, self.late_s, self.repeats, self._utc = run_id, LATE_S, False, utc
        self.waits: Callable[[InstrumentError], None] = lambda fault: None
        self._path, self._run, self._alive = path, run, alive
        self._connection = connect(path)
        self._connection.execute(f"PRAGMA busy_timeout = {ASK_AGAIN_MS}")
        self._pending: list[ItemRow] = []
        self._since_s: float | None = None  # when the oldest row that is not on the disk was handed in
        self._hand, self._committing = threading.Lock(), threading.Lock()
        self._fault: Exception | None = None  # of the last commit
        self._looked_s, self._excused = time.monotonic(), (0.0, 0.0)  # `_since_s`, and from when on it counts
        self._closing, self._wanted, self._left = threading.Event(), threading.Event(), threading.Event()
        self._clockwork = threading.Thread(target=self._commit_in_time, name=f"record {run_id}", daemon=True)
        self._clockwork.start()

    def write(self, item: Item) -> None:
        """Take one item: it goes to the disk as soon as that can be. Then raise as `check` does."""
        if isinstance(item, Block) and not len(item):
            return
        row = to_row(item)
        with self._hand:
            self._pending.append(row)
            self._since_s = self._since_s or time.monotonic()
        while len(self._pending) >= ROWS_BUFFERED and not self._closing.is_set():
            self._wanted.set()
            self.check()
            time.sleep(0.01)
        self.check()

    def check(self) -> None:
        """Raise InstrumentError ("disk full", "store locked", "store slow", "store gone") where rows are not kept.

        InputError where the store's file is damaged. What was handed in waits in memory and is tried again.
        """
        fault, late = self._fault, self._is_late()
        if fault is not None and (late or getattr(fault, "fault", "") != "store locked"):
            raise self._with_wait(fault) if isinstance(fault, InstrumentError) else fault
        if late:
            raise self._slow()

    @property
    def waited_s(self) -> float:
        """How long the oldest row has waited for the disk; 0 where none waits."""
        since_s = self._since_s
        return 0.0 if since_s is None else _ago(since_s)

    def _is_late(self) -> bool:
        """Whether the oldest row has waited too long.

        Who was kept from looking for so long, as the computer slept, gives the disk its time from now on, once.
        """
        since_s, now, unseen_s = self._since_s, time.monotonic(), self._looked_s
        self._looked_s = now
        if since_s is None:
            return False
        if now - unseen_s > self.late_s and self._excused[0] != since_s:
            self._excused = (since_s, now)
        return now - (self._excused[1] if self._excused[0] == since_s else since_s) > self.late_s

    def commit(self) -> None:
        """Bring everything written so far to the disk now."""
        with self._committing:
            with self._hand:
                rows, begun_s = self._pending[: self._ready()], time.monotonic()
            if rows:
                self._insert(rows)
            with self._hand:
                del self._pending[: len(rows)]
                self._since_s = begun_s if self._ready() else None

    def finish(self, status: str) -> None:
        """Commit what is left and state how it ended: `finished`, `stopped`, `failed: why`, `interrupted` as before.

        Where a lock or a full disk is in the way, it is waited for, ten seconds at the most: nothing may be energised.
        """
        if status not in ("finished", "stopped", "interrupted") and not status.startswith("failed: "):
            raise ValueError(f"a run ends finished, stopped, interrupted or failed: why; not {status!r}")
        if self._closing.is_set():
            return
        self._closing.set()
        self._wanted.set()
        deadline = time.monotonic() + PATIENCE_S
        self._clockwork.join(min(SAY_S, PATIENCE_S))
        if self._clockwork.is_alive():
            self.waits(self._slow())
            self._clockwork.join(PATIENCE_S)
        if self._clockwork.is_alive():
            self._left.set()  # it lets go when the disk has answered
            if not self._clockwork.is_alive():
                self._let_go()
            raise self._slow()
        try:
            while (fault := self._ended(status, deadline)) is not None:
                self.waits(fault)
                time.sleep(0.05)
        finally:
            self._let_go()

    def __enter__(self) -> Self:
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, _: TracebackType | None) -> None:
        if error is None:
            self.finish("finished")
            return
        with suppress(InstrumentError, InputError):  # the first fault is the one to tell
            self.finish(_ending(error))

    def _ended(self, status: str, deadline: float) -> InstrumentError | None:
        """Bring the rows that are left and `status` into the file that lies there; the fault for which to try again."""
        try:
            self.commit()
            with transaction(self._connection, self._path):
                chain.append(self._connection, self._run, "status", (status, self._utc()))
        except InstrumentError as fault:
            error = self._with_wait(fault)
            if fault.fault not in PASSING or time.monotonic() > deadline:
                raise error from None
            return error
        require_same(self._path, self._connection.files)
        return None

    def _ready(self) -> int:
        """How many of the rows that are there may go to the disk."""
        return whole(self._pending) if self.repeats and not self._closing.is_set() else len(self._pending)

    def _insert(self, rows: Sequence[ItemRow]) -> None:
        with transaction(self._connection, self._path):
            for row in merged(rows):
                chain.append(self._connection, self._run, "item", row)

    def _commit_in_time(self) -> None:
        while not self._closing.is_set():
            self._wanted.wait(COMMIT_EVERY_S)
            self._wanted.clear()
            try:
                self.commit()
                require_same(self._path, self._connection.files)
                self._fault = None
            except Exception as error:  # raised for whoever writes or looks next, and tried again
                self._fault = error
        if self._left.is_set():
            self._let_go()

    def _let_go(self) -> None:
        self._connection.close()
        self._alive.end()

    def _with_wait(self, fault: InstrumentError) -> InstrumentError:
        """`fault`, with how long the oldest row has waited for what may come by itself."""
        since_s = self._since_s
        if since_s is None or fault.fault not in (*PASSING, "store slow") or (waited_s := _ago(since_s)) < TOLD_S:
            return fault
        what = f"{fault.what.removesuffix('.')}; a row has waited {waited_s:.1f} s to be kept."
        return InstrumentError(what, fault=fault.fault, remedy=fault.remedy)

    def _slow(self) -> InstrumentError:
        what = f"{self._path}: the disk did not take in time what was recorded."
        return self._with_wait(InstrumentError(what, fault="store slow", remedy="See what keeps the disk busy."))


def _ago(then_s: float) -> float:
    return time.monotonic() - then_s


def _ending(error: BaseException) -> str:
    if isinstance(error, Stopped | KeyboardInterrupt):
        return "stopped"
    return f"failed: {str(error) or type(error).__name__}"

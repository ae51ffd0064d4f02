"""The store of a bench: every run in one SQLite file, readable by others while one is being written."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import asdict, replace
from pathlib import Path
from struct import unpack
from types import TracebackType
from typing import Any, Self

from labcal.errors import InputError
from labcal.files.home import home
from labcal.record import Run, RunHeader
from labcal.record.assemble import assemble
from labcal.record.run_id import as_file_name, checked_run_id
from labcal.record.stream import Event, Item
from labcal.store.bundle import Bundle, bundle_of, load_bundle
from labcal.store.database import (
    CHECKED_BEFORE_A_RUN_BYTES,
    Connection,
    connect,
    named_faults,
    require_sound,
    transaction,
)
from labcal.store.items import Row, from_row, header_from_json, to_json, to_row
from labcal.store.limits import shortened
from labcal.store.listing import (
    FILE,
    LAST_CORRECTION,
    LAST_STATUS,
    RunSummary,
    corrected,
    lock_file,
    summaries,
    true_status,
)
from labcal.store.liveness import Alive
from labcal.store.place import require_same
from labcal.store.schema import CORRECTED
from labcal.store.summary import describe
from labcal.store.writer import INSERT_ITEM, INSERT_STATUS, RunWriter, utc_now


class Store:
    """One bench's runs. A store object belongs to one thread; any number may be open on the same file."""

    def __init__(self, path: Path, connection: Connection) -> None:
        self.path, self._connection = path, connection

    @classmethod
    def open(cls, path: Path | None = None) -> Self:
        """Open the store file `path` (default: the user's own, see `labcal.files.home`), made where it is absent.

        Raises InputError where the file is damaged or another program's, InstrumentError where it is locked.
        """
        path = home() / FILE if path is None else path
        return cls(path, connect(path))

    def close(self) -> None:
        """Let go of the file."""
        self._connection.close()

    def __enter__(self) -> Self:
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, _: TracebackType | None) -> None:
        self.close()

    def begin(self, header: RunHeader) -> RunWriter:
        """Begin a run. Raises InputError where its run id is taken, or the store is damaged."""
        if not header.dut.serial:
            raise InputError("a run needs the serial number of its DUT")
        require_sound(self._connection, self.path, CHECKED_BEFORE_A_RUN_BYTES)
        _refuse_name(header.run_id)
        self._require_free(header.run_id)
        alive = Alive(self.lock_file(header.run_id))
        try:
            with self._written():
                number = self._add(header.run_id, to_json(asdict(header)), "running")
            return RunWriter(self.path, number, header.run_id, alive)
        except BaseException:
            alive.end()
            raise

    def resume(self, run_id: str) -> RunWriter:
        """Go on with an interrupted run. Raises InputError where there is none that was interrupted."""
        if (status := self.status(run_id)) != "interrupted":
            raise InputError(f"run {run_id} was not interrupted: it is {status}")
        require_sound(self._connection, self.path, CHECKED_BEFORE_A_RUN_BYTES)
        alive = Alive(self.lock_file(run_id))
        try:
            with self._written():
                number = self._number(run_id)
                self._connection.execute(INSERT_STATUS, (number, "running", utc_now()))
            return RunWriter(self.path, number, run_id, alive)
        except BaseException:
            alive.end()
            raise

    def add_bundle(self, path: Path) -> str:
        """Import a bundle, byte for byte, and return its run id; the same one again changes nothing.

        Raises InputError at the bundle's first fault, and where its run id belongs to another run here.
        """
        bundle = load_bundle(path)
        run_id = bundle.run().run_id
        if self._has(run_id):
            if self.bundle(run_id).sha256 != bundle.sha256:
                raise InputError(f"the store has another run called {run_id}", file=path)
            return run_id
        with self._written():
            number = self._add(run_id, bundle.run_json.decode("utf-8-sig"), "imported")
            parts = (number, bundle.run_json, bundle.samples_csv)
            self._connection.execute("INSERT INTO bundle (run, run_json, samples_csv) VALUES (?, ?, ?)", parts)
        return run_id

    def runs(self) -> list[RunSummary]:
        """All runs, the oldest first."""
        return summaries(self._connection, self.path)

    def status(self, run_id: str) -> str:
        """How the run stands. Raises InputError where there is no such run."""
        number = self._number(run_id)
        ((status,),) = self._all(f"SELECT {LAST_STATUS} FROM run WHERE number = ?", number)
        return true_status(self.path, run_id, str(status))

    def header(self, run_id: str) -> RunHeader:
        """The head of a recorded run. Raises InputError where there is no such run, or it was imported."""
        if self._imported(run_id) is not None:
            raise InputError(f"run {run_id} was imported: what is known of it stands in its bundle")
        ((text, correction),) = self._all(f"SELECT header, {LAST_CORRECTION} FROM run WHERE run_id = ?", run_id)
        header = header_from_json(text)
        serial = corrected(correction)
        return replace(header, dut=replace(header.dut, serial=serial)) if serial else header

    def correct_serial(self, run_id: str, serial: str, who: str) -> None:
        """State another serial of the DUT, as an event of the record. Raises InputError where that cannot be.

        What was written when the run began stays; the last correction counts.
        """
        header, status = self.header(run_id), self.status(run_id)
        if status == "running":
            raise InputError(f"run {run_id} is being recorded: correct its serial after it")
        if not serial.strip():
            raise InputError("a run needs the serial number of its DUT")
        data = {"from": header.dut.serial, "to": serial.strip(), "by": who, "utc": utc_now()}
        text = f"DUT serial {data['from']} corrected to {data['to']} by {who}"
        row = to_row(Event(self.end_s(run_id), CORRECTED, text, data))
        with self._written():
            self._connection.execute(INSERT_ITEM, (self._number(run_id), *row))

    def cage_sha256(self, run_id: str) -> str | None:
        """SHA-256 of the approved cage calibration that drove the run; None where none did, or it was imported."""
        return None if self._imported(run_id) is not None else self.header(run_id).cage_sha256

    def items(self, run_id: str, *, skip: int = 0, but: str = "", raw: bool = True) -> Iterator[Item]:
        """The timeline of a recorded run, after its first `skip` items: committed ones, in the order of writing.

        `but` leaves one kind out ("block"); without `raw` the frames as they came over the wire stay in the file.
        """
        number, what = self._number(run_id), ", ".join(Row._fields if raw else Row._fields[:-1])
        with named_faults(self.path):
            query = f"SELECT {what} FROM item WHERE run = ? AND kind <> ? ORDER BY number LIMIT -1 OFFSET ?"
            for row in self._connection.execute(query, (number, but, skip)):
                yield from_row(Row(*row))

    def end_s(self, run_id: str) -> float:
        """The last stamp of a recorded run: where the clock of one that is resumed must go on, not begin again."""
        rows = self._all("SELECT t_s, substr(stamps, -8) FROM item WHERE run = ?", self._number(run_id))
        return max((unpack("<d", last)[0] if last else t_s for t_s, last in rows), default=0.0)

    def run(self, run_id: str) -> Run:
        """The run's rows, as far as they are committed. Raises InputError where there is no such run."""
        imported = self._imported(run_id)
        return assemble(self.header(run_id), self.items(run_id, raw=False)) if imported is None else imported.run()

    def bundle(self, run_id: str) -> Bundle:
        """The run's exported bundle; of an imported run the bytes that came in."""
        return self._imported(run_id) or bundle_of(self.run(run_id))

    def describe(self, run_id: str) -> dict[str, Any]:
        """What the run is, in one look (see `labcal.store.summary`)."""
        status = self.status(run_id)
        if (imported := self._imported(run_id)) is not None:
            return describe(imported.run(), status)
        header, items = self.header(run_id), list(self.items(run_id, raw=False))
        return describe(assemble(header, items), status, header, items)

    @contextmanager
    def _written(self) -> Iterator[None]:
        """A transaction whose rows are in the file that lies there when it is over."""
        with transaction(self._connection, self.path):
            yield
        require_same(self.path, self._connection.files)

    def _add(self, run_id: str, header: str, status: str) -> int:
        self._require_free(run_id)
        insert = "INSERT INTO run (run_id, header) VALUES (?, ?)"
        number = self._connection.execute(insert, (run_id, header)).lastrowid
        assert number is not None
        self._connection.execute(INSERT_STATUS, (number, status, utc_now()))
        return number

    def _require_free(self, run_id: str) -> None:
        if self._has(run_id):
            raise InputError(f"the store has a run called {run_id} already")

    def _has(self, run_id: str) -> bool:
        return bool(self._all("SELECT 1 FROM run WHERE run_id = ?", run_id))

    def _number(self, run_id: str) -> int:
        found = self._all("SELECT number FROM run WHERE run_id = ?", run_id)
        if not found:
            name = as_file_name(shortened(run_id))
            raise InputError(f"the store has no run called {name}; `labcal runs` lists those it has", file=self.path)
        return int(found[0][0])

    def _imported(self, run_id: str) -> Bundle | None:
        found = self._all("SELECT run_json, samples_csv FROM bundle WHERE run = ?", self._number(run_id))
        return Bundle(found[0][0], found[0][1], Path(run_id), of_store=True) if found else None

    def lock_file(self, run_id: str) -> Path:
        """The file that is locked as long as the run's writer is alive."""
        return lock_file(self.path, run_id)

    def _all(self, query: str, *values: object) -> list[tuple[Any, ...]]:
        with named_faults(self.path):
            return self._connection.execute(query, values).fetchall()


def _refuse_name(run_id: str) -> None:
    try:
        checked_run_id(run_id)
    except ValueError as error:
        raise InputError(str(error)) from None

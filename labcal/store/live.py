"""The store of a bench: every run in one SQLite file, readable by others while one is being written."""

from __future__ import annotations

import sqlite3
from collections.abc import Iterator, Mapping
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
from labcal.record.endings import ended_words
from labcal.record.run_id import as_file_name, checked_run_id
from labcal.record.stream import Event, Item
from labcal.store import chain
from labcal.store.bundle import Bundle, bundle_of, load_bundle
from labcal.store.database import (
    CHECKED_BEFORE_A_RUN_BYTES,
    PATIENCE_S,
    Connection,
    connect,
    named_faults,
    require_sound,
    transaction,
)
from labcal.store.items import ItemRow, from_row, header_from_json, to_json, to_row
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
from labcal.store.origin import chain_jsonl, ends, last_link
from labcal.store.place import require_same
from labcal.store.schema import CORRECTED
from labcal.store.summary import describe
from labcal.store.writer import RunWriter, Utc, utc_now

NOT_USED = "nothing is made of it. `labcal check-store` looks through the whole store; go on with a copy from before"


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

    @classmethod
    def read_only(cls, path: Path) -> Self:
        """Open a store that is there to be read and nothing else. Raises InputError, InstrumentError as `open` does."""
        place = f"{path.resolve().as_uri()}?mode=ro"
        with named_faults(path):
            return cls(path, sqlite3.connect(place, PATIENCE_S, isolation_level=None, factory=Connection, uri=True))

    def close(self) -> None:
        """Let go of the file."""
        self._connection.close()

    def __enter__(self) -> Self:
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, _: TracebackType | None) -> None:
        self.close()

    def begin(self, header: RunHeader, utc: Utc = utc_now) -> RunWriter:
        """Begin a run; `utc` tells the time of its statuses.

        Raises InputError where its run id is taken, or the store is damaged.
        """
        if not header.dut.serial:
            raise InputError("a run needs the serial number of its DUT")
        require_sound(self._connection, self.path, CHECKED_BEFORE_A_RUN_BYTES)
        _refuse_name(header.run_id)
        self._require_free(header.run_id)
        alive = Alive(self.lock_file(header.run_id))
        try:
            with self._written():
                number = self._add(header.run_id, to_json({**asdict(header), "chain": chain.FORMAT}))
                chain.append(self._connection, number, "status", ("running", utc()))
            return RunWriter(self.path, number, header.run_id, alive, utc)
        except BaseException:
            alive.end()
            raise

    def resume(self, run_id: str, utc: Utc = utc_now) -> RunWriter:
        """Go on with an interrupted run, in the same chain.

        Raises InputError where there is none that was interrupted, or what is there does not fit its chain.
        """
        if (status := self.status(run_id)) != "interrupted":
            raise InputError(f"run {run_id} is none to be gone on with: it is {ended_words(status)}")
        require_sound(self._connection, self.path, CHECKED_BEFORE_A_RUN_BYTES)
        self.chain_of(run_id)
        alive = Alive(self.lock_file(run_id))
        try:
            with self._written():
                number = self._number(run_id)
                chain.append(self._connection, number, "status", ("running", utc()))
            return RunWriter(self.path, number, run_id, alive, utc)
        except BaseException:
            alive.end()
            raise

    def add_bundle(self, path: Path) -> str:
        """Import a bundle, byte for byte, and return its run id; the same one again changes nothing.

        Raises InputError at the bundle's first fault, and where its run id belongs to another run here.
        """
        bundle = load_bundle(path)
        run_id = bundle.run().run_id
        if self.has(run_id):
            if self.bundle(run_id).sha256 != bundle.sha256:
                raise InputError(f"the store has another run called {run_id}: state another run_id", file=path)
            return run_id
        with self._written():
            number = self._add(run_id, bundle.run_json.decode("utf-8-sig"))
            chain.append(self._connection, number, "bundle", (bundle.run_json, bundle.samples_csv))
            if bundle.chain:
                chain.append(self._connection, number, "origin", (bundle.chain,))
            chain.append(self._connection, number, "status", ("imported", utc_now()))
        return run_id

    def runs(self) -> list[RunSummary]:
        """All runs, the oldest first."""
        return summaries(self._connection, self.path)

    def summary(self, run_id: str) -> RunSummary:
        """One line about a run. Raises InputError where there is no such run."""
        [found] = summaries(self._connection, self.path, self._number(run_id))
        return found

    def first_and_last(self) -> tuple[str, str]:
        """The ids of the run that the store began with and of the newest; "" where it has none."""
        found = [self._all(f"SELECT run_id FROM run ORDER BY number {way} LIMIT 1") for way in ("ASC", "DESC")]
        return str(found[0][0][0]) if found[0] else "", str(found[1][0][0]) if found[1] else ""

    def missing(self) -> str:
        """What the numbers of the runs say of one that is gone from before another, in words; "" where none is."""
        for place, (number, run_id) in enumerate(self._all("SELECT number, run_id FROM run ORDER BY number"), 1):
            if number != place:
                return f"run {run_id} is the store's number {number}, and number {place} is gone"
        return ""

    def status(self, run_id: str) -> str:
        """How the run stands. Raises InputError where there is no such run."""
        number = self._number(run_id)
        ((status,),) = self._all(f"SELECT {LAST_STATUS} FROM run WHERE number = ?", number)
        return true_status(self.path, run_id, str(status))

    def statuses(self, run_id: str) -> list[tuple[str, str]]:
        """Every status that was written, with its time (ISO 8601, UTC), the first first."""
        number = self._number(run_id)
        found = self._all("SELECT status, utc FROM status WHERE run = ? ORDER BY rowid", number)
        return [(str(status), str(utc)) for status, utc in found]

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
            chain.append(self._connection, self._number(run_id), "item", row)

    def cage_sha256(self, run_id: str) -> str | None:
        """SHA-256 of the approved cage calibration that drove the run; None where none did, or it was imported."""
        return None if self._imported(run_id) is not None else self.header(run_id).cage_sha256

    def items(self, run_id: str, *, skip: int = 0, but: str = "", raw: bool = True) -> Iterator[Item]:
        """The timeline of a recorded run, after its first `skip` items: committed ones, in the order of writing.

        `but` leaves one kind out ("block"); without `raw` the frames as they came over the wire stay in the file.
        """
        number, what = self._number(run_id), ", ".join(ItemRow._fields if raw else ItemRow._fields[:-1])
        with named_faults(self.path):
            query = f"SELECT {what} FROM item WHERE run = ? AND kind <> ? ORDER BY number LIMIT -1 OFFSET ?"
            for row in self._connection.execute(query, (number, but, skip)):
                yield from_row(ItemRow(*row))

    def stored_bytes(self, run_id: str) -> int:
        """About how much the store keeps of a run: stamps, samples and raw frames, or the files that came in."""
        number, parts = self._number(run_id), ("stamps", "samples", "raw")
        lengths = " + ".join(f"coalesce(sum(length({part})), 0)" for part in parts)
        [(recorded,)] = self._all(f"SELECT {lengths} FROM item WHERE run = ?", number)
        came = self._all("SELECT length(samples_csv) FROM bundle WHERE run = ?", number)
        return int(recorded + sum(size for (size,) in came))

    def end_s(self, run_id: str) -> float:
        """The last stamp of a recorded run: where the clock of one that is resumed must go on, not begin again."""
        rows = self._all("SELECT t_s, substr(stamps, -8) FROM item WHERE run = ?", self._number(run_id))
        return max((unpack("<d", last)[0] if last else t_s for t_s, last in rows), default=0.0)

    def run(self, run_id: str) -> Run:
        """The run's rows, as far as they are committed. Raises InputError where there is no such run."""
        self.chain_of(run_id)
        imported = self._imported(run_id)
        return self._recorded(run_id) if imported is None else imported.run()

    def bundle(self, run_id: str, *, with_chain: bool = False) -> Bundle:
        """The run's exported bundle, with its chain.jsonl where it is asked for; of an imported run what came in.

        A run that has not ended hands out no chain: nobody could tell it from one that was cut off.
        """
        origin, imported = self.chain_of(run_id), self._imported(run_id)
        return self._exported(run_id, self._recorded(run_id), origin, with_chain) if imported is None else imported

    def bundle_and_run(self, run_id: str) -> tuple[Bundle, Run]:
        """The bundle with its chain, as `bundle` has it, and its rows: what is stored is walked and read once."""
        origin, imported = self.chain_of(run_id), self._imported(run_id)
        if imported is not None:
            return imported, imported.run()
        run = self._recorded(run_id)
        return self._exported(run_id, run, origin, with_chain=True), run

    def _recorded(self, run_id: str) -> Run:
        return assemble(self.header(run_id), self.items(run_id, raw=False))

    def _exported(self, run_id: str, run: Run, origin: chain.Chain | None, with_chain: bool) -> Bundle:
        lines = chain_jsonl(self._connection, self._number(run_id)) if with_chain and ends(self.status(run_id)) else b""
        return replace(bundle_of(run), chain=lines, origin=origin)

    def chain_of(self, run_id: str) -> chain.Chain | None:
        """The head of the chain that binds all that the store has of a run; None for a run of before there were chains.

        Raises InputError naming the first row that does not fit.
        """
        number = self._number(run_id)
        with named_faults(self.path), self._one_state():
            try:
                return chain.walk(self._connection, number)
            except chain.Misfit as misfit:
                words = f"run {run_id} does not fit its hash chain: {misfit}; {NOT_USED}"
                raise InputError(words, file=self.path) from None

    def head_of(self, run_id: str) -> str | None:
        """The head of a run's chain as it stands, its rows not looked at; None where it has none."""
        last = self._all(chain.LAST, self._number(run_id))
        return str(last[0][1]) if last else None

    def has_head(self, run_id: str, stated: Mapping[str, Any] | None) -> bool:
        """Whether the chain of a run had this head once, as a calibration states it: a run may have gone on since.

        True as well where none is stated, or where a run came without a chain. Raises InputError where its chain
        does not fit.
        """
        self.chain_of(run_id)
        if stated is None:
            return True
        if (imported := self._imported(run_id)) is not None:
            return imported.stated_chain in (None, dict(stated))
        query = "SELECT 1 FROM chain WHERE run = ? AND place = ? AND sha256 = ?"
        return bool(self._all(query, self._number(run_id), stated["rows"], stated["head"]))

    def has_link(self, run_id: str, sha256: str) -> bool:
        """Whether the chain of a run has this link, wherever in it."""
        query = "SELECT 1 FROM chain WHERE run = ? AND sha256 = ?"
        return bool(self._all(query, self._number(run_id), sha256))

    def describe(self, run_id: str) -> dict[str, Any]:
        """What the run is, in one look (see `labcal.store.summary`)."""
        status, origin = self.status(run_id), self.chain_of(run_id)
        if (imported := self._imported(run_id)) is not None:
            return describe(imported.run(), status, origin=imported.origin)
        header, items = self.header(run_id), list(self.items(run_id, raw=False))
        return describe(assemble(header, items), status, header, items, origin)

    @contextmanager
    def _one_state(self) -> Iterator[None]:
        """What is read within is of one moment, whoever writes meanwhile."""
        self._connection.execute("BEGIN")
        try:
            yield
        finally:
            self._connection.execute("ROLLBACK")

    @contextmanager
    def _written(self) -> Iterator[None]:
        """A transaction whose rows are in the file that lies there when it is over."""
        with transaction(self._connection, self.path):
            yield
        require_same(self.path, self._connection.files)

    def _add(self, run_id: str, header: str) -> int:
        self._require_free(run_id)
        return chain.begin(self._connection, run_id, header)

    def _require_free(self, run_id: str) -> None:
        if self.has(run_id):
            raise InputError(f"the store has a run called {run_id} already")

    def has(self, run_id: str) -> bool:
        """Whether there is a run of this id."""
        return bool(self._all("SELECT 1 FROM run WHERE run_id = ?", run_id))

    def _number(self, run_id: str) -> int:
        found = self._all("SELECT number FROM run WHERE run_id = ?", run_id)
        if not found:
            name = as_file_name(shortened(run_id))
            raise InputError(f"the store has no run called {name}; `labcal runs` lists those it has", file=self.path)
        return int(found[0][0])

    def _imported(self, run_id: str) -> Bundle | None:
        found = self._all("SELECT run_json, samples_csv FROM bundle WHERE run = ?", self._number(run_id))
        if not found:
            return None
        came = self._all("SELECT chain_jsonl FROM origin WHERE run = ?", self._number(run_id))
        lines = came[0][0] if came else b""
        origin = last_link(lines) if lines else None
        return Bundle(found[0][0], found[0][1], Path(run_id), of_store=True, chain=lines, origin=origin)

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

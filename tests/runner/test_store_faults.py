"""The store fails while coils are on: they go to zero first, the run is interrupted, nothing that was kept is lost."""

from __future__ import annotations

import os
import sqlite3
import threading
import time
from collections.abc import Callable
from contextlib import closing, nullcontext
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from short_preflight import SHORT

from labcal import session
from labcal.bench import open_bench
from labcal.bench.clock import VirtualClock
from labcal.bench.coils.state import AT_ZERO, BY_WORD
from labcal.bench.steps import Procedure, energise
from labcal.errors import InputError, InstrumentError
from labcal.files.home import home
from labcal.record.stream import NOT_KEPT, SLOW_DISK, Block, Event, Item
from labcal.runner import Outcome, find, run_procedure, yes_to_all
from labcal.runner.control import NotKept
from labcal.runner.drive import Drive
from labcal.runner.seen_in_run import SeenInRun
from labcal.store import RunWriter, Store, live, writer

BenchFile = Callable[..., Path]
LONG_S = 60.0  # until something that must come is given up


class Broken:
    """A short preflight whose store breaks once the coils are on, and what was told of it, in order."""

    def __init__(
        self, bench_file: BenchFile, patch: pytest.MonkeyPatch, breaks: Callable[[Broken], None], mend: bool = False
    ) -> None:
        self.breaks, self.told, self.mended = breaks, list[Item](), list[Callable[[], None]]()
        self.writers = list[RunWriter]()
        begin = live.RunWriter

        def begun(*given: Any) -> RunWriter:
            self.writers.append(begin(*given))
            if mend and len(self.writers) == 1:
                self._mend_while_it_finishes(self.writers[0])
            return self.writers[-1]

        patch.setattr(live, "RunWriter", begun)
        self.clock = VirtualClock(datetime(2026, 11, 21, tzinfo=UTC))
        with closing(open_bench(bench_file(), clock=self.clock, seed=2)) as bench, Store.open() as store:
            given = SHORT | {"zero_s": "3"}
            answer, found = yes_to_all(True), find("preflight")
            self.outcome: Outcome = run_procedure(
                bench, found, given, store=store, answer=answer, on_item=self.tell, run_id="R"
            )
            lab: Any = bench.simulated_operator._lab
            self.currents_A = [float(coil.at(np.array([self.clock.now()]))[0]) for coil in lab.coils.values()]

    def tell(self, item: Item) -> None:
        self.told.append(item)
        if isinstance(item, Event) and item.kind == "set-point" and not self.mended:
            self.mended.append(lambda: None)
            self.breaks(self)
            wait_for(self.not_kept)

    def not_kept(self) -> bool:
        """Hand in one more row, large enough for a page of its own, and see whether that can be kept."""
        self.told.append(Event(self.clock.now(), "note", "x" * 20_000))
        try:
            self.writers[0].write(self.told[-1])
        except (InputError, InstrumentError):
            return True
        return False

    def _mend_while_it_finishes(self, writer: RunWriter) -> None:
        finish = writer.finish

        def mended(status: str) -> None:
            threading.Timer(0.5, lambda: [mend() for mend in self.mended]).start()
            finish(status)

        writer.finish = mended  # type: ignore[method-assign]


def wait_for(true: Callable[[], bool]) -> None:
    deadline = time.monotonic() + LONG_S
    while not true():
        assert time.monotonic() < deadline, "it never came true"
        time.sleep(0.02)


def locked(run: Broken) -> None:
    run.writers[0].late_s = 0.5
    other = sqlite3.connect(home() / "store.sqlite", isolation_level=None, check_same_thread=False)
    other.execute("BEGIN IMMEDIATE")
    run.mended.append(other.close)


def full(run: Broken) -> None:
    connection = run.writers[0]._connection
    connection.execute("PRAGMA max_page_count = 1")
    run.mended.append(lambda: connection.execute("PRAGMA max_page_count = 1000000"))


def slow(run: Broken) -> None:
    """A disk that does not answer: whoever commits waits in the system."""
    held, insert = threading.Event(), run.writers[0]._insert
    run.writers[0].late_s = 0.5

    def waits(rows: Any) -> None:
        held.wait(LONG_S)
        insert(rows)

    run.writers[0]._insert = waits  # type: ignore[method-assign]
    run.mended.append(held.set)


def unlinked(run: Broken) -> None:
    (home() / "store.sqlite").unlink()


def replaced(run: Broken) -> None:
    other = home() / "other.sqlite"
    with closing(sqlite3.connect(home() / "store.sqlite")) as here, closing(sqlite3.connect(other)) as there:
        here.backup(there)
    other.replace(home() / "store.sqlite")


def moved(run: Broken) -> None:
    home().rename(home().with_name("moved"))
    run.mended.append(lambda: home().with_name("moved").rename(home()))


def without_wal(run: Broken) -> None:
    (home() / "store.sqlite-wal").unlink()


@pytest.mark.parametrize(("breaks", "fault"), [(locked, "store locked"), (full, "disk full"), (slow, "store slow")])
def test_the_coils_go_first_and_what_waits_is_kept_when_the_store_is_whole_again(
    bench_file: BenchFile, monkeypatch: pytest.MonkeyPatch, breaks: Callable[[Broken], None], fault: str
) -> None:
    monkeypatch.setattr(writer, "PATIENCE_S", LONG_S)
    run = Broken(bench_file, monkeypatch, breaks, mend=True)
    goes_first(run, fault)
    assert run.outcome.ending.startswith("interrupted by its store: ")
    assert run.outcome.ending.endswith("to be kept; every row is kept by now")
    assert run.outcome.resumable
    with Store.open() as store:
        assert store.status("R") == "interrupted"
        kept = list(store.items("R"))
    assert [i for i in kept if not isinstance(i, Block)] == [i for i in run.told if not isinstance(i, Block)]
    assert samples(kept) == samples(run.told)
    if breaks is locked:
        assert session.resume("R", bench_file(), seed=2).status == "finished"


def test_a_disk_that_keeps_the_end_waiting_is_told_of_again(
    bench_file: BenchFile, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(writer, "SAY_S", 1.5)  # as on a bench where the way to rest has taken time
    monkeypatch.setattr(writer, "PATIENCE_S", 1.5)
    run = Broken(bench_file, monkeypatch, slow)
    told = [item.text for item in run.told if isinstance(item, Event) and item.kind == NOT_KEPT]
    assert [text.split(":")[0] for text in told] == ["the run ends", "the end of the run waits"]
    for mend in run.mended:
        mend()


@pytest.mark.skipif(os.name != "posix", reason="an open file cannot be moved or removed on Windows")
@pytest.mark.parametrize("breaks", [unlinked, replaced, moved, without_wal])
def test_rows_for_a_file_that_lies_there_no_more_are_never_called_kept(
    bench_file: BenchFile, monkeypatch: pytest.MonkeyPatch, breaks: Callable[[Broken], None]
) -> None:
    monkeypatch.setattr(writer, "PATIENCE_S", 0.5)
    run = Broken(bench_file, monkeypatch, breaks)
    goes_first(run, "store gone")
    assert (
        run.outcome.ending.endswith("while it was written to; what it held is lost where there is no copy")
        or breaks is replaced
    )
    assert not run.outcome.resumable
    for mend in run.mended:
        mend()


FULL = InstrumentError("the disk is full.", fault="disk full")


@pytest.mark.parametrize("told_by", ["write", "kept"])
def test_the_coils_are_at_zero_before_the_procedure_hears_of_it(bench_file: BenchFile, told_by: str) -> None:
    """`write` tells with the next item, `kept` while the procedure waits inside one long look at the streams."""
    seen, written, broken = list[float](), list[Item](), list[str]()

    def procedure() -> Procedure:
        try:
            yield from energise(bench, bench.cage.field_nT() + [15_000.0, 0.0, 0.0], confirm_signs=False)
            broken.append(told_by)
            begun = bench.clock.now()
            yield from bench.stream_until(begun + 100.0)
        finally:
            seen.append(float(np.abs(bench.cage.currents_A()).max()))
            seen.append(bench.clock.now() - begun)

    def write(item: Item) -> None:
        written.append(item)
        if "write" in broken:
            raise FULL

    def kept() -> None:
        if "kept" in broken:
            raise FULL

    with closing(open_bench(bench_file(), clock=VirtualClock(datetime(2026, 11, 21, tzinfo=UTC)), seed=2)) as bench:
        ending = Drive(bench, write, yes_to_all(True), kept=kept).run(procedure())
        assert np.abs(bench.cage.currents_A()).max() < 0.002
    assert (ending.status, ending.fault) == ("interrupted", FULL)
    assert seen[0] < 0.01
    assert seen[1] > 100.0 if told_by == "write" else seen[1] < 5.0
    assert isinstance(written[-1], Event)
    assert written[-1].kind == "read-back"
    assert written[-1].text.startswith((AT_ZERO, BY_WORD)), "what follows waits in memory"


def goes_first(run: Broken, fault: str) -> None:
    assert run.outcome.status == "interrupted"
    assert isinstance(run.outcome.fault, InstrumentError)
    assert run.outcome.fault.fault == fault
    assert run.outcome.at_rest.startswith((AT_ZERO, BY_WORD))
    assert max(map(abs, run.currents_A)) < 1e-3
    told = [item.text for item in run.told if isinstance(item, Event) and item.kind == NOT_KEPT]
    assert [text.startswith("the run ends: ") for text in told] == [True]


def samples(items: list[Item]) -> dict[str, list[float]]:
    """The stamps of each stream, in order."""
    found: dict[str, list[float]] = {}
    for item in items:
        if isinstance(item, Block):
            found.setdefault(f"{item.stream} {item.source} {item.columns}", []).extend(item.t_s.tolist())
    return found


def test_a_disk_that_is_busy_for_seconds_is_said_and_ends_nothing(
    bench_file: BenchFile, monkeypatch: pytest.MonkeyPatch
) -> None:
    def busy(run: Broken) -> None:
        insert = run.writers[0]._insert

        def slowly(rows: Any) -> None:
            monkeypatch.setattr(run.writers[0], "_insert", insert)
            time.sleep(1.6)
            insert(rows)

        monkeypatch.setattr(run.writers[0], "_insert", slowly)

    monkeypatch.setattr(Broken, "not_kept", lambda run: run.writers[0].waited_s > 1.2)
    run = Broken(bench_file, monkeypatch, busy)
    assert run.outcome.status == "finished"
    said = [item.text for item in run.told if isinstance(item, Event) and item.kind == SLOW_DISK]
    assert said[0] == "the disk is slow: rows wait 1 s in memory"


def test_that_rows_wait_is_said_once_a_second_and_when_they_do_no_more() -> None:
    said = list[Any]()
    seen = SeenInRun(said.append)
    for waited_s in (0.2, 1.1, 1.3, 2.4, 0.1, 0.2):
        seen.waits(5.0, waited_s)
    assert [item.text for item in said] == [
        "the disk is slow: rows wait 1 s in memory",
        "the disk is slow: rows wait 2 s in memory",
        "the disk takes what is recorded again",
    ]


@pytest.mark.parametrize(("asking", "ends"), [(True, False), (False, True)])
def test_a_run_that_rests_at_a_question_waits_for_a_disk_as_for_a_person(
    bench_file: BenchFile, asking: bool, ends: bool
) -> None:
    with closing(open_bench(bench_file(), clock=VirtualClock(datetime(2026, 11, 21, tzinfo=UTC)), seed=2)) as bench:
        drive = Drive(bench, lambda item: None, yes_to_all(True))
        bench.asking = asking
        with pytest.raises(NotKept) if ends else nullcontext(), drive.zero_unless_kept():
            raise InstrumentError("the disk did not take it.", fault="store slow")

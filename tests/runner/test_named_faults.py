"""Disk full, store locked, clock set back: each is named, the coils are at zero, and what was committed stays."""

from __future__ import annotations

import sqlite3
import time
from collections.abc import Callable, Iterator
from contextlib import closing, contextmanager
from datetime import UTC, datetime, timedelta
from pathlib import Path

import pytest
from short_preflight import SHORT

from labcal.bench import Bench, open_bench
from labcal.bench.clock import VirtualClock
from labcal.errors import InstrumentError
from labcal.files.home import home
from labcal.record.stream import NOT_KEPT, Event, Item, Step
from labcal.runner import Control, Outcome, find, run, run_procedure, yes_to_all
from labcal.store import Store, database, writer

BenchFile = Callable[..., Path]


class JumpingClock(VirtualClock):
    """A virtual clock whose wall time can be set back."""

    back = timedelta(0)

    def utc(self) -> datetime:
        return super().utc() - self.back


@contextmanager
def opened(bench_file: BenchFile, clock: VirtualClock | None = None) -> Iterator[Bench]:
    clock = clock or VirtualClock(datetime(2026, 11, 21, tzinfo=UTC))
    with closing(open_bench(bench_file(), clock=clock, seed=2)) as bench:
        yield bench
        assert abs(bench.cage.currents_A()).max() < 0.002
        with sqlite3.connect(home() / "store.sqlite") as found:
            assert found.execute("PRAGMA integrity_check").fetchone() == ("ok",)


def preflight(bench: Bench, tell: Callable[[Item], None] = lambda item: None, **more: Control) -> Outcome:
    with Store.open() as store:
        return run_procedure(
            bench,
            find("preflight"),
            SHORT | {"zero_s": "3"},
            store=store,
            answer=yes_to_all(True),
            on_item=tell,
            run_id="R",
            **more,
        )


def test_a_full_disk_is_named(bench_file: BenchFile, monkeypatch: pytest.MonkeyPatch) -> None:
    connect, connections = database.connect, list[sqlite3.Connection]()

    def kept(path: Path) -> sqlite3.Connection:
        connections.append(connect(path))
        return connections[-1]

    def fill(item: Item) -> None:
        if isinstance(item, Step) and item.name == "sync-check":
            wait_for_the_first_commit()
            pages = connections[0].execute("PRAGMA page_count").fetchone()[0]
            connections[0].execute(f"PRAGMA max_page_count = {pages}")

    monkeypatch.setattr(writer, "connect", kept)
    monkeypatch.setattr(writer, "PATIENCE_S", 0.1)
    with opened(bench_file) as bench:
        outcome = preflight(bench, fill)
    assert isinstance(outcome.fault, InstrumentError)
    assert outcome.fault.fault == "disk full"
    with Store.open() as store:
        assert list(store.items("R"))
        assert outcome.status == store.status("R") == "interrupted"


def wait_for_the_first_commit() -> None:
    """Hold the run until a first row of it is on the disk."""
    deadline = time.monotonic() + 30
    with Store.open() as store:
        while not list(store.items("R")):
            assert time.monotonic() < deadline, "nothing was committed in 30 s"
            time.sleep(0.02)


def test_a_locked_store_is_named(bench_file: BenchFile, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(writer, "PATIENCE_S", 1.0)
    holder: list[sqlite3.Connection] = []

    def lock(item: Item) -> None:
        if isinstance(item, Step) and item.name == "sync-check":
            holder.append(sqlite3.connect(home() / "store.sqlite", isolation_level=None))
            holder[0].execute("BEGIN IMMEDIATE")

    with opened(bench_file) as bench:
        outcome = preflight(bench, lock)
        holder[0].execute("ROLLBACK")
        holder[0].close()
    assert isinstance(outcome.fault, InstrumentError)
    assert outcome.fault.fault == "store locked"
    with Store.open() as store:
        assert outcome.status == store.status("R") == "interrupted"


def test_a_clock_that_is_set_back_is_named(bench_file: BenchFile) -> None:
    clock = JumpingClock(datetime(2026, 11, 21, tzinfo=UTC))

    def set_back(item: Item) -> None:
        if isinstance(item, Step) and item.name == "axes-check":
            clock.back = timedelta(hours=1)

    with opened(bench_file, clock) as bench:
        outcome = preflight(bench, set_back)
    assert outcome.status.startswith("failed: the computer's clock was set back by 3600.0 s")
    with Store.open() as store:
        assert store.status("R") == outcome.status


class Patient(Control):
    """A person who goes on at the third look, and not before."""

    looks = 0

    def wait_for_resume(self, at_most_s: float) -> None:
        self.looks += 1
        if self.looks == 3:
            self.resume()


def test_a_pause_waits_with_the_coils_at_zero_and_goes_on(bench_file: BenchFile) -> None:
    control, pauses = Patient(), list[Event]()

    def tell(item: Item) -> None:
        if isinstance(item, Step) and item.name == "z+20uT-nominal":  # coils on
            control.pause()
        if isinstance(item, Event) and item.kind == "pause":
            pauses.append(item)

    with opened(bench_file) as bench:
        outcome = preflight(bench, tell, control=control)
    assert outcome.status == "finished"
    assert [p.text for p in pauses] == ["paused, coils at zero", "goes on"]
    assert max(map(abs, pauses[0].data["current_A"])) < 0.002
    assert control.looks == 3


def test_a_stop_whose_end_the_store_does_not_keep_tells_both(
    bench_file: BenchFile, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(writer, "PATIENCE_S", 0.5)
    control, holder, said = Control(), list[sqlite3.Connection](), list[str]()

    def tell(item: Item) -> None:
        if isinstance(item, Step) and item.name == "sync-check":
            holder.append(sqlite3.connect(home() / "store.sqlite", isolation_level=None))
            holder[0].execute("BEGIN IMMEDIATE")
            control.stop()
        if isinstance(item, Event) and item.kind == NOT_KEPT:
            said.append(item.text)

    with opened(bench_file) as bench:
        outcome = preflight(bench, tell, control=control)
        holder[0].close()
    assert outcome.status == "interrupted"
    assert outcome.ending.startswith("stopped, but the store has not kept its end and shows it as interrupted: ")
    assert "the store was locked" in outcome.ending
    assert outcome.resumable
    assert isinstance(outcome.fault, InstrumentError), "a run that can be gone on with is no stopped one"
    assert outcome.fault.fault == "store locked"
    assert [text.startswith("the end of the run waits: ") for text in said] == [True]


def test_an_end_that_waited_for_the_disk_says_so(bench_file: BenchFile, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(run, "LONG_S", 0.0)
    with opened(bench_file) as bench:
        outcome = preflight(bench)
    assert outcome.status == "finished"
    assert outcome.ending == "finished, kept by the store 0 s later"

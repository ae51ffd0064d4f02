"""How often a run orders zero at its end, and what is said meanwhile to whoever watches."""

from __future__ import annotations

import time
from collections.abc import Callable
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

import pytest

from labcal.bench import open_bench
from labcal.bench.bench import Bench
from labcal.bench.clock import Clock, RealClock, VirtualClock
from labcal.bench.coils.at_zero import NOT_ORDERED, ORDERED, words_of_slow_zero
from labcal.bench.steps import Procedure
from labcal.errors import InstrumentError
from labcal.record.stream import Event, Item
from labcal.runner.drive import Drive

BenchFile = Callable[..., Path]


def nothing(bench: Bench) -> Procedure:
    """It sets nothing."""
    yield Event(bench.clock.now(), "note", "begun", {})


def driven(file: Path, clock: Clock, prepare: Callable[[Bench], None]) -> tuple[list[Item], list[Item]]:
    """What was written and what was told of a run that does nothing."""
    written, told = list[Item](), list[Item]()
    with open_bench(file, clock=clock, seed=1) as bench:
        prepare(bench)
        Drive(bench, written.append, lambda prompt: "", on_item=told.append).run(nothing(bench))
    return written, told


@pytest.mark.parametrize("lost", [0, 1], ids=["read back", "lost once"])
def test_zero_is_ordered_again_only_where_it_was_not_read_back(bench_file: BenchFile, lost: int) -> None:
    orders, faults = list[float](), [InstrumentError("it is gone.", fault="guardian lost")] * lost

    def counted(bench: Bench) -> None:
        zero: Any = bench.cage.zero

        def ordered() -> None:
            orders.append(bench.clock.now())
            if faults:
                raise faults.pop()
            zero()

        bench.cage.zero = ordered  # type: ignore[method-assign]

    written, _ = driven(bench_file(), VirtualClock(datetime(2026, 1, 1, tzinfo=UTC)), counted)
    assert len(orders) == 1 + lost + 1  # the last is the bench's own, as it is closed
    assert isinstance(written[-1], Event)
    assert written[-1].kind == "read-back"


@pytest.mark.parametrize(("slow_s", "says"), [(0.0, [ORDERED]), (1000.0, [])], ids=["slow", "in time"])
def test_whoever_watches_is_told_once_that_zero_was_ordered_where_it_takes_long(
    bench_file: BenchFile, monkeypatch: pytest.MonkeyPatch, slow_s: float, says: list[str]
) -> None:
    monkeypatch.setattr("labcal.bench.coils.at_zero.SLOW_S", slow_s)
    written, told = driven(bench_file(), RealClock(), lambda bench: None)
    assert [item.text for item in told if isinstance(item, Event) and item.kind == "slow-zero"] == says
    assert not [item for item in written if isinstance(item, Event) and item.kind == "slow-zero"]


@pytest.mark.parametrize(("ordered", "says"), [(True, ORDERED), (False, NOT_ORDERED)], ids=["ordered", "not reached"])
def test_zero_is_called_ordered_once_a_guardian_was_told(ordered: bool, says: str) -> None:
    assert words_of_slow_zero(None, ordered) == words_of_slow_zero(time.monotonic(), ordered) == ""
    assert words_of_slow_zero(time.monotonic() - 10.0, ordered) == says

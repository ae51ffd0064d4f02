"""A DUT that sends a thousand samples a second, through the runner into the record: every one of them, once.

And for as long as one likes: what a run needs of memory does not grow with it.
"""

from __future__ import annotations

import math
import os
from collections.abc import Callable
from contextlib import closing
from datetime import UTC, datetime
from pathlib import Path
from typing import Any, cast

import numpy as np
import pytest

from drivers.emulators.line import Pieces
from drivers.emulators.streaming import SampleClock
from labcal.bench import open_bench
from labcal.bench.clock import Clock, RealClock, VirtualClock
from labcal.record.stream import Block, Item, Measurement
from labcal.runner import Outcome, find, run_procedure, yes_to_all
from labcal.store import Store

RATE_HZ = 1000.0
START = datetime(2026, 11, 21, tzinfo=UTC)
MEMORY = Path("/proc/self/statm")
MOST_GROWTH = 8 << 20  # bytes: what waits for the next commit comes and goes


@pytest.mark.parametrize(
    "clock", [VirtualClock(START), pytest.param(RealClock(), marks=pytest.mark.slow)], ids=["virtual", "real"]
)
def test_no_sample_of_a_thousand_a_second_is_lost(bench_file: Callable[..., Path], clock: Clock) -> None:
    with closing(open_bench(bench_file(), clock=clock, seed=2)) as bench, Store.open() as store:
        wire: Any = bench.dut
        wire._link._emulator._beat = SampleClock(RATE_HZ, clock.now())
        given = {"rate_deg_per_s": "20", "zero_s": "2", "inclination_deg": "50"}
        outcome = run_procedure(bench, find("rotate-axis"), given, store=store, answer=yes_to_all(True))
        items, run = list(store.items(outcome.run_id)), store.run(outcome.run_id)
    assert outcome.status == "finished", outcome.fault
    assert len(dut_stamps(items)) > 20 * RATE_HZ
    assert np.diff(dut_stamps(items)) == pytest.approx(1 / RATE_HZ, abs=2e-4)
    assert np.diff(run.t_s) == pytest.approx(1 / RATE_HZ, abs=2e-4)
    assert len(run) > 17 * RATE_HZ


def test_a_room_is_measured_with_lines_that_arrive_together(bench_file: Callable[..., Path]) -> None:
    items = list[Item]()
    outcome = listened(bench_file(), 10.0, items.append)
    told = {item.name: item.value for item in items if isinstance(item, Measurement)}
    assert outcome.status == "finished", outcome.fault
    assert len(np.unique(dut_stamps(items))) < 0.2 * len(dut_stamps(items))
    assert told["50 Hz in dut samples"] == pytest.approx(50.0, abs=0.5)


@pytest.mark.skipif(not MEMORY.exists(), reason="tells its memory elsewhere")
@pytest.mark.parametrize("minutes", [3, pytest.param(60, marks=pytest.mark.slow)])
def test_memory_does_not_grow_while_it_records(bench_file: Callable[..., Path], minutes: int) -> None:
    held: list[int] = []

    def look(item: Item) -> None:
        if isinstance(item, Block) and item.t_s[-1] > 60 * (len(held) + 1):
            held.append(resident_bytes())

    outcome = listened(bench_file(), 60.0 * minutes, look)
    assert outcome.status == "finished", outcome.fault
    assert len(held) >= minutes
    assert max(held[1:]) - held[0] < MOST_GROWTH


def resident_bytes() -> int:
    """What this process has in memory now."""
    return int(MEMORY.read_text().split()[1]) * os.sysconf("SC_PAGE_SIZE")


def listened(bench_file: Path, seconds: float, tell: Callable[[Item], None]) -> Outcome:
    """The procedure `ambient` with a DUT whose lines come ten at once, a hundred times a second."""
    clock = VirtualClock(START)
    with closing(open_bench(bench_file, clock=clock, seed=2)) as bench, Store.open() as store:
        emulator = cast(Any, bench.dut)._link._emulator
        emulator._beat, each = SampleClock(RATE_HZ, clock.now()), emulator.emit
        emulator.emit = lambda until_s: together(each(until_s))
        given, answer = {"duration_s": f"{seconds}", "mains_s": "5"}, yes_to_all(True)
        return run_procedure(bench, find("ambient"), given, store=store, answer=answer, on_item=tell)


def together(pieces: Pieces) -> Pieces:
    """The same lines as a buffer hands them on: all of a hundredth of a second at its end."""
    buffers: dict[float, bytes] = {}
    for t_s, line in pieces:
        end = round(math.ceil(t_s * 100) / 100, 6)
        buffers[end] = buffers.get(end, b"") + line
    return list(buffers.items())


def dut_stamps(items: list[Item]) -> np.ndarray:
    return np.concatenate([i.t_s for i in items if isinstance(i, Block) and i.stream == "dut"])

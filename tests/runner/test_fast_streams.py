"""A DUT that sends a thousand samples a second, through the runner into the record: every one of them, once."""

from __future__ import annotations

from collections.abc import Callable
from contextlib import closing
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from drivers.emulators.streaming import Beat
from labcal.bench import open_bench
from labcal.bench.clock import Clock, RealClock, VirtualClock
from labcal.record.stream import Block, Item
from labcal.runner import find, run_procedure, yes_to_all
from labcal.store import Store

RATE_HZ = 1000.0
START = datetime(2026, 11, 21, tzinfo=UTC)


@pytest.mark.parametrize(
    "clock", [VirtualClock(START), pytest.param(RealClock(), marks=pytest.mark.slow)], ids=["virtual", "real"]
)
def test_no_sample_of_a_thousand_a_second_is_lost(bench_file: Callable[..., Path], clock: Clock) -> None:
    with closing(open_bench(bench_file(), clock=clock, seed=2)) as bench, Store.open() as store:
        wire: Any = bench.dut
        wire._link._emulator._beat = Beat(RATE_HZ, clock.now())
        given = {"rate_deg_per_s": "20", "zero_s": "2", "inclination_deg": "50"}
        outcome = run_procedure(bench, find("rotate-axis"), given, store=store, answer=yes_to_all(True))
        items, run = list(store.items(outcome.run_id)), store.run(outcome.run_id)
    assert outcome.status == "finished", outcome.fault
    assert len(dut_stamps(items)) > 20 * RATE_HZ
    assert np.diff(dut_stamps(items)) == pytest.approx(1 / RATE_HZ, abs=2e-4)
    assert np.diff(run.t_s) == pytest.approx(1 / RATE_HZ, abs=2e-4)
    assert len(run) > 17 * RATE_HZ


def dut_stamps(items: list[Item]) -> np.ndarray:
    return np.concatenate([i.t_s for i in items if isinstance(i, Block) and i.stream == "dut"])

"""The session is heard whenever it waits: how long it computes between two waits while the coils carry current."""

from __future__ import annotations

import time
from collections.abc import Callable
from contextlib import closing
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

import pytest

from labcal.bench import open_bench
from labcal.bench.clock import VirtualClock
from labcal.runner import find, run_procedure, yes_to_all
from labcal.store import Store

QUICK: dict[str, dict[str, str]] = {
    "preflight": {"axes": "z", "modes": "nominal", "rate_deg_per_s": "20", "zero_s": "2", "dwell_s": "1"},
    "cage-calibration": {"steps": "2", "dwell_s": "1.5"},
    "cage-map": {"probes": "2", "dwell_s": "1"},
    "current-coupling": {"repeats": "2", "dwell_s": "3"},
    "degauss": {"cycles": "6", "hold_s": "0.1"},
    "dut-moment": {"rate_deg_per_s": "20", "rest_s": "2"},
    "field-hold": {"duration_s": "20"},
    "linearity": {"steps": "2", "dwell_s": "1"},
    "play-field": {"duration_s": "20", "step_s": "5"},
    "rate-sweep": {"rates_deg_per_s": "20"},
    "reference-check": {"dwell_s": "2"},
    "temperature-drift": {"rounds": "4", "dwell_s": "3"},
    "verify": {"positions": "4", "dwell_s": "1"},
}


class Watched(VirtualClock):
    """In the steps of the real clock; takes down the processor's time of this thread between two waits, coils on."""

    listen_s = 0.005

    def __init__(self) -> None:
        super().__init__(datetime(2026, 11, 21, tzinfo=UTC))
        self.energised: Callable[[], bool] = bool
        self.longest_s, self._since_s, self._on = 0.0, 0.0, False

    def wait_until(self, t_s: float) -> None:
        now = time.thread_time()
        self.longest_s = max(self.longest_s, now - self._since_s if self._on else 0.0)
        super().wait_until(t_s)
        self._since_s, self._on = time.thread_time(), self.energised()


@pytest.mark.slow
@pytest.mark.parametrize("name", QUICK)
def test_no_procedure_computes_for_long_while_the_coils_carry_current(
    bench_file: Callable[..., Path], name: str
) -> None:
    """A quarter of the least silence after which the guardian ends a session; the processor's time, not the clock's."""
    clock: Any = Watched()
    with closing(open_bench(bench_file(), clock=clock, seed=3)) as bench, Store.open() as store:
        clock.energised = lambda: bench.cage.on
        outcome = run_procedure(bench, find(name), QUICK[name], store=store, answer=yes_to_all(True))
    assert outcome.status == "finished", outcome.fault
    assert clock.longest_s < 0.3 / 4

"""At Go on the reference confirms a zero by what the run had measured before it was interrupted, as old as that is."""

from __future__ import annotations

import time
from collections.abc import Callable
from contextlib import closing
from datetime import UTC, datetime, timedelta
from pathlib import Path

import numpy as np
import pytest
from short_preflight import SHORT

from labcal.bench import Bench, open_bench
from labcal.bench.clock import VirtualClock
from labcal.bench.coils.agreement import BEFORE_HANDS
from labcal.bench.coils.before_hands import DRIFT_NT_PER_H
from labcal.bench.coils.state import Witness
from labcal.record.stream import Measurement, Prompt
from labcal.runner import awaited, drive, find, run_procedure
from labcal.runner.ambient_before import last_zero
from labcal.runner.control import Control
from labcal.runner.run import resume_run
from labcal.store import Store

BenchFile = Callable[..., Path]
BEGAN = datetime(2026, 11, 21, 7, tzinfo=UTC)
LONG_S = 6.0  # until a witness that does not come is given up


def stopped_in_its_first_turn(bench: Path) -> None:
    control = Control(to_be_resumed=True)
    with closing(open_bench(bench, clock=VirtualClock(BEGAN), seed=2)) as lab, Store.open() as store:

        def tell(item: object) -> None:
            if getattr(item, "name", "") == "axes-check":
                control.stop()

        run_procedure(
            lab, find("preflight"), SHORT, store=store, answer=lambda p: p.choices[0], on_item=tell, run_id="R",
            control=control,
        )  # fmt: skip


def seen_at_the_first_question(bench: Path, later_h: float, change: Callable[[Bench], None]) -> Witness:
    seen = list[Witness]()
    clock = VirtualClock(BEGAN + timedelta(hours=later_h))
    with closing(open_bench(bench, clock=clock, seed=2)) as lab, Store.open() as store:
        change(lab)

        def answer(prompt: Prompt) -> str:
            ends_s = time.monotonic() + LONG_S
            while time.monotonic() < ends_s and lab.state().reference.read_s is None:
                time.sleep(0.02)
            seen.append(lab.state().reference)
            raise KeyboardInterrupt

        resume_run(lab, find("preflight"), "R", store=store, answer=answer)
    return seen[0]


@pytest.fixture
def stopped(bench_file: BenchFile, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setattr(awaited, "AGAIN_S", 0.1)
    monkeypatch.setattr(drive, "LISTEN_S", 0.05)
    bench = bench_file()
    stopped_in_its_first_turn(bench)
    return bench


@pytest.mark.parametrize("later_h", [1.0, 3.0])
def test_the_zero_is_confirmed_at_the_first_question(stopped: Path, later_h: float) -> None:
    seen = seen_at_the_first_question(stopped, later_h, lambda lab: None)
    assert (seen.verdict, seen.why) == ("agrees", BEFORE_HANDS)
    fresh = 2_000.0
    assert seen.limit_nT - fresh == pytest.approx(later_h * DRIFT_NT_PER_H, abs=DRIFT_NT_PER_H / 60)  # a minute of it


def test_what_has_changed_meanwhile_confirms_nothing(stopped: Path) -> None:
    def moved(lab: Bench) -> None:
        remember = lab.cage.check.remember
        lab.cage.check.remember = lambda before: remember(type(before)(before.field_nT + 3_000.0, before.measured_s))

    seen = seen_at_the_first_question(stopped, 1.0, moved)
    assert seen.verdict == "not known"


def zero(axis: str, value: float, t_s: float, name: str = "zero") -> Measurement:
    return Measurement(t_s, f"{name}: ref_{axis}", value, 1.0, "nT")


def test_the_last_whole_zero_counts_and_no_other_measurement() -> None:
    first = [zero(axis, 10.0 * n, 1.0) for n, axis in enumerate("xyz")]
    again = [zero(axis, 20.0 * n, 9.0) for n, axis in enumerate("xyz")]
    found = last_zero([*first, *again, zero("x", 5.0, 12.0), *(zero(a, 7.0, 14.0, "closing") for a in "xyz")])
    assert found is not None
    assert np.array_equal(found[0], [0.0, 20.0, 40.0])
    assert found[1] == 9.0
    assert last_zero([zero("x", 1.0, 0.0), zero("y", 1.0, 0.0)]) is None

"""Whoever watches is told how the lab is on a ramp and on the way to zero too, and not only at its end."""

from __future__ import annotations

from collections.abc import Callable
from contextlib import closing
from datetime import UTC, datetime
from pathlib import Path

import pytest

from labcal.bench import open_bench
from labcal.bench.clock import VirtualClock
from labcal.bench.coils.state import LabState
from labcal.runner import drive, find, run_procedure
from labcal.runner.prompts import first_choice
from labcal.store import Store

TURN = {"zero_s": "8", "rate_deg_per_s": "20"}


def test_currents_are_shown_while_they_rise(bench_file: Callable[..., Path], monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(drive, "SHOWN_S", 0.0)
    shown = list[LabState]()
    clock = VirtualClock(datetime(2026, 11, 21, tzinfo=UTC))
    with closing(open_bench(bench_file(), clock=clock, seed=2)) as lab, Store.open() as store:
        run_procedure(lab, find("rotate-axis"), TURN, store=store, answer=first_choice, show=shown.append)
    z_A = [abs(state.coils[2].current_A or 0.0) for state in shown]
    assert [i for i in z_A if 0.01 < i < 0.9 * max(z_A)]


def test_who_is_lost_is_shown_while_the_guardian_still_tries_to_reach_it(monkeypatch: pytest.MonkeyPatch) -> None:
    told, state = list[LabState](), LabState(())
    monkeypatch.setattr(drive, "SHOWN_S", 60.0)
    bench = type("Waits", (), {
        "state": lambda self: state, "slow_zero": lambda self: "", "clock": type("Clock", (), {"now": lambda self: 0.0})(),
        "cage": type("Cage", (), {"on": False})(),
    })()  # fmt: skip
    one = drive.Drive(bench, lambda item: None, first_choice, show=told.append)
    for _ in range(3):
        one._say_what_takes_long()
    assert len(told) == 1  # at once, and then no more often than is of use

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
from labcal.record.stream import Item
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


def test_and_while_the_guardian_still_tries_to_reach_who_is_lost(
    bench_file: Callable[..., Path], monkeypatch: pytest.MonkeyPatch
) -> None:
    """The clock has everybody look who asked for it; nothing of the run comes meanwhile."""
    shown, looks, more = list[LabState](), list[Callable[[], None]](), list[int]()

    class Waiting(VirtualClock):
        def while_waiting(self, look: Callable[[], None]) -> None:
            looks.append(look)

    def tell(item: Item) -> None:
        monkeypatch.setattr(drive, "SHOWN_S", 0.0)
        before = len(shown)
        looks[-1]()
        monkeypatch.setattr(drive, "SHOWN_S", 1e9)
        looks[-1]()
        more.append(len(shown) - before)

    clock = Waiting(datetime(2026, 11, 21, tzinfo=UTC))
    with closing(open_bench(bench_file(), clock=clock, seed=2)) as lab, Store.open() as store:
        answers = first_choice
        run_procedure(lab, find("rotate-axis"), TURN, store=store, answer=answers, on_item=tell, show=shown.append)
    assert set(more) == {1}

"""What was lost while a run goes on is told when it is noticed, before what came later, and with its age where not."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import closing
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

import pytest

from labcal.bench import Bench, open_bench
from labcal.bench.clock import VirtualClock
from labcal.bench.steps import Procedure, note
from labcal.record.stream import Event, Item
from labcal.runner.drive import PROMPT_S, Drive

EXAMPLE = Path(__file__).parents[2] / "examples" / "simulated.toml"
Told = tuple[float, Event]


@pytest.fixture
def bench() -> Iterator[Bench]:
    with closing(open_bench(EXAMPLE, clock=VirtualClock(datetime(2026, 1, 1, tzinfo=UTC)), seed=1)) as bench:
        yield bench


def waits_long(bench: Bench, looks: bool) -> Procedure:
    """Twelve seconds go by in small steps, coils at zero; in eight of them the DUT sends nothing. It yields nothing."""
    dut: Any = bench._links["dut"]
    emit = dut._emulator.emit
    yield note(bench, "begins")
    bench.look = bench.look if looks else lambda: None
    by(bench, 1.0)
    dut._emulator.emit = lambda until_s: [piece for piece in emit(until_s) if False]
    by(bench, 8.0)
    dut._emulator.emit = emit
    by(bench, 3.0)
    yield note(bench, "ends")


def by(bench: Bench, seconds: float) -> None:
    end = bench.clock.now() + seconds
    while bench.clock.now() < end:
        bench.stream_until(min(end, bench.clock.now() + 0.2))


def told_and_written(bench: Bench, looks: bool) -> tuple[list[Told], list[Event]]:
    told, written = list[Told](), list[Item]()
    drive = Drive(bench, written.append, lambda prompt: "", on_item=lambda item: keep(told, bench, item))
    ended = drive.run(waits_long(bench, looks))
    assert ended.status == "finished", ended
    return told, [item for item in written if isinstance(item, Event) and item.kind in ("stream", "note")]


def keep(told: list[Told], bench: Bench, item: Item) -> None:
    if isinstance(item, Event) and item.kind in ("stream", "note"):
        told.append((bench.clock.now(), item))


def test_news_is_told_while_a_procedure_waits(bench: Bench) -> None:
    told, _ = told_and_written(bench, looks=True)
    assert [event.data.get("fault", event.text) for _, event in told] == ["begins", "silent", "heard again", "ends"]
    assert all(now - event.t_s <= PROMPT_S and "ago" not in event.text for now, event in told)


def test_news_that_is_told_late_comes_before_what_is_newer_and_says_how_old_it_is(bench: Bench) -> None:
    told, written = told_and_written(bench, looks=False)
    assert [event.data.get("fault", event.text) for _, event in told] == ["begins", "silent", "heard again", "ends"]
    for now, event in told[1:3]:
        assert event.text.startswith(f"{now - event.t_s:.1f} s ago: dut: ")
    assert [event.text.split(" for ")[0] for event in written[1:2]] == ["dut: no sample"]

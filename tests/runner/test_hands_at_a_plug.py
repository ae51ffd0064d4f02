"""Who puts an instrument right has a hand at its plug: nothing comes on or turns before "hands off" is said anew."""

from __future__ import annotations

from collections.abc import Callable
from contextlib import closing
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

from test_lost_and_gone_on_with import pulled, pulled_for

from labcal.bench import open_bench
from labcal.bench.clock import VirtualClock
from labcal.record.stream import Event, Item, Prompt
from labcal.runner import Outcome, find, run_procedure
from labcal.runner.prompts import first_choice
from labcal.store import Store

TURN = {"zero_s": "8", "rate_deg_per_s": "20"}
BenchFile = Callable[..., Path]


def turned(path: Path, happens: Callable[[Any], None]) -> tuple[Outcome, list[Item]]:
    """rotate-axis, to whose bench something happens once, when the second "hands off" is answered."""
    items, said = list[Item](), list[bool]()
    with (
        closing(open_bench(path, clock=VirtualClock(datetime(2026, 11, 21, tzinfo=UTC)), seed=2)) as lab,
        Store.open() as store,
    ):

        def tell(item: Item) -> None:
            items.append(item)
            said.extend(
                [True] if isinstance(item, Event) and item.kind == "answer" and item.data["key"] == "ready" else []
            )
            if len(said) == 2 and isinstance(item, Event) and item.data.get("key") == "ready":
                happens(lab)

        return run_procedure(lab, find("rotate-axis"), TURN, store=store, answer=first_choice, on_item=tell), items


def course(items: list[Item]) -> list[str]:
    """The questions, and where the coils came on."""
    asked = {id(i): i.key for i in items if isinstance(i, Prompt)}
    on = {id(i): "ON" for i in items if isinstance(i, Event) and i.kind == "set-point"}
    return [(asked | on)[id(i)] for i in items if id(i) in asked | on]


def test_a_dut_that_was_out_while_the_coils_were_at_zero_is_asked_about_before_they_come_on(
    bench_file: BenchFile,
) -> None:
    outcome, items = turned(bench_file(), pulled_for("dut", 3.0))
    assert outcome.status == "finished"
    assert course(items)[-3:] == ["ready", "ready", "ON"]


def test_hands_off_is_not_taken_while_an_instrument_is_lost(bench_file: BenchFile) -> None:
    words = ["Still lost: dut (silent). Put that right first: a step begun now fails again."] * 2

    def lost(lab: Any) -> None:
        lab.still_wrong = lambda: words.pop() if words else ""

    outcome, items = turned(bench_file(), lost)
    assert outcome.status == "finished"
    assert course(items)[-4:] == ["ready", "ready", "ready", "ON"]
    *_, whole, again, and_again = (i for i in items if isinstance(i, Prompt))
    assert (again.text[:15], and_again.text[:15]) == ("Still lost: dut",) * 2
    assert and_again.text.endswith(whole.text)  # what comes on and turns is said until it is answered
    assert again.drawing["question"] == whole.text


def test_nor_is_it_for_ever_where_nobody_puts_it_right(bench_file: BenchFile) -> None:
    outcome, items = turned(bench_file(), pulled("dut"))
    assert "ON" not in course(items)
    assert outcome.status.startswith("failed: dut")

"""A DUT that names another serial than the one typed is asked about before it is mounted first."""

from __future__ import annotations

from collections.abc import Callable
from contextlib import closing
from datetime import UTC, datetime
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

from labcal.bench import Bench, open_bench
from labcal.bench.clock import VirtualClock
from labcal.bench.driver_kit.roles import Identity
from labcal.errors import InputError
from labcal.record.stream import OTHER_SERIAL, Event, Prompt
from labcal.runner import Outcome, another_dut, find, run_procedure
from labcal.runner.another_dut import KEY
from labcal.runner.prompts import first_choice
from labcal.store import Store

TURN = {"zero_s": "2", "rate_deg_per_s": "20"}
BenchFile = Callable[..., Path]
ASKED = "dut names itself EM-21, and this run is of EM-07. Measure it as EM-07 all the same?"


def measured(
    path: Path, monkeypatch: pytest.MonkeyPatch, named: str, answer: str
) -> tuple[Outcome, list[Prompt], list[Event]]:
    """rotate-axis of EM-07 on a bench whose DUT names itself so, as a real one does."""
    asked, store_dir = list[Prompt](), Store.open()
    look = another_dut.other_serials

    def as_real(lab: Bench) -> list[Event]:
        lab._known = {"dut": Identity("", "line", named)}
        monkeypatch.setattr(type(lab.config), "unreal", False)
        found = look(lab)
        monkeypatch.undo()
        monkeypatch.setattr(another_dut, "other_serials", as_real)
        return found

    monkeypatch.setattr(another_dut, "other_serials", as_real)

    def answered(prompt: Prompt) -> str:
        asked.append(prompt)
        return answer if prompt.key == KEY and answer else first_choice(prompt)

    clock = VirtualClock(datetime(2026, 11, 21, tzinfo=UTC))
    with closing(open_bench(path, clock=clock, seed=2)) as lab, store_dir as store:
        outcome = run_procedure(
            lab, find("rotate-axis"), TURN, store=store, answer=answered, dut_serial="EM-07", run_id="R"
        )
        items = [one for one in store.items("R", but="block") if isinstance(one, Event)]
    return outcome, asked, items


def keys(asked: list[Prompt]) -> list[str]:
    return [one.key for one in asked]


def test_both_serials_are_named_before_it_is_mounted_and_the_answer_is_kept(
    bench_file: BenchFile, monkeypatch: pytest.MonkeyPatch
) -> None:
    outcome, asked, events = measured(bench_file(), monkeypatch, "EM-21", "yes")
    assert outcome.status == "finished"
    assert keys(asked).index(KEY) == keys(asked).index("mount-z") - 1
    assert keys(asked).count(KEY) == 1
    assert next(one.text for one in asked if one.key == KEY) == ASKED
    assert ("answer", "yes") in [(e.kind, e.text) for e in events if e.data.get("key") == KEY]


@pytest.mark.parametrize("answer", ["no", ""], ids=["a person", "a script"])
def test_where_nobody_says_so_nothing_is_measured(
    bench_file: BenchFile, monkeypatch: pytest.MonkeyPatch, answer: str
) -> None:
    outcome, asked, _ = measured(bench_file(), monkeypatch, "EM-21", answer)
    with pytest.raises(InputError, match="dut names itself EM-21, and this run is of EM-07: nothing was measured"):
        outcome.raise_fault()
    assert keys(asked)[-1] == KEY


@pytest.mark.parametrize("named", ["", "EM-07", "4711 em-07"])
def test_one_that_says_nothing_or_what_was_typed_is_not_asked_about(
    bench_file: BenchFile, monkeypatch: pytest.MonkeyPatch, named: str
) -> None:
    outcome, asked, _ = measured(bench_file(), monkeypatch, named, "")
    assert outcome.status == "finished"
    assert KEY not in keys(asked)


@pytest.mark.parametrize(("who", "asked"), [("dut", [True, False]), ("reference", [False, False])])
def test_it_is_asked_of_the_dut_alone_and_once(monkeypatch: pytest.MonkeyPatch, who: str, asked: list[bool]) -> None:
    found = Event(1.0, OTHER_SERIAL, f"{who} names itself EM-21", {"instrument": who, "stated": "EM-07"})
    monkeypatch.setattr(another_dut, "other_serials", lambda lab: [found])
    config = SimpleNamespace(instruments={name: SimpleNamespace(role=name) for name in ("dut", "reference")})
    lab: Any = SimpleNamespace(config=config, clock=SimpleNamespace(now=lambda: 2.0))
    mounting = Prompt(2.0, "mount-z", "Mount it.", drawing={another_dut.MOUNTS: []})
    of_one_run = another_dut.AnotherDut()
    assert [of_one_run.question(lab, mounting) is not None for _ in range(2)] == asked

"""After a silence it is said what moved meanwhile: the platform's angle and the ambient field, before and now."""

from __future__ import annotations

import threading
from collections.abc import Callable
from contextlib import closing
from datetime import UTC, datetime
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from test_hands_at_a_plug import TURN, turned
from test_lost_and_gone_on_with import pulled_for

from labcal.bench import open_bench
from labcal.bench.clock import VirtualClock
from labcal.bench.coils.state import Heard, LabState, PlatformReading, Witness, unread
from labcal.record.stream import FAULT, MEANWHILE, Block, Event, Item, Prompt
from labcal.runner import find, run_procedure
from labcal.runner.meanwhile import SETTLES_S, Meanwhile
from labcal.runner.prompts import first_choice
from labcal.store import Store

AMBIENT, NOW_NT = (20400.0, 1150.0, -43700.0), (20412.0, 1150.0, -43690.0)


class There:
    """A bench at rest at `t_s`, whose platform stands at 57.3 degrees: who does not look knows it at 12."""

    def __init__(
        self, t_s: float, witness: Witness, *, lost: str = "", on: bool = False, zero_expected: bool = True
    ) -> None:
        self.clock = SimpleNamespace(now=lambda: t_s, utc=lambda: LOOKED)
        self.cage = SimpleNamespace(on=on, witness=witness, check=SimpleNamespace(zero_expected=zero_expected))
        self._lost, self._known_deg = lost, 12.0

    def look_at_platform(self) -> None:
        self._known_deg = 57.3

    def state(self) -> LabState:
        heard = (Heard("stage", 1.0, self._lost),)
        return LabState(unread(), instruments=heard, platform=PlatformReading(self._known_deg, False, 1.0))


def angle(deg: float) -> Block:
    return Block("angle", "stage", ("angle_deg",), np.array([1.0]), np.array([[deg]]))


def said(kind: str, fault: str) -> Event:
    return Event(1.0, kind, "stage: …", {"fault": fault})


AGREES = Witness("agrees", "", NOW_NT, AMBIENT, 15.6, 2000.0, 12.0)
LOOKED = datetime(2026, 11, 30, 4, 41, 12, tzinfo=UTC)
BOTH = "ambient field 20400 1150 -43700 nT before, 20412 1150 -43690 nT now"


@pytest.mark.parametrize("lost", [said(FAULT, "silent"), said("stream", "link lost")])
@pytest.mark.parametrize("back", ["heard again", "reconnected"])
def test_angle_and_field_before_and_after_are_said_once(lost: Event, back: str) -> None:
    told = Meanwhile()
    for item in (angle(12.0), angle(40.0), lost):
        told.see(item, There(5.0, AGREES))
    assert told.over(There(6.0, AGREES)) is None  # it is silent still
    for item in (said("stream", back), angle(57.3)):
        told.see(item, There(11.0, AGREES))
    assert told.over(There(12.0, AGREES, lost="silent")) is None  # another one is
    assert told.over(There(12.0, AGREES, on=True)) is None  # nobody may look at it yet
    event = told.over(There(12.5, AGREES))
    assert event is not None
    assert (event.kind, event.text) == (MEANWHILE, f"after the silence: platform 40.0° before, 57.3° now; {BOTH}")
    assert event.data["utc"] == LOOKED.isoformat()  # the words may stand for long
    assert told.over(There(13.0, AGREES)) is None


def test_a_reference_that_has_not_looked_since_is_waited_for_and_says_nothing_of_now() -> None:
    told, before = Meanwhile(), Witness("agrees", "", NOW_NT, AMBIENT, 15.6, 2000.0, 10.0)
    for item in (angle(40.0), said(FAULT, "silent"), said("stream", "heard again")):
        told.see(item, There(11.0, AGREES))
    assert told.over(There(11.5, before)) is None
    event = told.over(There(11.0 + SETTLES_S, before))
    assert event is not None
    assert event.text == "after the silence: platform 40.0° before, 57.3° now"


def test_who_answers_the_question_does_not_wait_for_the_reference() -> None:
    told, before = Meanwhile(), Witness("agrees", "", NOW_NT, AMBIENT, 15.6, 2000.0, 10.0)
    for item in (angle(40.0), said(FAULT, "silent"), said("stream", "heard again")):
        told.see(item, There(11.0, AGREES))
    event = told.over(There(11.5, before), answered=True)
    assert event is not None
    assert event.text == "after the silence: platform 40.0° before, 57.3° now"


def test_where_the_reference_has_no_ambient_field_to_compare_with_nothing_is_said_of_it() -> None:
    told = Meanwhile()
    for item in (angle(40.0), said(FAULT, "silent"), said("stream", "heard again")):
        told.see(item, There(11.0, AGREES))
    event = told.over(There(12.5, AGREES, zero_expected=False))
    assert event is not None
    assert event.text == "after the silence: platform 40.0° before, 57.3° now"


def test_a_run_says_it_while_it_waits_for_an_answer(bench_file: Callable[..., Path], monkeypatch: Any) -> None:
    """The hands that have put a plug in are at the lab then."""
    untold, told = [Event(0.0, MEANWHILE, "after the silence: …")], threading.Event()

    def over(_: Meanwhile, bench: Any, *, answered: bool = False) -> Event | None:
        return None if answered or not untold else untold.pop()

    def hears(prompt: Prompt) -> str:
        told.wait(10.0)
        return first_choice(prompt)

    def tell(item: Item) -> None:
        if isinstance(item, Event) and item.kind == MEANWHILE:
            told.set()

    monkeypatch.setattr(Meanwhile, "over", over)
    clock = VirtualClock(datetime(2026, 11, 21, tzinfo=UTC))
    with closing(open_bench(bench_file(), clock=clock, seed=2)) as lab, Store.open() as store:
        run_procedure(lab, find("rotate-axis"), TURN, store=store, answer=hears, on_item=tell)
    assert told.is_set()


def test_an_instrument_that_failed_otherwise_was_not_silent() -> None:
    told = Meanwhile()
    for item in (angle(40.0), said(FAULT, "overloaded"), said("stream", "heard again")):
        told.see(item, There(11.0, AGREES))
    assert told.over(There(20.0, AGREES)) is None


def test_a_run_says_it_at_the_next_question(bench_file: Callable[..., Path]) -> None:
    outcome, items = turned(bench_file(), pulled_for("dut", 3.0))
    assert outcome.status == "finished"
    [told] = [one for one in items if isinstance(one, Event) and one.kind == MEANWHILE]
    assert told.text.startswith("after the silence: platform 0.0° before, 0.0° now")
    assert asked_after(items, told)


def asked_after(items: list[Item], told: Any) -> bool:
    """Whether "hands off" is asked before that, and answered by then."""
    kinds = [getattr(one, "key", "") for one in items[: items.index(told)]]
    return kinds.count("ready") >= 3

"""After a silence it is said what moved meanwhile: the platform's angle and the ambient field, before and now."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from test_hands_at_a_plug import turned
from test_lost_and_gone_on_with import pulled_for

from labcal.bench.coils.state import Heard, LabState, PlatformReading, Witness, unread
from labcal.record.stream import FAULT, Block, Event, Item
from labcal.runner.meanwhile import MEANWHILE, SETTLES_S, Meanwhile

AMBIENT, NOW_NT = (20400.0, 1150.0, -43700.0), (20412.0, 1150.0, -43690.0)


class There:
    """A bench at rest whose platform stands at 57.3 degrees, at `t_s`."""

    def __init__(self, t_s: float, witness: Witness, *, lost: str = "", on: bool = False) -> None:
        self.clock = SimpleNamespace(now=lambda: t_s)
        self.cage = SimpleNamespace(on=on, witness=witness, check=SimpleNamespace(zero_expected=True))
        self._lost = lost

    def look_at_platform(self) -> None:
        pass

    def state(self) -> LabState:
        heard = (Heard("stage", 1.0, self._lost),)
        return LabState(unread(), instruments=heard, platform=PlatformReading(57.3, False, 1.0))


def angle(deg: float) -> Block:
    return Block("angle", "stage", ("angle_deg",), np.array([1.0]), np.array([[deg]]))


def said(kind: str, fault: str) -> Event:
    return Event(1.0, kind, "stage: …", {"fault": fault})


AGREES = Witness("agrees", "", NOW_NT, AMBIENT, 15.6, 2000.0, 12.0)
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
    assert told.over(There(13.0, AGREES)) is None


def test_a_reference_that_has_not_looked_since_is_waited_for_and_says_nothing_of_now() -> None:
    told, before = Meanwhile(), Witness("agrees", "", NOW_NT, AMBIENT, 15.6, 2000.0, 10.0)
    for item in (angle(40.0), said(FAULT, "silent"), said("stream", "heard again")):
        told.see(item, There(11.0, AGREES))
    assert told.over(There(11.5, before)) is None
    event = told.over(There(11.0 + SETTLES_S, before))
    assert event is not None
    assert event.text == "after the silence: platform 40.0° before, 57.3° now"


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

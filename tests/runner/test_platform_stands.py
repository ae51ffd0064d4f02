"""Whoever is asked after a fault may put hands in: the platform was stopped and stands, or is not said to stand."""

from __future__ import annotations

import contextlib
from collections.abc import Callable
from contextlib import closing
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

import numpy as np
from test_lost_and_gone_on_with import SECOND, TWO_FIELDS, events, pulled

from labcal import session
from labcal.bench import open_bench
from labcal.bench.clock import VirtualClock
from labcal.bench.coils.state import MAY_TURN, PlatformReading
from labcal.errors import InstrumentError
from labcal.record.stream import Item, Prompt, SegmentOpened
from labcal.runner import Outcome, find, run_procedure, yes_to_all
from labcal.store import Store

BenchFile = Callable[..., Path]
Happens = Callable[[Any], None]


def in_a_turn(bench: Path, happens: Happens, answer: Callable[[Any, Prompt], str]) -> tuple[Outcome, list[Any]]:
    """Run R, to which something happens a second into its second turn; what is answered may look at the lab."""
    there, seen = list[bool](), list[Any]()
    clock = VirtualClock(datetime(2026, 11, 28, tzinfo=UTC))
    with closing(open_bench(bench, clock=clock, seed=2)) as lab, Store.open() as store:

        def tell(item: Item) -> None:
            if isinstance(item, SegmentOpened) and item.segment.id == SECOND and not there:
                there.append(True)
                happens(lab)

        def asked(prompt: Prompt) -> str:
            if prompt.key.startswith("failed-"):
                now_s = clock.now()
                seen.append((lab.simulated_operator._lab.platform.moving(now_s), lab.state().platform, prompt.text))
            return answer(lab, prompt)

        ended = run_procedure(lab, find("preflight"), TWO_FIELDS, store=store, answer=asked, on_item=tell, run_id="R")
        return ended, seen


def stop_there(lab: Any, prompt: Prompt) -> str:
    return "stop" if prompt.key.startswith("failed-") else yes_to_all(True)(prompt)


def test_it_was_stopped_and_stands_where_the_question_is_asked(bench_file: BenchFile) -> None:
    _, seen = in_a_turn(bench_file(), pulled("reference"), stop_there)
    ((moving, read, _),) = seen
    assert not moving
    assert read.moving is False
    assert 0.5 < read.angle_deg < 359.5  # it was not turned to its end
    assert events("standstill")[0] == f"platform stands at {read.angle_deg:.0f}°"


def test_where_nobody_is_asked_as_the_run_ends_it_is_stopped_too(bench_file: BenchFile) -> None:
    ended, seen = in_a_turn(bench_file(), pulled("supply_x"), stop_there)
    assert (ended.status, seen) == ("interrupted", [])
    (said,) = events("standstill")
    assert said.startswith("platform stands at ")
    assert said not in ("platform stands at 0°", "platform stands at 360°")


def test_where_it_does_not_answer_it_is_not_said_to_stand(bench_file: BenchFile) -> None:
    ended, seen = in_a_turn(bench_file(), pulled("stage"), stop_there)
    assert ended.status == "interrupted"
    assert [read.moving for _, read, _ in seen] == [None]
    assert set(events("standstill")) == {MAY_TURN}


def once(lab: Any) -> None:
    """Something fails on the way, once."""
    listen, calls = lab.stream_until, list[float]()

    def failing(t_s: float) -> Any:
        calls.append(t_s)
        if len(calls) == 2:
            lab.stream_until = listen
            raise InstrumentError("reference: it sent nonsense.", fault="reply")
        return listen(t_s)

    lab.stream_until = failing


def test_the_turn_is_begun_again_from_its_beginning(bench_file: BenchFile) -> None:
    def again(lab: Any, prompt: Prompt) -> str:
        return "retry" if "retry" in prompt.choices else yes_to_all(True)(prompt)

    ended, seen = in_a_turn(bench_file(), once, again)
    assert (ended.status, ended.failed) == ("finished", ())
    ((moving, read, _),) = seen
    assert (moving, read.moving) == (False, False)
    assert 0.5 < read.angle_deg < 359.5
    run = session.load_run("R")
    whole = next(n for n, one in enumerate(run.segments) if one.id == f"{SECOND}-2")
    assert np.ptp(run.angle_deg[run.rows(whole)]) > 355


def test_a_try_is_not_begun_while_what_was_lost_is_lost(bench_file: BenchFile) -> None:
    asked = list[str]()

    def at_once(lab: Any, prompt: Prompt) -> str:
        if not prompt.key.startswith("failed-"):
            return yes_to_all(True)(prompt)
        asked.append(prompt.text)
        return "retry" if len(asked) == 1 else "stop"

    in_a_turn(bench_file(), pulled("reference"), at_once)
    assert asked[1].startswith("Still lost: reference (")
    assert "a step begun now fails again" in asked[1]


def test_at_its_end_too_it_is_stopped_and_that_is_in_the_record(bench_file: BenchFile) -> None:
    ended, _ = in_a_turn(bench_file(), lambda lab: None, stop_there)
    assert ended.status == "finished"
    assert events("standstill")[-1] == "platform stands at 0°"


def lost_for(lab: Any, seconds: float) -> None:
    """The stage's line gives no answer for so long, and the stage turns on."""
    platform, state, back_s = lab.platform, lab.platform.state, lab.clock.now() + seconds

    def answers() -> Any:
        if lab.clock.now() < back_s:
            raise InstrumentError("stage: no reply.", fault="silent")
        return state()

    platform.state = platform.moving = answers
    platform.brought_to_rest = lambda clock: PlatformReading(fault="silent")
    platform.told_to_stop = lambda: None


def test_one_that_answers_again_in_the_question_is_told_to_stop_first(bench_file: BenchFile) -> None:
    words = list[str]()
    with closing(open_bench(bench_file(), clock=VirtualClock(datetime(2026, 11, 28, tzinfo=UTC)), seed=2)) as lab:
        lab.start()
        lab.platform.home()
        lab.platform.move_to(300.0, 6.0)
        lost_for(lab, 2.0)
        with contextlib.suppress(InstrumentError):
            lab.stream_until(lab.clock.now() + 1.0)
        lab.stop_platform()
        stop, state, lab.asking = lab.platform.make_safe, lab.platform.state, True
        lab.platform.make_safe = lambda: (words.append("stop"), stop())
        lab.platform.state = lambda: (words.append("state"), state())[1]
        lab.stream_until(lab.clock.now() + 8.0)
        assert words[0] == "stop"
        assert not lab.simulated_operator._lab.platform.moving(lab.clock.now())
        assert lab.state().platform.moving is False

"""A DUT that was mounted wrongly is found by the axes check, and may be mounted again without losing the run."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import closing, contextmanager
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from short_preflight import SHORT
from test_lost_and_gone_on_with import SECOND, TWO_FIELDS, begun, pulled

from labcal import session
from labcal.bench import open_bench
from labcal.bench.axis_up import FARTHEST_DEG, turned_about
from labcal.bench.bench import Bench
from labcal.bench.clock import VirtualClock
from labcal.bench.mounting import attitude
from labcal.errors import LimitNotMet
from labcal.geometry import rotate
from labcal.record.stream import (
    NOT_USED,
    Block,
    Event,
    Item,
    Measurement,
    Prompt,
    SegmentClosed,
    SegmentOpened,
    Step,
)
from labcal.runner import Outcome, find, resume_run, run_procedure
from labcal.store import Store

BenchFile = Callable[..., Path]


class Hands:
    """Mounts the wrong axis at the first `wrong` mountings, says done each time, and then what `then` says."""

    def __init__(self, lab: Bench, wrong: int, then: str = "remount", at: str = "") -> None:
        self.lab, self.wrong, self.then, self.at, self.asked = lab, wrong, then, at, list[str]()
        operator: Any = lab.simulated_operator
        self._do, operator.do = operator.do, self.do

    def do(self, prompt: Prompt) -> None:
        if "body_from_cage" in prompt.drawing and self.wrong > 0 and self.at in ("", prompt.key):
            self.wrong -= 1
            drawing = {"body_from_cage": attitude(self.lab, "y" if self.at else "x").tolist()}
            return self._do(Prompt(prompt.t_s, prompt.key, prompt.text, drawing=drawing))
        return self._do(prompt)

    def answer(self, prompt: Prompt) -> str:
        self.asked.append(prompt.key)
        return self.then if prompt.key in ("opening-failed", "wrong-axis-z") else prompt.choices[0]


@contextmanager
def laboratory(bench: Path) -> Iterator[tuple[Bench, Store]]:
    clock = VirtualClock(datetime(2026, 11, 21, tzinfo=UTC))
    with closing(open_bench(bench, clock=clock, seed=2)) as lab, Store.open() as store:
        yield lab, store


def gone_on_with(bench: Path, wrong: int, then: str = "remount") -> tuple[Outcome, Hands]:
    with laboratory(bench) as (lab, store):
        hands = Hands(lab, wrong, then)
        return resume_run(lab, find("preflight"), "R", store=store, answer=hands.answer), hands


def kept() -> list[Item]:
    with Store.open() as store:
        return list(store.items("R", but="block"))


def of_axes() -> list[str]:
    """The verdicts of the DUT's z axis, in the order in which it was looked at."""
    return [i.verdict for i in kept() if isinstance(i, Measurement) and i.name == "DUT z axis: angle off its direction"]


def test_mounted_again_the_run_begins_anew_and_both_checks_stay_in_the_record(bench_file: BenchFile) -> None:
    with laboratory(bench_file()) as (lab, store):
        hands = Hands(lab, 1)
        ended = run_procedure(lab, find("preflight"), SHORT, store=store, answer=hands.answer, run_id="R")
    assert (ended.status, ended.fault, ended.failed) == ("finished", None, ())
    assert hands.asked[:6] == ["ready", "mount-z", "mode-nominal", "ready", "opening-failed", "mount-z"]
    assert of_axes() == ["FAIL", "PASS"]
    assert [i.name for i in kept() if isinstance(i, Step)][:5] == ["zero", "axes-check"] * 2 + ["sync-check"]


def test_a_wrong_yes_where_a_run_is_gone_on_with_loses_nothing(bench_file: BenchFile) -> None:
    bench = bench_file()
    assert begun(bench, "preflight", pulled("dut"), TWO_FIELDS, SECOND).resumable
    ended, hands = gone_on_with(bench, 1)
    assert (ended.status, ended.fault, ended.failed) == ("finished", None, ())
    assert hands.asked[0] == "mounting-stands"
    assert hands.asked[hands.asked.index("opening-failed") + 1] == "mount-z"  # not whether it still stands
    assert of_axes() == ["PASS", "FAIL", "PASS"]
    run = session.load_run("R")
    turned = [one for n, one in enumerate(run.segments) if len(run.rows(n)) > 150]
    assert [one.mounting for one in turned] == ["z", "z.again"]


def test_stopped_at_that_question_it_can_be_gone_on_with_once_more(bench_file: BenchFile) -> None:
    bench = bench_file()
    begun(bench, "preflight", pulled("dut"), TWO_FIELDS, SECOND)
    stopped, _ = gone_on_with(bench, 9, "stop")
    assert (stopped.status, stopped.resumable) == ("interrupted", True)
    assert stopped.ending.startswith("interrupted: axes-check: body X is up, not Z.")
    with pytest.raises(LimitNotMet, match="axes-check"):
        stopped.raise_fault()
    ended, _ = gone_on_with(bench, 0)
    assert (ended.status, ended.failed) == ("finished", ())


def test_a_run_that_never_passed_it_fails_where_the_person_stops(bench_file: BenchFile) -> None:
    with laboratory(bench_file()) as (lab, store):
        hands = Hands(lab, 9, "stop")
        ended = run_procedure(lab, find("preflight"), SHORT, store=store, answer=hands.answer, run_id="R")
    assert ended.status.startswith("failed: axes-check: body X is up, not Z.")
    assert not ended.resumable


def test_what_was_measured_with_a_closure_beyond_its_limit_is_still_a_failed_run(bench_file: BenchFile) -> None:
    bench = bench_file('effects = { "offset-step" = { at_s = 120.0 } }')
    begun(bench, "preflight", pulled("dut"), TWO_FIELDS | {"closure_nT": "40"}, SECOND)
    ended, hands = gone_on_with(bench, 0, "stop")
    assert "opening-failed" not in hands.asked
    assert ended.status.startswith("failed: closure")


TWO_AXES = SHORT | {"axes": "x,z"}


def test_an_axis_that_was_mounted_in_place_of_another_is_told_by_its_first_turn(bench_file: BenchFile) -> None:
    with laboratory(bench_file()) as (lab, store):
        hands = Hands(lab, 1, at="mount-z")
        ended = run_procedure(lab, find("preflight"), TWO_AXES, store=store, answer=hands.answer, run_id="R")
    assert (ended.status, ended.failed) == ("finished", ())
    at = hands.asked.index("wrong-axis-z")
    assert hands.asked[at + 1 : at + 4] == ["ready", "mount-z", "ready"]  # the one mode was asked for already
    (said,) = [i.text for i in kept() if isinstance(i, Prompt) and i.key == "wrong-axis-z"]
    assert "body Y is up, not Z" in said
    assert [i.data["segments"] for i in kept() if isinstance(i, Event) and i.kind == NOT_USED] == [["z+20uT-nominal"]]


def test_rotate_axis_does_not_pass_about_another_axis(bench_file: BenchFile) -> None:
    with laboratory(bench_file()) as (lab, store):
        hands = Hands(lab, 1, at="mount-z")
        given = {"zero_s": "2", "rate_deg_per_s": "20"}
        ended = run_procedure(lab, find("rotate-axis"), given, store=store, answer=hands.answer, run_id="R")
    assert ended.status.startswith("failed: z+50uT: body Y is up, not Z.")
    assert 60.0 <= turned_deg("z+50uT") < 180.0


def turned_deg(segment: str) -> float:
    """How far the platform had turned in it when it was stopped [deg]."""
    with Store.open() as store:
        items = list(store.items("R"))
    opened = next(i.t_s for i in items if isinstance(i, SegmentOpened) and i.segment.id == segment)
    closed = next(i.t_s for i in items if isinstance(i, SegmentClosed) and i.t_s > opened)
    angles = [b for b in items if isinstance(b, Block) and b.stream == "angle"]
    inside = [v for b in angles for t, v in zip(b.t_s, b.values[:, 0], strict=True) if opened <= t <= closed]
    return float(np.ptp(inside))


@pytest.mark.parametrize(("tilt_deg", "wrong"), [(0.0, False), (8.0, False), (40.0, False), (60.0, True)])
def test_how_far_an_axis_may_be_off(tilt_deg: float, wrong: bool) -> None:
    up = rotate((1, 0, 0), np.radians([tilt_deg]), (0, 0, 1))[0]
    seen = rotate(up, np.linspace(0, 2 * np.pi, 200), (3, 4, 5)) * [1.0, 1.1, 0.9] + [7.0, -3.0, 2.0]
    found = turned_about(seen + 0.01 * np.random.default_rng(1).standard_normal(seen.shape))
    assert found is not None
    assert bool(abs(found[2]) < np.cos(np.radians(FARTHEST_DEG))) is wrong

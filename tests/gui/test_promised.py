"""What is promised of a run stands: it moves by what people take, and by nothing else."""

from datetime import UTC, datetime
from pathlib import Path
from types import SimpleNamespace

import pytest

from labcal import session
from labcal.bench.clock import VirtualClock
from labcal.bench.steps import Plan
from labcal.gui.ipc.messages import RunProcedure
from labcal.gui.viewmodels import run_time
from labcal.gui.viewmodels.number_format import CLOCK_S
from labcal.gui.viewmodels.promised import Promised
from labcal.gui.viewmodels.run import RunViewModel
from labcal.gui.viewmodels.run_steps import name_a_turn
from labcal.record.stream import Event, Prompt, Step

ABOUT = (  # of the preflight of examples/simulated.toml about one axis: each step, its plan and what it took [s]
    ("mount", 8.6, 8.9),
    ("+20uT-nominal", 153.9, 152.0), ("+50uT-nominal", 153.9, 153.8), ("-50uT-nominal", 153.9, 154.4),
    ("+20uT-full", 153.9, 155.1), ("+50uT-full", 153.9, 153.9), ("-50uT-full", 153.9, 154.4),
    ("closure", 8.6, 8.6),
)  # fmt: skip
RECORDED = (
    ("zero", 18.6, 18.6), ("axes-check", 44.0, 43.5), ("sync-check", 42.0, 41.0),
    *((f"{part}-{axis}" if part.isalpha() else f"{axis}{part}", *s) for axis in "xyz" for part, *s in ABOUT),
    ("closing", 18.6, 18.6),
)  # fmt: skip
PEOPLE_S = {"zero": 70.0, "mount-y": 95.0, "mount-z": 240.0, "y+20uT-full": 12.0, "closing": 61.0}
TICK_S = 7.3


class Clock:
    """Of the wall; the bench's stands while somebody is asked, or passes `pace` times as fast."""

    def __init__(self, monkeypatch, pace=1.0):
        self.wall_s = self.bench_s = 0.0
        self.pace = pace
        monkeypatch.setattr(run_time.time, "monotonic", lambda: self.wall_s)

    def goes_on(self, bench_s):
        self.bench_s += bench_s
        self.wall_s += bench_s / self.pace


def played(deaf, clock, recorded=RECORDED, **order):
    """Yield the run at each moment of what was `recorded`, with what people have taken until then."""
    worker, taken_s = deaf(), 0.0
    run = RunViewModel(worker)
    run.start(RunProcedure("preflight", "bench.toml", **order))
    run.virtual_time = clock.pace != 1.0
    plan = Plan(tuple((name, planned_s) for name, planned_s, _ in recorded), frozenset(PEOPLE_S))
    bench = SimpleNamespace(clock=SimpleNamespace(now=lambda: clock.bench_s))
    for name, _, took_s in recorded:
        worker.items.emit((plan.begin(bench, name),))
        yield run, taken_s
        if name in PEOPLE_S:
            worker.items.emit((Prompt(clock.bench_s, name, "Mount it.", ("done",), True),))
            clock.wall_s += PEOPLE_S[name]
            clock.bench_s += PEOPLE_S[name] if clock.pace == 1.0 else 0.0
            taken_s += PEOPLE_S[name]
            worker.items.emit((Event(clock.bench_s, "answer", "done", {"key": name}),))
            run.state = "running"
        left_s = took_s
        while left_s > TICK_S:
            clock.goes_on(TICK_S)
            left_s -= TICK_S
            worker.items.emit((Event(clock.bench_s, "note", "it turns"),))
            yield run, taken_s
        clock.goes_on(left_s)


def ends(deaf, clock, **order):
    """When the run is done and when somebody is needed, as it is promised, without what people have taken."""
    for run, taken_s in played(deaf, clock, **order):
        done_s = run.promised_s("", run.left_s())
        is_near = (run.needed_s() or 0.0) < TICK_S  # then it is said to be "within a minute", and may be late
        needed_s = None if is_near else run.promised_s(run.step.needed_for, run.needed_s())
        yield (
            None if done_s is None else clock.wall_s + done_s - taken_s,
            (run.step.needed_for, None if needed_s is None else clock.wall_s + needed_s - taken_s),
        )


@pytest.mark.parametrize("pace", [1.0, 23.0], ids=["a served bench", "simulated, on a busy computer"])
def test_the_promised_end_moves_by_what_people_take_and_by_nothing_else(deaf, monkeypatch, pace):
    clock = Clock(monkeypatch, pace)
    order = {} if pace == 1.0 else {"pace": "100 times"}
    said = list(ends(deaf, clock, **order))
    dones = [done for done, _ in said if done is not None]
    assert len(dones) > len(said) / 2
    assert max(dones) - min(dones) < 1e-6
    over_s = clock.wall_s - sum(PEOPLE_S.values())
    assert dones[0] == pytest.approx(over_s, abs=CLOCK_S / 2)
    for what in PEOPLE_S:
        times = [at for _, (of, at) in said if of == what and at is not None]
        assert max(times, default=0.0) - min(times, default=0.0) < 1e-6, what


def test_where_each_turn_takes_longer_than_its_plan_that_is_known_after_the_first(deaf, monkeypatch):
    """On real lines a turn takes some seconds more: the end crept on by a minute until it was there."""
    clock = Clock(monkeypatch)
    slow = tuple((name, plan_s, took_s + (9.0 if "uT" in name else 0.0)) for name, plan_s, took_s in RECORDED)
    dones, over_s = [], sum(took_s for _, _, took_s in slow)
    for run, taken_s in played(deaf, clock, slow):
        if sum(name_a_turn((name,)) and mark == "done" for name, mark in run.steps()) and run.state == "running":
            dones.append(clock.wall_s + run.promised_s("", run.left_s()) - taken_s)
    assert len(dones) > 100
    assert max(dones) - min(dones) < CLOCK_S
    assert dones == pytest.approx([over_s] * len(dones), abs=CLOCK_S)


def test_what_is_wrong_by_more_than_is_said_is_said_anew():
    promised = Promised()
    assert promised.in_s(0.0, 600.0) == 600.0
    assert promised.in_s(10.0, 590.0 + CLOCK_S - 1.0) == 590.0
    assert promised.in_s(10.0, 590.0 + CLOCK_S + 1.0) == 590.0 + CLOCK_S + 1.0
    assert promised.in_s(700.0, 30.0) == 30.0  # what is past is no promise


def test_a_preflight_s_plan_is_right_to_half_of_the_minute_that_is_said(tmp_path, monkeypatch):
    monkeypatch.setenv("LABCAL_HOME", str(tmp_path))
    seen, ends_s = list[Step](), [0.0]

    def see(item):
        if isinstance(item, Step):
            seen.append(item)
        ends_s.append(float(item.t_s if hasattr(item, "text") else 0.0))

    file = Path(__file__).parents[2] / "examples" / "simulated.toml"
    clock = VirtualClock(datetime(2026, 1, 5, tzinfo=UTC))
    assert session.run("preflight", file, {}, clock=clock, seed=3, on_item=see).status == "finished"
    for step in seen:
        assert step.left_s == pytest.approx(max(ends_s) - step.t_s, abs=CLOCK_S / 2), step.name

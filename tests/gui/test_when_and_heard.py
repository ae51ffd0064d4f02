"""When a run is done and when somebody is needed, by the clock on the wall; and what is heard of either."""

import wave
from datetime import UTC, datetime
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
from PySide6.QtCore import QSettings, Qt
from PySide6.QtWidgets import QApplication

from labcal import session
from labcal.bench.clock import VirtualClock
from labcal.bench.steps import Plan
from labcal.gui.ipc.answers import Ended
from labcal.gui.ipc.messages import RunProcedure
from labcal.gui.viewmodels import run_time
from labcal.gui.viewmodels.lab_now import LabNow
from labcal.gui.viewmodels.number_format import clock_time
from labcal.gui.viewmodels.pace import Pace
from labcal.gui.viewmodels.run import RunViewModel
from labcal.gui.viewmodels.what_happens import what_happens
from labcal.gui.widgets import sounds, time_left
from labcal.record.stream import Block, Event, Prompt, Step

FILE = Path(__file__).parents[2] / "examples" / "simulated.toml"
BENCH = SimpleNamespace(clock=SimpleNamespace(now=lambda: 100.0))
PLAN = Plan((("zero", 20.0), ("x", 300.0), ("mount-y", 10.0), ("y", 300.0)), frozenset({"mount-y"}))


@pytest.mark.parametrize(
    ("step", "needed"), [("zero", (320.0, "mount-y")), ("x", (300.0, "mount-y")), ("mount-y", (None, ""))]
)
def test_each_step_says_when_the_next_question_comes(step, needed):
    begun = PLAN.begin(BENCH, step)
    assert (begun.needed_s, begun.needed_for) == needed


@pytest.mark.slow
def test_a_preflight_asks_where_its_plan_says(tmp_path, monkeypatch):
    monkeypatch.setenv("LABCAL_HOME", str(tmp_path))
    told, asked = [], set()

    def see(item):
        if isinstance(item, Step):
            told.append(item)
        elif isinstance(item, Prompt) and len(told) > 1:
            asked.add(told[-1].name)

    given = {"axes": "x,y", "magnitudes_nT": "20000", "reverse": "no", "rate_deg_per_s": "20", "zero_s": "3"}
    session.run("preflight", FILE, given, clock=VirtualClock(datetime(2026, 1, 5, tzinfo=UTC)), seed=3, on_item=see)
    assert {one.needed_for for one in told} - {""} == asked


def running(deaf, **order):
    worker = deaf()
    run = RunViewModel(worker)
    run.start(RunProcedure("preflight", "bench.toml", **order))
    worker.items.emit((PLAN.begin(BENCH, "x"),))
    return run, worker


def test_the_time_that_a_person_takes_is_in_no_plan(deaf):
    run, worker = running(deaf)
    assert (run.left_s(), run.needed_s()) == (610.0, 300.0)
    worker.items.emit((Event(130.0, "note", "half a minute later"),))
    assert (run.left_s(), run.needed_s()) == (580.0, 270.0)
    worker.items.emit((Prompt(130.0, "m", "Mount it."), Event(900.0, "note", "still thinking")))
    assert run.left_s() == 580.0
    assert run.wall_s(run.left_s()) is None  # nobody knows how long
    worker.items.emit((Event(1000.0, "answer", "done"), Event(1010.0, "note", "goes on")))
    run.state = "running"
    assert (run.left_s(), run.wall_s(run.left_s())) == (570.0, 570.0)
    worker.items.emit((Event(1010.0, "pause", "paused, coils at zero"), Event(1200.0, "note", "tea")))
    worker.items.emit((Event(1300.0, "pause", "goes on"),))
    assert run.left_s() == 570.0


@pytest.mark.parametrize(("pace", "at_first_s", "is_said"), [("true", 610.0, True), ("20 times", None, True),
                                                             ("at once", None, False)])  # fmt: skip
def test_on_a_simulated_bench_time_passes_at_the_pace_that_is_seen(deaf, monkeypatch, pace, at_first_s, is_said):
    """What is to be 20 times is less on a busy computer: nothing is promised before it was seen."""
    speed, clock = {"true": 1.0}.get(pace, 20.0), [0.0]
    monkeypatch.setattr(run_time.time, "monotonic", lambda: clock[0])
    run, worker = running(deaf, pace=pace)
    run.virtual_time = True
    assert run.wall_s(run.left_s()) == at_first_s
    for second in range(1, 7):
        clock[0] = float(second)
        worker.items.emit((Event(100.0 + speed * second, "note", "it turns"),))
    left_s = pytest.approx((610.0 - 6 * speed) / speed)
    assert run.wall_s(run.left_s()) == (left_s if is_said else None)


def test_a_time_of_another_day_says_which():
    now = datetime(2026, 11, 23, 23, 50)
    assert clock_time(now, 300.0) == "23:55"
    assert clock_time(now, 900.0) == "Tue 00:05"


def test_the_run_page_says_both_and_neither_while_somebody_is_asked(still):
    still.app_state.run.start(RunProcedure("preflight", "bench.toml", pace="true"))
    worker, live = still.app_state.bench_worker, still.page("Run").live
    worker.items.emit((PLAN.begin(BENCH, "x"),))
    live.draw()
    needed, done = live.time_left.until.text().splitlines()
    assert needed.startswith("You are needed at ")
    assert needed.endswith(": mount it with body Y up")
    assert done.startswith("Done at about ")
    worker.items.emit((Prompt(101.0, "m", "Mount it."),))
    live.draw()
    assert live.time_left.until.text() == ""


@pytest.mark.parametrize(
    ("needed_s", "done_s", "says"),
    [
        (61.0, 600.0, ["You are needed at 04:50: ", "Done at about 04:59"]),
        (4.0, 600.0, ["You are needed within a minute: ", "Done at about 04:59"]),
        (0.0, 600.0, ["Done at about 04:59"]),
        (None, 4.0, []),
    ],
)
def test_no_time_that_is_there_is_a_forecast(still, monkeypatch, needed_s, done_s, says):
    still.app_state.run.start(RunProcedure("preflight", "bench.toml", pace="true"))
    run, live = still.app_state.run, still.page("Run").live
    clock = type("Clock", (), {"now": staticmethod(lambda: datetime(2026, 11, 30, 4, 49, 55))})
    monkeypatch.setattr(time_left, "datetime", clock)
    monkeypatch.setattr(run, "needed_s", lambda: needed_s)
    monkeypatch.setattr(run, "left_s", lambda: done_s)
    still.app_state.bench_worker.items.emit((PLAN.begin(BENCH, "x"),))
    live.draw()
    lines = live.time_left.until.text().splitlines()
    assert [line.startswith(begins) for line, begins in zip(lines, says, strict=True)] == [True] * len(says)


@pytest.fixture
def heard(monkeypatch):
    found = []
    monkeypatch.setattr(QApplication, "beep", lambda: found.append("beep"))
    monkeypatch.setattr(sounds, "import_module", lambda name: (_ for _ in ()).throw(ImportError(name)))
    monkeypatch.setattr(sounds, "BETWEEN_BEEPS_MS", 1)
    return found


def test_done_is_heard_otherwise_than_needed_and_a_click_turns_both_off(still, heard, qtbot):
    worker = still.app_state.bench_worker
    still.page("Run").live.sounds.effects = None
    still.app_state.run.start(RunProcedure("preflight", "bench.toml"))
    worker.items.emit((PLAN.begin(BENCH, "x"), Prompt(101.0, "m", "Mount it.", ("done",))))
    assert heard == ["beep"]
    heard.clear()
    worker.answer(RunProcedure, Ended("r1", "finished"))
    qtbot.waitUntil(lambda: len(heard) == 3, timeout=15_000)
    heard.clear()
    qtbot.mouseClick(still.sound_switch, Qt.MouseButton.LeftButton)
    assert still.sound_switch.text() == "Unmute"
    still.app_state.run.start(RunProcedure("preflight", "bench.toml"))
    worker.items.emit((Prompt(101.0, "m", "Mount it.", ("done",)),))
    assert heard == []
    qtbot.mouseClick(still.sound_switch, Qt.MouseButton.LeftButton)
    assert sounds.is_on(still.app_state.settings)


def test_where_the_computer_can_it_plays_tones(qapp, tmp_path, monkeypatch):
    played = []

    class Effect:
        def __init__(self, parent):
            self.file = ""

        def setSource(self, url):
            self.file = url.toLocalFile()

        def play(self):
            with wave.open(self.file) as tones:
                played.append(round(tones.getnframes() / tones.getframerate(), 1))

    devices = SimpleNamespace(audioOutputs=lambda: ["loudspeaker"])
    there = SimpleNamespace(QMediaDevices=devices, QSoundEffect=Effect)
    monkeypatch.setattr(sounds, "import_module", lambda name: there)
    made = sounds.Sounds(qapp, QSettings(str(tmp_path / "s.ini"), QSettings.Format.IniFormat))
    for one in ("needed", "done"):
        made.play(one)
    assert played == [0.4, 0.7]


def test_of_what_takes_longer_than_planned_nothing_is_promised(still, monkeypatch):
    """A run that is late said "Hands off · 0 s", and "Done at" a time that was past."""
    run, live = still.app_state.run, still.page("Run").live
    run.start(RunProcedure("preflight", "bench.toml"))
    monkeypatch.setattr(run, "virtual_time", False)
    step = Step(0.0, 1, 1, "sphere", 60.0, ("sphere",), 60.0)
    still.app_state.bench_worker.items.emit((step,))
    live.draw()
    assert (live.headline.text(), live.time_left.until.text()[:13]) == ("Hands off · 60 s · sphere", "Done at about")
    late = Block("angle", "stage", ("angle_deg",), np.array([61.0]), np.zeros((1, 1)))
    still.app_state.bench_worker.items.emit((late,))
    live.draw()
    assert (live.headline.text(), live.time_left.until.text()) == ("Hands off · sphere", "")
    still.app_state.bench_worker.answer(RunProcedure, Ended("r1", "finished"))


def test_a_step_that_is_tried_again_is_left_as_a_whole(deaf):
    run, worker = running(deaf)
    key = "failed-x"
    worker.items.emit((Event(250.0, "note", "it turns"), Prompt(250.0, key, "x: lost", ("stop", "retry", "skip"))))
    assert run.left_s() == 460.0  # the bench's clock stood at 100 s as it began
    worker.items.emit((Event(900.0, "answer", "retry", {"key": key}), Event(910.0, "note", "it turns")))
    assert (run.left_s(), run.step_left_s(), run.needed_s()) == (600.0, 290.0, 290.0)


def test_the_pace_is_learnt_as_a_run_goes_on_and_a_person_counts_for_nothing():
    """What was to be 100 times ran at 23 on a busy computer, and what was promised crept on."""
    pace = Pace()
    for second in range(4):
        pace.see(23.0 * second, float(second))
    assert (pace.learnt(100.0), pace.learnt(1.0)) == (0.0, 1.0)  # nothing is known of so little
    for second in range(4, 8):
        pace.see(23.0 * second, float(second))
    assert pace.learnt(100.0) == pytest.approx(23.0)
    pace.waits()
    for second in range(300, 304):
        pace.see(23.0 * (second - 293), float(second))
    assert pace.learnt(100.0) == pytest.approx(23.0)
    for second in range(304, 500):
        pace.see(23.0 * 11 + 50.0 * (second - 304), float(second))
    assert pace.learnt(100.0) == pytest.approx(50.0, rel=0.05)


def test_the_time_between_stop_and_go_on_is_no_pace():
    """Two minutes between were learnt as the pace, and what was promised after them was out by ten."""
    pace = Pace()
    for second in range(20):
        pace.see(20.0 * second, float(second))
    for second in range(140, 160):
        pace.see(20.0 * (second - 120), float(second))
        assert pace.learnt(100.0) == pytest.approx(20.0)


def test_a_bench_that_is_faster_than_life_says_that_its_seconds_are_simulated(deaf):
    for pace, said in (
        ("100 times", "Hands off · 20 s simulated · offset and first position"),
        ("true", "Hands off · 20 s · offset and first position"),
    ):
        run = RunViewModel(deaf())
        run.virtual_time = True
        run.start(RunProcedure("preflight", "bench.toml", {}, "EM-07", "J. Doe", pace))
        run._worker.items.emit((Step(0.0, 1, 2, "zero", 60.0, (), 20.0),))
        assert what_happens(run, LabNow()) == said


@pytest.mark.parametrize(("pace", "speed"), [("20 times", 20.0), ("100 times", 100.0)])
def test_done_at_is_the_clock_on_the_wall_however_fast_simulated_time_passes(still, monkeypatch, pace, speed):
    """Of 6000 s of the bench 300 s on the wall at 20 times, 60 s at 100 times."""
    wall = [0.0]
    monkeypatch.setattr(run_time.time, "monotonic", lambda: wall[0])
    clock = type("Clock", (), {"now": staticmethod(lambda: datetime(2026, 11, 30, 4, 49, 55))})
    monkeypatch.setattr(time_left, "datetime", clock)
    still.app_state.run.start(RunProcedure("preflight", "bench.toml", pace=pace))
    run, live = still.app_state.run, still.page("Run").live
    monkeypatch.setattr(run, "left_s", lambda: 6000.0)
    monkeypatch.setattr(run, "needed_s", lambda: None)
    still.app_state.bench_worker.items.emit((PLAN.begin(BENCH, "x"),))
    for second in range(1, 7):
        wall[0] = float(second)
        still.app_state.bench_worker.items.emit((Event(100.0 + speed * second, "note", "it turns"),))
    live.time_left.show_now(still.app_state.lab.state.now)
    at = clock_time(clock.now(), 6000.0 / speed)
    assert live.time_left.until.text() == f"Done at about {at}"
    assert at in ("04:54", "04:50")

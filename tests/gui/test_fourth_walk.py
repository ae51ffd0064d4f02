"""What a fourth person saw of hands and coils in a run, each as it was seen."""

import time
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from lab_states import told
from PySide6.QtCore import QTimer

from labcal.bench.coils.state import AT_ZERO, BY_WORD, LabState, PlatformReading
from labcal.gui.ipc.backlog import PastMessages
from labcal.gui.ipc.bench_commands import read_bench
from labcal.gui.ipc.messages import GoesOn, Pause, ReadBench, Recorded, RunProcedure, StateRead
from labcal.gui.pages import run_live
from labcal.gui.viewmodels.hands_now import hands_words
from labcal.gui.widgets.run_pictures import LOCI_EVERY
from labcal.record import Segment
from labcal.record.stream import Block, Event, Measurement, Prompt, SegmentOpened, Step

TURN = "z+50uT-nominal"
BENCH = str(Path(__file__).parents[2] / "examples" / "simulated.toml")
STEPS = ("zero", TURN, "closing")
MOUNT = Prompt(1.0, "mount-x", "Mount it.", ("done",), True, {"body_from_cage": np.eye(3).tolist()})


@pytest.fixture
def running(still):
    return in_a_turn(still)


def in_a_turn(window):
    window.app_state.run.start(RunProcedure("preflight", "bench.toml", {}, "EM-07", "J. Doe"))
    send(window, Step(0.0, 2, 3, TURN, 60.0, STEPS, 20.0))
    return window


def send(window, *items):
    window.app_state.bench_worker.items.emit(items)


def test_a_window_that_comes_back_says_that_the_coils_may_be_on_until_they_are_read(still):
    app_state, live = still.app_state, still.page("Run").live
    app_state.forget()
    app_state.run.come_back()
    app_state.grow_old()
    live.draw()
    assert live.headline.text() == "A run goes on: the coils may be on. Hands off."
    assert still.side.zero_words.text().startswith("● coils may be on")
    assert still.side.zero_words.property("state") == "warning"
    send(still, Step(0.0, 2, 3, TURN, 60.0, STEPS, 20.0))
    live.draw()
    assert live.headline.text() == "A run goes on: the coils may be on. Hands off."
    told(still, (0.0, 0.0, 0.0))
    live.draw()
    assert live.headline.text().startswith("Hands off")
    assert still.side.zero_words.text() == f"✓ {AT_ZERO}"


def test_how_the_coils_are_is_the_first_that_a_window_that_comes_back_hears():
    past = PastMessages(GoesOn(RunProcedure("preflight", "b.toml"), "now", read_bench(None, ReadBench(BENCH))))
    past.keep(Recorded((Step(0.0, 2, 3, TURN, 60.0, STEPS, 20.0),)))
    past.keep(StateRead(LabState(())))
    assert [type(one).__name__ for one in past.events()] == ["GoesOn", "StateRead", "Recorded"]


def test_a_page_that_is_built_into_a_question_says_how_coils_and_platform_are(new_window):
    from labcal.gui.pages.run_live import Live

    running = in_a_turn(new_window)  # the new page takes the plots of the old one
    told(running, (0.0, 0.0, 0.0))
    lab = replace(running.app_state.run.lab, platform=PlatformReading(0.0, False, time.monotonic()))
    running.app_state.bench_worker.states.emit(lab)
    send(running, MOUNT)
    old = running.page("Run").live
    new = Live(running.app_state, old._theme, old.loci, old.traces)
    assert new.prompt.lab.text() == old.prompt.lab.text() == f"✓ {AT_ZERO}"
    assert new.prompt.stands.text() == old.prompt.stands.text() == "✓ platform stands at 0°"
    assert new.prompt.hands.text().startswith(("✓ Hands may go in", "● Hands may go in"))


@pytest.mark.parametrize(
    ("coils", "platform", "said", "mark"),
    [
        (AT_ZERO, "platform stands at 0°", "✓ Hands may go in: coils at zero", "good"),
        (f"{BY_WORD}: no ambient field", "", "● Hands may go in: coils read back at zero by their supplies", "alone"),
        (AT_ZERO, "platform turns, at 12°", "▲ Hands off: platform turns", "bad"),
        (AT_ZERO, "platform NOT confirmed at a standstill", "▲ Hands off: platform NOT confirmed at a stand", "bad"),
        ("coils on: x +1.1000 A", "platform stands at 0°", "▲ Hands off: coils on", "bad"),
        ("coils not read back in this session", "", "▲ Hands off: not read yet", "off"),
        ("coils confirmed at zero 12 s ago; not watched since", "", "▲ Hands off: the coils are not being", "off"),
        ("coils NOT confirmed at zero", "", "▲ Hands off: coils NOT confirmed at zero", "bad"),
    ],
)
def test_whether_hands_may_go_in_is_said_first(coils, platform, said, mark):
    words, state = hands_words(coils, platform)
    assert words.startswith(said)
    assert state == mark


def test_who_is_asked_to_stand_back_is_not_told_that_hands_may_go_in(running):
    told(running, (0.0, 0.0, 0.0))
    card = running.page("Run").live.prompt
    send(running, MOUNT)
    assert card.hands.isVisible()
    send(running, Prompt(2.0, "ready", "The field goes to 50 µT. Hands off?", ("done",), True))
    assert not card.hands.isVisible()


def test_a_pause_that_was_asked_for_is_said_by_its_button(running):
    live = running.page("Run").live
    live.pause.click()
    assert running.app_state.bench_worker.said == [Pause()]
    assert (live.pause.text(), live.pause.isEnabled()) == ("Pausing …", False)
    send(running, Event(2.0, "pause", "paused, coils at zero", {}))
    assert (live.pause.text(), live.pause.isEnabled()) == ("Go on", True)
    send(running, Event(3.0, "pause", "goes on"))
    assert live.pause.text() == "Pause"


def circle(n=50):
    t = np.linspace(0.0, 6.0, n)
    return Block("dut", "dut", ("dut_x", "dut_y", "dut_z"), t, np.column_stack([np.cos(t), np.sin(t), 0 * t]) * 1e4)


def drawn(live):
    """How many points of a locus stand on the spheres."""
    lines = [line.getData()[0] for view in live.loci._views for pair in view for line in pair]
    return sum(len(x) for x in lines if x is not None)


def test_the_run_of_another_dut_begins_with_empty_spheres(running):
    live, run = running.page("Run").live, running.app_state.run
    send(running, SegmentOpened(0.5, Segment(TURN, "rotation")), circle())
    live.draw()
    assert drawn(live) > 0
    run.forget()
    run.start(RunProcedure("preflight", "bench.toml", {}, "EM-08", "J. Doe"))
    live.draw()
    assert drawn(live) == 0
    send(running, Step(0.0, 1, 3, "zero", 60.0, STEPS, 20.0), SegmentOpened(0.5, Segment(TURN, "rotation")), circle())
    live.draw()
    assert drawn(live) > 0


def test_a_turn_that_is_begun_again_has_neither_ticks_nor_rows_of_the_one_that_was_broken_off(running):
    run = running.app_state.run
    good = Measurement(1.5, f"{TURN}: noise", 20.0, 1.0, "nT", 30.0)
    other = replace(good, name="z-50uT-nominal: noise")
    send(running, SegmentOpened(0.5, Segment(TURN, "rotation")), circle(), good, other)
    assert run.axis_checks("z")["noise"] == "PASS"
    send(running, SegmentOpened(9.0, Segment(TURN, "rotation")))
    assert list(run.measurements) == [other.name]
    assert len(run.drawn.now[TURN].rows()) == 0


def test_the_spheres_follow_by_the_clock_however_seldom_rows_come(running):
    live = running.page("Run").live
    send(running, SegmentOpened(0.5, Segment(TURN, "rotation")))
    first = circle()
    send(running, replace(first, t_s=first.t_s[:2], values=first.values[:2]))
    live.draw()
    before = drawn(live)
    send(running, replace(first, t_s=first.t_s[2:], values=first.values[2:]))  # a block of half a second, and no more
    for _ in range(LOCI_EVERY):
        live.draw()
    assert drawn(live) > before


def test_the_spheres_begin_with_the_first_rows_of_each_turn(running):
    """At 100 times the pace a turn may be over before they are drawn the next time."""
    live, turns = running.page("Run").live, (TURN, "z-50uT-nominal")
    seen = []
    for turn in turns:
        send(running, SegmentOpened(0.5, Segment(turn, "rotation")))
        live.draw()
        send(running, replace(circle(), t_s=circle().t_s[:5], values=circle().values[:5]))
        live.draw()
        seen.append(drawn(live))
    assert 0 < seen[0] < seen[1]


def test_at_a_high_pace_the_pictures_are_drawn_all_the_same(running, qtbot, monkeypatch):
    """Each word of the run began the time to the next frame anew: where they came quickly there was none."""
    live, frames = running.page("Run").live, []
    monkeypatch.setattr(live.pictures, "draw", lambda: frames.append(1))
    running.open_page("Run")
    send(running, SegmentOpened(0.5, Segment(TURN, "rotation")))
    words = QTimer(interval=run_live.FRAME_MS // 4)
    words.timeout.connect(running.app_state.run.changed)
    words.start()
    qtbot.waitUntil(lambda: len(frames) >= 3, timeout=10_000)
    words.stop()


def test_what_was_covered_is_of_this_step(running):
    run = running.app_state.run
    angle = Block("angle", "stage", ("angle_deg",), np.arange(24.0), 15.0 * np.arange(24.0)[:, None])
    send(running, SegmentOpened(0.5, Segment(TURN, "rotation")), circle(), angle)
    assert run.coverage() > 0.0
    send(running, Step(30.0, 3, 3, "closing", 60.0, STEPS, 20.0))
    assert run.coverage() == 0.0

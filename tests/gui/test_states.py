"""Every state of a run: Stop, F12, a dying instrument and a dying worker, on a window without a process."""

import re

import numpy as np
import pytest
from lab_states import told
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QApplication

from labcal.gui.ipc.answers import CoilEnd, Ended, SwitchedOff
from labcal.gui.ipc.messages import Abort, GoOn, KeepPhoto, Note, Pause, RunProcedure, Stop, SwitchOff
from labcal.gui.ipc.wire import Fault
from labcal.gui.theming.theme import DARK, LIGHT
from labcal.gui.widgets.prompt_card import PromptCard
from labcal.record import Segment
from labcal.record.stream import Block, Event, Measurement, Prompt, SegmentClosed, SegmentOpened, Step

STEPS = ("zero", "x+20uT-nominal", "closing")
SEGMENT = SegmentOpened(2.0, Segment("x+20uT-nominal", "rotation"))
INTO = {
    "starting": (),
    "running": (Step(0.0, 1, 3, "zero", 60.0, STEPS, 20.0), Event(0.5, "set-point", "on", {"read_back_A": [1, 0, 0]})),
    "measuring": (Step(0.0, 2, 3, "x+20uT-nominal", 60.0, STEPS, 20.0), SEGMENT),
    "asking": (Step(0.0, 1, 3, "zero", 60.0, STEPS), Prompt(1.0, "mount-x", "Mount it.", ("done",), True)),
    "asked for words": (Step(0.0, 1, 3, "zero", 60.0, STEPS), Prompt(1.0, "why", "Why?", ())),
    "paused": (Step(0.0, 1, 3, "zero", 60.0, STEPS), Event(1.0, "pause", "paused, coils at zero", {})),
}
SILENT = Fault(
    "instrument",
    "ref: no sample for 2.1 s.",
    "Is its plug in at both ends, and has it power? Nobody can tell from here which it is.",
    "trace",
)


def send(window, *items):
    window.app_state.bench_worker.items.emit(items)


@pytest.fixture(params=INTO)
def brought(request, still):
    still.app_state.run.start(RunProcedure("preflight", "bench.toml", {}, "EM-07", "J. Doe"))
    send(still, *INTO[request.param])
    return still


def end(window, status, fault=None):
    window.app_state.bench_worker.answer(RunProcedure, Ended("r1", status, fault))


def test_stop_is_there_in_every_state_and_ends_in_order(qtbot, brought):
    live, worker = brought.page("Run").live, brought.app_state.bench_worker
    qtbot.mouseClick(live.stop, Qt.MouseButton.LeftButton)
    assert worker.said == [Stop()]
    assert (brought.app_state.run.state, live.prompt.isVisible()) == ("stopping", False)
    told(brought)
    end(brought, "stopped")
    assert (brought.app_state.run.status, live.fault.isVisible(), live.close_run.isVisible()) == (
        "stopped",
        False,
        True,
    )
    assert brought.app_state.lab.state.now.coils_at_zero is True


def test_coils_off_is_heard_in_every_state(qtbot, brought):
    qtbot.keyClick(brought, Qt.Key.Key_F12)
    assert brought.app_state.bench_worker.said == [Abort()]
    assert brought.app_state.run.state == "stopping"
    assert brought.app_state.off.force_timer.isActive()
    brought.app_state.off.force_timer.timeout.emit()  # what happens where the run does not come to its end
    assert brought.app_state.bench_worker.killed == 1
    assert isinstance(brought.app_state.off_worker.asked[-1].command, SwitchOff)


def test_what_was_on_its_way_when_coils_off_was_ordered_is_not_announced_as_now(qtbot, brought):
    qtbot.keyClick(brought, Qt.Key.Key_F12)
    ordered = brought.app_state.lab.state.message
    send(brought, Step(6.0, 3, 4, "x+50uT", 60.0), SegmentOpened(7.0, Segment("x+50uT", "rotation")))
    assert brought.app_state.run.state == "stopping"
    assert brought.app_state.lab.state.message == ordered


def test_a_run_that_comes_to_its_end_by_itself_leaves_nothing_behind_that_could_kill_the_next(qtbot, brought):
    qtbot.keyClick(brought, Qt.Key.Key_F12)
    end(brought, "failed: aborted by the operator")
    assert not brought.app_state.off.force_timer.isActive()


def test_an_instrument_that_dies_in_any_state_is_a_card_with_words_and_a_remedy(brought):
    live = brought.page("Run").live
    end(brought, "failed: ref is silent", SILENT)
    assert live.fault.isVisible()
    assert (live.fault.text.text(), live.fault.remedy.text()) == ("ref: no answer.", SILENT.remedy)
    assert not live.prompt.isVisible()
    assert not live.fault.details.isVisible()
    assert ("reference", "fault", "failed") not in brought.app_state.lab.state.now.lights
    assert not brought.app_state.run.alive


def test_a_worker_that_dies_in_any_state_is_a_card_and_another_one_switches_the_coils_off(brought):
    failed = brought.app_state.bench_worker.asked[-1].failed
    failed(Fault("ended", "The work was killed (signal 9, SIGKILL).", "", "trace"))
    card = brought.page("Run").live.fault
    assert card.isVisible()
    assert card.heading.text() == "✕ The work broke off"
    assert card.coils.text() == "coils not read back since they were ordered off"
    assert isinstance(brought.app_state.off_worker.asked[-1].command, SwitchOff)


def test_coils_that_cannot_be_confirmed_are_said_to_be_so(still):
    still.app_state.off.order()
    failed = still.app_state.off_worker.asked[-1].failed
    failed(Fault("instrument", "supply_x does not answer."))
    assert still.app_state.lab.state.now.coils_at_zero is False
    assert still.side.zero_words.text() == "✕ coils NOT confirmed at zero"
    assert still.fault.by_hand.text() == "Switch off by hand: supply_x, supply_y, supply_z"
    assert "at its mains switch" in still.fault.remedy.text()
    assert still.fault.isVisible()


def test_coils_off_without_a_run_asks_for_them_at_once(qtbot, still):
    qtbot.keyClick(still, Qt.Key.Key_F12)
    assert isinstance(still.app_state.off_worker.asked[-1].command, SwitchOff)
    still.app_state.off_worker.answer(SwitchOff, SwitchedOff(tuple(CoilEnd(a, 0.0, "at zero", True) for a in "xyz")))
    assert still.app_state.lab.state.now.coils_at_zero is True


def test_a_question_sounds_at_once_and_again_until_it_is_answered(by_mouse, still, monkeypatch):
    card = still.page("Run").live.prompt
    still.app_state.run.start(RunProcedure("preflight", "bench.toml"))
    heard = []
    monkeypatch.setattr(QApplication, "beep", lambda: heard.append("beep"))
    send(still, *INTO["asking"])
    assert heard
    heard.clear()
    assert (card.call.isActive(), card.call.interval()) == (True, 20_000)
    card.call.timeout.emit()  # twenty seconds later
    assert heard == ["beep"]
    closed = PromptCard(LIGHT)
    closed.show_prompt(still.app_state.run.prompt)
    assert heard == ["beep"]
    by_mouse(card.choices["done"])
    assert not card.call.isActive()


def test_pause_and_go_on(qtbot, still):
    still.app_state.run.start(RunProcedure("preflight", "bench.toml"))
    send(still, *INTO["running"])
    live, worker = still.page("Run").live, still.app_state.bench_worker
    qtbot.mouseClick(live.pause, Qt.MouseButton.LeftButton)
    send(still, Event(1.0, "pause", "paused, coils at zero", {}))
    assert live.pause.text() == "Go on"
    qtbot.mouseClick(live.pause, Qt.MouseButton.LeftButton)
    send(still, Event(2.0, "pause", "goes on", {}))
    assert worker.said == [Pause(), GoOn()]
    assert still.app_state.run.state == "running"


def test_what_happens_can_be_read_from_the_cage(still):
    still.app_state.run.start(RunProcedure("preflight", "bench.toml"))
    live = still.page("Run").live
    send(still, *INTO["measuring"])
    t = np.array([6.0])
    send(still, Block("dut", "dut", ("dut_x", "dut_y", "dut_z"), t, np.ones((1, 3))))
    live.draw()
    assert live.headline.text() == "Hands off · 14 s simulated · x +20 µT nominal"
    assert still.app_state.lab.state.waiting == "hands off, measuring"


@pytest.mark.slow
def test_the_light_of_an_axis_is_on_before_it_is_dismounted_and_off_again_when_it_is_redone(still):
    still.app_state.run.start(RunProcedure("preflight", "bench.toml"))
    lights, name = still.page("Run").live.lights, "x+20uT-nominal"
    steps = ("zero", name, "closure-x")  # a run that closes the axis looks at its delay and closure
    send(still, Step(0.0, 2, 3, name, 60.0, steps, 20.0), SEGMENT, SegmentClosed(20.0))
    assert lights.worst["x"].text() == "X  ○"
    looks = (("missing sectors", 0.0, 0.0, 0.0), ("noise", 26.0, 1.0, 37.5), ("wrong signs", 0.0, 0.0, 0.0))
    send(still, *(Measurement(20.5, f"{name}: {what}", v, u, "", limit) for what, v, u, limit in looks))
    assert lights.worst["x"].text() == "X  …"
    send(still, Measurement(21.0, "delay x", 0.9, 0.01, "s", 0.5))
    send(still, Prompt(22.0, "mount-y", "Mount Y.", ("done", "redo x"), True))
    assert lights.worst["x"].text() == "X  ✕ FAIL"
    looks = re.sub("<[^>]*>|&nbsp;", " ", lights.looks["x"].text()).split()
    assert looks == ["✓", "coverage", "✓", "noise", "✓", "sign", "✕", "delay", "○", "closure"]
    assert lights.isVisible()
    still.set_theme(DARK)
    still.style_queue.finish()
    assert DARK.good in lights.looks["x"].text()
    still.set_theme(LIGHT)
    still.style_queue.finish()
    send(still, Event(23.0, "not-used", "lift moved", {"segments": [name], "reason": "lift moved"}))
    assert lights.worst["x"].text() == "X  ○"
    assert name not in still.app_state.run.drawn.now


def test_a_note_and_a_photograph_go_into_the_record_at_any_moment(qtbot, brought):
    live, worker = brought.page("Run").live, brought.app_state.bench_worker
    live.note.setText("lift moved")
    live.note.returnPressed.emit()
    live.note.setText("how it stands")
    live.notes.keep_photo("/tmp/picture.jpg")
    brought.app_state.quick_worker.answer(KeepPhoto, {"photo": "ab.jpg", "sha256": "ab"})
    assert worker.said == [
        Note("lift moved"),
        Note("how it stands", {"photo": "ab.jpg", "sha256": "ab"}),
    ]


def test_a_form_that_comes_up_new_is_in_the_theme_and_so_after_another_theme(qtbot, still, patience):
    choose = still.page("Run").choose
    choose.choose("axes-check")
    choose.choose("preflight")
    qtbot.waitUntil(lambda: choose.form.isVisible(), timeout=patience)
    assert LIGHT.sunken in choose.form.styleSheet()
    still.set_theme(DARK)
    choose.choose("axes-check")
    qtbot.waitUntil(lambda: choose.form.isVisible(), timeout=patience)  # the old one is gone before it is its turn
    still.style_queue.finish()
    assert DARK.sunken in choose.form.styleSheet()
    still.set_theme(LIGHT)
    still.style_queue.finish()


def test_a_page_is_built_in_several_events_and_then_put_into_its_place(qapp, still):
    from labcal.gui.pages.lazy_page import LazyPage
    from labcal.gui.pages.registry import pages

    page, turns = LazyPage(pages()["Run"], still.app_state, lambda: LIGHT, still.sheet), 0
    while not page.ready:
        page.build()
        turns += 1
    assert turns > 4  # the page, loci, traces, the live face, and its style sheets
    assert page.page.live.note.styleSheet()
    page.build()  # there is nothing more to do

"""What a stranger stumbled over: marks of steps, a held key, a scan that was typed, a file that is verified."""

import pytest
from PySide6.QtCore import QEvent, Qt
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import QApplication
from test_path import RUN, calibration

from labcal.gui.ipc.answers import Ended, Standing
from labcal.gui.ipc.messages import Answer, ListCalibrations, ListKeys, RunProcedure, VerifyFile
from labcal.gui.ipc.wire import Fault
from labcal.gui.viewmodels.trace_pace import TracePace
from labcal.gui.widgets import hold_button
from labcal.record.stream import Prompt, Step

MOUNT = Prompt(2.0, "mount-z", "Mount the DUT.", ("done",), True)
NAMES = ("zero", "mount-z", "z+20uT")


@pytest.mark.parametrize(("at_a_question", "mark"), [(True, "next"), (False, "broken")])
def test_a_step_that_was_ended_at_its_question_was_never_begun(still, at_a_question, mark):
    run, worker = still.app_state.run, still.app_state.bench_worker
    run.start(RunProcedure("preflight", "bench.toml", {}, "EM-07", "J. Doe"))
    worker.items.emit((Step(1.0, 2, 3, "mount-z", 60.0, NAMES), *((MOUNT,) if at_a_question else ())))
    run.stop()
    worker.answer(RunProcedure, Ended("r1", "interrupted", Fault("stopped", "stopped")))
    assert dict(run.steps())["mount-z"] == mark


def stamped(kind, at_ms, key=Qt.Key.Key_F8):
    event = QKeyEvent(kind, key, Qt.KeyboardModifier.NoModifier)
    event.setTimestamp(at_ms)
    return event


@pytest.fixture
def asked(qtbot, still, patience):
    """A question that is alive; no clock confirms or gives up."""
    hold_button.heard_ms.clear()
    still.open_page("Run")
    still.app_state.run.start(RunProcedure("preflight", "bench.toml"))
    still.app_state.bench_worker.items.emit((MOUNT,))
    card = still.page("Run").live.prompt
    qtbot.waitUntil(lambda: card.alive, timeout=patience)
    card.choices["done"].held.setInterval(3_600_000)
    return card


@pytest.mark.parametrize(("held_ms", "answered"), [(1300, True), (300, False)])
def test_how_long_a_key_was_held_is_told_by_its_events_however_late_they_are_heard(
    qtbot, still, asked, patience, held_ms, answered
):
    """A busy window heard press and release in one go: "Let go too early" of what was held for 1.3 s."""
    QApplication.sendEvent(still, stamped(QEvent.Type.KeyPress, 50_000))
    QApplication.sendEvent(still, stamped(QEvent.Type.KeyRelease, 50_000 + held_ms))
    qtbot.waitUntil(lambda: asked.choices["done"]._began is None, timeout=patience)
    assert (still.app_state.bench_worker.said == [Answer("mount-z", "done")]) == answered
    if not answered:
        assert asked.hint.text() == "▲ Let go too early, after 0.3 s: hold F8 for 0.7 s."


def test_a_release_that_waits_is_heard_before_the_time_is_up(qtbot, still, asked, patience):
    """A window that stood still had its time run out before it heard that the key was let go."""
    button = asked.choices["done"]
    QApplication.sendEvent(still, stamped(QEvent.Type.KeyPress, 50_000))
    QApplication.postEvent(still, stamped(QEvent.Type.KeyRelease, 50_200))
    button.held.timeout.emit()
    qtbot.waitUntil(lambda: button._began is None, timeout=patience)
    assert still.app_state.bench_worker.said == []


def test_a_key_pressed_before_the_question_took_any_is_refused_by_what_was_the_case(qtbot, still, asked, patience):
    button = asked.choices["done"]
    button.setEnabled(False)
    QApplication.sendEvent(still, stamped(QEvent.Type.KeyPress, 50_000))
    button.setEnabled(True)
    QApplication.sendEvent(still, stamped(QEvent.Type.KeyRelease, 51_300))
    assert still.app_state.bench_worker.said == []
    assert asked.hint.text() == "▲ F8 was pressed before this question took an answer. Press it anew."


def test_the_verdict_on_a_file_stands_alone(same_window):
    """A file that was verified stood in small letters above "✓ RELEASED" of another one."""
    same_window.app_state.set_identity(dut="EM-07", operator="J. Doe")
    same_window.open_page("Certificate")
    page, worker = same_window.page("Certificate"), same_window.app_state.quick_worker
    worker.answer(ListCalibrations, (calibration(),))
    worker.answer(ListKeys, ())
    assert page.detail.isVisible()
    page.verify("/x/other.json")
    worker.answer(VerifyFile, Standing("/x/other.json", False, False, (), (), ("no signature",)))
    assert (page.drop.name.text(), page.drop.name.property("state")) == ("✕ other.json", "bad")
    assert page.drop.words.text().startswith("checked at ")
    assert (page.drop.card.isVisible(), page.detail.isVisible()) == (True, False)
    page.drop.close_card.click()
    assert (page.drop.card.isVisible(), page.detail.isVisible()) == (False, True)


def test_the_last_estimate_of_a_tracing_stays_with_its_time_and_fills_the_bar():
    now = [0.0]
    pace = TracePace(lambda: now[0])
    assert (pace.words(), pace.share()) == ("", None)
    pace.hear("scoring every effect")
    now[0] = 20.0
    pace.hear("this run takes about 60 s more and may be stopped; so far nothing has the evidence of a name")
    now[0] = 60.0
    pace.hear("scoring all candidates beside offset-current")
    assert pace.words().startswith("about 60 s more, said at ")
    assert pace.share() == 60 / 80
    now[0] = 79.9
    assert pace.words()
    now[0] = 80.0
    assert pace.words() == ""  # what it promised is over
    now[0] = 600.0
    assert pace.share() == 0.95


def test_start_says_ready_only_where_it_is_to_be_measured(still):
    still.open_page("Start")
    page, app_state = still.page("Start"), still.app_state
    app_state.path.take_runs(())
    assert page.question.text().startswith("Ready. EM-07 is to be measured")
    app_state.path.take_runs((RUN,))
    assert page.question.text() == ""
    app_state.path.take_runs(())
    app_state.set_identity(operator="")
    assert app_state.path.next().words == "Say who works here"
    assert page.calibrate.objectName() != "primary"
    app_state.set_identity(operator="J. Doe")


def test_there_are_no_larger_letters_where_there_is_no_room(same_window):
    same_window.resize(984, 660)
    same_window.toggle_wall()
    assert (same_window.wall, same_window.size_switch.text()) == (False, "Larger   F11")


def test_what_settings_mean_stands_below_them_in_a_narrow_form(same_window, qtbot):
    form = same_window.page("Run").choose.form
    for width, below in ((1500, False), (420, True)):
        form.resize(width, 500)
        form.layout().activate()
        field, about = form.fields["axes"], form.complaints["axes"]
        assert (about.y() >= field.y() + field.height()) == below


def test_the_bar_of_a_tracing_never_goes_back_and_a_longer_estimate_says_that_it_is_one():
    now = [0.0]
    pace = TracePace(lambda: now[0])
    assert pace.share() is None  # it moves, and stands nowhere
    now[0] = 10.0
    pace.hear("this run takes about 30 s more and may be stopped")
    now[0] = 34.0
    assert pace.share() == 34 / 40
    pace.hear("this run takes about 56 s more and may be stopped")
    assert pace.share() == 34 / 40
    assert pace.words().startswith("about 56 s more, longer than was said before; said at ")
    now[0] = 60.0
    pace.hear("this run takes about 20 s more and may be stopped")
    assert pace.words().startswith("about 20 s more, said at ")

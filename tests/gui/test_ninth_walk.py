"""What a stranger stumbled over: marks of steps, a held key, a scan that was typed, a file that is verified."""

import pytest
from PySide6.QtCore import QEvent, Qt
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import QApplication

from labcal.gui.ipc.answers import Ended
from labcal.gui.ipc.messages import Answer, RunProcedure
from labcal.gui.ipc.wire import Fault
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

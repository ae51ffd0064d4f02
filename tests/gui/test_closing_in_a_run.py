"""Closing the window in a run asks first: stop, keep running behind, resume later, or back."""

import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QApplication, QSystemTrayIcon

from labcal.gui.ipc.answers import Ended
from labcal.gui.ipc.messages import Abort, RunProcedure, Stop
from labcal.record.stream import Prompt, Step


@pytest.fixture
def running(new_window, monkeypatch):
    """A window of its own in a run; `hung_up` says whether the line to its worker was closed."""
    hung_up = []
    app_state = new_window.app_state
    worker = app_state.bench_worker
    monkeypatch.setattr(worker, "close", lambda wait_ms: hung_up.append(list(worker.said)))
    app_state.run.start(RunProcedure("preflight", "bench.toml", {}, "EM-07", "J. Doe"))
    app_state.bench_worker.items.emit((Step(0.0, 1, 1, "zero", 60.0, ("zero",)),))
    new_window.hung_up = hung_up
    new_window.close()
    yield new_window
    QApplication.setQuitOnLastWindowClosed(True)


def press(qtbot, window, way):
    qtbot.mouseClick(window.leaving.question.buttons[way], Qt.MouseButton.LeftButton)


def test_nothing_is_closed_or_said_before_an_answer(qtbot, running):
    question = running.leaving.question
    assert (running.isVisible(), question.isVisible(), running.hung_up) == (True, True, [])
    assert running.app_state.bench_worker.said == []
    assert {"Stop", "Keep running behind", "Go on later"} == {one.text() for one in question.buttons.values()}
    assert question.findChild(type(question.back), "off").isVisible()
    assert question.back.isDefault()
    qtbot.keyClick(question, Qt.Key.Key_Return)
    assert (running.isVisible(), question.isVisible(), running.app_state.run.alive) == (True, False, True)


def test_stop_ends_the_run_in_order_and_closes_then(qtbot, running):
    press(qtbot, running, "stop")
    assert (running.app_state.bench_worker.said, running.isVisible()) == ([Stop()], True)
    running.app_state.bench_worker.answer(RunProcedure, Ended("r1", "stopped"))
    assert (running.isVisible(), len(running.hung_up)) == (False, 1)


def test_resume_later_hangs_up_without_a_word_so_that_the_run_is_left_interrupted(qtbot, running):
    press(qtbot, running, "later")
    assert (running.isVisible(), running.hung_up) == (False, [[]])


def test_a_procedure_that_cannot_be_gone_on_with_offers_no_later(running):
    running.leaving.question.close()
    running.app_state.resumable = frozenset()
    running.close()
    assert set(running.leaving.question.buttons) == {"stop", "behind"}


@pytest.mark.parametrize("tray", [pytest.param(True, marks=pytest.mark.slow), False])
def test_kept_behind_it_runs_and_comes_back_when_somebody_is_needed(qtbot, running, monkeypatch, tray):
    monkeypatch.setattr(QSystemTrayIcon, "isSystemTrayAvailable", lambda: tray)
    press(qtbot, running, "behind")
    assert running.isMinimized() or not running.isVisible()
    assert not QApplication.quitOnLastWindowClosed()
    assert (running.app_state.bench_worker.said, running.hung_up) == ([], [])
    running.app_state.bench_worker.items.emit((Prompt(1.0, "mount-x", "Mount it.", ("done",), True),))
    assert (running.isVisible(), running.isMinimized(), QApplication.quitOnLastWindowClosed()) == (True, False, True)


def test_the_question_goes_when_the_run_ends_by_itself(running):
    running.app_state.bench_worker.answer(RunProcedure, Ended("r1", "finished"))
    assert not running.leaving.question.isVisible()
    assert running.isVisible()


def test_without_a_run_nothing_is_asked(new_window):
    new_window.close()
    assert (new_window.isVisible(), new_window.leaving.question) == (False, None)


def test_who_must_go_goes_and_says_off_first(running):
    running.leave()
    assert running.hung_up == [[Abort()]]

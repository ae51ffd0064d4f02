"""Closing the window in a run asks first: stop, keep running behind, or back."""

import time

import pytest
from lab_states import told
from PySide6.QtCore import QEvent, QObject, Qt
from PySide6.QtWidgets import QApplication, QLabel, QPushButton, QSystemTrayIcon

from labcal.bench.coils.state import CoilReading, LabState, PlatformReading, Witness
from labcal.gui import leaving
from labcal.gui.ipc.answers import CoilEnd, Ended, SwitchedOff
from labcal.gui.ipc.messages import Abort, RunProcedure, Stop, SwitchOff
from labcal.gui.ipc.wire import Fault
from labcal.gui.leaving import LOOK_MS
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


class Painted(QObject):
    """What a line said when it was drawn last."""

    def __init__(self, line):
        super().__init__(line)
        self.words = ""
        line.installEventFilter(self)
        line.update()

    def eventFilter(self, line, event):
        if event.type() == QEvent.Type.Paint:
            self.words = line.text()
        return False


def press(qtbot, window, way):
    """A click on its button; `stop`: on Stop where the procedure cannot be gone on with, `later`: where it can."""
    if way == "stop":
        ask_of_what_cannot_be_gone_on_with(window)
    qtbot.mouseClick(window.leaving.question.buttons[way], Qt.MouseButton.LeftButton)


def ask_of_what_cannot_be_gone_on_with(window):
    window.leaving.question.close()
    window.app_state.path.resumable = frozenset()
    window.close()


def test_nothing_is_closed_or_said_before_an_answer(qtbot, running):
    question = running.leaving.question
    assert (running.isVisible(), question.isVisible(), running.hung_up) == (True, True, [])
    assert running.app_state.bench_worker.said == []
    assert {"Stop", "Keep running behind"} == {one.text() for one in question.buttons.values()}
    assert question.findChild(QPushButton, "off").isVisible()
    assert question.back.isDefault()
    qtbot.keyClick(question, Qt.Key.Key_Return)
    assert (running.isVisible(), question.isVisible(), running.app_state.run.alive) == (True, False, True)


def test_stop_ends_the_run_in_order_and_closes_then(qtbot, running):
    press(qtbot, running, "stop")
    assert (running.app_state.bench_worker.said, running.isVisible()) == ([Stop()], True)
    running.app_state.bench_worker.answer(RunProcedure, Ended("r1", "stopped"))
    qtbot.waitUntil(lambda: not running.isVisible())
    assert len(running.hung_up) == 1


def test_later_leaves_the_run_interrupted_and_closes_when_it_has_ended(qtbot, running):
    press(qtbot, running, "later")
    assert (running.app_state.bench_worker.said, running.isVisible(), running.hung_up) == ([Stop(later=True)], True, [])
    running.app_state.bench_worker.answer(RunProcedure, Ended("r1", "interrupted"))
    qtbot.waitUntil(lambda: not running.isVisible())
    assert running.hung_up == [[Stop(later=True)]]  # and no COILS OFF after it


@pytest.mark.parametrize("way", ["stop", "later"])
def test_the_window_stays_until_the_coils_were_read_back_and_says_so_before_it_goes(qtbot, running, way):
    told(running, (0.0, 0.0, 1.1))
    press(qtbot, running, way)
    going = running.leaving.going
    assert (going.isVisible(), going.lab_lines.coils.text()) == (True, "● coils on: z +1.100 A")
    assert going.heading.text().startswith("Going to zero")
    told(running)
    status = "stopped" if way == "stop" else "interrupted"
    running.app_state.bench_worker.answer(RunProcedure, Ended("r1", status))
    qtbot.waitUntil(lambda: going.heading.text().startswith("The run has ended"))
    seen_s = time.monotonic()
    assert (running.isVisible(), going.lab_lines.coils.text()[:15]) == (True, "✓ coils at zero")
    qtbot.waitUntil(lambda: not running.isVisible())
    assert time.monotonic() - seen_s > 1.0


def test_what_the_dialog_shows_is_never_older_than_what_the_window_knows(qtbot, running):
    told(running, (0.0, 0.0, 1.1))
    press(qtbot, running, "stop")
    seen = Painted(running.leaving.going.lab_lines.coils)
    qtbot.waitUntil(lambda: seen.words == "● coils on: z +1.100 A")
    told(running)
    assert seen.words.startswith("✓ coils at zero"), "before anything else is drawn"


def test_with_a_coil_that_is_not_read_back_it_does_not_close_and_says_so(qtbot, running):
    told(running, (0.0, 0.0, 1.1))
    press(qtbot, running, "later")
    told(running, (0.0, 0.0, None))
    running.app_state.bench_worker.answer(RunProcedure, Ended("r1", "interrupted", Fault("instrument", "z: silent")))
    ends = (*(CoilEnd(a, 0.0, "zero, open", True, time.monotonic()) for a in "xy"), CoilEnd("z", None, "lost", False))
    running.app_state.off_worker.answer(SwitchOff, SwitchedOff(ends))
    qtbot.waitUntil(lambda: running.leaving.still_on is not None and running.leaving.still_on.isVisible())
    assert "z: +1.100 A when last read" in running.leaving.still_on.coils.text()
    qtbot.keyClick(running.leaving.still_on, Qt.Key.Key_Escape)
    qtbot.wait(2 * LOOK_MS)
    assert (running.isVisible(), running.leaving.still_on.isVisible(), running.leaving.going.isVisible()) == (
        *(True, False, False),
    )


def test_a_way_out_that_takes_too_long_is_no_end_of_waiting_for_the_person(qtbot, running, monkeypatch):
    told(running, (0.0, 0.0, 1.1))
    monkeypatch.setattr(leaving, "OUT_S", 0.0)
    press(qtbot, running, "later")
    qtbot.waitUntil(lambda: running.leaving.still_on is not None and running.leaving.still_on.isVisible())
    qtbot.mouseClick(running.leaving.still_on.go, Qt.MouseButton.LeftButton)
    assert (running.isVisible(), len(running.hung_up)) == (False, 1)


def test_stay_keeps_the_window_though_the_run_ends(qtbot, running):
    press(qtbot, running, "stop")
    qtbot.mouseClick(running.leaving.going.stay, Qt.MouseButton.LeftButton)
    running.app_state.bench_worker.answer(RunProcedure, Ended("r1", "stopped"))
    qtbot.wait(2 * LOOK_MS)
    assert (running.isVisible(), running.leaving.going.isVisible(), running.hung_up) == (True, False, [])


def test_the_question_is_whole_and_says_how_the_platform_is(qtbot, running):
    states = running.app_state.bench_worker.states
    coils = tuple(CoilReading(a, None, -1.2345, False, None, time.monotonic()) for a in "xyz")
    states.emit(LabState(coils, Witness(), platform=PlatformReading(40.0, True, time.monotonic())))
    question = running.leaving.question
    assert question.lab_lines.platform.text() == "● platform turns, at 40°"
    question.lab_lines.coils.setText("coils on, and one that is not read back any more. " * 8)
    labels = [one for one in question.findChildren(QLabel) if one.wordWrap() and one.isVisible()]
    qtbot.waitUntil(lambda: all(one.height() >= one.heightForWidth(one.width()) for one in labels))
    assert question.rect().contains(question.back.geometry())


def test_stop_says_what_it_leaves_as_stop_on_the_run_page_does(qtbot, running):
    """It was "for good" here, and left a run to be gone on with there."""
    (stop,) = (tip for words, tip in running.leaving.question.ways.values() if words == "Stop")
    assert "Go on, on the Start page" in stop
    ask_of_what_cannot_be_gone_on_with(running)
    (stop,) = (tip for words, tip in running.leaving.question.ways.values() if words == "Stop")
    assert "cannot be gone on with" in stop


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

"""F12 on the real window while a served platform turns: it stands still within the bound, and the window says so."""

import os
import signal
import subprocess
import sys
import time

import pytest
from PySide6.QtCore import QSettings, Qt
from served_lab import LONG_S, Served, all_gone, at_zero, example, until

from labcal.gui.theming.theme import LIGHT
from labcal.gui.viewmodels.app_state import AppState
from labcal.gui.viewmodels.coils_off import OFF_WAITS_MS
from labcal.gui.window import Window

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="needs ptys and SIGSTOP, which Windows lacks")
# A quiet machine takes a third of these; nobody stops a turn that goes on for a minute.
AT_ONCE_S = 4.5
OF_A_PROCESS_S = 15.0  # to end it, and for another to load and to open the line
OF_A_LOOK_S = 20.0  # after the plug is in: it is looked at, and a process loads
SAID_S = 30.0  # after it stands: it is read, or a later look finds who has its line
WAITED_FOR_S = 6.0  # a supply
HANDS_OFF = "✕ HANDS OFF: the platform may still turn"
KEPT = """
import sys, time
from pathlib import Path
from labcal.bench import open_bench
bench = open_bench(Path(sys.argv[1]))
bench.platform.home()
while bench.platform.moving():
    bench.clock.wait_until(bench.clock.now() + 0.05)
bench.platform.move_to(300.0, 6.0)
print("turns", flush=True)
while True:
    bench.clock.wait_until(bench.clock.now() + 0.05)
"""


@pytest.fixture
def served(tmp_path, monkeypatch):
    served = Served(tmp_path, monkeypatch, example(WAITED_FOR_S))
    yield served
    all_gone(served.file)
    served.close()


@pytest.fixture
def opened(qtbot, served, tmp_path, windows):
    """A window on the served bench, whose workers are processes of their own."""
    window = Window(AppState(QSettings(str(tmp_path / "w.ini"), QSettings.Format.IniFormat)), LIGHT)
    windows.append(window)
    window.show()
    window.app_state.open_bench(str(served.file))
    qtbot.waitUntil(lambda: bool(window.app_state.facts), timeout=int(LONG_S * 1000))
    window.app_state.set_identity(operator="J. Doe", dut="SIM-0001")
    return window


def turning(served):
    return bool(served.twin.platform.moving(served.clock.now()))


def run_that_turns(qtbot, window, served):
    """Begun and answered, until the platform turns in the field."""
    run = window.app_state.run
    window.open_page("Run")
    window.app_state.start("rotate-axis", {"rate_deg_per_s": "6", "zero_s": "2", "magnitude_nT": "20000"})

    def turns():
        assert run.state != "ended", run.fault
        if run.state == "asking":
            run.answer(run.prompt.choices[0])
        return run.segment is not None and turning(served) and not at_zero(served)

    qtbot.waitUntil(turns, timeout=int(LONG_S * 1000))


def pressed(qtbot, window, served):
    """F12; how long it took until the platform stood [s]."""
    begun = time.monotonic()
    qtbot.keyClick(window, Qt.Key.Key_F12)
    qtbot.waitUntil(lambda: not turning(served), timeout=int(LONG_S * 1000))
    return time.monotonic() - begun


def test_of_a_run_that_lives_it_stands_at_once_and_the_window_says_so(qtbot, opened, served):
    run_that_turns(qtbot, opened, served)
    assert pressed(qtbot, opened, served) < AT_ONCE_S
    qtbot.waitUntil(lambda: "platform stands at " in opened.side.platform.text(), timeout=int(SAID_S * 1000))
    qtbot.waitUntil(lambda: opened.app_state.run.state == "ended", timeout=int(LONG_S * 1000))
    assert at_zero(served)
    opened.page("Run").live.draw()
    assert "platform stands" in opened.page("Run").live.verdict.reason.text() + opened.side.platform.text()


@pytest.mark.slow  # by the clock, beside a lab that this very process serves
def test_of_a_run_that_hangs_it_stands_once_that_was_ended(qtbot, opened, served):
    run_that_turns(qtbot, opened, served)
    os.kill(opened.app_state.bench_worker.pid, signal.SIGSTOP)
    assert pressed(qtbot, opened, served) < OFF_WAITS_MS / 1000 + OF_A_PROCESS_S
    qtbot.waitUntil(lambda: "platform stands at " in opened.side.platform.text(), timeout=int(SAID_S * 1000))
    assert at_zero(served)


@pytest.mark.slow  # by the clock, beside a lab that this very process serves
def test_of_a_run_of_somebody_else_that_hangs_the_window_says_that_it_may_turn(qtbot, opened, served):
    with subprocess.Popen([sys.executable, "-c", KEPT, str(served.file)], stdout=subprocess.PIPE, text=True) as other:
        try:
            assert other.stdout.readline() == "turns\n"
            until(lambda: turning(served))
            os.kill(other.pid, signal.SIGSTOP)
            qtbot.keyClick(opened, Qt.Key.Key_F12)
            may_turn = "platform NOT confirmed at a standstill"
            qtbot.waitUntil(lambda: may_turn in opened.side.platform.text(), timeout=int(LONG_S * 1000))
            qtbot.waitUntil(lambda: opened.fault.heading.text() == HANDS_OFF, timeout=int(LONG_S * 1000))
            assert opened.fault.turning.isVisible()
            assert turning(served)
            assert at_zero(served)
        finally:
            other.kill()
    assert pressed(qtbot, opened, served) < OF_A_PROCESS_S
    qtbot.waitUntil(lambda: "platform stands at " in opened.side.platform.text(), timeout=int(LONG_S * 1000))
    qtbot.waitUntil(lambda: not opened.fault.isVisible(), timeout=int(SAID_S * 1000))


@pytest.mark.slow  # by the clock, beside a lab that this very process serves
def test_one_whose_line_was_silent_when_its_run_failed_stands_once_it_answers(qtbot, opened, served):
    run_that_turns(qtbot, opened, served)
    stage = served.emulator("stage")
    stage.take, stage.emit = lambda *_: None, lambda *_: []  # its plug is out
    app_state = opened.app_state
    answered = []

    def failed():
        if app_state.run.state == "asking" and app_state.run.prompt not in answered:
            answered.append(app_state.run.prompt)
            app_state.run.answer("stop" if "stop" in app_state.run.prompt.choices else app_state.run.prompt.choices[0])
        return app_state.run.state == "ended"

    qtbot.waitUntil(failed, timeout=int(LONG_S * 1000))
    assert turning(served)
    del stage.take, stage.emit
    qtbot.waitUntil(lambda: not turning(served), timeout=int(OF_A_LOOK_S * 1000))
    qtbot.waitUntil(lambda: "platform stands at " in app_state.lab.state.message, timeout=int(SAID_S * 1000))

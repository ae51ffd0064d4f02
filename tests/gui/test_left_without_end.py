"""A run that a killed window left behind: hands are kept out, nothing begins beside it, and it is gone on with."""

import subprocess
import sys
from dataclasses import replace

import pytest
from lab_states import told

from labcal.files.home import home
from labcal.gui.ipc.answers import CoilEnd, RunLine, SwitchedOff
from labcal.gui.ipc.lab_messages import ReadLab
from labcal.gui.ipc.messages import ListRuns, SwitchOff
from labcal.gui.ipc.record_messages import LookForLeft
from labcal.record import Dut, Reference
from labcal.record.header import RunHeader
from labcal.record.left_running import LeftRunning
from labcal.store import Store
from labcal.store.left_running import left_running

BENCH = 'name = "cage-2"\n'
CUT_OFF = "✕ Hands off: a run of MAG-0043 was cut off; the coils are not known"
ELSEWHERE = "Hands off: another process drives a run of MAG-0043; the coils may be on"
KILLED = LeftRunning("MAG-0043_20260101T000000", "MAG-0043", False)
WRITES = """
import os, sys
sys.path[:0] = sys.argv[2:]
from test_left_without_end import begun
writer = begun(sys.argv[1])
print("begun", flush=True)
sys.stdin.read()
os._exit(9)
"""


def begun(run_id, bench=BENCH, store=None):
    """A run of MAG-0043 that goes on in this process."""
    header = RunHeader(
        run_id, "2026-01-01T00:00:00Z", True, "J. Doe", Dut("MAG-0043"), Reference("vector"), bench=bench
    )
    return (store or Store.open()).begin(header)


@pytest.fixture
def cut_off(still):
    """The window is opened on a bench on which a run was cut off."""
    still.app_state.left.look()
    still.app_state.quick_worker.answer(LookForLeft, KILLED)
    return still


def test_of_a_killed_process_the_run_is_found_until_another_has_ended(tmp_path, monkeypatch):
    monkeypatch.setenv("LABCAL_HOME", str(tmp_path))
    file = home() / "store.sqlite"
    assert left_running(file, "cage-2") is None
    with subprocess.Popen(
        [sys.executable, "-c", WRITES, "r1", *sys.path], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
    ) as other:
        assert other.stdout.readline() == "begun\n"
        assert left_running(file, "cage-2") == LeftRunning("r1", "MAG-0043", True)
        assert left_running(file, "cage-3") is None
        other.stdin.close()
    assert left_running(file, "cage-2") == LeftRunning("r1", "MAG-0043", False)
    with Store.open() as store:
        begun("r2", 'name = "cage-3"\n', store).finish("finished")
        assert left_running(file, "cage-2") == LeftRunning("r1", "MAG-0043", False)
        begun("r3", store=store).finish("stopped")
    assert left_running(file, "cage-2") is None


def test_the_bench_is_looked_up_as_it_is_opened(new_window):
    app_state = new_window.app_state
    assert LookForLeft(app_state.facts.name) in app_state.quick_worker.commands(LookForLeft)


def test_hands_are_kept_out_on_every_page_until_the_coils_are_read(cut_off):
    for page in cut_off.lazy_pages:
        cut_off.open_page(page)
        assert (cut_off.side.hands.text(), cut_off.side.hands.isVisible()) == (CUT_OFF, True)
        assert cut_off.side.keep_off.text() == cut_off.top.keep_off.text() == "✕ HANDS OFF"
    assert CUT_OFF in cut_off.page("Start").question.text()
    ends = tuple(CoilEnd(axis, 0.0, "zero, open", True, cut_off.app_state.now_s()) for axis in "xyz")
    cut_off.app_state.off.order()
    cut_off.app_state.off_worker.answer(SwitchOff, SwitchedOff(ends))
    assert "Hands may go in" in cut_off.side.hands.text()
    assert CUT_OFF not in cut_off.page("Start").question.text()


def test_nothing_begins_while_another_process_drives_the_run(cut_off, qtbot):
    app_state, start = cut_off.app_state, cut_off.page("Start")
    app_state.left.look()
    app_state.quick_worker.answer(LookForLeft, replace(KILLED, goes_on=True))
    told_of = "Another process still drives a run of MAG-0043 on this bench: wait until it has ended."
    assert (cut_off.side.hands.text(), app_state.objection()) == (ELSEWHERE, told_of)
    assert start.question.text() == told_of
    assert start.calibrate.objectName() != "primary"
    cut_off.open_page("Run")
    assert not cut_off.page("Run").choose.start.isEnabled()
    told(cut_off)
    assert cut_off.side.hands.text() == ELSEWHERE  # whatever was read: it is not this window's to say
    assert cut_off.top.keep_off.text() == "HANDS OFF"
    app_state.watch.look()
    assert app_state.watch_worker.commands(ReadLab) == []  # nor is it read on from here
    assert app_state.left.timer.isActive()
    assert cut_off.leaving.may_go()  # nobody is asked to switch off what another process answers for
    assert not cut_off.says_off
    cut_off.says_off = True
    app_state.left.timer.timeout.emit()
    app_state.quick_worker.answer(LookForLeft, KILLED)
    assert not app_state.left.timer.isActive()
    assert app_state.objection() != told_of


def test_start_looks_again_while_a_run_goes_on_elsewhere(still):
    app_state, start = still.app_state, still.page("Start")
    still.open_page("Start")
    line = RunLine(KILLED.run_id, "2026-01-01T00:00:00Z", "running", "MAG-0043", "J. Doe", "preflight", True)
    app_state.quick_worker.answer(ListRuns, (line,))
    assert start.interrupted.isHidden()
    assert start.again.isActive()
    start.again.timeout.emit()
    app_state.quick_worker.answer(ListRuns, (replace(line, status="interrupted"),))
    assert not start.interrupted.isHidden()
    app_state.quick_worker.answer(ListRuns, ())


def test_what_a_run_of_this_window_knows_goes_before(cut_off):
    cut_off.app_state.run.state = "running"
    cut_off.app_state.grow_old()
    assert cut_off.app_state.lab.state.now.left_by == ""
    cut_off.app_state.run.forget()

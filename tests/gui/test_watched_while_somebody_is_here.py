"""Supplies are not asked all night for nobody: after a quarter of an hour alone the watch stops, and says so."""

import re
import time
from dataclasses import replace

import pytest
from PySide6.QtCore import QEvent, QPointF, Qt
from PySide6.QtGui import QMouseEvent
from PySide6.QtWidgets import QApplication
from test_hands_in_the_cage import lab, stands
from test_hands_in_the_cage import real as real

from labcal.gui.ipc.lab_messages import ReadLab
from labcal.gui.ipc.messages import RunProcedure
from labcal.gui.viewmodels.lab_watch import ALONE_S


def asked(window):
    """Whether the watch, which looks now, asks anybody."""
    watch = window.app_state.watch
    watch.stop()
    window.app_state.watch_worker.asked.clear()
    watch.look()
    return bool(window.app_state.watch_worker.commands(ReadLab))


def alone(window, seconds):
    window.app_state.watch._touched_s = time.monotonic() - seconds


@pytest.fixture
def at_zero(real):
    """Read at zero, and nothing is wrong."""
    real.app_state.watch.touched()
    real.app_state.take_lab(lab(platform=stands()))
    return real


def test_who_is_here_is_read_for(at_zero):
    alone(at_zero, ALONE_S - 60.0)
    assert asked(at_zero)


def test_alone_it_stops_and_says_since_when(at_zero):
    alone(at_zero, ALONE_S + 1.0)
    assert not asked(at_zero)
    at_zero.app_state.grow_old()
    said = at_zero.side.hands
    assert re.fullmatch(r"▲ Hands off: not read since \d\d:\d\d; move the mouse, and it is read again", said.text())
    assert said.property("state") == "off"
    for heading in (at_zero.side.keep_off, at_zero.top.keep_off):  # no alarm, and no other word than below it
        assert (heading.text(), heading.property("state")) == ("▲ Hands off", "off")


@pytest.mark.parametrize("how", [QEvent.Type.MouseMove, QEvent.Type.MouseButtonPress])
def test_any_input_begins_it_again_at_once(at_zero, how):
    alone(at_zero, ALONE_S + 1.0)
    assert not asked(at_zero)
    button = Qt.MouseButton.LeftButton
    at = QPointF(9.0, 9.0)
    QApplication.sendEvent(at_zero, QMouseEvent(how, at, at, button, button, Qt.KeyboardModifier.NoModifier))
    assert at_zero.app_state.watch_worker.commands(ReadLab)
    at_zero.app_state.grow_old()
    assert at_zero.side.hands.text().startswith(("✓ Hands may go in", "● Hands may go in"))


def test_so_does_a_key(at_zero, qtbot):
    alone(at_zero, ALONE_S + 1.0)
    assert not asked(at_zero)
    qtbot.keyClick(at_zero, Qt.Key.Key_Shift)
    assert at_zero.app_state.watch_worker.commands(ReadLab)


@pytest.mark.parametrize("wrong", ["on", "silent", "turns"])
def test_while_anything_is_not_confirmed_it_goes_on(at_zero, wrong):
    known = {"on": lab((0.0, 0.0, 0.4), platform=stands()), "silent": lab((0.0, 0.0, None), platform=stands()),
             "turns": lab(platform=stands(moving=True))}[wrong]  # fmt: skip
    at_zero.app_state.take_lab(known)
    alone(at_zero, 10 * ALONE_S)
    assert asked(at_zero)
    at_zero.app_state.take_lab(replace(lab(platform=stands())))
    assert not asked(at_zero)


def test_after_a_run_that_nobody_saw_end_it_is_read_for_as_long(at_zero):
    app_state = at_zero.app_state
    alone(at_zero, 10 * ALONE_S)
    app_state.run.start(RunProcedure("preflight", "bench.toml", {}, "EM-07", "J. Doe"))
    assert not asked(at_zero)  # the run has the lines
    assert time.monotonic() - app_state.watch._touched_s < 60.0

"""A burst is a scan and a person is not, by when keys were struck: the clock is the test's own."""

import pytest
from PySide6.QtCore import QEvent, Qt
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import QApplication


class Clock:
    def __init__(self):
        self.now_s = 100.0

    def __call__(self):
        return self.now_s


@pytest.fixture
def keys(still, qtbot, patience):
    """Type `text` into a widget, `apart_s` between two keys."""
    clock = Clock()
    still.scanner.now = clock
    still.scanner.wait.setInterval(3_600_000)  # nothing is decided but by the clock above, or at the end

    def struck(widget, text, apart_s, ends_with=None):
        widget.setFocus()
        qtbot.waitUntil(lambda: QApplication.focusWidget() is widget, timeout=patience)
        for letter in text:
            clock.now_s += apart_s
            qtbot.keyClicks(widget, letter)
        if ends_with is not None:
            clock.now_s += apart_s
            qtbot.keyClick(widget, ends_with)
        still.scanner.flush()

    return struck


def test_a_burst_of_characters_is_a_scan_and_goes_to_the_serial(still, keys):
    keys(still.top.operator, "EM-19", 0.01, Qt.Key.Key_Return)
    assert still.app_state.lab.state.dut_serial == "EM-19"
    assert still.app_state.lab.state.operator == "J. Doe"
    assert still.top.dut.text() == "EM-19"


def test_a_scan_reaches_no_answer_of_an_open_question(still, keys):
    from labcal.gui.ipc.messages import Answer, RunProcedure
    from labcal.record.stream import Prompt

    still.app_state.run.start(RunProcedure("preflight", "bench.toml"))
    still.app_state.bench_worker.items.emit((Prompt(1.0, "why", "Why?", ()),))
    entry = still.page("Run").live.prompt.entry
    keys(entry, "EM-19", 0.01, Qt.Key.Key_Return)
    assert entry.text() == ""
    assert still.app_state.bench_worker.said == []
    keys(entry, "lift", 0.2, Qt.Key.Key_Return)
    assert still.app_state.bench_worker.said == [Answer("why", "lift")]


@pytest.mark.parametrize("apart_s", [0.05, 0.2])
def test_what_a_person_types_stays_where_it_is_typed(still, keys, apart_s):
    still.top.operator.clear()
    keys(still.top.operator, "A. Smith", apart_s)
    assert still.top.operator.text() == "A. Smith"
    assert still.app_state.lab.state.dut_serial == "EM-07"


def test_keys_that_a_busy_window_hears_late_are_judged_by_when_they_were_struck(still, keys):
    operator, scanner = still.top.operator, still.scanner
    operator.clear()
    operator.setFocus()
    for n, letter in enumerate("Smith"):
        event = QKeyEvent(QEvent.Type.KeyPress, ord(letter.upper()), Qt.KeyboardModifier.NoModifier, letter)
        event.setTimestamp(5_000 + 200 * n)
        assert scanner.handle_key(operator, event)  # all at once by the clock on the wall
    scanner.flush()
    assert operator.text() == "Smith"

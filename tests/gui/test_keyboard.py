"""Without a mouse: every control of every page is reached by Tab and seen to have the focus; a run is led by keys."""

import pyqtgraph as pg
import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import (
    QAbstractButton,
    QAbstractItemView,
    QApplication,
    QComboBox,
    QLineEdit,
    QPlainTextEdit,
)

from labcal.gui.ipc.messages import Answer, Note, RunProcedure, Stop
from labcal.record.stream import Prompt

CONTROLS = (QAbstractButton, QAbstractItemView, QComboBox, QLineEdit, QPlainTextEdit)
MOST = 150  # presses of Tab until it has gone round


def by_tab(qtbot, window, wanted):
    """Press Tab until `wanted` has the focus."""
    for _ in range(MOST):
        if QApplication.focusWidget() is wanted:
            return
        qtbot.keyClick(QApplication.focusWidget() or window, Qt.Key.Key_Tab)
    raise AssertionError(f"Tab never comes to {wanted.objectName() or wanted}")


def round_by_tab(qtbot, window):
    """Everything that has the focus in turn until the first has it again, with the picture of each that has it."""
    seen = {}
    while (one := QApplication.focusWidget()) not in seen:
        seen[one] = one.grab().toImage()
        assert len(seen) < MOST, "Tab goes round and round"
        qtbot.keyClick(one, Qt.Key.Key_Tab)
    return seen


@pytest.fixture
def active(qtbot, still, patience):
    still.activateWindow()
    still.sidebar.findChildren(QAbstractButton)[0].setFocus()
    qtbot.waitUntil(lambda: QApplication.focusWidget() is not None, timeout=patience)
    return still


def test_a_run_is_started_answered_noted_and_stopped_without_a_mouse(qtbot, active, patience):
    page, worker = active.page("Run"), active.app_state.bench_worker
    by_tab(qtbot, active, page.choose.list)
    for key, there in ((Qt.Key.Key_Down, "field-sphere"), (Qt.Key.Key_Home, "preflight")):
        qtbot.keyClick(page.choose.list, key)
        assert page.choose.list.currentItem().text() == there
    first = page.choose.form.findChildren(QLineEdit)[0]
    qtbot.waitUntil(first.isVisible, timeout=patience)
    by_tab(qtbot, active, first)
    by_tab(qtbot, active, page.choose.start)
    qtbot.keyClick(page.choose.start, Qt.Key.Key_Space)
    active.scanner.flush()  # Space is held back until it is known to be no scan
    assert isinstance(worker.asked[-1].command, RunProcedure)
    worker.items.emit((Prompt(1.0, "ready", "Hands off?", ("done",), True),))
    qtbot.waitUntil(lambda: page.live.prompt.alive, timeout=patience)
    qtbot.keyPress(active, Qt.Key.Key_F8)
    qtbot.waitUntil(lambda: active.app_state.run.state == "running", timeout=patience)
    by_tab(qtbot, active, page.live.note)
    for letter in "up":
        qtbot.keyClick(page.live.note, letter)
        active.scanner.flush()
    qtbot.keyClick(page.live.note, Qt.Key.Key_Return)
    active.scanner.flush()
    by_tab(qtbot, active, page.live.stop)
    qtbot.keyClick(page.live.stop, Qt.Key.Key_Space)
    active.scanner.flush()
    assert worker.said == [Answer("ready", "done"), Note("up"), Stop()]


@pytest.mark.parametrize("name", ["Start", "Bench", "Run", "Fit", "Loop", "Certificate", "History"])
def test_every_control_of_every_page_is_reached_by_tab_and_is_seen_to_have_the_focus(qtbot, active, name):
    active.open_page(name)
    page = active.page(name)
    active.style_queue.finish()
    QApplication.processEvents()
    seen = round_by_tab(qtbot, active)
    wanted = {one for kind in CONTROLS for one in page.findChildren(kind) if one.isVisible() and one.isEnabled()}
    wanted = {one for one in wanted if one.focusPolicy() and one.focusProxy() is None}
    assert wanted - set(seen) == set()
    active.setFocus()
    alike = [one for one, picture in seen.items() if one.grab().toImage() == picture]
    assert [(type(one).__name__, one.objectName(), one.accessibleName()) for one in alike] == []
    for button in page.findChildren(QAbstractButton):
        if type(button).__name__ == "QPushButton":
            assert button.focusPolicy() & Qt.FocusPolicy.TabFocus, button.text()
            assert button.toolTip(), button.text()


def test_every_plot_says_to_a_screen_reader_what_it_shows(still):
    plots = [one for name in ("Run", "Fit", "Loop", "History") for one in still.page(name).findChildren(pg.PlotWidget)]
    assert len(plots) > 8
    assert [one for one in plots if not one.accessibleName().startswith("Plot: ")] == []

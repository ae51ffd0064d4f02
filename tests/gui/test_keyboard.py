"""Without a mouse: from the keyboard alone a procedure is chosen, set, started, answered and stopped."""

import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QAbstractButton, QApplication, QLineEdit

from labcal.gui.wire import item_to_json
from labcal.record.stream import Prompt

NO_KEY_NEEDED = {"off"}  # Coils off has F12


def by_tab(qtbot, window, wanted, most=120):
    """Press Tab until `wanted` has the focus."""
    for _ in range(most):
        if QApplication.focusWidget() is wanted:
            return
        qtbot.keyClick(QApplication.focusWidget() or window, Qt.Key.Key_Tab)
    raise AssertionError(f"Tab never comes to {wanted.objectName() or wanted}")


@pytest.fixture
def active(qtbot, still, patience):
    still.activateWindow()
    still.rail.findChildren(QAbstractButton)[0].setFocus()
    qtbot.waitUntil(lambda: QApplication.focusWidget() is not None, timeout=patience)
    return still


def test_a_run_is_started_answered_noted_and_stopped_without_a_mouse(qtbot, active, patience):
    page, worker = active.page("Run"), active.desk.bench_worker
    by_tab(qtbot, active, page.choose.list)
    qtbot.keyClick(page.choose.list, Qt.Key.Key_Home)
    assert page.choose.list.currentItem().text() == "ambient"
    first = page.choose.form.findChildren(QLineEdit)[0]
    qtbot.waitUntil(first.isVisible, timeout=patience)
    by_tab(qtbot, active, first)
    by_tab(qtbot, active, page.choose.start)
    qtbot.keyClick(page.choose.start, Qt.Key.Key_Space)
    qtbot.waitUntil(lambda: bool(worker.asked), timeout=patience)  # Space is held back until it is known to be no scan
    assert worker.asked[-1][0] == "run"
    worker.items.emit([item_to_json(Prompt(1.0, "ready", "Hands off?", ("done",), True))])
    qtbot.keyPress(active, Qt.Key.Key_F8)
    qtbot.waitUntil(lambda: active.desk.run.state == "running", timeout=patience)
    by_tab(qtbot, active, page.live.note)
    page.live.note.setText("lift moved")
    qtbot.keyClick(page.live.note, Qt.Key.Key_Return)
    active.scanner.flush()
    by_tab(qtbot, active, page.live.stop)
    qtbot.keyClick(page.live.stop, Qt.Key.Key_Space)
    qtbot.waitUntil(lambda: len(worker.said) == 3, timeout=patience)
    assert [word for word, _ in worker.said] == ["answer", "note", "stop"]


@pytest.mark.parametrize("name", ["Start", "Bench", "Run", "Fit", "Loop", "Certificate", "History"])
def test_every_button_of_every_page_can_be_reached_and_says_what_it_does(active, name):
    active.open_page(name)
    for button in active.page(name).findChildren(QAbstractButton):
        if type(button).__name__ == "QPushButton":
            assert button.focusPolicy() & Qt.FocusPolicy.TabFocus, button.text()
            assert button.toolTip(), button.text()

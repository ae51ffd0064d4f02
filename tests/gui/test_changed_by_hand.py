"""Next says that it has just changed to nobody who has changed it: by another DUT at the top."""

from dataclasses import replace

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QApplication
from test_path import RUN

from labcal.gui.widgets import next_button


def test_who_has_just_said_another_dut_presses_next_for_that_one(still, qtbot, monkeypatch):
    monkeypatch.setattr(next_button, "TOO_SOON_MS", 60_000)
    app_state = still.app_state
    app_state.path.take_runs((replace(RUN, dut_serial="EM-08"),))
    still.open_page("History")
    QApplication.processEvents()
    before, done = still.next.text(), []
    app_state.set_identity(dut="EM-08")
    assert still.next.text() != before
    still.next.clicked.connect(lambda: done.append(still.next.text()))
    qtbot.mouseClick(still.next, Qt.MouseButton.LeftButton)
    assert done
    assert "has just changed" not in app_state.lab.state.message


def test_what_changes_by_itself_after_that_is_said(still, monkeypatch):
    monkeypatch.setattr(next_button, "TOO_SOON_MS", 60_000)
    app_state = still.app_state
    still.open_page("History")
    app_state.set_identity(dut="EM-08")
    QApplication.processEvents()
    app_state.path.take_runs((replace(RUN, dut_serial="EM-08"),))
    still.next.press()
    assert "has just changed" in app_state.lab.state.message

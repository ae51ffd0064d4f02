"""A result stands under its own serial alone; what is typed is shown as it was typed; Coils off is in every dialog."""

import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QFileDialog, QInputDialog, QLabel, QLineEdit, QMessageBox, QPushButton

from labcal.gui.ipc.answers import Ended
from labcal.gui.ipc.messages import RunProcedure, SwitchOff
from labcal.record.stream import Prompt, Step

TYPED = "<b>EM 07</b>"


def test_a_result_is_put_away_when_another_serial_comes(still):
    page = still.page("Run")
    still.app_state.run.start(RunProcedure("preflight", "bench.toml", {}, "EM-07", "J. Doe"))
    still.app_state.bench_worker.items.emit((Step(0.0, 1, 1, "zero", 60.0, ("zero",)),))
    still.app_state.bench_worker.answer(RunProcedure, Ended("r1", "finished"))
    assert page.live.whose.text().startswith("EM-07 · J. Doe · 20")
    assert page.faces.currentWidget() is page.live
    still.app_state.set_identity(dut="EM-19")
    assert page.faces.currentWidget() is page.choose


def test_who_looks_into_another_program_while_typing_goes_on_where_the_cursor_was(still, qtbot, patience):
    field, other = still.top.dut, QLineEdit()
    qtbot.addWidget(other)
    field.setFocus()
    field.selectAll()
    for text, window in (("EM-", other), ("4", still), ("2", still)):
        qtbot.keyClicks(field, text)
        still.scanner.flush()
        window.show()
        window.activateWindow()
        qtbot.waitUntil(window.isActiveWindow, timeout=patience)
    assert (field.text(), still.app_state.lab.state.dut_serial) == ("EM-42", "EM-42")
    still.top.operator.setFocus()
    assert field.cursorPosition() == 0  # of a long one that was left its beginning is seen


def test_nothing_that_was_typed_is_markup(still):
    still.app_state.set_identity(operator=TYPED)
    still.app_state.run.start(RunProcedure("preflight", "bench.toml", {}, "EM-07", TYPED))
    still.app_state.bench_worker.items.emit((Prompt(1.0, "why", TYPED, ()),))
    shown = [one for one in still.findChildren(QLabel) if TYPED in one.text()]
    assert len(shown) >= 2
    assert all(one.textFormat() == Qt.TextFormat.PlainText for one in shown)
    assert TYPED not in still.top.operator.toolTip()


@pytest.mark.parametrize("kind", [QFileDialog, QInputDialog, QMessageBox])
def test_coils_off_is_clicked_while_a_dialog_is_open(qtbot, still, kind, patience):
    dialog = kind(still)
    dialog.setModal(True)
    dialog.show()
    off = dialog.findChild(QPushButton, "off")
    qtbot.waitUntil(lambda: off.isVisible() and dialog.rect().contains(off.geometry()), timeout=patience)
    qtbot.mouseClick(off, Qt.MouseButton.LeftButton)
    assert still.app_state.off_worker.commands(SwitchOff)
    dialog.close()


@pytest.mark.parametrize("size", [(1024, 700), (1360, 860), (1920, 1080)])
def test_coils_off_is_whole_at_every_size(still, size):
    before = still.size()
    for _ in range(2):
        still.toggle_wall()
        still.style_queue.finish()
        still.resize(*size)
        still.top.resize(size[0], still.top.height())
        still.top.layout().activate()
        off = still.top.off
        assert off.width() >= off.sizeHint().width()
        assert off.geometry().right() < size[0], still.wall
    still.resize(before)

"""Where the window stands is kept without anything that was typed; after a crash it stands there again and says so."""

import json
from types import SimpleNamespace

from PySide6.QtWidgets import QVBoxLayout, QWidget

from labcal.gui.ipc.answers import RunLine
from labcal.gui.ipc.messages import ListRuns
from labcal.gui.ipc.wire import Fault
from labcal.gui.once import keep_picture
from labcal.gui.standing import Standing, come_back
from labcal.gui.widgets.fault_card import FaultCard

CANARY = "a canary in the mine"


def test_where_it_stands_is_written_and_nothing_that_was_typed(new_window, tmp_path):
    file = tmp_path / "state.json"
    standing = Standing(new_window, file)
    new_window.top.operator.setText(CANARY)
    new_window.open_page("Certificate")
    assert json.loads(file.read_text())["page"] == "Certificate"
    assert CANARY not in file.read_text()
    file.unlink()
    standing.write()
    assert not file.exists()  # nothing is new


def test_after_a_crash_it_stands_where_it_stood_and_says_what_happened(new_window):
    come_back(new_window, "Fit", "window-1.zip", ran=True)
    assert list(new_window.lazy_pages)[new_window.stack.currentIndex()] == "Fit"
    assert "window-1.zip" in new_window.fault.text.text()
    assert "go on with it on Start" in new_window.fault.remedy.text()
    left = RunLine("r9", "2026-11-22T01:10:00+00:00", "interrupted", "EM-21", "J. Doe", "preflight")
    new_window.app_state.quick_worker.answer(ListRuns, (left,))
    assert new_window.top.dut.text() == "EM-21"  # its run is the one to go on with
    come_back(new_window, "no such page", "window-2.zip", ran=False)
    assert list(new_window.lazy_pages)[new_window.stack.currentIndex()] == "Fit"
    assert "window-2.zip" in new_window.fault.text.text()
    assert not new_window.fault.remedy.text()  # nothing ran: no run is spoken of


def test_a_page_that_cannot_be_built_is_named_by_the_self_test_s_window(qapp, tmp_path, capsys):
    page, card = QWidget(), FaultCard(closable=False)
    QVBoxLayout(page).addWidget(card)
    card.show_fault(Fault("page", "its package is broken"))
    pages = {name: SimpleNamespace(built=lambda one=one: one) for name, one in (("Start", QWidget()), ("Mine", page))}
    window = SimpleNamespace(lazy_pages=pages, open_page=lambda name: None)
    assert keep_picture(window, tmp_path / "window.png") == 1
    assert capsys.readouterr().err == "pages that cannot be built: Mine\n"

"""In a narrow window no column of causes or runs has to be rolled to: words wrap, and what matters least goes first."""

from dataclasses import replace

import pytest
from geometry import faults
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication
from test_causes_table import told
from test_choose import looked_at
from test_history_search import RUN
from test_nothing_is_cut import stored
from test_tenth_walk import in_language as in_language

from labcal.gui.ipc.messages import CloseLoop, LookAt
from labcal.gui.viewmodels.loop_causes import CAUSE, EVIDENCE, ID, REASON, TAKES_OFF, VERDICT

LONG = "Ein weichmagnetisches Teil, das der Strom der Nutzlast magnetisiert, bis es gesättigt ist"


def seen(table):
    """Columns in sight, each whole, from the left, once the window is laid out and nothing changes any more."""
    header, before = table.horizontalHeader(), None
    while (now := (table.width(), header.length(), header.hiddenSectionCount())) != before:
        before = now
        QTest.qWait(50)
    assert header.length() <= table.viewport().width()
    return [n for n in map(header.logicalIndex, range(header.count())) if not header.isSectionHidden(n)]


@pytest.mark.parametrize(("size", "gone"), [((1024, 700), {EVIDENCE}), ((1280, 800), set())])
def test_causes_are_whole_in_german(in_language, new_window, size, gone):
    in_language("de")
    new_window.resize(*size)
    new_window.show()
    new_window.open_page("Loop")
    study, worker, table = (
        new_window.app_state.study_vm,
        new_window.app_state.fit_worker,
        new_window.page("Loop").others,
    )
    study.open("r1")
    worker.answer(LookAt, looked_at("r1"))
    study.close_loop()
    worker.answer(CloseLoop, told())
    new_window.style_queue.finish()
    for row in range(table.rowCount()):
        table.set_cell(row, CAUSE, LONG)
    QApplication.processEvents()
    assert set(seen(table)) == {VERDICT, CAUSE, TAKES_OFF, EVIDENCE, REASON} - gone
    assert table.isColumnHidden(ID)  # no cause has one
    assert [fault for fault in faults(new_window) if fault.startswith("cell")] == []


@pytest.mark.parametrize("code", ["en", "de", "fr"])
def test_runs_are_whole_and_what_became_of_them_is_among_what_is_seen(in_language, new_window, code):
    in_language(code)
    new_window.show()
    for page in ("Start", "History"):
        new_window.page(page)
    stored(new_window, replace(RUN, verdict="explained"))
    table = new_window.page("History").table
    new_window.resize(1920, 1080)
    new_window.style_queue.finish()
    assert len(seen(table)) == table.columnCount()
    new_window.resize(1024, 700)
    assert {0, 1, 4, 5} <= set(seen(table)) < set(range(table.columnCount()))
    assert RUN.run_id in table.item(0, 0).toolTip()
    new_window.resize(1920, 1080)
    assert len(seen(table)) == table.columnCount()  # what went is there again

"""Nothing is cut that there is room for, and no half of a page is empty beside what has to be rolled."""

from dataclasses import replace

import pytest
from PySide6.QtCore import QLocale
from PySide6.QtWidgets import QApplication, QPushButton, QWidget
from test_nothing_is_cut import RUN, settle, stored

from labcal.gui.ipc.answers import Identified, InstrumentAnswer
from labcal.gui.ipc.messages import Identify
from labcal.gui.ipc.wire import Fault
from labcal.gui.pages.bench import LETTERS, one_sentence
from labcal.gui.translations import translate
from labcal.gui.widgets.flow import Flow

LONG = "Applied: the calibration of EM-07 was written beside the readings, " * 3


@pytest.fixture
def german(qapp, same_window):
    translate.install_translator(qapp, QLocale("de"))
    same_window.resize(1024, 700)
    yield same_window
    translate.install_translator(qapp, QLocale("en"))


def test_the_line_at_the_bottom_goes_on_in_a_second_line_and_nothing_above_it_moves(same_window):
    same_window.resize(1024, 700)
    settle(same_window)
    high = same_window.bottom.height()
    same_window.app_state.lab.update(message=LONG[:150])
    settle(same_window)
    message = same_window.message
    assert message.fontMetrics().horizontalAdvance(message.text()) > message.width()
    assert not message.is_cut()
    assert same_window.bottom.height() == high
    same_window.app_state.lab.update(message=LONG * 3)
    settle(same_window)
    assert message.is_cut()  # its whole is in the tip
    assert message.text() in message.toolTip()


def test_buttons_that_need_two_rows_are_shared_between_them(qtbot):
    holder = QWidget()
    qtbot.addWidget(holder)
    buttons = [QPushButton("a button") for _ in range(6)]
    holder.setLayout(Flow(*buttons))
    holder.resize(5 * (buttons[0].sizeHint().width() + 8) + 20, 200)
    holder.show()
    QApplication.processEvents()
    rows = [one.y() for one in buttons]
    assert [rows.count(y) for y in sorted(set(rows))] == [3, 3]
    holder.resize(10, 200)  # narrower than one
    QApplication.processEvents()
    assert len({one.y() for one in buttons}) == 6


def test_how_an_instrument_stands_is_one_sentence_and_what_helps_stands_above(same_window):
    same_window.open_page("Bench")
    bench, worker = same_window.page("Bench"), same_window.app_state.off_worker
    same_window.app_state.bench_changed.emit()
    bench.check_all()
    said = "dut: another instrument answered there. It names itself PL303QMT-P 123456, which is a supply."
    silent = Fault("instrument", said, "Is the link in bench.toml the right one?")
    names = same_window.app_state.facts.instruments
    answers = tuple(InstrumentAnswer(n, "", "", "", silent if n == "dut" else None) for n in names)
    worker.answer(Identify, Identified(answers))
    bench.show_readings()
    (row,) = (row for row in range(bench.table.rowCount()) if bench.table.text(row, 1) == "dut")
    assert len(bench.table.text(row, 5)) <= LETTERS
    assert silent.remedy.replace("bench.toml", "")[:12] in bench.to_do.text()
    assert "PL303QMT-P" in bench.table.item(row, 5).toolTip()


def test_a_sentence_is_cut_between_words():
    assert one_sentence("✕ silent. Look at it.") == "✕ silent"
    assert one_sentence("✕ " + "word " * 20).endswith("word …")


def test_the_table_of_bench_is_as_high_as_its_rows(same_window):
    same_window.resize(1920, 1080)
    same_window.open_page("Bench")
    settle(same_window)
    table = same_window.page("Bench").table
    rows = sum(table.rowHeight(row) for row in range(table.rowCount()))
    assert table.viewport().height() - rows < 2 * table.rowHeight(0)


def test_what_became_of_a_run_is_in_sight_in_a_narrow_window_in_german(german):
    for page in ("Start", "History"):
        german.page(page)
    stored(german, replace(RUN, verdict="explained"))
    german.open_page("History")
    german.page("History")._idle_queue.finish()
    settle(german)
    table = german.page("History").table
    result = table.visualItemRect(table.item(0, 5))
    assert table.viewport().rect().contains(result)
    trend, runs = german.page("History").trend, table.parentWidget()
    assert trend.height() < runs.height() / 2  # a sentence alone needs no half

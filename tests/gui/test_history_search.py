"""History: days as people name them, on the clock of this place; sorted by any column."""

import time
from dataclasses import replace
from datetime import datetime

import pytest
from PySide6.QtCore import QPoint, Qt

from labcal.gui.ipc.answers import RunLine
from labcal.gui.ipc.messages import ListRuns
from labcal.gui.viewmodels.run_search import cells, file_name, matches

RUN = RunLine("r1", "2026-11-22T23:30:00Z", "finished", "EM-07", "J. Doe", "preflight", simulated=True)
BEFORE = replace(
    RUN, run_id="r0", started_utc="2026-11-20T08:00:00Z", dut_serial="AM-99", status="failed: dut is silent"
)


@pytest.fixture
def in_tokyo(monkeypatch):
    monkeypatch.setenv("TZ", "Asia/Tokyo")
    time.tzset()
    yield datetime(2026, 11, 24, 9, 0).astimezone()
    monkeypatch.undo()
    time.tzset()


@pytest.mark.parametrize(
    ("words", "found"),
    [("yesterday", True), ("Yesterday em-07", True), ("today", False), ("23.11.2026", True), ("23.11.", True),
     ("22.11.2026", False), ("23/11/2026", True), ("23.11.2025", False), ("2026-11", True), ("simulated", True),
     ("em-07 preflight finished", True), ("em-08", False), ("explained", False), ("07", True)],
)  # fmt: skip
def test_a_run_is_found_by_the_day_on_which_it_began_here(in_tokyo, words, found):
    assert matches(RUN, words, in_tokyo) == found


def test_times_are_those_of_this_place(in_tokyo):
    assert cells(RUN)[0] == "2026-11-23 08:30"
    assert "SIMULATED" in cells(RUN)[2]


def test_a_run_of_another_lab_names_no_folder_when_it_is_written(in_tokyo):
    hostile = replace(RUN, site="../lab", dut_serial="a/b", procedure="../../etc/x", sha256="0")
    assert file_name(hostile) == "..-lab_a-b_2026-11-23_083000_..-..-etc-x"
    assert file_name(RUN) == "EM-07_2026-11-23_083000_preflight"


def test_a_click_on_a_heading_sorts_and_a_second_one_turns_round_and_the_choice_stays(still, qtbot):
    still.open_page("History")
    page = still.page("History")
    page.search.clear()
    still.app_state.quick_worker.answer(ListRuns, (RUN, BEFORE))
    table, header = page.table, page.table.horizontalHeader()

    def ids():
        return [table.text(row, 6) for row in range(table.rowCount())]

    def click(column):
        place = header.sectionViewportPosition(column) + 4
        qtbot.mouseClick(header.viewport(), Qt.MouseButton.LeftButton, pos=QPoint(place, 8))

    assert ids() == ["r1", "r0"]
    table.selectRow(0)
    click(1)
    assert ids() == ["r0", "r1"]
    assert page.chosen() == RUN
    click(1)
    assert ids() == ["r1", "r0"]
    click(0)
    click(0)
    assert ids() == ["r0", "r1"]
    page.sort_by(0)
    page.search.clear()

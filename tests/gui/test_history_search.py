"""History: days as people name them, on the clock of this place; sorted by any column."""

import time
from dataclasses import replace
from datetime import datetime

import pytest
from PySide6.QtCore import QPoint, Qt
from test_path import calibration

from labcal.gui.ipc.answers import RunLine
from labcal.gui.ipc.messages import ListRuns
from labcal.gui.ipc.record_messages import RunResult, TellResults
from labcal.gui.theming.theme import LIGHT
from labcal.gui.viewmodels.run_results import RunResults
from labcal.gui.viewmodels.run_search import HEADINGS, cells, file_name, matches, measured_s, moment_s
from labcal.gui.viewmodels.run_verdict import end_result
from labcal.gui.widgets.run_chooser import run_label, run_title

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


def test_the_result_is_that_of_the_card_at_the_end_of_the_run_and_is_sorted_and_found_by(still):
    """PASS, FAIL, stopped …: not how it ended in the store's words, and not what its calibration became."""
    still.open_page("History")
    page, worker = still.page("History"), still.app_state.quick_worker
    page.results.waiting.clear()  # of the test before, which nobody answers any more
    stopped = "failed: aborted by the operator"
    ends = ("finished", "finished", "finished", "stopped", stopped, "failed: dut is silent", "interrupted")
    runs = tuple(replace(RUN, run_id=f"s{n}", status=status) for n, status in enumerate(ends))
    worker.answer(ListRuns, runs)
    at = HEADINGS.index("result")

    def shown():
        return [page.table.text(row, at) for row in range(page.table.rowCount())]

    assert shown()[0] == "finished"  # before it is read
    results = RunResult("s0", "PASS", ()), RunResult("s1", "FAIL", ()), RunResult("s2", "PASS", ("closure z",))
    worker.answer(TellResults, results)
    assert shown() == [
        "✓ PASS", "✕ FAIL", "▲ PASS, without closure z", "■ STOPPED", "■ STOPPED", "✕ BROKEN OFF", "▲ BROKEN OFF"
    ]  # fmt: skip
    assert page.table.item(1, at).foreground().color().name() == LIGHT.bad
    page.search.setText("pass")
    assert shown() == ["✓ PASS", "▲ PASS, without closure z"]
    page.search.clear()
    page.sort_by(at)
    assert [word.split()[1] for word in shown()] == sorted(word.split()[1] for word in shown())
    page.sort_by(0)
    seen = [page.table.horizontalHeader().logicalIndex(n) for n in range(4)]
    assert [HEADINGS[n] for n in seen] == ["started", "DUT", "result", "calibration"]


def test_a_run_that_coils_off_ended_says_so_in_the_same_words_in_every_list():
    ended = replace(RUN, status="interrupted", stopped=True)
    by_off = replace(ended, by_off=True)
    assert end_result("interrupted", stopped=True, by_off=True) == ("■ STOPPED BY COILS OFF", "warning")
    assert end_result("interrupted", stopped=True) == ("■ STOPPED", "warning")
    assert run_title(by_off).endswith(" · stopped by COILS OFF")
    assert run_label(by_off).startswith("■ stopped by COILS OFF · ")
    assert run_label(ended).startswith("■ stopped · ")
    assert cells(by_off)[4] == "stopped by COILS OFF"


def test_a_window_in_another_language_asks_for_no_result_that_was_told(still):
    """For seconds a run was "finished" that had been "✓ PASS" before."""
    path, worker = still.app_state.path, still.app_state.quick_worker
    before, done = RunResults(worker, path.results), replace(RUN, run_id="of a window before")
    before.ask([done])
    worker.answer(TellResults, (RunResult(done.run_id, "PASS", ()),))
    after = RunResults(worker, path.results)
    after.ask([done])
    assert after.word(done)[0] == "✓ PASS"
    assert not after.waiting


def test_the_pages_share_what_runs_came_to(still):
    assert still.page("History").results._known is still.page("Start").results._known is still.app_state.path.results


def test_a_calibration_whose_file_is_gone_by_now_has_no_place_in_time(tmp_path):
    file = tmp_path / "c.json"
    one = replace(calibration(), path=str(file), run_id="of another store")
    assert measured_s(one, (RUN,)) is None
    file.write_text("{}")
    assert measured_s(one, (RUN,)) == pytest.approx(file.stat().st_mtime)
    assert measured_s(replace(one, run_id=RUN.run_id), (RUN,)) == moment_s(RUN.started_utc)

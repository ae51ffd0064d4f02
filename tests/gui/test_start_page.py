"""Start fills its page: what is to be done, how far the DUT is, what holds, and as many runs as there is room for."""

from dataclasses import replace

import pytest
from test_nothing_is_cut import interrupted, settle, stored
from test_path import RUN

from labcal.gui.viewmodels.run_results import AT_ONCE


def brought_to(window, *size):
    window.open_page("Start")
    for _ in range(2):
        window.resize(*size)
        settle(window)
    return window.page("Start")


def bottom(page, part):
    return part.mapTo(page, part.rect().bottomLeft()).y()


def test_the_last_runs_reach_to_the_end_of_a_large_page_and_are_more_than_there_were_room_for(same_window):
    stored(same_window, *(replace(RUN, run_id=f"r{n}") for n in range(AT_ONCE + 5)))
    page = brought_to(same_window, 1920, 1080)
    assert page.runs.rowCount() == AT_ONCE
    in_sight = page.runs.viewport().height() // page.runs.rowHeight(0)
    assert in_sight > 10
    left = page.height() - bottom(page, page.runs)
    assert left <= 2 * page.layout().contentsMargins().bottom() + 1  # the card's own, and the page's


def test_of_few_runs_the_table_ends_with_the_last_and_the_page_of_many_is_not_rolled(same_window):
    stored(same_window, RUN, replace(RUN, run_id="r2"))
    page = brought_to(same_window, 1920, 1080)
    assert page.runs.viewport().height() < 3.5 * page.runs.rowHeight(0)
    stored(same_window, *(replace(RUN, run_id=f"r{n}") for n in range(AT_ONCE)))
    brought_to(same_window, 1360, 860)
    assert not same_window.lazy_pages["Start"].area.verticalScrollBar().isVisible()


@pytest.mark.parametrize("size", [(1024, 700), (1920, 1080)])
def test_every_run_that_is_to_be_gone_on_with_has_its_button_and_none_is_wider_than_its_words(same_window, size):
    interrupted(same_window)
    page = brought_to(same_window, *size)
    buttons = page.go_on_buttons
    assert len(buttons) == 3
    for one in buttons:
        assert one.isVisible()
        assert one.width() == one.sizeHint().width()
        assert bottom(page.interrupted, one) < page.interrupted.height()


def test_who_has_measured_nothing_yet_reads_what_a_calibration_comes_by(same_window):
    stored(same_window)
    page = brought_to(same_window, 1360, 860)
    assert page.way_ahead.isVisible()
    stored(same_window, RUN)
    page = brought_to(same_window, 1360, 860)
    assert not page.way_ahead.isVisible()
    stored(same_window)
    assert not brought_to(same_window, 1024, 700).way_ahead.isVisible()


def test_how_far_the_dut_is_stands_below_what_is_to_be_done(same_window):
    stored(same_window, RUN)
    page = brought_to(same_window, 1360, 860)
    assert page.way.text() == "○ Bench  →  ✓ Run  →  ○ Fit  →  ○ Loop  →  ○ Certificate"
    assert page.way.isVisible()


def test_how_the_last_runs_came_out_is_whole_in_a_small_window(same_window):
    """It was cut at "runnin"."""
    running = replace(RUN, run_id="r9", status="running", dut_serial="SIM-0001")
    stored(same_window, running, replace(RUN, status="stopped", stopped=True))
    runs = brought_to(same_window, 1024, 700).runs
    assert runs.text(0, 2) == "running"
    for column in (1, 2):  # whose, and how
        end = runs.columnViewportPosition(column) + runs.columnWidth(column)
        assert end <= runs.viewport().width(), column

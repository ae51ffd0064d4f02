"""Next and the page in sight speak of one run; where that cannot be, Next says which one it means."""

from dataclasses import replace

import pytest
from PySide6.QtCore import Qt
from test_nothing_is_cut import other_language as other_language
from test_path import RUN, calibration

from labcal.gui.ipc.answers import Ended
from labcal.gui.ipc.messages import ListRuns, RunProcedure
from labcal.gui.translations.translate import translated
from labcal.gui.viewmodels.run_search import local_time

EARLIER = replace(RUN, run_id="r0", started_utc="2026-01-04T07:00:00Z", verdict="explained")
OTHER = replace(RUN, run_id="r2", started_utc="2026-01-06T07:00:00Z", procedure="rotate-axis")


def of(one):
    return f" · run of {local_time(one.started_utc):%Y-%m-%d %H:%M}"


@pytest.mark.parametrize("page", ["Fit", "Loop"])
def test_a_page_that_shows_an_earlier_run_is_not_what_next_speaks_of(still, page):
    still.app_state.path.take_runs((RUN, EARLIER))
    still.app_state.one_dut.open("r0")
    still.open_page(page)
    assert still.next.text() == "Next: Fit the run" + of(RUN)
    still.app_state.one_dut.open("r1")
    assert "run of" not in still.next.text()


def test_the_run_page_shows_what_has_just_ended_and_next_is_of_the_calibration(still):
    app_state = still.app_state
    app_state.run.start(RunProcedure("rotate-axis", "bench.toml", {}, "EM-07", "J. Doe"))
    app_state.bench_worker.answer(RunProcedure, Ended("r2", "finished"))
    app_state.path.take_runs((OTHER, RUN))
    assert still.next.text() == "Next: Fit the run" + of(RUN)
    still.open_page("Start")
    assert still.next.text() == "Next: Fit the run"


def test_the_calibration_in_sight_is_that_which_next_signs_or_it_says_so(still):
    app_state = still.app_state
    app_state.path.take_runs((replace(RUN, verdict="explained"), EARLIER))
    app_state.path.take_calibrations((calibration(signed=False),))
    still.open_page("Certificate")
    app_state.one_dut.take_calibration(replace(calibration(signed=False), run_id="r0"))
    assert still.next.text().endswith(of(RUN))
    app_state.one_dut.take_calibration(calibration(signed=False))
    assert " · run of" not in still.next.text()


def test_the_step_of_a_signed_file_is_not_that_of_a_new_draft_of_the_run(still):
    path = still.app_state.path
    path.take_runs((replace(RUN, verdict="explained"),))
    path.take_calibrations((calibration(signed=False),))
    path.take_step(calibration(), "Hand it out (4)")
    assert "Hand it out" not in still.next.text()


@pytest.mark.parametrize("last", ["interrupted", "a finished one after it"])
def test_start_has_in_blue_what_next_goes_on_with_and_no_other(still, last):
    """A run that broke off was the blue button, and Next led to the fit of a later one."""
    broken = replace(EARLIER, status="interrupted", verdict="")
    later = replace(RUN, procedure="field-sphere")
    app_state = still.app_state
    app_state.path.resumable = frozenset({"preflight"})
    still.open_page("Start")
    runs = (broken,) if last == "interrupted" else (later, broken)
    app_state.quick_worker.answer(ListRuns, runs)
    goes_on = still.page("Start").go_on_buttons[0]
    assert goes_on.text().startswith("Go on with EM-07")
    resumes = app_state.path.next().resumes
    assert (resumes is not None) == (last == "interrupted")
    assert (goes_on.objectName() == "primary") == (resumes is not None)
    choose = still.page("Run").choose
    assert (choose.go_on.objectName() == "primary") == (resumes is not None)


@pytest.mark.parametrize("status", ["finished", "stopped", "interrupted", "failed: reference is silent"])
def test_next_closes_the_run_that_has_ended_and_begins(still, qtbot, status):
    """Next: Begin rotate-axis, on the page of a run that has ended, began nothing."""
    app_state, page = still.app_state, still.page("Run")
    page.choose.choose("rotate-axis")
    app_state.run.start(RunProcedure("rotate-axis", "bench.toml", {}, "EM-07", "J. Doe"))
    app_state.bench_worker.answer(RunProcedure, Ended("r2", status))
    still.open_page("Run")
    assert page.faces.currentWidget() is page.live
    assert still.next.text() == "Next: Begin rotate-axis"
    page.choose.form.set_text("turns", "3")
    qtbot.mouseClick(still.next, Qt.MouseButton.LeftButton)
    order = app_state.run.order
    assert (order.procedure, order.given["turns"], app_state.run.state) == ("rotate-axis", "3", "starting")
    assert len(app_state.bench_worker.commands(RunProcedure)) == 1
    assert page.faces.currentWidget() is page.live


def test_next_begins_nothing_that_begin_would_not(still):
    """It is said no longer as soon as it may not be; were it pressed in that moment, nothing would begin."""
    app_state, page = still.app_state, still.page("Run")
    page.choose.choose("rotate-axis")
    app_state.run.start(RunProcedure("rotate-axis", "bench.toml", {}, "EM-07", "J. Doe"))
    app_state.bench_worker.answer(RunProcedure, Ended("r2", "stopped"))
    still.open_page("Run")
    page.choose.form.set_text("turns", "many")
    assert not still.next.text().startswith("Next: Begin")
    page.begin()
    assert app_state.run.state == "ended"
    assert page.faces.currentWidget() is page.choose


@pytest.mark.parametrize("other_language", ["de", "fr"], indirect=True)
def test_next_says_no_word_twice(other_language, new_window):
    """It read "Weiter: Weiter mit EM-08"."""
    words = translated("Go on with {0}").format("EM-08")
    new_window.say_next(words)
    first, after = new_window.next.text().split(":")
    assert after.strip() == words
    assert first.strip() != words.split()[0]

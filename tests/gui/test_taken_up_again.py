"""After a restart what is kept of the DUT at the top is there again; nothing is asked for that is under way."""

from dataclasses import replace

import pytest
from test_path import RUN, calibration

from labcal.gui.ipc.messages import ListCalibrations, ListKeys, ListRuns, LookAt, RunProcedure
from labcal.gui.viewmodels.kept_of_run import kept_words


@pytest.mark.parametrize("page", ["Fit", "Loop"])
def test_the_last_run_of_the_dut_at_the_top_is_under_study_again_with_what_is_kept_of_it(same_window, page):
    app_state = same_window.app_state
    app_state.set_identity(dut="EM-07")
    same_window.page(page)
    same_window.open_page(page)
    app_state.quick_worker.answer(ListCalibrations, (calibration(),))
    app_state.quick_worker.answer(ListRuns, (RUN,))
    assert app_state.study_vm.run == "r1"
    assert app_state.fit_worker.commands(LookAt) == [LookAt("r1")]
    assert same_window.page(page).chooser.currentData() == "r1"
    app_state.path.take_calibrations((calibration(),))
    assert kept_words(app_state.path, app_state.study_vm.run).startswith("Kept of this run")


def test_nothing_of_another_dut_is_taken_up(same_window):
    app_state = same_window.app_state
    app_state.set_identity(dut="EM-99")
    same_window.open_page("Fit")
    app_state.quick_worker.answer(ListRuns, (RUN,))
    assert app_state.study_vm.run == ""


def test_the_page_and_its_mark_are_of_one_dut(same_window):
    app_state = same_window.app_state
    app_state.set_identity(dut="EM-07", operator="J. Doe")
    app_state.path.take_runs((RUN,))
    same_window.open_page("Certificate")
    page, worker = same_window.page("Certificate"), app_state.quick_worker
    worker.answer(ListCalibrations, (calibration(),))
    worker.answer(ListKeys, ())
    assert page.chosen() is not None
    app_state.set_identity(dut="EM-08")
    worker.answer(ListCalibrations, (calibration(),))
    assert page.chosen() is None  # RELEASED stands beside ○ Certificate no longer
    app_state.set_identity(dut="")
    worker.answer(ListCalibrations, (calibration(),))
    assert page.chosen() is None
    assert page.empty.text().startswith("Choose a calibration")
    page.list.setCurrentIndex(0)
    page.list.activated.emit(0)
    assert (same_window.shown_bar.isVisible(), app_state.lab.state.dut_serial) == (True, "")
    same_window.shown_bar.take.click()
    assert app_state.lab.state.dut_serial == "EM-07"
    assert app_state.path.marks()["Certificate"] == "done"


def test_who_waits_for_a_bench_that_is_being_opened_is_not_told_to_open_one(same_window):
    app_state = same_window.app_state
    facts, app_state.facts = app_state.facts, None
    assert app_state.objection().startswith("Open a bench first")
    app_state.lab.update(opening=True)
    assert app_state.objection() == "The bench is being opened …"
    app_state.lab.update(opening=False)
    app_state.facts = facts


@pytest.mark.parametrize("page", ["Fit", "Loop"])
def test_in_a_run_it_is_said_that_it_can_be_looked_at_later_and_no_other_one_is_chosen(still, page):
    """No run yet, it said, and Start "1 in the store"; then another DUT had its run chosen, and Trace was grey."""
    still.app_state.set_identity(dut="EM-08")
    still.app_state.path.take_runs((RUN,))
    still.app_state.open_study("r1")
    still.open_page("History")
    still.app_state.set_identity(dut="EM-07")
    still.app_state.run.start(RunProcedure("preflight", "bench.toml", {}, "EM-07", "J. Doe"))
    still.app_state.study_vm.forget("")
    still.open_page(page)
    shown = still.page(page)
    still.app_state.quick_worker.answer(ListRuns, (replace(RUN, run_id="r9", status="running"), RUN))
    assert shown.empty.text() == "EM-07 is being measured: its run can be looked at once it has ended."
    still.app_state.study_vm.changed.emit()
    assert shown.chooser.currentData() is None
    still.app_state.run.forget()
    shown.chooser.refresh()
    still.app_state.quick_worker.answer(ListRuns, (replace(RUN, run_id="r9", status="running"),))
    assert shown.empty.text().startswith("The run in the store has not ended yet")
    still.app_state.path.take_runs(())

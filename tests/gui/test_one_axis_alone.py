"""A run that gives no calibration is told as one story: before Begin, at its end, and on Fit, Loop and the sidebar."""

from dataclasses import replace

import pytest
from test_choose import looked_at, told_by_the_loop
from test_path import RUN, marks

from labcal.gui.ipc.answers import Ended, FitFigures, Fitted, Proposal
from labcal.gui.ipc.messages import CloseLoop, LookAt, RunProcedure
from labcal.gui.viewmodels.loop_words import OPEN_MAP
from labcal.gui.viewmodels.procedure_groups import CALIBRATES, calibrates, grouped
from labcal.gui.viewmodels.run_verdict import run_verdict, to_be_fitted
from labcal.gui.widgets.run_chooser import run_name
from labcal.loop.narrative import of_faulty_data
from labcal.loop.result import Finding
from labcal.record.stream import Measurement

ONE_AXIS = replace(RUN, run_id="r2", procedure="rotate-axis", started_utc="2026-01-05T08:00:00Z")
STOPPED = replace(RUN, status="stopped")
OPEN = Finding("excitation", "data", "This run does not determine the whole map (offset alone).")


def ended(window, procedure):
    run, worker = window.app_state.run, window.app_state.bench_worker
    run.start(RunProcedure(procedure, "bench.toml", {}, "EM-07", "J. Doe"))
    worker.items.emit((Measurement(1.0, "closure", 1.0, 1.0, "nT", 500.0),))
    worker.answer(RunProcedure, Ended("r2", "finished", None))
    return run


def test_it_says_before_begin_that_it_is_not_enough(still):
    still.open_page("Run")
    choose = still.page("Run").choose
    choose.choose("rotate-axis")
    assert choose.title.text().endswith("one axis is not enough for a calibration by itself.")
    assert "rotate-axis" not in dict(grouped(choose._procedures))["Calibrate a DUT"]


@pytest.mark.parametrize(
    ("procedure", "words"),
    [
        ("preflight", "Fit, Loop, Certificate: Next leads there."),
        ("rotate-axis", "One axis: not enough for a calibration by itself. Measure the others too, or a preflight."),
        ("axes-check", "No calibration of a DUT comes of this procedure. Next leads on."),
    ],
)
def test_it_says_at_its_end_what_comes_of_it(still, procedure, words):
    run = ended(still, procedure)
    verdict = run_verdict(run)
    assert verdict.next == words
    assert verdict.rule.endswith("Fit and Loop judge.") == calibrates(procedure)
    assert to_be_fitted(run) == (procedure in CALIBRATES)


def test_next_leads_to_what_is_missing(still):
    still.app_state.path.take_runs((ONE_AXIS,))
    assert still.app_state.path.next().words == "Calibrate EM-07"
    assert marks(still) == "○○○○"


def test_nothing_is_traced_where_fit_says_that_nothing_can_be(still):
    still.open_page("Fit")
    page, study = still.page("Fit"), still.app_state.study_vm
    study.open("r2")
    still.app_state.fit_worker.answer(LookAt, looked_at("r2"))
    study.waiting.clear()
    study.changed.emit()
    assert page.trace.isEnabled()
    study.fits["ml"] = Fitted(FitFigures(False, why_not="the readings lie close to one plane"))
    study.changed.emit()
    assert page.no_fit.isVisible()
    assert not page.trace.isEnabled()


def test_the_loop_says_that_the_run_is_too_short_and_not_that_something_is_wrong(new_window):
    new_window.open_page("Loop")
    page, study, worker = new_window.page("Loop"), new_window.app_state.study_vm, new_window.app_state.fit_worker
    study.open("r2")
    worker.answer(LookAt, looked_at("r2"))
    study.close_loop()
    said = of_faulty_data(OPEN)
    proposal = Proposal(said["next_experiment"].why, said["next_experiment"].do, said["next_experiment"].procedure)
    assert (said["verdict"], proposal.why) == ("unexplained", OPEN_MAP)
    found = replace(told_by_the_loop(None), verdict="unexplained", accepted=(), next_experiment=proposal)
    worker.answer(CloseLoop, found)
    page._idle_queue.finish()
    assert page.verdict.text() == "▲ NOT ENOUGH FOR A WHOLE MAP"
    assert page.plainly.text().startswith("This run does not determine the whole map")
    assert "wrong" not in page.plainly.text()
    assert (page.others.isVisible(), page.none_searched.isVisible()) == (False, True)
    assert page.next.text() == "Measure what is missing"


def test_a_page_of_another_run_of_the_dut_says_which_and_of_which_the_marks_are(still):
    app_state = still.app_state
    app_state.path.take_runs((ONE_AXIS, STOPPED))
    app_state.open_study("r2")
    assert marks(still) == "▲○○○"
    assert still.shown_bar.isVisible()
    of_another = f"Shown: {run_name(ONE_AXIS)}. The marks at the left and Next are of another run: {run_name(STOPPED)}."
    assert still.shown_bar.words.text() == of_another
    still.shown_bar.back.click()
    assert (still.shown_bar.isVisible(), app_state.study_vm.run) == (False, "")
    app_state.path.take_runs((ONE_AXIS,))
    app_state.open_study("r2")
    assert still.shown_bar.words.text().endswith("are of no run yet.")

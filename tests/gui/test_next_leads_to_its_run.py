"""A press on Next leads to the run, and to the file, that Next speaks of, whatever its page has shown before."""

from dataclasses import replace

import pytest
from PySide6.QtCore import Qt
from test_choose import looked_at, told_by_the_loop
from test_languages import restored as restored
from test_path import DONE, RUN, calibration

from labcal.gui.ipc.answers import Ended, FitFigures, Fitted
from labcal.gui.ipc.messages import CloseLoop, FitRun, ListCalibrations, ListMethods, ListRuns, LookAt, RunProcedure
from labcal.gui.reopened import Shown

OF_SIM = replace(RUN, run_id="r0", dut_serial="SIM-0001", simulated=True)
STOPPED = replace(RUN, run_id="r8", dut_serial="EM-08", status="stopped")
RUNS = (STOPPED, DONE, OF_SIM)
MINE = replace(calibration(signed=False), path="mine.json")
SIM = replace(MINE, path="sim.json", run_id="r0", dut=replace(MINE.dut, serial="SIM-0001"))


def press_next(qtbot, window):
    qtbot.mouseClick(window.next, Qt.MouseButton.LeftButton)


def say_dut(qtbot, window, serial):
    """Typed at the top as a person types: each key is taken before the next; its end is said by Enter."""
    field = window.top.dut
    field.setFocus()
    field.selectAll()
    for letter in serial:
        qtbot.keyClick(field, letter)
        qtbot.waitUntil(lambda: not window.scanner.wait.isActive())
    qtbot.keyClick(field, Qt.Key.Key_Return)


def answer_looks(window, run, dut):
    for worker in (window.app_state.fit_worker, window.app_state.second_fit_worker):
        worker.answer(LookAt, looked_at(run, dut))
        if worker.commands(ListMethods):
            worker.answer(ListMethods, ("ml",))


def choose_on(window, page, run):
    """In its list of runs, as a person does."""
    window.open_page(page)
    chooser = window.page(page).chooser
    window.app_state.quick_worker.answer(ListRuns, window.app_state.path.runs)
    chooser.setCurrentIndex(chooser.findData(run))
    chooser.activated.emit(chooser.currentIndex())


def certificate(window, *files):
    """The page, as it is once it has asked what there is."""
    window.open_page("Certificate")
    page = window.page("Certificate")
    window.app_state.quick_worker.answer(ListCalibrations, files)
    return page


@pytest.fixture
def certified(still):
    """EM-07 has a draft, and is at the top."""
    still.app_state.one_dut.take_calibration(None)
    still.app_state.path.take_runs(RUNS)
    still.app_state.path.take_calibrations((MINE,))
    return still


def test_next_turns_the_certificate_page_from_a_dut_without_a_file_to_its_own(certified, qtbot):
    choose_on(certified, "Loop", "r0")
    page = certificate(certified, MINE)
    assert (page.chosen(), "SIM-0001" in page.empty.text()) == (None, True)
    assert certified.next.text() == "Next: Approve and sign"
    press_next(qtbot, certified)
    assert (page.chosen(), page.word.isVisible()) == (MINE, True)
    certified.app_state.quick_worker.answer(ListCalibrations, (MINE,))
    assert page.chosen() == MINE


@pytest.mark.parametrize("page_open", ["Certificate", "Start"])
def test_next_turns_the_certificate_page_from_the_file_of_another_dut(certified, qtbot, page_open):
    page = certificate(certified, SIM, MINE)
    page.list.setCurrentIndex(0)
    assert page.chosen() == SIM
    certified.open_page(page_open)
    press_next(qtbot, certified)
    certified.app_state.quick_worker.answer(ListCalibrations, (SIM, MINE))
    assert (certified.page_shown(), page.chosen(), certified.shown_bar.isVisible()) == ("Certificate", MINE, False)


def test_next_leads_to_a_file_that_the_page_has_not_heard_of(certified, qtbot):
    page = certificate(certified, SIM)
    page.list.setCurrentIndex(0)
    certified.app_state.path.take_calibrations((SIM, MINE))
    press_next(qtbot, certified)
    certified.app_state.quick_worker.answer(ListCalibrations, (SIM, MINE))
    assert page.chosen() == MINE


def test_next_leads_to_its_file_on_a_page_that_is_built_only_then(new_window, qtbot):
    older = replace(SIM, path="older.json", run_id="r1", dut=MINE.dut)
    signed = replace(calibration(), path="mine.json")
    new_window.app_state.path.take_runs(RUNS)
    new_window.app_state.path.take_calibrations((older, signed))  # the newest is a draft beside the signed one
    press_next(qtbot, new_window)
    page = new_window.page("Certificate")
    new_window.app_state.quick_worker.answer(ListCalibrations, (older, signed))
    assert page.chosen() == signed


def test_a_dut_that_comes_back_to_the_top_has_its_pages_again(certified, qtbot):
    """Whatever was looked at before another was there."""
    choose_on(certified, "Fit", "r0")
    page = certificate(certified, SIM, MINE)
    assert page.chosen() == SIM
    certified.open_page("Run")
    certified.app_state.set_identity(dut="EM-08")
    certified.app_state.run.start(RunProcedure("preflight", "bench.toml", {}, "EM-08", "J. Doe"))
    certified.app_state.bench_worker.answer(RunProcedure, Ended("r8", "stopped"))
    say_dut(qtbot, certified, "EM-07")
    assert certified.app_state.study_vm.run == "r1"
    certificate(certified, SIM, MINE)
    assert page.chosen() == MINE


def test_a_serial_of_which_half_was_left_for_a_moment_has_its_pages_once_it_is_whole(certified, qtbot):
    certified.open_page("Run")
    certified.app_state.open_study("r0")
    for serial in ("EM-0", "EM-07"):
        say_dut(qtbot, certified, serial)
    assert certified.app_state.study_vm.run == "r1"


def test_a_file_that_was_looked_at_before_another_dut_stood_there_does_not_come_back_with_the_first(certified, qtbot):
    page = certificate(certified, SIM, MINE)
    page.list.setCurrentIndex(0)
    certified.open_page("Run")
    say_dut(qtbot, certified, "EM-08")
    say_dut(qtbot, certified, "EM-07")
    certificate(certified, SIM, MINE)
    assert page.chosen() == MINE


def test_the_page_in_sight_shows_the_newest_run_of_a_dut_that_is_back_though_it_was_not_studied(certified, qtbot):
    certified.app_state.open_study("r0")
    say_dut(qtbot, certified, "EM-08")
    assert certified.app_state.study_vm.run == ""
    certified.app_state.open_study("r0")
    say_dut(qtbot, certified, "EM-07")
    assert certified.app_state.study_vm.run == "r1"


def test_what_a_person_chose_on_a_page_since_the_dut_was_said_stays(certified):
    certified.open_page("Fit")
    certified.app_state.set_identity(dut="EM-08")
    certified.app_state.set_identity(dut="EM-07")
    choose_on(certified, "Fit", "r0")
    certified.open_page("Loop")
    assert certified.app_state.study_vm.run == "r0"
    page = certificate(certified, SIM, MINE)
    page.list.setCurrentIndex(0)
    certified.open_page("Start")
    assert certificate(certified, SIM, MINE).chosen() == SIM


def test_a_window_in_another_language_begins_with_the_dut_at_the_top(new_window, restored, windows, qtbot):
    app_state = new_window.app_state
    app_state.path.take_runs(RUNS)
    choose_on(new_window, "Loop", "r0")
    page = certificate(new_window, SIM, MINE)
    page.list.setCurrentIndex(0)
    shown = Shown(new_window)
    shown.speak("de")
    windows.append(shown.window)
    page = shown.window.page("Certificate")
    app_state.quick_worker.answer(ListCalibrations, (SIM, MINE))
    assert (page.chosen(), app_state.study_vm.run) == (MINE, "r1")


@pytest.fixture
def tracing(still):
    """The residual of EM-07 is being traced."""
    still.app_state.path.take_runs((STOPPED, RUN, OF_SIM))
    still.app_state.one_dut.open("r1")
    answer_looks(still, "r1", "EM-07")
    still.app_state.study_vm.close_loop()
    return still


def test_a_trace_that_goes_on_is_in_sight_where_next_leads_and_so_is_its_result(tracing, qtbot):
    study, page = tracing.app_state.study_vm, tracing.page("Loop")
    tracing.open_page("Loop")
    tracing.app_state.quick_worker.answer(ListRuns, tracing.app_state.path.runs)
    assert not tracing.next.isEnabled()  # it is in sight: there is nothing but to wait
    study.let_go()
    assert (page.empty.text()[:12], page.progress.isVisible()) == ("Choose a run", False)
    assert (tracing.next.text(), tracing.next.isEnabled()) == ("Next: See how far the trace is", True)
    press_next(qtbot, tracing)
    assert (study.run, page.progress.isVisible(), tracing.next.isEnabled()) == ("r1", True, False)
    study.let_go()
    tracing.app_state.fit_worker.answer(CloseLoop, told_by_the_loop("reverse"))
    tracing.app_state.quick_worker.answer(ListCalibrations, (MINE,))
    assert tracing.next.text() == "Next: See what is not known"
    press_next(qtbot, tracing)
    assert (study.run, page.story.isVisible(), len(tracing.app_state.fit_worker.commands(CloseLoop))) == ("r1", True, 0)


def test_a_trace_whose_run_was_let_go_of_is_taken_up_as_its_page_opens(tracing):
    study, page = tracing.app_state.study_vm, tracing.page("Loop")
    study.let_go()
    tracing.open_page("Loop")
    assert (study.run, page.progress.isVisible()) == ("r1", True)


def test_a_loop_of_a_run_that_was_never_looked_at_is_not_lost(still):
    """Of all rows together the residual is traced at once."""
    study = still.app_state.study_vm
    still.app_state.path.take_runs((RUN, OF_SIM))
    study.open("r1")
    still.app_state.fit_worker.asked.clear()
    study.shown.waiting.clear()
    study.close_loop()
    still.app_state.fit_worker.answer(CloseLoop, told_by_the_loop("reverse"))
    study.open("r0")
    study.open("r1")
    assert study.loop is not None


def test_next_tries_the_other_methods_on_the_run_that_had_no_fit_and_not_on_the_one_in_sight(still, qtbot):
    study, worker = still.app_state.study_vm, still.app_state.fit_worker
    still.app_state.path.take_runs((RUN, OF_SIM))
    for run, dut in (("r0", "SIM-0001"), ("r1", "EM-07")):
        still.app_state.one_dut.open(run)
        answer_looks(still, run, dut)
    study.methods = ("ml", "centered")
    study.fits["ml"] = Fitted(FitFigures(False, "no turn"))
    still.app_state.one_dut.open("r0")
    study.fits |= dict.fromkeys(study.methods, Fitted(FitFigures(False, "no turn")))  # nothing is left to try there
    still.open_page("Fit")
    assert "Next: Try the other methods" in still.next.text()
    press_next(qtbot, still)
    assert [(one.run, one.method) for one in worker.commands(FitRun)] == [("r1", "centered")]

"""The path of a DUT: its state at the pages, what is next in one place, and what a run that failed does not offer."""

from dataclasses import replace

import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QAbstractButton, QApplication

from labcal.gui.ipc.answers import CalibrationFile, Ended, FitFigures, Fitted, RunLine, Signature, Standing
from labcal.gui.ipc.messages import (
    CloseLoop,
    FitRun,
    HandOut,
    ListCalibrations,
    ListKeys,
    ListRuns,
    ReadBench,
    RunProcedure,
)
from labcal.gui.ipc.wire import Fault
from labcal.gui.viewmodels.resumed import to_be_resumed
from labcal.gui.viewmodels.run_verdict import run_verdict
from labcal.record import Dut
from labcal.record.stream import Measurement, Prompt, Step

RUN = RunLine("r1", "2026-01-05T07:00:00Z", "finished", "EM-07", "J. Doe", "preflight")
ANOTHER = replace(RUN, run_id="r0", dut_serial="EM-08", verdict="clean")
SIGNATURE = Signature("c.sshsig", "jdoe@lab", None)


def calibration(*, valid=True, provisional=False, signed=True):
    signatures = (SIGNATURE,) if signed else ()
    standing = Standing("c.json", valid, provisional, ("jdoe@lab",), signatures, ())
    K, k_nT = ((1.0,) * 3,) * 3, (0.0,) * 3
    return CalibrationFile("c.json", "r1", Dut("EM-07"), K, k_nT, "", None, (), (), (), "J. Doe", (), standing)


def expired(one):
    return replace(one, standing=replace(one.standing, status="expired"))


DONE = replace(RUN, verdict="explained")
UNSIGNED = (calibration(signed=False),)
HOW_FAR = {  # runs, calibrations: the marks of Run, Fit, Loop and Certificate, and what is next
    "nothing yet": ((ANOTHER,), (), "○○○○", "Calibrate EM-07", "Run"),
    "another procedure": ((replace(RUN, procedure="axes-check"),), (), "○○○○", "Calibrate EM-07", "Run"),
    "measured": ((RUN, ANOTHER), (), "✓○○○", "Fit the run", "Fit"),
    "stopped": ((replace(RUN, status="stopped"),), (), "▲○○○", "Calibrate EM-07", "Run"),
    "failed": ((replace(RUN, status="failed: dut is silent"),), (), "✕○○○", "Calibrate EM-07", "Run"),
    "interrupted": ((replace(RUN, status="interrupted"),), (), "▲○○○", "Go on with EM-07", "Run"),
    "drafted": ((RUN,), UNSIGNED, "✓✓○○", "Trace the residual", "Loop"),
    "traced": ((DONE,), UNSIGNED, "✓✓✓○", "Approve and sign", "Certificate"),
    "approved": ((DONE,), (replace(calibration(signed=False), approvers=("a.smith",)),), "✓✓✓○", "Sign", "Certificate"),
    "ambiguous": ((replace(RUN, verdict="ambiguous"),), UNSIGNED, "✓✓▲○", "See what is not known", "Loop"),
    "unexplained, signed": (
        (replace(RUN, verdict="unexplained"),),
        (calibration(provisional=True),),
        "✓✓▲▲",
        "Hand it out, as PROVISIONAL",
        "Certificate",
    ),
    "provisional": (
        (DONE,),
        (calibration(provisional=True),),
        "✓✓✓▲",
        "Hand it out, as PROVISIONAL",
        "Certificate",
    ),
    "approved, one signature": (
        (DONE,),
        (replace(calibration(provisional=True), approvers=("a.smith",)),),
        "✓✓✓▲",
        "The second signature",
        "Certificate",
    ),
    "expired": ((DONE,), (expired(calibration()),), "✓✓✓✓", "Calibrate EM-07", "Run"),
    "not valid": ((DONE,), (calibration(valid=False),), "✓✓✓✕", "Make a new draft", "Fit"),
    "signed": ((DONE,), (calibration(),), "✓✓✓✓", "Hand it out", "Certificate"),
}


@pytest.fixture
def path(still):
    yield still.app_state.path
    still.app_state.path.take_runs(())
    still.app_state.path.take_calibrations(())


def marks(window):
    texts = [one.text() for one in window.sidebar_buttons.buttons()]
    return "".join(text[0] for text in texts[2:6])


@pytest.mark.parametrize("how_far", HOW_FAR)
def test_the_sidebar_says_how_far_this_dut_is_and_next_leads_on(still, path, qtbot, how_far):
    runs, files, shown, words, page = HOW_FAR[how_far]
    path.take_runs(runs)
    path.take_calibrations(files)
    assert marks(still) == shown
    still.open_page("History")
    assert still.next.text() == f"Next: {words}"
    qtbot.mouseClick(still.next, Qt.MouseButton.LeftButton)
    assert still.stack.currentWidget() is still.lazy_pages[page]


def test_another_dut_has_a_path_of_its_own(still, path):
    path.take_runs((ANOTHER, RUN))
    still.app_state.set_identity(dut="EM-08")
    assert marks(still) == "✓○✓○"
    still.app_state.set_identity(dut="")
    assert still.next.text() == "Next: Say which DUT"


def test_a_run_that_goes_on_is_now(still, path):
    path.take_runs((RUN,))
    still.app_state.run.start(RunProcedure("preflight", "bench.toml", {}, "EM-07", "J. Doe"))
    assert (marks(still), still.next.text()) == ("●○○○", "Next: See the run")
    still.app_state.bench_worker.items.emit((Prompt(1.0, "ready", "Hands off?", acts=True),))
    assert still.next.text() == "Next: Answer the question"


def test_a_second_run_of_a_dut_keeps_no_tick_of_the_first(still, path):
    path.take_runs((DONE,))
    path.take_calibrations((calibration(),))
    assert marks(still) == "✓✓✓✓"
    still.app_state.run.start(RunProcedure("axes-check", "bench.toml", {}, "EM-07", "J. Doe"))
    assert marks(still) == "●✓✓✓"  # it calibrates nothing
    still.app_state.bench_worker.answer(RunProcedure, Ended("r8", "finished"))
    still.app_state.run.start(RunProcedure("preflight", "bench.toml", {}, "EM-07", "J. Doe"))
    assert marks(still) == "●○○○"
    still.app_state.bench_worker.answer(RunProcedure, Ended("r9", "finished"))
    assert marks(still) == "✓○○○"  # before the store's list has come as well
    path.take_runs((replace(RUN, run_id="r9"), DONE))
    assert (marks(still), still.next.text()) == ("✓○○○", "Next: Fit the run")


def test_after_a_file_has_left_the_lab_the_next_dut_begins_with_open_steps(new_window, qtbot, tmp_path):
    path, page = new_window.app_state.path, new_window.page("Certificate")
    new_window.app_state.set_identity(dut="EM-07", operator="J. Doe")
    path.take_runs((DONE,))
    new_window.open_page("Certificate")
    new_window.app_state.quick_worker.answer(ListCalibrations, (calibration(),))
    assert new_window.next.text() == "Next: Hand it out"
    page.paper.hand_out(str(tmp_path))
    new_window.app_state.quick_worker.answer(HandOut, str(tmp_path))
    assert new_window.next.text() == "Next: The next DUT"
    assert new_window.message.text() == "EM-07 is handed out."
    assert page.stands(page.chosen())[-1].mark == "done"
    qtbot.mouseClick(new_window.next, Qt.MouseButton.LeftButton)
    assert (new_window.page_shown(), new_window.top.dut.text(), new_window.message.text()) == ("Start", "", "")
    assert new_window.top.dut.hasFocus()
    assert (marks(new_window), new_window.next.text()) == ("○○○○", "Next: Say which DUT")
    new_window.app_state.set_identity(dut="EM-07")  # the same once more: its path begins anew
    assert (marks(new_window), new_window.next.text()) == ("○○○○", "Next: Calibrate EM-07")


def test_what_was_handed_out_before_a_second_signature_is_handed_out_again(still, path):
    one = calibration()
    path.handed_out.add(one)
    assert path.handed_out.holds(one)
    twice = replace(one, standing=replace(one.standing, signatures=(SIGNATURE, SIGNATURE)))
    assert not path.handed_out.holds(twice)


@pytest.mark.parametrize(
    ("status", "why"),
    [
        ("stopped", "was stopped before its end"),
        ("failed: dut is silent", "was broken off: dut is silent"),
        ("interrupted", "was broken off"),
    ],
)
@pytest.mark.parametrize("name", ["Fit", "Loop"])
def test_a_run_that_did_not_come_to_its_end_gives_no_calibration_and_it_is_said_why(still, path, name, status, why):
    still.open_page(name)
    page, study = still.page(name), still.app_state.study_vm
    study.open("r1")
    study.waiting, study.methods = [], ("ml",)
    buttons = (page.fit, page.all, page.trace) if name == "Fit" else (page.close_loop,)
    page.chooser.refresh()
    still.app_state.quick_worker.answer(ListRuns, (RUN,))
    assert all(one.isEnabled() for one in buttons)
    page.chooser.refresh()
    still.app_state.quick_worker.answer(ListRuns, (replace(RUN, status=status),))
    assert not any(one.isEnabled() for one in buttons)
    assert why in page.empty.text()
    assert ("on the Start page" if status == "interrupted" else "Measure again") in page.empty.text()


def test_a_method_that_was_fitted_marks_fit(still, path):
    path.take_runs((RUN,))
    study = still.app_state.study_vm
    study.open("r1")
    study.waiting = []
    study.fit("ml")
    assert (marks(still)[1], still.next.text()) == (
        "●",
        "Next: See how far the fit is",
    )  # not what comes then
    assert still.next.isEnabled()
    still.open_page("Fit")
    assert not still.next.isEnabled()
    still.app_state.fit_worker.answer(FitRun, Fitted(FitFigures(True)))
    assert (marks(still)[1], still.next.text()) == ("✓", "Next: Trace the residual")
    study.close_loop()
    assert (marks(still)[2], still.next.text()) == ("●", "Next: See how far the trace is")


MEASURED = {
    "PASS": (20.0, 1.0, 30.0),
    "MARGINAL": (30.0, 1.0, 30.0),
    "FAIL": (40.0, 1.0, 30.0),
    "CANNOT DECIDE": (1.0, 20.0, 30.0),
}


@pytest.mark.parametrize("verdict", MEASURED)
def test_the_end_of_a_run_fills_the_page_with_its_verdict(still, qtbot, verdict):
    live, worker = still.page("Run").live, still.app_state.bench_worker
    still.app_state.run.start(RunProcedure("preflight", "bench.toml", {}, "EM-07", "J. Doe"))
    worker.items.emit((Step(0.0, 1, 1, "zero", 60.0, ("zero",)),))
    worker.items.emit((Measurement(1.0, "closure x", *MEASURED["PASS"][:2], "nT", 30.0),))
    value, u, limit = MEASURED[verdict]
    worker.items.emit((Measurement(1.5, "noise", value, u, "nT", limit),))
    worker.answer(RunProcedure, Ended("r1", "finished"))
    card = live.verdict
    assert live.middle.currentWidget() is card
    assert (card.serial.text(), card.word.text().split("\N{NO-BREAK SPACE}", 1)[1]) == ("EM-07", verdict)
    assert verdict in card.rule.text()
    assert verdict == "PASS" or "noise" in card.rule.text()
    assert card.next.text()
    assert not live.below.isVisible()
    qtbot.mouseClick(card.details, Qt.MouseButton.LeftButton)
    assert live.below.isVisible()
    assert live.middle.currentWidget() is not card


def test_next_begins_what_it_says(still, path, qtbot):
    path.take_runs((RUN,))
    qtbot.mouseClick(still.next, Qt.MouseButton.LeftButton)
    assert still.app_state.fit_worker.commands(FitRun) == [FitRun("r1", "ml")]
    still.app_state.fit_worker.answer(FitRun, Fitted(FitFigures(True)))
    path.take_calibrations((calibration(signed=False),))
    qtbot.mouseClick(still.next, Qt.MouseButton.LeftButton)
    assert still.app_state.fit_worker.commands(CloseLoop) == [CloseLoop("r1")]


@pytest.mark.parametrize(
    ("lights", "mark"),
    [
        (("ok", "old"), "✓"),
        (("ok", "absent"), "●"),
        (("ok", "waiting"), "●"),
        (("waiting", "absent"), "○"),
        (("absent", "fault"), "✕"),
        ((), "○"),
    ],
)
def test_the_bench_is_done_where_every_instrument_has_answered(still, path, lights, mark):
    lab = still.app_state.lab
    lab.update(now=replace(lab.state.now, lights=tuple((f"supply_{n}", one, "") for n, one in enumerate(lights))))
    assert f"{mark} Bench" in [button.text() for button in still.sidebar.findChildren(QAbstractButton)]


@pytest.mark.parametrize(("ages", "mark"), [((3, 3), "✓"), ((3, 180), "●"), ((180, 180), "○")])
def test_the_bench_has_a_tick_of_what_was_read_just_now_and_no_longer(still, path, ages, mark):
    lab, names = still.app_state.lab, ("supply_x", "reference")
    lights = tuple((name, "old", "") for name in names)
    lab.update(now=replace(lab.state.now, lights=lights, heard_old_s=tuple(zip(names, ages, strict=True))))
    assert f"{mark} Bench" in [button.text() for button in still.sidebar.findChildren(QAbstractButton)]


def test_without_a_bench_next_leads_to_where_one_is_opened_and_points_at_the_button(new_window, qtbot):
    new_window.page("Bench")
    new_window.app_state.lab.update(bench="")
    new_window.app_state.facts = None
    new_window.app_state.bench_changed.emit()
    assert new_window.next.text() == "Next: Open a bench"
    qtbot.mouseClick(new_window.next, Qt.MouseButton.LeftButton)
    assert (new_window.page_shown(), QApplication.focusWidget().text()) == ("Bench", "Open a bench file …")
    new_window.app_state.open_bench("another.toml")
    assert not new_window.next.isEnabled()
    asked = next(one for one in new_window.app_state.quick_worker.asked if isinstance(one.command, ReadBench))
    asked.failed(Fault("input", "another.toml: there is no such file"))
    assert new_window.next.isEnabled()


def test_next_points_at_the_one_thing_to_do_where_the_page_stands_already(still, path, qtbot):
    page = still.page("Certificate")
    path.take_runs((DONE,))
    path.take_calibrations((calibration(signed=False),))
    qtbot.mouseClick(still.next, Qt.MouseButton.LeftButton)
    still.app_state.quick_worker.answer(ListCalibrations, (calibration(signed=False),))
    still.app_state.quick_worker.answer(ListKeys, ("jdoe@lab",))
    qtbot.mouseClick(still.next, Qt.MouseButton.LeftButton)
    assert (still.page_shown(), page.steps.key_name.hasFocus()) == ("Certificate", True)  # nobody may approve


def test_who_sees_the_run_and_is_not_asked_has_nothing_to_click_on(still, path):
    still.app_state.run.start(RunProcedure("preflight", "bench.toml", {}, "EM-07", "J. Doe"))
    assert not still.next.isEnabled()
    still.open_page("Start")
    assert still.next.isEnabled()
    still.open_page("Run")
    assert not still.next.isEnabled()
    still.app_state.bench_worker.items.emit((Prompt(1.0, "ready", "Hands off?", acts=True),))
    assert still.next.isEnabled()


def test_fit_is_done_while_its_residual_is_traced(still, path):
    path.take_runs((RUN,))
    study = still.app_state.study_vm
    study.open("r1")
    study.fits["ml"] = Fitted(FitFigures(True))
    study.waiting = []
    study.close_loop()
    assert marks(still)[1:3] == "✓●"


def test_next_leads_to_the_setting_that_is_refused_else_to_begin(still, path, qtbot):
    choose = still.page("Run").choose
    assert (still.next.text(), choose.start.isEnabled()) == ("Next: Begin preflight", True)
    choose.form.set_text("inclination_deg", "80")
    assert (still.next.text(), choose.start.isEnabled()) == ("Next: Correct Inclination", False)
    still.open_page("Start")
    assert still.next.text() == "Next: Correct Inclination"
    qtbot.mouseClick(still.next, Qt.MouseButton.LeftButton)
    assert (still.page_shown(), choose.form.fields["inclination_deg"].hasFocus()) == ("Run", True)
    choose.form.set_text("inclination_deg", "50")
    assert still.next.text() == "Next: Begin preflight"
    still.open_page("Start")
    assert still.next.text() == "Next: Calibrate EM-07"


def test_start_is_not_ready_where_the_side_panel_says_what_is_wrong(new_window):
    question, lab = new_window.page("Start").question, new_window.app_state.lab
    assert question.text().startswith("Ready.")
    lab.update(now=replace(lab.state.now, lights=(("supply_x", "fault", "the link was lost"),)))
    assert question.text() == "✕ Not ready: supply_x. See the Bench page."
    lab.update(now=replace(lab.state.now, coil_words="coils NOT confirmed at zero"))
    assert question.text() == "✕ Not ready: see what is said of the coils."


def test_what_coils_off_has_ended_is_no_failure(still):
    run = still.app_state.run
    run.start(RunProcedure("field-hold", "bench.toml", {}, "EM-07", "J. Doe"))
    fault = Fault("stopped", "aborted by the operator")
    still.app_state.bench_worker.answer(RunProcedure, Ended("r1", "failed: aborted by the operator", fault))
    assert run_verdict(run).word == "■ STOPPED"


def test_who_began_anew_is_not_asked_to_go_on_with_what_was_before():
    broken = replace(RUN, status="interrupted")
    again, older = replace(RUN, run_id="r2"), replace(ANOTHER, status="interrupted")
    assert to_be_resumed((broken, older)) == [broken, older]
    assert to_be_resumed((again, broken, older)) == [older]


@pytest.mark.parametrize(
    ("status", "word"),
    [("stopped", "■ STOPPED"), ("failed: dut is silent", "✕ BROKEN OFF"), ("interrupted", "▲ BROKEN OFF")],
)
def test_a_run_that_did_not_come_to_its_end_has_no_verdict(still, status, word):
    run, live = still.app_state.run, still.page("Run").live
    run.start(RunProcedure("preflight", "bench.toml", {}, "EM-07", "J. Doe"))
    still.app_state.bench_worker.items.emit((Step(0.0, 1, 1, "zero", 60.0, ("zero",)),))
    still.app_state.bench_worker.items.emit((Measurement(1.0, "closure x", 1.0, 1.0, "nT", 30.0),))
    still.app_state.bench_worker.answer(RunProcedure, Ended("r1", status))
    assert run_verdict(run).word == word
    assert live.verdict.word.text().split() == word.split()
    assert "no verdict" in live.verdict.rule.text()
    assert not live.fit.isVisible()


def test_a_run_that_measured_nothing_puts_no_failed_below_the_serial(still):
    run, live = still.app_state.run, still.page("Run").live
    run.start(RunProcedure("preflight", "bench.toml", {}, "SIM-0001", "J. Doe"))
    (asked,) = (one for one in still.app_state.bench_worker.asked if isinstance(one.command, RunProcedure))
    asked.failed(Fault("input", "no such supply"))
    assert run_verdict(run).word == "✕ NOT MEASURED"
    assert live.verdict.rule.text() == "Nothing was measured, so this says nothing of the DUT."


@pytest.mark.parametrize(
    ("identity", "words", "field"),
    [({"operator": ""}, "Say who works here", "operator"), ({"dut": ""}, "Say which DUT", "dut")],
)
def test_who_and_which_are_said_where_the_operator_is(still, path, identity, words, field, qtbot):
    still.open_page("Run")
    still.app_state.set_identity(**identity)
    assert still.next.text() == f"Next: {words}"
    qtbot.mouseClick(still.next, Qt.MouseButton.LeftButton)
    assert still.page_shown() == "Run"  # with all that was typed there
    assert getattr(still.top, field).hasFocus()
    still.app_state.set_identity(dut="EM-07", operator="J. Doe")

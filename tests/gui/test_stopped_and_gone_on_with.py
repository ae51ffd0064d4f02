"""After Stop: one word for it in all places, the focus where the work is, and the run to go on with in front."""

from dataclasses import replace

import numpy as np
import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QApplication, QLabel
from test_path import RUN

from labcal.gui.ipc.answers import Ended
from labcal.gui.ipc.messages import Answer, ListRuns, Rehearse, ResumeRun, RunProcedure
from labcal.gui.ipc.wire import Fault, fault_of
from labcal.gui.viewmodels.run_verdict import run_verdict
from labcal.record.run import Segment
from labcal.record.stream import FAULT, Block, Measurement, Prompt, SegmentClosed, SegmentOpened, Step
from labcal.runner.control import Left

FIRST = Step(0.0, 1, 2, "x+20uT-nominal", 60.0, ("x+20uT-nominal", "closing"))
SECOND = Step(70.0, 2, 2, "closing", 60.0)
STOPPED = Fault("stopped", "stopped by the operator")


@pytest.fixture
def running(still):
    still.app_state.run.start(RunProcedure("preflight", "bench.toml", {}, "EM-07", "J. Doe"))
    still.app_state.bench_worker.items.emit((FIRST,))
    return still


@pytest.mark.parametrize(("status", "fit"), [("interrupted", False), ("finished", True)])
def test_at_the_end_the_focus_is_at_what_is_next_and_never_in_the_serial(running, qtbot, status, fit):
    live = running.page("Run").live
    qtbot.mouseClick(live.stop, Qt.MouseButton.LeftButton)
    assert not live.stop.isEnabled()
    assert live.isAncestorOf(QApplication.focusWidget())
    running.app_state.bench_worker.answer(RunProcedure, Ended("r1", status, None if fit else STOPPED))
    assert QApplication.focusWidget() is (live.fit if fit else live.close_run)


def test_in_the_last_step_nothing_offers_a_pause(running):
    """There is no step after it to pause at: it was promised, and the run ended with Close where Pause had stood."""
    live = running.page("Run").live
    assert live.pause.isEnabled()
    assert live.time_left.left.text().startswith("step 1 of 2")
    running.app_state.bench_worker.items.emit((SECOND,))
    assert not live.pause.isEnabled()
    assert live.time_left.left.text().startswith("step 2 of 2")  # at once, as the list beside it


def test_who_works_elsewhere_keeps_the_focus_when_a_run_ends(running):
    running.open_page("History")
    search = running.page("History").search
    search.setFocus()
    running.app_state.bench_worker.answer(RunProcedure, Ended("r1", "finished"))
    assert QApplication.focusWidget() is search


def test_a_run_that_was_stopped_is_said_to_be_stopped_also_where_it_can_be_gone_on_with(running):
    running.app_state.bench_worker.answer(RunProcedure, Ended("r1", "interrupted", STOPPED))
    verdict = run_verdict(running.app_state.run)
    assert verdict.word == "■ STOPPED"
    assert verdict.next.startswith("No turn was finished: Go on begins with the first step again")
    running.app_state.run.step = SECOND
    assert run_verdict(running.app_state.run).next.endswith("the timing again, then what is missing.")


def test_it_is_gone_on_with_where_it_was_stopped_by_the_one_blue_button(running, qtbot):
    worker, live = running.app_state.bench_worker, running.page("Run").live
    running.app_state.path.resumable = frozenset({"preflight"})
    worker.answer(RunProcedure, Ended("r1", "interrupted", STOPPED))
    assert [one.objectName() for one in (live.go_on, live.close_run)] == ["primary", ""]
    qtbot.mouseClick(live.go_on, Qt.MouseButton.LeftButton)
    assert [one.command.run for one in worker.asked if isinstance(one.command, ResumeRun)] == ["r1"]
    running.app_state.path.resumable = frozenset()  # no procedure that can be gone on with
    worker.answer(ResumeRun, Ended("r1", "interrupted", STOPPED))
    assert (live.go_on.isVisible(), live.close_run.objectName()) == (False, "primary")


def test_a_run_whose_worker_died_is_interrupted_here_as_in_its_record(running):
    live = running.page("Run").live
    running.app_state.path.resumable = frozenset({"preflight"})
    (asked,) = (one for one in running.app_state.bench_worker.asked if isinstance(one.command, RunProcedure))
    asked.failed(Fault("ended", "The work broke off."))
    assert run_verdict(running.app_state.run).word == "▲ BROKEN OFF"
    assert not live.go_on.isVisible()  # nobody has said under which name its record is: the Start page knows


def test_what_is_left_of_simulated_time_is_called_that(running):
    run, live = running.app_state.run, running.page("Run").live
    run.virtual_time = False
    live.draw()
    assert live.time_left.left.text() == "step 1 of 2 · 01:00 left"
    run.virtual_time, run.order = True, replace(run.order, pace="100 times")
    live.draw()
    assert live.time_left.left.text() == "step 1 of 2 · 01:00 of simulated time left"


def test_a_run_that_nobody_stopped_says_why_it_was_left_and_not_that_it_was_stopped(running):
    why = "the window stood still for more than 4 seconds"
    running.app_state.bench_worker.answer(RunProcedure, Ended("r1", "interrupted", fault_of(Left(why))))
    assert run_verdict(running.app_state.run).word == "▲ BROKEN OFF"
    card = running.page("Run").live.fault
    assert (card.heading.text(), card.text.text()) == ("▲ Broken off", why)


def test_a_run_that_lost_an_instrument_says_that_it_is_mended_first_and_then_gone_on_with(running):
    lost = Fault("instrument", "stage: the link was lost.", "Plug it in.")
    running.app_state.bench_worker.answer(RunProcedure, Ended("r1", "interrupted", lost))
    verdict = run_verdict(running.app_state.run)
    assert verdict.word == "▲ BROKEN OFF"
    assert verdict.next.startswith("Mend what is said above, then Go on: no turn was finished")
    running.app_state.run.step = SECOND
    assert "finished turns are kept" in run_verdict(running.app_state.run).next
    assert running.page("Run").live.fault.text.text() == "stage: the link was lost."


@pytest.mark.parametrize(("kind", "word"), [("instrument", "▲ BROKEN OFF"), ("input", "✕ BROKEN OFF")])
def test_who_goes_on_before_it_is_mended_finds_the_run_as_it_was(still, kind, word):
    still.app_state.resume("r1", "preflight", "EM-07")
    (asked,) = (one for one in still.app_state.bench_worker.asked if isinstance(one.command, ResumeRun))
    asked.failed(Fault(kind, "stage: the link was lost."))
    run = still.app_state.run
    assert run_verdict(run).word == word
    assert run_verdict(run).next.endswith("then Go on.") == (kind == "instrument")
    assert run.message.startswith("EM-07 · ")


def test_a_failed_step_is_asked_by_the_instrument_s_name_and_the_way_on_is_the_blue_one(running):
    long = "x+20uT-nominal: stage (serial:///dev/ttyUSB0): the link was lost. Plug it in. (coils at zero)"
    choices, drawing = ("stop", "retry", "skip"), {FAULT: "stage: the link was lost. Plug it in."}
    running.app_state.bench_worker.items.emit((Prompt(1.0, "failed-x", long, choices, drawing=drawing),))
    card = running.page("Run").live.prompt
    assert card.text.text() == "stage: the link was lost. Plug it in."
    assert {choice: made.objectName() for choice, made in card.choices.items()}["retry"] == "primary"
    assert [made.objectName() for made in card.choices.values()].count("primary") == 1
    assert card.choices["retry"].text().startswith("Hands off")


def test_a_wrong_mounting_is_asked_about_and_to_mount_again_is_the_blue_one(running, by_mouse):
    wrong = (
        "axes-check: the DUT's z axis shows +x. Mount it again where it is not mounted as asked; else look at its axes."
    )
    running.app_state.bench_worker.items.emit((Prompt(1.0, "opening-failed", wrong, ("stop", "remount")),))
    card = running.page("Run").live.prompt
    assert {made.text(): made.objectName() for made in card.choices.values()} == {
        "Stop the run": "", "Mount it again": "primary"
    }  # fmt: skip
    by_mouse(card.choices["remount"])
    assert running.app_state.bench_worker.said[-1] == Answer("opening-failed", "remount")


def test_a_serial_that_is_asked_is_typed_without_a_click(running):
    live = running.page("Run").live
    live.note.setFocus()
    drawing = {"serial": "EM-07"}
    running.app_state.bench_worker.items.emit((Prompt(1.0, "serial-mount-z", "Scan it.", (), True, drawing),))
    assert QApplication.focusWidget() is live.prompt.entry


@pytest.mark.parametrize(("procedure", "said"), [("preflight", False), ("field-sphere", True)])
def test_a_run_that_cannot_be_gone_on_with_says_so_and_why(still, procedure, said):
    still.open_page("Run")
    still.app_state.path.resumable = frozenset({"preflight"})
    still.app_state.run.start(RunProcedure(procedure, "bench.toml", {}, "EM-07", "J. Doe"))
    still.app_state.bench_worker.items.emit((Step(0.0, 1, 2, "sphere", 60.0, ("sphere", "verify")),))
    still.app_state.bench_worker.answer(RunProcedure, Ended("r1", "stopped", STOPPED))
    shown = " ".join(one.text() for one in still.page("Run").live.verdict.findChildren(QLabel))
    assert ("It cannot be gone on with" in shown) is said


def test_what_was_measured_before_an_interruption_counts_in_the_verdict_after_it(running):
    run, worker = running.app_state.run, running.app_state.bench_worker
    worker.items.emit((Measurement(1.0, "x+20uT-nominal: noise", 90.0, 1.0, "nT", 20.0),))
    worker.items.emit((replace(FIRST, t_s=2.0, number=2, name="closing"),))
    assert running.page("Run").live.lights.worst["x"].text() == "X  ✕ FAIL"
    worker.answer(RunProcedure, Ended("r1", "finished"))
    assert run_verdict(run).word == "✕ FAIL"


def test_who_goes_on_sees_which_turns_are_kept_and_what_was_broken_off_for_good(running):
    worker = running.app_state.bench_worker
    worker.answer(RunProcedure, Ended("r1", "interrupted", STOPPED))
    run, names = running.app_state.run, ("zero", "mount-x", "x+20uT-nominal", "closure-x", "mount-y", "closing")
    run.resume("r1", run.order)
    worker.items.emit((Measurement(3.5, "x+20uT-nominal: noise", 15.0, 1.0, "nT", 22.0),))  # of before

    def step(number):
        worker.items.emit((Step(float(number), number, len(names), names[number - 1], 60.0, names),))

    step(1)
    assert [mark for _, mark in run.steps()] == ["now", "done", "done", "next", "next", "next"]
    assert (run.steps_done(), running.page("Run").live.time_left.progress.value()) == (2, 333)
    step(5)
    assert [mark for _, mark in run.steps()] == ["done", "done", "done", "skipped", "now", "next"]
    step(6)
    worker.answer(ResumeRun, Ended("r1", "finished"))
    assert run_verdict(run).rule.endswith("Not measured: closure x.")


SILENT = Fault("instrument", "dut: no answer")


def test_a_refused_go_on_leaves_the_steps_the_bar_and_what_was_drawn_as_they_were(running):
    live, run, worker = running.page("Run").live, running.app_state.run, running.app_state.bench_worker
    names, turn = ("zero", "x+20uT-nominal", "closing"), Segment("x+20uT-nominal", "rotation")
    read = Block("dut", "dut", ("dut_x", "dut_y", "dut_z"), np.array([15.0]), np.array([[1.0, 2.0, 3.0]]))
    begun = Step(0.0, 1, 3, "zero", 100.0, names, 10.0, whole_s=100.0)
    worker.items.emit((begun, Step(10.0, 2, 3, names[1], 90.0, (), 60.0, whole_s=100.0), SegmentOpened(11.0, turn)))
    worker.items.emit((read, SegmentClosed(70.0), Step(70.0, 3, 3, "closing", 30.0, (), 30.0, whole_s=100.0)))
    worker.answer(RunProcedure, Ended("r1", "interrupted", STOPPED))
    worker.items.emit(())
    before = [text_of(live.steps), live.time_left.progress.value()]
    assert before == [["✓  offset and first position", "✓  x +20 µT nominal", "✕  closing"], 700]
    run.resume("r1", run.order)
    for state in ("starting", "ended"):
        assert (run.state, live.steps.isVisible()) == (state, True)
        assert [text_of(live.steps), live.time_left.progress.value()] == before
        assert (len(run.drawn.rows()), len(run.drawn.rows(earlier=True))) == (0, 1)  # pale from now on
        worker.answer(ResumeRun, Ended("r1", "interrupted", SILENT)) if state == "starting" else None
    run.resume("r1", run.order)
    worker.items.emit((Measurement(171.0, f"{turn.id}: missing sectors", 6.0, 0.0, "", 0.0), replace(begun, t_s=171.0)))
    assert (run.axis, live.turn.isVisible()) == ("", False)  # of no axis: no share of a circle is told
    assert len(run.drawn.rows(earlier=True)) == 1
    worker.items.emit((Step(180.0, 2, 3, "mount-x", 90.0, (), 60.0, whole_s=100.0),))
    assert (live.turn.words.text(), live.turn.isVisible()) == ("X:  75 % of the circle", True)
    worker.items.emit((Step(181.0, 2, 3, turn.id, 90.0, (), 60.0, whole_s=100.0),))
    for opened in ((), (SegmentOpened(182.0, turn),)):  # on the way to its field it is this turn already
        worker.items.emit(opened)
        assert (live.turn.words.text(), live.turn.bar.value()) == ("X, this turn:   0 % of the circle", 0)
    assert len(run.drawn.rows(earlier=True)) == 0  # it is measured again


def test_what_is_said_in_the_middle_is_of_now_when_it_comes_into_sight(running):
    live, worker, seen = running.page("Run").live, running.app_state.bench_worker, []
    worker.items.emit((Prompt(1.0, "ready", "The coils go to 20 µT. Hands off?", ("done",), True),))
    live.draw()
    asked = live.headline.text()
    live.middle.currentChanged.connect(lambda _: seen.append(live.headline.text()))
    running.app_state.run.stop()
    live.draw()
    assert seen == [live.headline.text()] != [asked]


def text_of(steps):
    return [steps.item(row).text() for row in range(steps.count())]


def test_an_axis_whose_closure_is_made_up_is_to_be_mounted_again(running):
    running.app_state.bench_worker.answer(RunProcedure, Ended("r1", "interrupted", STOPPED))
    run, names = running.app_state.run, ("zero", "mount-x", "x+20uT-nominal", "closure-x", "mount-y", "closing")
    run.resume("r1", run.order)
    before = [("x+20uT-nominal: noise", 15.0), ("mount-x: DUT less reference, first position", 120.0)]
    items = [Measurement(3.5, name, value, 1.0, "nT") for name, value in before]
    running.app_state.bench_worker.items.emit((*items, Step(1.0, 1, len(names), "zero", 60.0, names)))
    assert [mark for _, mark in run.steps()] == ["now", "next", "done", "next", "next", "next"]


def test_start_has_one_thing_to_do_and_that_is_what_next_says(still, qtbot, patience):
    start, path = still.page("Start"), still.app_state.path
    broken = (replace(RUN, status="interrupted"), replace(RUN, run_id="r2", dut_serial="EM-08", status="interrupted"))
    still.open_page("Start")
    still.app_state.quick_worker.answer(ListRuns, broken)
    mine, other = start.go_on_buttons
    assert [one.objectName() for one in (mine, other, start.calibrate)] == ["primary", "", ""]
    qtbot.waitUntil(mine.isVisible, timeout=patience)
    mine.setFocus()
    start.refresh()  # the list is made anew, as each time the page comes up
    still.app_state.quick_worker.answer(ListRuns, broken)
    mine = start.go_on_buttons[0]
    assert mine.hasFocus()
    start.refresh()
    still.app_state.quick_worker.answer(ListRuns, ())
    assert start.calibrate.objectName() == "primary"
    path.take_runs(())


def test_a_name_that_no_record_takes_is_refused_before_a_run(still):
    still.app_state.set_identity(operator="J" * 101)
    choose = still.page("Run").choose
    assert choose.objection.text() == "Correct what is red at the top."
    assert not choose.start.isEnabled()
    still.app_state.set_identity(operator="J. Doe")
    assert choose.start.isEnabled()


def test_how_long_a_procedure_takes_is_said_of_its_own_settings_alone(still):
    choose = still.page("Run").choose
    assert "min of measuring" in choose.needs.text()
    choose.form.set_text("magnitudes_nT", "20000")
    assert "The plan says how long this takes" in choose.needs.text()
    choose.rehearse()
    still.app_state.bench_worker.answer(Rehearse, ("preflight", "12 min"))
    assert (choose.plan.text(), "The plan says" in choose.needs.text()) == ("12 min", False)  # it is there


def test_who_goes_to_another_page_by_keyboard_does_not_land_in_the_serial(still, qtbot):
    still.open_page("History")
    still.page("History").search.setFocus()
    qtbot.keyClick(still, Qt.Key.Key_1, Qt.KeyboardModifier.ControlModifier)
    assert still.page_shown() == "Start"
    assert QApplication.focusWidget() is still.sidebar_buttons.checkedButton()
    qtbot.keyClicks(QApplication.focusWidget(), "X", delay=60)
    assert still.app_state.lab.state.dut_serial == "EM-07"


TURNS = ("zero", "mount-x", "x+20uT-nominal", "x-20uT-nominal", "closure-x", "mount-y", "y+20uT-nominal", "closing")
NOISE = Measurement(1.0, "x+20uT-nominal: noise", 15.0, 1.0, "nT", 22.0)
DELAY_X = Measurement(2.0, "delay x", 0.01, 0.001, "s", 0.1)
ASKS = Prompt(9.0, "mounting-stands", "Is it still mounted?", ("yes", "no"), True)


@pytest.mark.parametrize(
    ("at", "measured", "said"),
    [
        (3, (), "No turn was finished"),  # the first turn of two broke off: both are measured after it
        (4, (NOISE,), "Lost: delay x, which comes of turns there and back"),
        (7, (NOISE, DELAY_X), "Measured already, and kept: delay x (how late"),
    ],
)
def test_what_becomes_of_the_delay_is_said_at_the_stop_and_at_the_question_before_it_goes_on(
    running, at, measured, said
):
    worker, run, live = running.app_state.bench_worker, running.app_state.run, running.page("Run").live
    running.app_state.path.resumable = frozenset({"preflight"})
    worker.items.emit((Measurement(0.5, "zero: ref_x", 1.0, 1.0, "nT", 0.0), *measured))
    worker.items.emit((Step(3.0, at, len(TURNS), TURNS[at - 1], 60.0, TURNS),))
    worker.answer(RunProcedure, Ended("r1", "interrupted", STOPPED))
    assert said in live.fault.text.text()
    run.resume("r1", run.order)
    worker.items.emit((Step(8.0, 1, len(TURNS), "zero", 60.0, TURNS), ASKS))
    assert said in live.prompt.hint.text()
    assert ("with their ticks" in live.prompt.hint.text()) is bool(measured)

"""What to run: what it needs, how long it takes, its form, and what keeps Start waiting."""

from dataclasses import replace

import numpy as np
import pytest
from PySide6.QtCore import QPoint, QRect, Qt
from PySide6.QtGui import QFontMetrics
from PySide6.QtWidgets import QApplication

from labcal.gui.ipc.answers import Change, Ended, Look, Loop, Proposal
from labcal.gui.ipc.bench_commands import procedures, rehearse
from labcal.gui.ipc.messages import CloseLoop, JoinRuns, ListProcedures, LookAt, Rehearse, RunProcedure
from labcal.gui.ipc.study_commands import proposal
from labcal.gui.ipc.wire import Fault
from labcal.gui.theming.theme import LIGHT
from labcal.gui.viewmodels.path import Wanted
from labcal.gui.widgets.parameter_form import ParameterForm
from labcal.gui.widgets.typed_number import NotClear, number_stated
from labcal.loop.result import NextExperiment
from labcal.model.records import EffectRecord, Rival


@pytest.fixture
def choose(still):
    return still.page("Run").choose


def procedure_rows(choose):
    """The rows of the list that are procedures; the others are headings."""
    return [row for row in range(choose.list.count()) if choose.list.item(row).flags() & Qt.ItemFlag.ItemIsSelectable]


def in_sight(choose):
    rows = range(choose.list.count())
    return [choose.list.item(row).text() for row in rows if not choose.list.item(row).isHidden()]


def test_procedures_stand_in_groups_and_are_found_by_what_they_do(choose):
    assert in_sight(choose)[:2] == ["Calibrate a DUT", "preflight"]
    choose.search.setText("gyro")
    assert in_sight(choose) == []
    choose.search.setText("cage-map")
    assert in_sight(choose) == ["The cage and its reference", "cage-map"]
    assert not choose.none_found.isVisible()
    choose.search.setText("nothing of the kind")
    assert choose.none_found.isVisible()  # an empty list says why
    choose.search.setText("")
    assert not choose.none_found.isVisible()
    assert len(in_sight(choose)) == choose.list.count()


@pytest.mark.parametrize("width", [1024, 1360])
def test_no_heading_of_the_list_is_cut(still, choose, qtbot, width):
    before = still.size()
    still.resize(width, 700)
    QApplication.processEvents()
    qtbot.waitUntil(lambda: still.width() == width, timeout=60_000)
    choose.search.clear()
    cut = []
    for item in map(choose.list.item, range(choose.list.count())):
        place = choose.list.visualItemRect(item)
        metrics = QFontMetrics(item.font() if item.font().bold() else choose.list.font())
        room = QRect(0, 0, place.width() - 8, 1000)
        needed = metrics.boundingRect(room, int(Qt.TextFlag.TextWordWrap), item.text())
        cut += [item.text()] if needed.height() > place.height() else []
    still.resize(before)
    assert cut == []


def test_what_was_typed_is_there_again_after_another_procedure(choose):
    choose.form.set_text("inclination_deg", "80")
    choose.form.set_text("rate_deg_per_s", "12")
    choose.choose("axes-check")
    choose.choose("preflight")
    assert choose.form.text("inclination_deg") == "80"
    assert choose.form.given() == {"inclination_deg": "80", "rate_deg_per_s": "12"}
    assert not choose.start.isEnabled()


def test_a_form_that_was_never_shown_stays_nowhere(qtbot, choose):
    for row in procedure_rows(choose)[:4]:  # quicker than forms are put in their place
        choose.list.setCurrentRow(row)
    qtbot.waitUntil(lambda: choose.findChildren(ParameterForm) == [choose.form], timeout=15_000)


def test_a_refused_setting_is_red_with_its_reason(choose):
    choose.form.set_text("inclination_deg", "80")
    field, complaint = choose.form.fields["inclination_deg"], choose.form.complaints["inclination_deg"]
    assert (field.property("state"), complaint.property("state")) == ("bad", "bad")
    choose.form.ensurePolished()
    assert complaint.palette().windowText().color().name() == LIGHT.bad
    choose.form.set_text("inclination_deg", "50")
    assert (field.property("state"), complaint.property("state")) == ("", "")


@pytest.mark.parametrize(
    ("typed", "mark", "stated"),
    [("1.5", ".", "1.5"), ("1,5", ",", "1.5"), ("-0,005", ",", "-0.005"), ("0,125", ",", "0.125"), ("1e4", ".", "1e4"),
     ("20000", ",", "20000"), ("1.125", ".", "1.125"), ("1234,567", ",", "1234.567"), (" 7 ", ".", "7")],
)  # fmt: skip
def test_numbers_are_taken_as_the_locale_writes_them(typed, mark, stated):
    assert number_stated(typed, mark) == stated


@pytest.mark.parametrize(
    ("typed", "mark", "reason"),
    [("20 000", ".", "thousands"), ("20,000", ".", "thousands"), ("20,000", ",", "thousands"),
     ("20.000", ",", "thousands"), ("1.234,5", ",", "thousands"), ("20'000", ".", "thousands"),
     ("20\u202f000", ",", "thousands"), ("1,5", ".", "point")],
)  # fmt: skip
def test_a_number_that_may_be_meant_in_two_ways_is_refused_with_the_reason(typed, mark, reason):
    with pytest.raises(NotClear, match=reason):
        number_stated(typed, mark)


def test_a_list_takes_no_comma_within_a_number(choose):
    for typed, accepted in (
        ("20000, 50000", True),
        ("20,000, 50,000", False),
        ("1,5, 3", False),
        ("20 000, 5000", False),
    ):
        choose.form.set_text("magnitudes_nT", typed)
        assert choose.form.valid() == accepted, typed


def test_every_procedure_says_what_it_needs_and_how_long_it_takes(choose):
    for row in procedure_rows(choose):
        choose.list.setCurrentRow(row)
        assert "Needs: " in choose.needs.text(), choose.list.item(row).text()
        assert "min of measuring" in choose.needs.text()


def test_a_setting_out_of_range_is_named_and_start_waits(choose):
    choose.choose("preflight")
    assert choose.start.isEnabled()
    choose.form.set_text("inclination_deg", "80")
    assert not choose.start.isEnabled()
    assert "35 to 65" in choose.form.complaints["inclination_deg"].text()


def test_nothing_points_to_a_plan_that_cannot_be_asked_for(still, choose):
    def points():
        return ["The plan" in choose.needs.text(), choose.show_plan.isEnabled()]

    lines = len(choose.needs.text().splitlines())
    choose.form.set_text("rate_deg_per_s", "20")
    assert points() == [True, True]
    choose.form.set_text("inclination_deg", "80")
    assert points() == [False, False]
    assert len(choose.needs.text().splitlines()) == lines
    choose.form.set_text("inclination_deg", "50")
    still.app_state.set_identity(operator="")
    assert points() == [False, False]


def test_no_operator_no_run(still, choose):
    still.app_state.set_identity(operator="")
    assert not choose.start.isEnabled()
    assert "operator" in choose.objection.text()


def test_a_procedure_that_does_not_load_is_listed_with_its_fault_and_is_not_chosen(choose):
    there = procedures(None, ListProcedures())
    choose.choose("preflight")
    choose.show_procedures(replace(there, broken={"other": "other.py, line 3: it exits"}))
    broken = choose.list.item(choose.list.count() - 1)
    assert (broken.text(), broken.toolTip()) == ("✕ other", "other.py, line 3: it exits")
    assert not broken.flags() & Qt.ItemFlag.ItemIsSelectable
    assert choose.list.currentItem().text() == "preflight"
    choose.show_procedures(there)
    assert len(procedure_rows(choose)) == len(there.found)


def told_by_the_loop(procedure):
    """A loop's answer that is not sure, as the worker gives it."""
    t = np.linspace(0.0, 100.0, 50)
    effect = EffectRecord(
        "offset-current", ("i_eps",), {}, "sensor", (), why="it falls", improvement_ci95_nT=(5.0, 9.0),
        holdout_rms_before_nT=50.0, holdout_rms_after_nT=30.0, rivals=(Rival("offset-drift", (), 31.0),),
    )  # fmt: skip
    residual = np.ones((50, 3))
    return Loop(
        verdict="ambiguous", summary="Two causes do as well.", before_nT=50.0, after_nT=50.0, noise_floor_nT=27.0,
        noise_floor_source="declared", set_aside={}, accepted=(effect,), rejected=(),
        next_experiment=Proposal("drift goes on", "turn back", procedure), remarks=(), draft="d.json",
        change=Change(residual, residual, {"time  s": t, "i_eps  A": t}),
    )  # fmt: skip


def looked_at(run, dut="EM-07"):
    """What the worker says of a run."""
    return Look(run, dut, 50, np.ones((50, 3)), {})


def loop_page(window, answer):
    """`window` with its Loop page on a run of which the worker says `answer`."""
    window.open_page("Loop")
    window.page("Loop")
    study, worker = window.app_state.study_vm, window.app_state.fit_worker
    study.open("r1")
    worker.answer(LookAt, looked_at("r1"))
    study.close_loop()
    worker.answer(CloseLoop, answer)
    return window


@pytest.fixture
def undecided(still):
    """The Loop page on a run whose loop has two causes that do as well."""
    return loop_page(still, told_by_the_loop("reverse"))


def test_every_cause_is_named_whole_with_its_reason(qtbot, undecided, patience):
    page = undecided.page("Loop")
    qtbot.waitUntil(lambda: page.others.rowCount() == 2, timeout=patience)
    rows = [[page.others.text(row, column) for column in range(5)] for row in range(2)]
    assert [(row[0], row[3], row[4]) for row in rows] == [
        ("offset-current (i_eps)", "✓ named", "it falls"),
        ("offset-drift", "? rival", "does about as well as “offset-current (i_eps)”"),
    ]
    page.others.selectRow(1)
    assert page.change_why.text() == "offset-drift: does about as well as “offset-current (i_eps)”"


def test_what_would_tell_causes_apart_is_not_measured_on_another_dut(qtbot, undecided):
    page = undecided.page("Loop")
    page.next.setFocus()  # a serial that is typed, and left, lets go of the run
    undecided.app_state.set_identity(dut="EM-08")
    qtbot.mouseClick(page.next, Qt.MouseButton.LeftButton)
    assert "This run is of EM-07; the DUT at the top is EM-08" in page.fault.text.text()
    assert undecided.app_state.bench_worker.asked == []


def test_what_would_tell_them_apart_is_begun_with_the_settings_that_tell_and_the_next_run_with_the_usual(
    qtbot, undecided
):
    still, page, study = undecided, undecided.page("Loop"), undecided.app_state.study_vm
    choose, worker = still.page("Run").choose, still.app_state.bench_worker
    still.app_state.open_procedure("preflight")
    choose.form.set_text("zero_s", "30")  # as somebody likes it
    found = NextExperiment("", "", "preflight", (), {"magnitudes_nT": "16667, 100000", "reverse": "false"})
    study.loop = replace(told_by_the_loop(None), next_experiment=proposal(found))
    study.changed.emit()
    still.open_page("Loop")
    qtbot.mouseClick(page.next, Qt.MouseButton.LeftButton)
    given = {"magnitudes_nT": "16667, 100000", "reverse": "no"}
    (asked,) = worker.commands()
    assert asked == Rehearse("preflight", still.app_state.bench, given)
    worker.answer(Rehearse, ("Preflight:",))
    assert "the next run has the usual ones again" in choose.plan.text()
    qtbot.mouseClick(choose.start, Qt.MouseButton.LeftButton)
    assert [one.given for one in worker.commands(RunProcedure)] == [given]
    assert choose.form.given() == {"zero_s": "30"}


def test_settings_that_were_proposed_and_not_begun_are_gone_when_a_dut_is_calibrated(still, choose):
    still.app_state.open_procedure("preflight", Wanted("preflight", settings={"rate_deg_per_s": "1e9"}))
    assert choose.refused_field() is choose.form.fields["rate_deg_per_s"]  # it says so itself
    still.app_state.open_procedure("preflight")
    assert choose.form.given() == {}
    still.app_state.open_procedure("preflight", Wanted("preflight", settings={"zero_s": "30"}))
    choose.choose("reverse")
    choose.choose("preflight")
    assert choose.form.given() == {}


def test_what_would_tell_them_apart_is_planned_in_words_started_by_a_click_and_decides_again(qtbot, undecided):
    still, page, study = undecided, undecided.page("Loop"), undecided.app_state.study_vm
    qtbot.mouseClick(page.next, Qt.MouseButton.LeftButton)
    choose, worker = still.page("Run").choose, still.app_state.bench_worker
    assert still.stack.currentWidget() is still.lazy_pages["Run"]
    (asked,) = worker.commands()
    assert asked == Rehearse("reverse", still.app_state.bench)
    assert not choose.start.isEnabled()  # nothing moves before the plan is read
    worker.answer(Rehearse, rehearse(None, asked))
    said = choose.plan.text()
    assert choose.plan.isVisible()
    for words in (
        "largest field at the DUT 50.0 µT",
        "turns between",
        "°/s",
        "°C",
        " min,",
        "× in all:\n– Next the platform looks for its zero",
        "– Mount the DUT",
    ):
        assert words in said
    assert "added to run r1" in said
    qtbot.mouseClick(choose.start, Qt.MouseButton.LeftButton)
    assert [(one.procedure, one.after) for one in worker.commands(RunProcedure)] == [("reverse", "r1")]
    worker.answer(RunProcedure, Ended("r2", "finished"))
    assert still.stack.currentWidget() is still.lazy_pages["Loop"]
    assert still.app_state.fit_worker.commands(JoinRuns) == [JoinRuns("r1", "r2")]
    still.app_state.fit_worker.answer(JoinRuns, "r1+r2")
    assert still.app_state.fit_worker.commands(CloseLoop) == [CloseLoop("r1+r2")]
    still.app_state.fit_worker.answer(LookAt, looked_at("r1+r2"))
    still.app_state.fit_worker.answer(CloseLoop, told_by_the_loop("repeat"))
    assert study.run == "r1+r2"
    assert "Added to it: reverse (r2)." in page.unknown.toPlainText()


@pytest.mark.parametrize("status", ["stopped", "failed: aborted by the operator"])
def test_a_run_that_did_not_finish_is_added_to_nothing(qtbot, undecided, status):
    undecided.app_state.study_vm.want("reverse")
    undecided.app_state.start("reverse", {})
    undecided.app_state.bench_worker.answer(RunProcedure, Ended("r2", status))
    undecided.app_state.start("preflight", {})  # another procedure is no answer to the question either
    undecided.app_state.bench_worker.answer(RunProcedure, Ended("r3", "finished"))
    assert undecided.app_state.fit_worker.commands(JoinRuns) == []


def test_a_plan_is_that_of_its_settings_and_one_beyond_a_limit_is_refused_in_words(qtbot, still, choose):
    choose.choose("reverse")
    qtbot.mouseClick(choose.show_plan, Qt.MouseButton.LeftButton)
    late = still.app_state.bench_worker.asked[-1].then
    choose.form.set_text("rate_deg_per_s", "15")
    late(("the plan of other settings",))
    assert not choose.plan.text()
    qtbot.mouseClick(choose.show_plan, Qt.MouseButton.LeftButton)
    asked = still.app_state.bench_worker.asked[-1]
    assert asked.command.given == {"rate_deg_per_s": "15"}
    asked.failed(Fault("input", "25 deg/s is beyond the DUT's limit.", "Nothing was moved."))
    assert choose.plan.text() == "✕ 25 deg/s is beyond the DUT's limit. Nothing was moved."


def test_settings_that_most_runs_leave_alone_are_folded_until_they_are_another_or_wanted(qtbot, still, choose):
    choose.choose("preflight")
    qtbot.waitUntil(lambda: choose.form.isVisible(), timeout=30_000)
    form = choose.form

    def seen():
        return [name for name, field in form.fields.items() if field.isVisible()]

    usual = list(form.fields)[:6]
    assert seen() == usual
    assert form.more.text() == f"▸ More settings: {len(form.fields) - 6}"
    form.set_text("zero_s", "30")
    assert seen() == [*usual, "zero_s"]
    form.set_text("zero_s", "much")
    assert form.complaints["zero_s"].isVisible()
    qtbot.mouseClick(form.more, Qt.MouseButton.LeftButton)
    assert seen() == list(form.fields)


def test_next_begins_what_is_chosen_and_chooses_nothing_else(still):
    choose = still.page("Run").choose
    still.app_state.open_procedure("rotate-axis")
    choose.form.set_text("turns", "3")
    assert still.next.text() == "Next: Begin rotate-axis"
    still.open_page("Start")
    assert still.next.text() == "Next: Calibrate EM-07"
    still.open_page("Run")
    still.next.click()
    order = still.app_state.run.order
    assert (order.procedure, order.given["turns"]) == ("rotate-axis", "3")


def test_a_setting_refused_for_one_dut_says_nothing_of_the_next_on_another_page(still):
    choose = still.page("Run").choose
    still.open_page("Run")
    still.app_state.set_identity(dut="EM-07")
    choose.form.set_text("inclination_deg", "80")
    still.open_page("Start")
    assert still.app_state.path.refused == "Inclination"  # of this DUT it is still what is in the way
    still.app_state.set_identity(dut="EM-08")
    assert still.app_state.path.refused == ""
    still.open_page("Run")
    assert still.app_state.path.refused == "Inclination"  # where it is in sight


def test_one_button_brings_a_form_back_to_its_usual_settings(still, qtbot):
    choose = still.page("Run").choose
    still.open_page("Run")
    assert not choose.usual.isEnabled()
    choose.form.set_text("inclination_deg", "80")
    choose.form.set_text("axes", "x")
    qtbot.mouseClick(choose.usual, Qt.MouseButton.LeftButton)
    assert (choose.form.given(), choose.form.valid(), choose.usual.isEnabled()) == ({}, True, False)


def test_while_it_is_rehearsed_nothing_beside_the_button_moves(still, choose, qtbot):
    still.open_page("Run")
    QApplication.processEvents()
    before = choose.pace.mapTo(choose, choose.pace.rect().topLeft()), choose.start.mapTo(choose, QPoint(0, 0))
    choose.rehearse()
    QApplication.processEvents()
    assert (choose.give_up.isVisible(), choose.show_plan.isVisible()) == (True, False)
    assert before == (choose.pace.mapTo(choose, choose.pace.rect().topLeft()), choose.start.mapTo(choose, QPoint(0, 0)))

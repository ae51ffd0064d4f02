"""What a stranger stumbled over on a served lab: what is lost is in the headline, words name buttons that are there."""

import time

import numpy as np
from lab_states import told

from labcal.bench.coils.state import CoilReading, Heard, LabState, PlatformReading
from labcal.gui.ipc.answers import CoilEnd, Ended, RunLine, SwitchedOff
from labcal.gui.ipc.messages import RunProcedure, SwitchOff
from labcal.gui.ipc.wire import Fault
from labcal.gui.viewmodels.resumed import to_be_resumed
from labcal.gui.viewmodels.run_verdict import run_verdict
from labcal.gui.widgets.fault_card import FaultCard
from labcal.record import Segment
from labcal.record.stream import FAULT, Block, Event, Measurement, Prompt, SegmentOpened, Step
from labcal.runner.rehearsal import Rehearsal

LOST = Fault("instrument", "dut: the link was lost.", "Plug it in, then try again.")


def begun(still):
    still.app_state.run.start(RunProcedure("preflight", "bench.toml", {}, "EM-07", "J. Doe"))
    return still.page("Run").live


def says(still, *faulty, z_A=0.0, platform=None):
    now = time.monotonic()
    coils = tuple(CoilReading(a, None, i, not i, None, now) for a, i in (("x", 0.0), ("y", 0.0), ("z", z_A)))
    heard = tuple(Heard(n, now, "silent") for n in faulty)
    still.app_state.bench_worker.states.emit(LabState(coils, instruments=heard, platform=platform))


def test_what_is_lost_is_in_the_largest_letters_while_the_run_goes_on_and_after_it(still):
    live = begun(still)
    still.app_state.bench_worker.items.emit((SegmentOpened(1.0, Segment("x+20uT", "rotation")),))
    says(still, "dut")
    live.draw()
    assert live.headline.text() == "✕ No answer from dut"
    says(still)
    live.draw()
    assert live.headline.text().startswith("Hands off")
    still.app_state.bench_worker.answer(RunProcedure, Ended("r1", "interrupted", LOST))
    live.draw()
    assert live.headline.text() == "✕ Broken off: no answer from dut"


def test_a_step_to_be_begun_again_is_said_by_the_button_that_is_there(still):
    live = begun(still)
    told(still)
    still.app_state.bench_worker.answer(RunProcedure, Ended("r1", "interrupted", LOST))
    assert live.fault.remedy.text().endswith("Here that is Go on: what was finished is kept.")
    live = begun(still)
    still.app_state.bench_worker.answer(RunProcedure, Ended("r2", "failed: dut", LOST))
    assert live.fault.remedy.text().endswith("This run has ended: Close, then Begin measures anew.")


def test_a_turn_that_is_tried_again_begins_with_an_empty_circle(still):
    begun(still)
    worker, run = still.app_state.bench_worker, still.app_state.run
    turn = Block("angle", "stage", ("angle_deg",), np.array([1.0, 2.0]), np.array([[0.0], [90.0]]))
    worker.items.emit((SegmentOpened(1.0, Segment("x+20uT", "rotation")), turn))
    assert run.coverage() > 0
    worker.items.emit((Prompt(3.0, "failed-x+20uT", "x+20uT: lost", ("stop", "retry", "skip")),))
    assert run.coverage() == 0
    assert "x+20uT" not in run.drawn.now
    card = still.page("Run").live.prompt
    assert "Skipped, it is missing, and this run does not come back to it" in card.hint.text()  # before it is pressed


def test_a_traceback_is_said_to_be_for_others(qtbot):
    card = FaultCard(closable=False)
    qtbot.addWidget(card)
    card.show_fault(Fault("crash", "It broke.", "", "Traceback (most recent call last): …"))
    assert card.details.toPlainText().startswith("For who mends labcal; a problem report holds it:\n\nTraceback")
    card.show_fault(Fault("input", "No.", "", "/lab/bench.toml: line 3"))
    assert card.details.toPlainText() == "/lab/bench.toml: line 3"


def test_a_plan_says_the_rate_that_was_typed_and_whose_limit_it_is_beside():
    for rate, most, said in ((20.0, 20, "20"), (2.4, 20, "2.4"), (9.97, 20, "10"), (9.97, 9.97, "9.97")):
        limit = (most, "platform's limit")
        plan = Rehearsal("preflight", "x", angles_deg=(0.0, 360.0), rate_deg_per_s=rate, limit=limit)
        assert f"the fastest at {said} °/s; the platform's limit is {most:g} °/s" in "\n".join(plan.lines())


def failed(still, **said):
    live = begun(still)
    drawing = {"fault": "the whole sentence", **said}
    still.app_state.bench_worker.items.emit(
        (Prompt(3.0, "failed-z+20uT", "z+20uT: …", ("stop", "retry", "skip"), drawing=drawing),)
    )
    return live.prompt


def test_a_lost_link_is_short_in_the_headline_and_its_advice_names_the_button_that_is_there(still):
    card = failed(
        still,
        no_answer="supply_z",
        what="supply_z: the link was lost (Input/output error).",
        remedy="Plug it in, see that nobody else has opened it, then try again.",
    )
    assert card.text.text() == "✕ No answer from supply_z"
    assert card.details.text() == (
        "supply_z: the link was lost. Plug it in, see that nobody else has opened it, then try again. "
        "Here that is “Hands off: try again”."
    )
    assert "Hands off: try again" in card.choices["retry"].text()
    assert card.text.toolTip() == "the whole sentence"


def test_what_failed_otherwise_is_the_headline_without_what_the_system_says(still):
    card = failed(still, what="stage: it stands at 40° (status 0x17).", remedy="Look for what holds it.")
    assert card.text.text() == "stage: it stands at 40°."
    assert card.details.text() == "Look for what holds it. Then “Hands off: try again”."


def test_a_question_that_is_no_failure_has_no_details(still):
    live = begun(still)
    still.app_state.bench_worker.items.emit((Prompt(3.0, "ready", "The coils go on. Hands off?", acts=True),))
    assert live.prompt.details.isHidden()


def test_of_a_silent_dut_plug_and_power_are_named_in_the_panel(still):
    begun(still)
    says(still, "dut")
    (row,) = [row.text() for row in still.side.instrument_rows if row.text().startswith("✕ dut")]
    assert row.startswith("✕ dut  no answer (plug? power?)")


def test_who_is_lost_stands_below_hands_off_and_no_longer_than_it_is(still):
    live = begun(still)
    asks = still.app_state.bench_worker.items.emit
    asks((Prompt(3.0, "ready", "The coils go to 50 µT and the platform turns. Hands off?", acts=True),))
    assert live.prompt.details.isHidden()
    says(still, "dut")
    assert live.prompt.details.text().startswith("✕ No answer from dut (since ")
    still_lost = "Still lost: dut (silent). Put that right first: a step begun now fails again."
    asked = "The coils go to 50 µT and the platform turns. Hands off?"
    asks((Prompt(4.0, "ready", f"{still_lost} {asked}", acts=True, drawing={"question": asked}),))
    assert live.prompt.details.text().startswith("✕ No answer from dut (since ")
    says(still)
    assert live.prompt.details.text() == "dut: answers again"
    assert live.prompt.text.text().replace("\N{NO-BREAK SPACE}", " ") == f"Next: t{asked[1:]}"


def test_as_long_as_anything_is_on_or_turns_the_headline_keeps_hands_off(still):
    live, emit = begun(still), still.app_state.bench_worker.items.emit
    emit((SegmentOpened(1.0, Segment("z+50uT", "rotation")),))
    turns, now = PlatformReading(220.0, True, time.monotonic()), time.monotonic()
    for z_A, platform, said in (
        (1.13, turns, "✕ HANDS OFF – no answer from dut; coils on, platform turning"),
        (0.0, turns, "✕ HANDS OFF – no answer from dut; platform turning"),
        (0.0, PlatformReading(220.0, True, now - 12), "✕ HANDS OFF – no answer from dut; platform may turn"),
        (0.0, PlatformReading(220.0, False, now), "✕ No answer from dut"),
    ):
        says(still, "dut", z_A=z_A, platform=platform)
        live.draw()
        assert live.headline.text() == said
    lost = "dut: no sample for 2.1 s. Is its plug in at both ends, and has it power?"
    emit((Event(2.0, FAULT, lost, {"step": "z+50uT", "fault": "silent"}),))
    assert still.app_state.run.message == "dut: no answer"


def test_a_platform_that_turned_when_it_was_read_last_is_not_said_to_turn_now():
    turned = PlatformReading(220.0, True, 10.0)
    assert turned.sentence(11.0) == "platform turns, at 220°"
    assert turned.sentence(22.0) == "platform NOT confirmed at a standstill: at 220° it turned, 12 s ago"


def test_a_failed_steps_headline_is_no_longer_than_its_instrument_is_lost(still):
    card = failed(still, no_answer="dut", what="dut: no sample for 2.1 s.", remedy="Is its plug in?")
    says(still, "dut")
    assert card.text.text() == "✕ No answer from dut"
    says(still)
    assert card.text.text() == "Every instrument answers again."


def test_what_cannot_be_gone_on_with_is_offered_nowhere(still):
    still.app_state.path.resumable = frozenset({"preflight"})
    still.app_state.run.start(RunProcedure("rotate-axis", "bench.toml", {}, "EM-07", "J. Doe"))
    live = still.page("Run").live
    told(still)
    still.app_state.bench_worker.answer(RunProcedure, Ended("r1", "interrupted", LOST))
    assert live.go_on.isHidden()
    said = live.fault.remedy.text(), live.verdict.next.text(), live.verdict.rule.text()
    assert not any("Go on" in words for words in said)
    began = "2026-11-22T01:10:00+00:00"
    lines = tuple(RunLine(f"r-{n}", began, "interrupted", "EM-07", "J. Doe", n) for n in ("rotate-axis", "preflight"))
    assert [one.procedure for one in to_be_resumed(lines, still.app_state.path.resumable)] == ["preflight"]


def test_a_pass_that_lacks_a_closure_says_so_as_large_as_pass(still):
    live, emit = begun(still), still.app_state.bench_worker.items.emit
    names = ("mount-x", "closure-x", "closing")
    for number, name in ((1, "mount-x"), (3, "closing")):
        emit((Step(1.0, number, 3, name, 0.0, names),))
    emit((Measurement(2.0, "closure, |B|", 1.0, 0.1, "nT", 500.0),))
    still.app_state.run.skipped.add("closure-x")
    still.app_state.bench_worker.answer(RunProcedure, Ended("r1", "finished", None))
    verdict = run_verdict(still.app_state.run)
    assert (verdict.word, verdict.state) == ("▲ PASS, without closure x", "warning")
    assert live.verdict.isVisibleTo(live)


def test_a_delay_that_no_turn_told_is_said_in_the_verdict_and_turns_no_axis_green(still):
    live, emit = begun(still), still.app_state.bench_worker.items.emit
    names = ("zero", "mount-z", "z+20uT-nominal", "closure-z", "closing")
    told = [("zero: ref_x", None), ("closure z", 500.0), ("z+20uT-nominal: noise", 20.0)]
    looks = [*told, ("z+20uT-nominal: missing sectors", 1.5), ("z+20uT-nominal: wrong signs", 1.5)]
    emit((Step(1.0, 1, 5, "zero", 0.0, names), Step(2.0, 5, 5, "closing", 0.0)))
    emit(tuple(Measurement(2.0, name, 1.0, 0.1, "nT", limit) for name, limit in looks))
    still.app_state.bench_worker.answer(RunProcedure, Ended("r1", "finished", None))
    verdict = run_verdict(still.app_state.run)
    assert (verdict.word, verdict.state) == ("▲ PASS, without delay z", "warning")
    _, told = verdict.rule.split("Not measured: delay z. ")
    assert told.startswith("The delay is how late the DUT reads behind the platform's angle.")
    assert "after Go on too few" in told
    assert told.endswith("To get it: sync-check, or a new preflight.")
    assert live.lights.worst["z"].text() == "Z  ▲ not complete"
    assert [axis for axis, column in live.lights.columns.items() if column.isVisibleTo(live.lights)] == ["z"]
    emit((Measurement(3.0, "delay z", 0.1, 0.01, "s", 0.5),))
    assert run_verdict(still.app_state.run).word == "✓ PASS"
    assert live.lights.worst["z"].text() == "Z  ✓ PASS"


def test_what_a_run_does_not_look_at_is_not_open_beside_its_verdict(still):
    live, emit = begun(still), still.app_state.bench_worker.items.emit
    emit((Step(1.0, 1, 2, "mounting and zero", 0.0, ("mounting and zero", "z+50uT")), Step(2.0, 2, 2, "z+50uT", 0.0)))
    looks = ("missing sectors", "noise", "wrong signs")
    emit(tuple(Measurement(2.0, f"z+50uT: {look}", 1.0, 0.1, "nT", 5.0) for look in looks))
    still.app_state.bench_worker.answer(RunProcedure, Ended("r1", "finished", None))
    assert live.lights.worst["z"].text() == "Z  ✓ PASS"
    assert "closure" not in live.lights.looks["z"].text()
    assert live.lights.columns["x"].isHidden()


def test_a_persons_own_coils_off_is_called_so_and_names_the_platform(still):
    live = begun(still)
    says(still, platform=PlatformReading(220.0, True, time.monotonic() - 12))
    still.app_state.off.order()
    still.app_state.bench_worker.asked[-1].failed(Fault("ended", "The work was ended by this window."))
    assert live.fault.heading.text() == "■ Stopped by COILS OFF (F12)"
    assert still.app_state.run.status == "interrupted"
    ends = tuple(CoilEnd(a, 0.0, "0 A, open", True, time.monotonic()) for a in "xyz")
    still.app_state.off_worker.answer(SwitchOff, SwitchedOff(ends, ""))
    said = still.app_state.lab.state.message
    assert said.startswith("COILS OFF done ")
    assert "platform NOT confirmed at a standstill: at 220° it turned, 12 s ago: COILS OFF was pressed" in said

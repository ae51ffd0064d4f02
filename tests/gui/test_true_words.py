"""What was done on purpose is no accident, what is to come is not there yet, COILS OFF is not said to reach all."""

from dataclasses import replace

import pytest
from lab_states import told
from test_hands_in_the_cage import READY, says, send, stands
from test_hands_in_the_cage import real as real
from test_hands_in_the_cage import running as running

from labcal.bench.coils.state import MAY_TURN, Heard, LabState, PlatformReading, unread
from labcal.errors import Stopped
from labcal.gui.ipc.answers import Ended
from labcal.gui.ipc.messages import RunProcedure
from labcal.gui.ipc.wire import Fault, fault_of
from labcal.gui.theming.theme import GRID
from labcal.gui.viewmodels.lab_now import lab_now, platform_said
from labcal.runner.control import GONE, LATER, Later, Left


def test_who_goes_on_later_is_not_told_that_whoever_ran_this_is_gone(running):
    later = fault_of(Later(LATER))
    assert (later.kind, fault_of(Left(GONE)).kind) == ("stopped", "left")
    running.app_state.bench_worker.answer(RunProcedure, Ended("r1", "interrupted", later))
    card = running.page("Run").live.fault
    assert card.heading.text() == "■ Stopped"
    assert not card.save.isVisibleTo(card), "a problem report"
    assert not card.heading.property("state")


def test_a_stop_that_was_asked_for_is_not_written_in_the_colour_of_an_alarm(running):
    live, app_state = running.page("Run").live, running.app_state
    told(running, (0.0, 0.0, None))
    app_state.bench_worker.answer(RunProcedure, Ended("r1", "stopped", fault_of(Stopped("stopped by the operator"))))
    app_state.off.warn(Fault("coils", "z: silent"))
    for fault, mark in ((app_state.run.fault, ""), (Fault("instrument", "dut: lost"), "bad")):
        app_state.run.fault = fault
        app_state.lab.update(message=fault.kind)
        assert live.verdict.reason.text()
        assert live.verdict.reason.property("state") == mark, fault


@pytest.mark.parametrize(
    "text", ["The field goes to 20 µT. Hands off?", "Next the platform looks for its zero. Hands off?"]
)
def test_what_comes_after_the_answer_is_said_as_to_come(running, text):
    says(running, platform=stands())
    send(running, replace(READY, text=text))
    assert running.page("Run").live.prompt.text.text().replace("\N{NO-BREAK SPACE}", " ").startswith("Next")
    assert running.side.hands.text().startswith("▲ Hands off: Next")


def test_coils_off_is_said_to_stop_a_platform_only_where_its_line_answers():
    assert "COILS OFF" not in platform_said(MAY_TURN)
    assert "at its controller" in platform_said(MAY_TURN)
    for now_s in (100.0, 90.5):  # read long ago, and just now
        said = platform_said(PlatformReading(33.0, moving=True, read_s=90.0).sentence(now_s))
        assert "COILS OFF (F12) first: it stops the platform too, if it can be reached" in said
        assert said.endswith("If it keeps turning, stop it at its controller")


@pytest.mark.parametrize(
    ("fault", "driven", "said"),
    [("no sample for 3 s", False, "no answer"), ("", True, "not read in this step"), ("", False, "not read yet")],
)
def test_a_field_that_is_not_shown_says_why(running, fault, driven, said):
    facts = running.app_state.facts
    roles = {name: one.role for name, one in facts.instruments.items()}
    name = next(name for name, role in roles.items() if role == "reference")
    lab = LabState(unread(), instruments=(Heard(name, None if fault else 1.0, fault),))
    now = lab_now(lab, 1.0, roles, 1.0, driven=driven)
    running.show_state(replace(running.app_state.lab.state, now=now))
    assert running.side.field_age.text() == said
    seen = replace(now, field_measured_nT=(1.0, 2.0, 3.0), field_why="")
    running.show_state(replace(running.app_state.lab.state, now=seen))
    assert running.side.field_age.text() == ""


def test_no_empty_line_stands_above_the_words_of_a_card(still):
    still.app_state.fault.emit(Fault("platform", "stage: silent."))
    card = still.fault
    still.resize(1360, 860)
    card.layout().activate()
    assert card.gravest.y() - card.contentsRect().y() <= 3 * GRID

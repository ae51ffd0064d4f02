"""With plugs out: hands out as long as anything is on, turns or is not confirmed, and nothing is said that is past."""

import time
from dataclasses import replace

import pytest
from test_hands_in_the_cage import STEPS, headline, says, send

from labcal.bench.coils.state import CoilReading, Heard, LabState, PlatformReading, Witness
from labcal.bench.guardian.wire import TRIED_AGAIN
from labcal.gui.ipc.answers import Ended
from labcal.gui.ipc.messages import RunProcedure
from labcal.gui.ipc.wire import Fault
from labcal.record.stream import Prompt, Step


@pytest.fixture
def running(still):
    still.app_state.run.start(RunProcedure("preflight", "bench.toml", {}, "EM-07", "J. Doe"))
    send(still, Step(0.0, 1, 4, "zero", 60.0, STEPS, 20.0))
    return still


def turning():
    return PlatformReading(40.0, True, time.monotonic())


def stands():
    return PlatformReading(40.0, False, time.monotonic())


def test_a_supply_that_is_out_is_named_with_hands_off_until_zero_is_confirmed(running):
    says(running, (0.0, 0.0, None), stands(), ("supply_z",))
    assert headline(running) == "HANDS OFF – no answer from supply_z; coils NOT confirmed at zero"
    says(running, (None, None, None), PlatformReading(fault="silent"))
    assert headline(running).startswith("HANDS OFF – ")
    assert headline(running).endswith("coils NOT confirmed at zero, platform may turn")


def test_a_run_that_stops_keeps_hands_out_while_the_platform_turns(running):
    says(running, (0.0, 0.0, 0.0), turning())
    running.app_state.run.abort()
    assert headline(running) == "HANDS OFF – platform turning · Stopping"
    says(running, (0.0, 0.0, 0.0), stands())
    assert headline(running) == "Stopping"


def test_who_says_hands_off_by_try_again_stands_back(running):
    says(running, (0.0, 0.0, 0.0), stands())
    send(running, Prompt(3.0, "failed-zero", "zero: lost", ("stop", "retry")))
    running.app_state.run.answer("retry")
    assert headline(running).startswith("Hands off")


def test_a_refused_hands_off_keeps_its_question_and_its_button_is_grey(running, qtbot):
    card, asked = running.page("Run").live.prompt, "The field goes to 20 µT, and the platform may turn. Hands off?"
    running.open_page("Run")
    still = "Still lost: dut (silent). Put that right first: a step begun now fails again."
    send(running, Prompt(3.0, "ready", f"{still} {asked}", ("done",), True, drawing={"question": asked}))
    says(running, platform=stands(), faulty=("dut",))
    qtbot.waitUntil(lambda: card.alive, timeout=10_000)
    assert not card.choices["done"].isEnabled()
    assert card.text.text() == "✕ No answer from dut"  # in the largest letters; what is asked is below it
    assert card.text.below.text().replace("\N{NO-BREAK SPACE}", " ") == f"Next: {asked}"
    says(running, platform=stands())
    assert card.choices["done"].isEnabled()
    assert card.details.text() == "dut: answers again"
    assert card.text.text().replace("\N{NO-BREAK SPACE}", " ") == f"Next: {asked}"


def test_a_second_click_on_go_on_hits_nothing(running, qtbot):
    live = running.page("Run").live
    running.app_state.run.state = "paused"
    running.app_state.run.changed.emit()
    live.pause.click()
    running.app_state.run.state = "running"
    running.app_state.run.changed.emit()
    assert not live.pause.isEnabled()
    assert not live.stop.isEnabled()
    qtbot.waitUntil(live.stop.isEnabled, timeout=10_000)
    assert live.pause.isEnabled()


def test_who_answers_again_is_blamed_no_more(running):
    app_state, live = running.app_state, running.page("Run").live
    app_state.facts = replace(app_state.facts, virtual_time=False)
    fault = Fault("instrument", "supply_y (tcp://lab:1): no reply in 1.5 s.", TRIED_AGAIN)
    app_state.bench_worker.answer(RunProcedure, Ended("r1", "interrupted", fault))
    running.open_page("Run")
    assert live.fault.isVisibleTo(live)
    now = time.monotonic()
    zero = tuple(CoilReading(a, 0.0, 0.0, True, True, now) for a in "xyz")
    app_state.take_lab(LabState(zero, Witness(), None, (Heard("supply_y", now),), platform=stands()))
    assert not live.fault.isVisibleTo(live)
    assert live.verdict.reason.text() == "supply_y: answers again"

"""With plugs out: hands out as long as anything is on, turns or is not confirmed, and nothing is said that is past."""

import time
from dataclasses import replace
from datetime import UTC, datetime

import pytest
from test_hands_in_the_cage import MOUNT, STEPS, headline, says, send
from test_hands_in_the_cage import real as real

from labcal.bench.coils.state import CoilReading, Heard, LabState, PlatformReading, Witness
from labcal.bench.guardian.wire import TRIED_AGAIN
from labcal.gui.ipc.answers import Ended
from labcal.gui.ipc.messages import RunProcedure
from labcal.gui.ipc.wire import Fault
from labcal.record import Segment
from labcal.record.stream import MEANWHILE, Event, Prompt, SegmentOpened, Step


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
    assert headline(running) == "✕ HANDS OFF – no answer from supply_z; coils NOT confirmed at zero"
    says(running, (None, None, None), PlatformReading(fault="silent"))
    assert headline(running).startswith("✕ HANDS OFF – ")
    assert headline(running).endswith("coils NOT confirmed at zero, platform may turn")


def test_a_run_that_stops_keeps_hands_out_while_the_platform_turns(running):
    says(running, (0.0, 0.0, 0.0), turning())
    running.app_state.run.abort()
    assert headline(running) == "HANDS OFF – COILS OFF: the run stops …"
    says(running, (0.0, 0.0, 0.0), stands())
    assert headline(running) == "HANDS OFF – COILS OFF: the run stops …"  # one sentence, until it has ended


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
    assert card.text.below.text().replace("\N{NO-BREAK SPACE}", " ") == f"Next: t{asked[1:]}"
    says(running, platform=stands())
    assert card.choices["done"].isEnabled()
    assert card.details.text() == "dut: answers again"
    assert card.text.text().replace("\N{NO-BREAK SPACE}", " ") == f"Next: t{asked[1:]}"


def test_what_a_silence_has_moved_stands_on_the_card_until_the_next_turn(real, monkeypatch):
    """It was in the bottom line alone, where nobody looks who has just put a plug in."""
    monkeypatch.setattr(real.app_state.run, "virtual_time", False)
    real.app_state.run.start(RunProcedure("preflight", "bench.toml", {}, "EM-07", "J. Doe"))
    real.open_page("Run")
    card, at = real.page("Run").live.prompt, datetime.now(UTC)
    choices, drawing = ("stop", "retry"), {"no_answer": "stage", "what": "stage: silent."}
    send(real, Step(0.0, 1, 4, "zero", 60.0, STEPS, 20.0), Prompt(3.0, "failed-zero", "lost", choices, drawing=drawing))
    says(real, platform=stands(), faulty=("stage",))
    assert not card.moved.isVisible()
    says(real, platform=stands())
    moved = "after the silence: platform 40.0° before, 57.3° now"
    send(real, Event(9.0, MEANWHILE, moved, {"utc": at.isoformat()}))
    says(real, platform=stands())
    assert card.text.text() == "Every instrument answers again."
    assert card.moved.isVisible()
    assert card.moved.text() == f"{at.astimezone():%H:%M:%S}: {moved}"  # "now" was then
    says(real, platform=stands(), faulty=("stage",))
    assert not card.moved.isVisible()  # it may move anew
    says(real, platform=stands())
    real.app_state.run.answer("retry")
    send(real, Prompt(10.0, "ready", "Hands off?", ("done",), True))
    assert card.moved.isVisible()  # whoever was asked before it was known is told as well
    real.app_state.run.answer("done")
    send(real, SegmentOpened(11.0, Segment("x+20uT-nominal", "rotation")), replace(MOUNT, t_s=12.0))
    assert not card.moved.isVisible()


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

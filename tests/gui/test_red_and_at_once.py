"""What is wrong is red, as large as what stood there before, with its reason, at once; and one stance at a time."""

import time
from dataclasses import replace

import pytest
from test_hands_in_the_cage import STEPS, headline, lab, says, send, stands
from test_hands_in_the_cage import real as real

from labcal.bench.coils.at_zero import ORDERED
from labcal.bench.coils.state import Heard, PlatformReading
from labcal.bench.links.heard_before import NOT_HEARD, PLUG
from labcal.gui.ipc.answers import Ended
from labcal.gui.ipc.messages import RunProcedure
from labcal.gui.ipc.wire import Fault
from labcal.record import Segment
from labcal.record.stream import Event, Prompt, SegmentOpened, Step

FAILED = Prompt(3.0, "failed-z", "z: lost", ("stop", "retry"), drawing={"no_answer": "dut", "what": "dut: silent."})
READY = Prompt(3.0, "ready", "The coils go to 20 µT. Hands off?", ("done",), True)


@pytest.fixture
def running(real):
    real.app_state.run.start(RunProcedure("preflight", "bench.toml", {}, "EM-07", "J. Doe"))
    send(real, Step(0.0, 1, 4, "z+20uT", 60.0, STEPS, 20.0))
    says(real, platform=stands())
    real.open_page("Run")
    return real


def hands(window):
    side = window.side
    return side.hands.text(), side.keep_off.text()


def red(window, name="supply_z"):
    """The card above every page."""
    card = window.fault
    return card.isVisible() and (card.gravest.text(), card.by_hand.text()) == (
        "✕ HANDS OFF: the coils may be on", f"COILS OFF (F12), then switch off by hand: {name}"
    )  # fmt: skip


def test_the_red_card_of_a_supply_that_is_out_in_a_run_comes_as_soon_as_that_is_known(running):
    says(running, (0.0, 0.0, 0.5), platform=stands(moving=True))
    running.app_state.kept.heard |= {"supply_z"}
    assert not running.fault.isVisible()
    says(running, (0.0, 0.0, None), platform=stands(moving=True), faulty=("supply_z",))
    assert red(running)
    says(running, (0.0, 0.0, 0.5), platform=stands())
    assert not running.fault.isVisible(), "it answers, and the run goes on"


def test_so_at_rest_after_coils_off(running):
    app_state = running.app_state
    app_state.run.abort()
    app_state.bench_worker.answer(RunProcedure, Ended("r1", "failed: aborted by the operator"))
    app_state.kept.answered()
    app_state.take_lab(lab(platform=stands()))
    app_state.kept.heard |= {"supply_z"}
    app_state.take_lab(lab((0.0, 0.0, None), platform=stands(), faulty=("supply_z",)))
    assert red(running)
    verdict = running.page("Run").live.verdict
    running.page("Run").live.draw()
    running.page("Run").live.show_verdict()
    assert verdict.word.text().replace("\N{NO-BREAK SPACE}", " ") == "HANDS OFF"


def test_a_supply_that_was_never_heard_is_no_alarm_of_the_morning(real):
    real.app_state.kept.heard.clear()
    silent = (Heard("supply_z", None, "silent"),)
    real.app_state.take_lab(replace(lab((0.0, 0.0, None), platform=stands()), instruments=silent))
    assert not real.fault.isVisible()
    assert hands(real)[1] == "✕ HANDS OFF"


def test_the_headline_of_a_fault_is_red_has_a_cross_and_is_no_smaller_than_what_stood_there(still, qtbot):
    still.app_state.run.start(RunProcedure("preflight", "bench.toml", {}, "EM-07", "J. Doe"))
    send(still, Step(0.0, 1, 4, "z+20uT", 60.0, STEPS, 20.0), SegmentOpened(1.0, Segment("z+20uT", "rotation")))
    still.open_page("Run")
    says(still, (0.0, 0.0, 0.5), platform=stands(moving=True))
    words, before = headline(still), still.page("Run").live.headline
    assert words.startswith("Hands off")
    qtbot.wait(50)
    size, room = before.font().pointSize(), before.minimumHeight()
    assert before.palette().windowText().color().name() == still.theme.bad.lower()  # hands have to be off as well
    says(still, (0.0, 0.0, None), platform=stands(), faulty=("supply_z",))
    assert headline(still) == "✕ HANDS OFF – no answer from supply_z; coils NOT confirmed at zero"
    qtbot.wait(50)
    after = still.page("Run").live.headline
    assert after.font().pointSize() >= size
    assert after.minimumHeight() > room
    assert after.palette().windowText().color().name() == still.theme.bad.lower()


def test_while_coils_are_on_the_reason_says_which_and_that_the_platform_turns(running):
    send(running, SegmentOpened(1.0, Segment("z+20uT", "rotation")))
    says(running, (0.0, 0.0, 1.133), platform=stands(moving=True))
    assert hands(running) == ("Hands off: coils on: z +1.133 A; platform turns", "HANDS OFF")


def test_a_platform_that_is_not_heard_in_a_turn_is_the_headline_from_two_seconds_on(running):
    send(running, SegmentOpened(1.0, Segment("z+20uT", "rotation")))
    says(running, (0.0, 0.0, 0.5), platform=PlatformReading(125.0, True, time.monotonic() - 3.0))
    assert headline(running) == "Hands off · platform turns, at 125°, read 3 s ago"
    assert running.side.platform.property("state") == "old"


def test_the_order_of_zero_is_said_no_longer_once_it_is_read_back(running):
    send(running, Event(2.0, "safety", ORDERED))
    assert running.message.text() == ORDERED
    says(running, platform=stands())
    assert running.message.text().startswith("coils read back at zero by their supplies")


def test_where_the_next_answer_energises_nobody_is_let_in(running):
    card = running.page("Run").live.prompt
    send(running, FAILED)
    says(running, platform=stands(), faulty=("dut",))
    assert hands(running)[0].startswith(("✓ Hands may go in", "● Hands may go in")), "to the plug"
    says(running, platform=stands())
    said = "▲ Hands off: the field and the platform come next"
    assert hands(running) == (said, "▲ Hands off")
    assert card.hands.text() in ("", said)


def test_who_is_silent_at_hands_off_is_the_giant_word(running):
    card = running.page("Run").live.prompt
    send(running, READY)
    says(running, platform=stands(), faulty=("dut",))
    assert card.text.text() == "✕ No answer from dut"
    says(running, platform=stands())
    assert card.text.text().replace("\N{NO-BREAK SPACE}", " ") == f"Next: t{READY.text[1:]}"


def test_closing_in_a_run_says_hands_off_first_and_its_buttons_keep_their_place(running, qtbot):
    says(running, (0.0, 0.0, 0.5), platform=stands())
    running.leaving.may_go()
    question = running.leaving.question
    assert question.layout().itemAt(0).widget() is question.keep_off
    assert (question.keep_off.text(), question.keep_off.property("state")) == (
        "HANDS OFF – coils on: z +0.500 A", "bad"
    )  # fmt: skip
    qtbot.wait(50)
    before = {way: one.pos() for way, one in question.buttons.items()}
    says(running, (0.5, 0.5, 0.5), platform=stands(moving=True))
    question.say_lab("coils on: " + ", ".join(["x +0.5000 A"] * 20), "platform turns, at 40°")
    qtbot.wait(50)
    assert {way: one.pos() for way, one in question.buttons.items()} == before
    question.reject()


def test_what_waits_for_zero_does_not_promise_to_close_once_a_supply_has_failed(running):
    says(running, (0.0, 0.0, 0.5), platform=stands())
    running.leaving.take("stop")
    says(running, (0.0, 0.0, None), platform=stands(), faulty=("supply_z",))
    assert running.leaving.going.heading.text() == "HANDS OFF: not at zero yet. The window does not close by itself."
    running.leaving.going.stays.emit()


@pytest.mark.parametrize("said", ["All 7 instruments answered", "7 of 7 instruments were read"])
def test_that_all_answer_is_said_no_longer_once_one_does_not(real, said):
    real.app_state.take_lab(lab(platform=stands()))
    real.app_state.lab.update(message=said)
    real.app_state.take_lab(lab(platform=stands()))
    assert real.message.text() == said
    real.app_state.take_lab(lab(platform=stands(), faulty=("dut",)))
    assert real.message.text() == "✕ No answer from dut"


def test_who_answered_before_the_run_is_not_looked_for_at_another_link(running):
    app_state = running.app_state
    app_state.kept.heard |= {"supply_z"}
    fault = Fault("instrument", "supply_z (tcp://lab:1): no reply in 1.5 s.", NOT_HEARD[0])
    app_state.bench_worker.answer(RunProcedure, Ended("r1", "interrupted", fault))
    assert app_state.run.fault.remedy == PLUG

"""From the click on Begin, or Go on, until the run has read the coils itself nothing lets hands in."""

import time

import pytest
from test_hands_in_the_cage import STEPS, lab, says, send, stands
from test_hands_in_the_cage import real as real

from labcal.bench.coils.state import FRESH_S
from labcal.gui.ipc.messages import RunProcedure
from labcal.gui.viewmodels.lab_now import WATCHED_S
from labcal.gui.viewmodels.lab_watch import LOOK_MS
from labcal.gui.widgets.prompt_card import STANDS
from labcal.record.stream import Event, Prompt, Step

ORDER = RunProcedure("preflight", "bench.toml", {}, "EM-07", "J. Doe")


def hands(window):
    """In the panel: the words and their state, the large word above them."""
    side = window.side
    return side.hands.text(), side.hands.property("state"), side.keep_off.text()


BEGINS = ("▲ Hands off: the run begins", "off", "▲ Hands off")
GOES_ON = ("▲ Hands off: the run goes on", "off", "▲ Hands off")


@pytest.fixture
def at_zero(real):
    real.app_state.take_lab(lab(platform=stands()))
    assert hands(real)[1] == "alone"
    return real


def test_a_run_that_begins_is_no_time_to_reach_in(at_zero):
    at_zero.app_state.run.start(ORDER)
    assert hands(at_zero) == BEGINS  # at once
    at_zero.app_state.grow_old()
    assert hands(at_zero) == BEGINS
    send(at_zero, Step(0.0, 1, 4, "zero", 60.0, STEPS, 20.0))
    assert hands(at_zero) == BEGINS
    says(at_zero, platform=stands())
    assert hands(at_zero) == GOES_ON


def test_hands_are_let_in_by_a_question_and_by_a_pause_alone(at_zero):
    """In between it was "may go in" for a second, with the platform's search for its zero next."""
    at_zero.app_state.run.start(ORDER)
    send(at_zero, Step(0.0, 1, 4, "zero", 60.0, STEPS, 20.0))
    says(at_zero, platform=stands())
    assert hands(at_zero) == GOES_ON
    send(at_zero, Prompt(0.0, "mount-z", "Mount the DUT with body Z up.", ("done",), acts=True))
    assert hands(at_zero)[1] == "alone"
    at_zero.app_state.run.answer("done")
    send(at_zero, Step(1.0, 2, 4, "z", 60.0, STEPS, 20.0))
    assert hands(at_zero) == GOES_ON


def test_what_a_run_asks_at_once_is_not_hidden_by_the_lab_of_before(still):
    """Else a question that sends hands to the DUT reads "Hands off" until the next look at the ages."""
    still.app_state.grow_old()
    still.app_state.run.start(ORDER)
    send(still, Prompt(0.0, STANDS, "Is the DUT still mounted with body X up?", ("yes", "no"), acts=True))
    assert still.page("Run").live.prompt.text.text().startswith("Is the DUT")


def test_nor_is_one_that_is_gone_on_with(at_zero):
    at_zero.app_state.run.resume("r1", ORDER)
    assert hands(at_zero) == BEGINS


def test_nor_is_one_that_goes_on_after_a_pause(at_zero):
    run = at_zero.app_state.run
    run.start(ORDER)
    says(at_zero, platform=stands())
    send(at_zero, Event(1.0, "pause", "paused", {}))
    assert hands(at_zero)[1] == "alone"
    run.go_on()
    assert hands(at_zero) == BEGINS
    says(at_zero, platform=stands())  # it was on its way before the click
    assert hands(at_zero) == BEGINS
    send(at_zero, Event(2.0, "pause", "goes on", {}))
    says(at_zero, platform=stands())
    assert hands(at_zero) == GOES_ON


def test_a_reason_that_is_known_stays_one(at_zero):
    at_zero.app_state.take_lab(lab((0.0, 0.0, None), platform=stands()))
    at_zero.app_state.run.start(ORDER)
    assert hands(at_zero)[2] == "✕ HANDS OFF"


def test_at_rest_they_are_let_in_by_one_look_and_its_answer(real):
    assert LOOK_MS / 1000 + FRESH_S <= WATCHED_S <= 5.0
    old = lab(platform=stands())
    by = time.monotonic() - WATCHED_S - 0.5
    real.app_state.take_lab(old.shifted(by - time.monotonic()))
    assert hands(real)[1] == "alone"
    assert real.side.hands_age.text() == f"read {WATCHED_S + 1} s ago"
    real.app_state.take_lab(old.shifted(by - time.monotonic() - 1.0))
    assert hands(real)[1] == "off"

"""COILS OFF at rest: a platform that was just read to stand stands still, and one voice says so."""

import time
from dataclasses import replace

import pytest
from test_hands_in_the_cage import lab, says, send, stands, zeros
from test_hands_in_the_cage import real as real

from labcal.bench.coils.state import MAY_TURN, PlatformReading, Witness
from labcal.bench.stage_off import NOT_YET
from labcal.gui.ipc.answers import Ended, SwitchedOff
from labcal.gui.ipc.messages import RunProcedure, SwitchOff
from labcal.gui.viewmodels.hands_now import MAY
from labcal.gui.viewmodels.lab_now import WATCHED_S
from labcal.gui.viewmodels.stood_before import StoodBefore
from labcal.record.stream import Step

AT_REST, AGED, UNKNOWN = (2.0, WATCHED_S + 2.0, None)


def agreed():
    return Witness("agrees", "", (0.0, 0.0, 0.0), (0.0, 0.0, 0.0), 0.0, 2000.0, time.monotonic())


def rests(window, age_s=AT_REST):
    """At rest, the platform read so long ago; None: it was never read."""
    platform = None if age_s is None else stands(age_s=age_s)
    window.app_state.take_lab(replace(lab(platform=platform), reference=agreed()))


def off(window, fault=NOT_YET):
    """F12, answered by who has not seen it stand in time."""
    window.app_state.off.order()
    answer = SwitchedOff(zeros(), platform=PlatformReading(fault=fault))
    window.app_state.off_worker.answer(SwitchOff, answer)
    window.app_state.grow_old()
    return window.app_state.lab.state


def test_one_that_was_read_to_stand_is_no_reason_to_keep_hands_off(real):
    rests(real)
    state = off(real)
    assert state.now.platform_words.startswith("platform stands at 40°, read ")
    assert state.hands[1] in MAY, state.hands
    assert state.keep_off == ("", "")
    assert "not seen to stand" not in state.message
    assert "platform" not in state.message  # nobody has looked since
    real.app_state.take_lab(lab(platform=stands()))
    assert real.app_state.lab.state.message.endswith("; platform stands at 40°")


@pytest.mark.parametrize("age_s", [AGED, UNKNOWN])
def test_one_of_which_that_is_not_known_may_turn(real, age_s):
    rests(real, age_s)
    state = off(real)
    assert (state.now.platform_words, state.hands[1]) == (MAY_TURN, "bad")


def test_one_that_is_kept_by_another_program_may_turn(real):
    rests(real)
    assert off(real, "another process (7) keeps the platform's line and does not stop it").hands[1] == "bad"


def test_pressed_twice_it_stands_still_until_a_run_has_had_it():
    stood, reading = StoodBefore(), PlatformReading(40.0, False, 100.0)
    for at_s in (101.0, 101.0 + 2 * WATCHED_S):
        stood.ordered(reading, at_s, may_be_turned=False)
        assert stood.holds
    stood.ordered(reading, 102.0, may_be_turned=True)
    assert not stood.holds
    stood.run_over(103.0)
    stood.ordered(reading, 103.0, may_be_turned=False)
    assert not stood.holds


def test_what_a_run_read_before_its_last_orders_says_nothing_of_it(still):
    app_state = still.app_state
    app_state.facts = replace(app_state.facts, virtual_time=False)
    app_state.run.start(RunProcedure("preflight", "bench.toml", {}, "EM-07", "J. Doe"))
    send(still, Step(0.0, 1, 4, "zero", 60.0, ("zero",), 20.0))
    says(still, platform=stands())
    app_state.bench_worker.answer(RunProcedure, Ended("r1", "finished", None))
    assert off(still).now.platform_words == MAY_TURN


def test_a_first_reading_ends_what_is_said_of_the_order_at_once(real):
    """And not with the next look at what is shown: in no frame do they stand beside each other."""
    real.app_state.take_lab(lab(platform=stands(moving=True)))
    off(real)
    said = []
    real.app_state.lab.changed.connect(lambda: said.append(real.app_state.lab.state))
    real.app_state.take_lab(lab(platform=stands()))
    assert said
    assert not [
        one.hands
        for one in said
        if one.now.platform_words == "platform stands at 40°" and "ordered to stop" in one.hands[0]
    ]

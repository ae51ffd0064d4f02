"""What is said of hands while a run breaks off, after F12, and where a turn is to come: one sentence, and true."""

from dataclasses import replace

import pytest
from test_hands_in_the_cage import headline, lab, now_s, says, send, stands
from test_hands_in_the_cage import real as real
from test_hands_in_the_cage import running as running

from labcal.bench.coils.state import PlatformReading
from labcal.gui.ipc.wire import Fault
from labcal.gui.viewmodels.coils_off import STOPS_S
from labcal.record.stream import FAULT, Event, Step

GOING = "HANDS OFF – COILS OFF: the run stops …"
NAMES = ("zero", "z+20uT")


def test_from_f12_to_the_end_of_the_run_one_sentence_stands(real, running):
    says(running, (0.4, 0.4, 0.4), platform=stands(moving=True))
    running.app_state.off.order()
    said = {headline(running)}
    for currents, moving in (((0.2, 0.0, 0.0), True), ((0.0, 0.0, 0.0), True), ((0.0, 0.0, 0.0), False)):
        says(running, currents, platform=stands(moving=moving))
        said.add(headline(running))
    assert said == {GOING}


def test_but_a_supply_that_gives_no_answer_is_named_above_it(real, running):
    running.app_state.off.order()
    says(running, (0.0, 0.0, None), platform=stands(), faulty=("supply_z",))
    assert GOING not in headline(running)


def test_nobody_is_sent_to_press_what_was_just_pressed(real):
    app_state, first = real.app_state, "press COILS OFF (F12) first"
    turns = PlatformReading(40.0, True, now_s())
    app_state.take_lab(lab((0.0, 0.0, None), platform=turns))
    app_state.off.warn(Fault("coils", "z: lost"))
    card = real.fault
    assert first in card.turning.text()
    app_state.off.order()
    app_state.take_lab(lab((0.0, 0.0, None), platform=replace(turns, read_s=now_s())))
    assert first not in card.turning.text() + app_state.lab.state.message
    assert "stops it if it can be reached" in card.turning.text()


def test_long_after_it_is_said_again(real):
    app_state = real.app_state
    app_state.off.order()
    app_state.off.pressed = ""
    assert app_state.off.told
    app_state.off._off_s -= STOPS_S + 0.1
    assert not app_state.off.told


@pytest.mark.parametrize(("step", "said"), [("z+20uT", "the platform turns next"), ("zero", "the next field or turn")])
def test_a_turn_that_is_to_come_is_the_reason_while_the_platform_stands(running, step, said):
    send(running, Step(1.0, 2, 2, step, 60.0, NAMES))
    says(running, platform=stands())
    running.app_state.run.hands_off = True
    running.app_state.grow_old()
    assert said in running.side.hands.text()


@pytest.mark.parametrize("how", ["somebody is lost", "the step failed"])
def test_nothing_comes_unasked_where_the_run_breaks_off(running, how):
    send(running, Step(1.0, 2, 2, "zero", 60.0, NAMES))
    running.app_state.run.hands_off = True
    if how == "the step failed":
        send(running, Event(2.0, FAULT, "dut: no sample", {"step": "zero", "fault": "silent"}))
    says(running, platform=stands(), faulty=("dut",) if how == "somebody is lost" else ())
    assert running.side.hands.text().endswith("Hands off: the step is broken off")

"""What the line below says of coils and platform leaves once it holds no longer; what is past is not ordered again."""

from dataclasses import replace

import pytest
from test_field_as_witness import OFF_NT, agreed, hands, read
from test_hands_in_the_cage import LOST, STEPS, lab, now_s, says, send, stands, zeros
from test_hands_in_the_cage import real as real

from labcal.bench.coils.agreement import CHANGED, NO_AMBIENT
from labcal.bench.coils.state import AT_ZERO, FieldReading, PlatformReading, Witness
from labcal.gui.ipc.answers import CoilEnd, SwitchedOff
from labcal.gui.ipc.lab_messages import InstrumentRead
from labcal.gui.ipc.messages import RunProcedure, SwitchOff
from labcal.gui.viewmodels.field_witness import off_as_measured
from labcal.gui.viewmodels.reference_again import seconded
from labcal.record.stream import Step

ORDER = RunProcedure("preflight", "bench.toml", {}, "EM-07", "J. Doe")


def z_lost_after_off(window):
    """F12, and supply z gives no answer to it."""
    window.app_state.take_lab(lab((0.0, 0.0, 1.5), stands()))
    window.app_state.off.order()
    ends = (*zeros()[:2], CoilEnd("z", None, "supply_z: silent", False))
    window.app_state.off_worker.answer(SwitchOff, SwitchedOff(ends, platform=stands()))
    window.app_state.take_lab(lab((0.0, 0.0, None), stands(), ("supply_z",)))


def test_coils_off_that_was_pressed_is_not_ordered_again(real):
    real.app_state.take_lab(lab((0.0, 0.0, None), stands(), ("supply_z",)))
    assert real.fault.by_hand.text() == "COILS OFF (F12), then switch off by hand: supply_z"
    z_lost_after_off(real)
    assert real.fault.by_hand.text() == "Switch off by hand: supply_z"
    assert real.app_state.lab.state.message.startswith("Switch off by hand: supply_z")
    assert ".." not in real.fault.coils.text()


def test_that_who_was_lost_answers_again_stays_and_how_the_coils_were_then_does_not(real):
    z_lost_after_off(real)
    real.app_state.take_lab(lab(platform=stands()))
    line = real.app_state.lab.state
    assert "supply_z: answers again" in line.message
    assert "platform stands at 40°" in line.message
    real.app_state.take_lab(agreed())
    said = real.app_state.lab.state
    assert said.message == line.message.partition("; ")[0]
    assert said.said_at == line.said_at


@pytest.mark.parametrize("answers", [True, False])
def test_who_was_seen_to_stand_has_one_age(real, answers):
    real.app_state.take_lab(replace(lab(platform=stands()), instruments=()))
    seen = stands(age_s=3.0) if answers else PlatformReading(fault="silent")
    real.app_state.off.order()
    real.app_state.off_worker.answer(SwitchOff, SwitchedOff(zeros(), platform=seen))
    now = real.app_state.lab.state.now
    assert (dict(now.heard_old_s).get("stage") == now.platform_old_s == 3) is answers


def test_the_field_of_before_the_order_is_no_heading_of_what_came_of_it(real):
    app_state = real.app_state
    app_state.take_lab(agreed(10.0))
    app_state.take_lab(lab((0.5, 0.0, 0.0), stands()))
    app_state.take_lab(lab((None, 0.0, 0.0), stands(), ("supply_x",)))
    read(real, 48_000.0, None)
    assert real.fault.gravest.text() == "✕ HANDS OFF: a coil is still on, the field says so"
    app_state.off.order()
    app_state.grow_old()
    assert real.fault.gravest.text() == "✕ HANDS OFF: the coils may be on"
    assert "the field says: still on (x" in hands(real)[1]  # with its age


def test_while_a_run_asks_who_is_there_hands_are_off_though_it_has_read_the_coils(real):
    real.app_state.take_lab(agreed())
    real.app_state.run.start(ORDER)
    says(real, platform=stands())  # as one that goes on does, while everybody is asked who he is
    assert real.side.keep_off.text() == "▲ Hands off"
    assert real.app_state.lab.state.hands == ("▲ Hands off: the run begins", "off")
    send(real, Step(0.0, 1, 4, "zero", 60.0, STEPS, 20.0))
    assert real.app_state.lab.state.hands == ("▲ Hands off: the run goes on", "off")


@pytest.mark.parametrize("more_nT", [0.0, 48_000.0])
def test_a_zero_is_compared_with_what_the_reference_saw_just_before(real, more_nT):
    """It agrees, or says nothing: a current of a moment before flows no more."""
    now, facts = now_s(), real.app_state.facts
    off = off_as_measured(OFF_NT, facts, now - 20.0, now)
    seen = FieldReading(None, (OFF_NT[0] + more_nT, *OFF_NT[1:]), now - 0.5)
    known = replace(lab(platform=stands()), field=seen, reference=Witness(why="of before"))
    supplies = tuple(InstrumentRead(f"supply_{a}", f"coil-{a}", a, "", None, False, now, 0.0, True) for a in "xyz")
    found = seconded(known, supplies, (OFF_NT, 2000.0), off).reference
    assert (found.verdict, found.why == "of before") == (("agrees", False) if not more_nT else ("not known", True))
    old = replace(known, field=replace(seen, read_s=now - 5.0))
    assert seconded(old, supplies, (OFF_NT, 2000.0), off).reference.why == "of before"


def test_an_ambient_field_that_was_compared_with_is_not_said_to_be_missing(real):
    now, facts = now_s(), real.app_state.facts
    off = off_as_measured(OFF_NT, facts, now - 20.0, now)
    known = replace(lab((0.0, 0.0, None), stands(), ("supply_z",)), reference=Witness("not known", CHANGED))
    field = InstrumentRead("reference", "reference", "r", "", None, False, now, field_nT=OFF_NT)
    assert seconded(known, (field,), None, off).reference.why != NO_AMBIENT
    assert seconded(known, (field,), None, None).reference.why == NO_AMBIENT


def test_coils_at_zero_and_a_platform_that_stands_are_ticked_alike(still):
    card = still.page("Run").live.fault
    card.show_fault(LOST)
    card.say_coils(AT_ZERO)
    assert (card.coils.text(), card.coils.property("state")) == ("✓ coils at zero", "good")
    card.say_coils("coils NOT confirmed at zero")
    assert (card.coils.text(), card.coils.property("state")) == ("coils NOT confirmed at zero", "")

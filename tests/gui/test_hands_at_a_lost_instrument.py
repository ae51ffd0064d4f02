"""A lost instrument's card says whether hands may go in; who answers again, and who never did, is asked themselves."""

import time

from test_hands_in_the_cage import AMBIENT, lab, read, says, stands, zeros
from test_hands_in_the_cage import real as real
from test_hands_in_the_cage import running as running

from labcal.bench.links.heard_before import LINE, PLUG
from labcal.gui.ipc.answers import Ended, SwitchedOff
from labcal.gui.ipc.lab_messages import InstrumentRead, ReadLab
from labcal.gui.ipc.messages import RunProcedure, SwitchOff
from labcal.gui.ipc.wire import Fault
from labcal.gui.viewmodels.lab_now import WATCHED_S


def test_the_card_of_an_instrument_that_is_lost_says_whether_hands_may_go_in_with_the_age_of_what_was_read(
    real, running, later
):
    app_state, card = running.app_state, running.page("Run").live.fault
    says(running, platform=stands(), faulty=("dut",))
    silent = Fault("instrument", "dut: no sample for 5.0 s.", "Is its plug in at both ends?")
    app_state.bench_worker.answer(RunProcedure, Ended("r1", "interrupted", silent))
    assert card.isVisibleTo(running.page("Run").live)
    assert card.hands.text().startswith("● Hands may go in: coils read back at zero by their supplies")
    later(4.0)
    card.say_hands()
    assert (
        card.hands.text()
        == "● Hands may go in: coils read back at zero by their supplies; no reference has confirmed it · read 4 s ago"
    )
    assert card.hands.isVisibleTo(card)
    later(WATCHED_S)
    card.say_hands()
    assert card.hands.text() == "▲ Hands off: the platform is not being read"
    app_state.watch.look()
    read(running, AMBIENT)
    turned = stands(moving=True, age_s=2.0 * WATCHED_S)
    says(running, platform=turned)
    app_state.take_lab(lab(platform=turned))
    card.say_hands()
    assert card.hands.text() == "✕ Hands off"
    assert "platform NOT confirmed at a standstill" in card.turning.text()  # once on one card


def names_in_a_round(app_state):
    """Who is asked in one look, one question after another."""
    asked = []
    while commands := app_state.watch_worker.commands(ReadLab):
        asked.append(commands[0].names)
        app_state.watch_worker.answer(ReadLab, ())
    return asked


def test_while_such_a_card_is_up_the_coils_are_read_again_beside_who_is_lost(real, running):
    app_state = running.app_state
    says(running, platform=stands(), faulty=("dut",))
    app_state.bench_worker.answer(RunProcedure, Ended("r1", "interrupted", Fault("instrument", "dut: silent.")))
    app_state.watch.look()
    asked = names_in_a_round(app_state)
    assert asked[0] == ("supply_x", "supply_y", "supply_z")
    assert {("dut",), ("stage",)} <= set(asked[1:])


def test_contacts_are_not_said_to_answer_because_their_supplies_do(real):
    def light():
        return next(one for one in real.app_state.lab.state.now.lights if one[0] == "reversers")

    real.app_state.off.order()
    real.app_state.off_worker.answer(SwitchOff, SwitchedOff(zeros()))
    assert light()[1] == "absent"
    real.app_state.watch_worker.answer(ReadLab, ())  # the coils
    (asked,) = real.app_state.watch_worker.commands(ReadLab)
    assert "reversers" in asked.names
    fault, now = Fault("instrument", "reversers: no valid Modbus reply."), time.monotonic()
    silent = InstrumentRead("reversers", "polarity", "modbus-rtu:///dev/ttyUSB1", "", fault, False, now)
    real.app_state.watch_worker.answer(ReadLab, (silent,))
    assert light()[1] == "fault"


def test_who_was_heard_in_this_window_is_looked_for_at_its_plug_and_not_in_the_file(real):
    def dut(identity="", fault=None):
        one = InstrumentRead("dut", "dut", "serial:///dev/ttyUSB0", identity, fault, False, time.monotonic())
        real.app_state.watch.read_again(("dut",))
        real.app_state.watch_worker.answer(ReadLab, (one,))
        return real.app_state.answered["dut"].fault

    silent = Fault("instrument", "dut: no reply in 1 s, nothing came.", f"{LINE} This line is set to 9600 baud, 8N1.")
    assert dut(fault=silent).remedy == silent.remedy
    assert dut(identity="CSV lines") is None
    assert dut(fault=silent).remedy == PLUG


def test_no_other_card_speaks_of_hands(still):
    still.app_state.fault.emit(Fault("input", "This cannot be done."))
    assert not still.fault.hands.isVisibleTo(still.fault)
    still.app_state.fault.emit(Fault("instrument", "dut: silent."))
    assert still.fault.hands.text() == "▲ Hands off: not read yet"

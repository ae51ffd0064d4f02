"""The field tells of a coil that is on, where its supply is silent or says zero, at rest as in a run."""

import time
from dataclasses import replace

import numpy as np
import pytest
from test_hands_in_the_cage import MOUNT, lab, says, send, stands
from test_hands_in_the_cage import real as real
from test_hands_in_the_cage import running as running

from labcal.bench.coils.agreement import BEFORE_HANDS, CHANGED, LIMIT_NT, MOVED
from labcal.bench.coils.before_hands import DRIFT_NT_PER_H
from labcal.bench.coils.state import NOT_SINCE, FieldReading, Witness
from labcal.gui.ipc.lab_messages import InstrumentRead, ReadLab
from labcal.gui.ipc.wire import Fault
from labcal.gui.viewmodels.beside_coils import beside_coils
from labcal.gui.viewmodels.what_happens import what_happens

STILL_ON = "✕ Hands off: the field says: still on (x, +48 µT more than with the coils off, 0 s ago)"
OFF_NT = (20_400.0, 1_150.0, -43_700.0)
SAID = "✕ Hands off: the reference sees +48 µT along x more than with the coils off"


def agreed(age_s=0.0):
    """The lab as it was when supplies and reference said zero, `age_s` ago."""
    read_s = time.monotonic() - age_s
    return replace(lab(platform=stands()), reference=Witness("agrees", "", OFF_NT, OFF_NT, 0.0, 2000.0, read_s))


def read(window, more_nT, supply_x_A=0.0):
    """The watch reads supply x (None: silent) and the reference, which sees so much more along x."""
    now, answers = time.monotonic(), supply_x_A is not None
    fault = None if answers else Fault("instrument", "supply_x: silent.")
    supply = InstrumentRead("supply_x", "coil-x", "x", "", fault, False, now, supply_x_A, answers)
    seen = (OFF_NT[0] + more_nT, *OFF_NT[1:])
    field = InstrumentRead("reference", "reference", "reference", "", None, False, now, field_nT=seen)
    window.app_state.watch.read_again(("supply_x", "reference"))
    window.app_state.watch_worker.answer(ReadLab, (supply, field))


def real_lines(window):
    """The same bench on lines of its own."""
    window.app_state.facts = replace(window.app_state.facts, virtual_time=False)


def hands(window):
    return window.side.keep_off.text(), window.app_state.lab.state.hands[0]


@pytest.mark.parametrize("supply_x_A", [None, 0.0], ids=["silent", "says zero"])
@pytest.mark.parametrize("ago_s", [10.0, 600.0])
def test_at_rest_a_field_that_only_a_coil_makes_keeps_hands_off(real, supply_x_A, ago_s):
    real.app_state.take_lab(agreed(ago_s))
    read(real, 48_000.0, supply_x_A)
    large, said = hands(real)
    assert large == "✕ HANDS OFF"
    assert said.startswith(SAID if supply_x_A is not None else STILL_ON)  # and what else there is


@pytest.mark.parametrize("others_A", [0.0, 0.1], ids=["at zero", "on their way"])
def test_beside_a_supply_that_fell_silent_with_its_current_the_field_says_so_on_panel_and_card(running, others_A):
    """As in a turn: the last agreement stands, what the reference sees since is the run's stream."""
    real_lines(running)
    now = time.monotonic()
    cage = running.app_state.facts.cage
    turn = np.array([0.0, 0.0, 1.1])
    of_turn = np.array(cage.matrix) @ turn
    seen = tuple(np.add(OFF_NT, of_turn).tolist())
    agrees = Witness("agrees", "", seen, seen, 0.0, 2000.0, now)
    says(running, tuple(turn), stands(moving=True), witness=agrees)
    says(running, (others_A, 0.0, None), stands(), ("supply_z",), witness=agrees)  # compared before the plug was out
    was = lab((others_A, 0.0, None), stands(), ("supply_z",))
    running.app_state.take_lab(replace(was, field=FieldReading(None, seen, now)))
    said = f"the field says: still on (z, {of_turn[2] / 1000:+.0f} µT more than with the coils off, 0 s ago)"
    assert hands(running)[1].startswith(f"✕ Hands off: {said}; coils NOT confirmed at zero")
    assert said.replace("the field", "The field") in running.fault.coils.text()  # a sentence of its own there
    assert running.fault.gravest.text() == "✕ HANDS OFF: a coil is still on, the field says so"
    assert "a coil is still on by the field" in what_happens(running.app_state.run, running.app_state.lab.state.now)
    running.app_state.take_lab(replace(was, field=FieldReading(None, OFF_NT, now)))
    assert "still on" not in hands(running)[1] + running.fault.coils.text()
    assert running.fault.gravest.text() == "✕ HANDS OFF: the coils may be on"


@pytest.mark.parametrize("since", ["on the way down", "ordered off", "both"])
def test_what_the_field_said_last_stands_with_its_age_until_it_is_read_again(real, since):
    """On the way down a run shows no reading of before, and after COILS OFF no supply has been read back yet."""
    app_state, now = real.app_state, time.monotonic() - 3.0
    app_state.take_lab(agreed(10.0))
    seen = FieldReading(None, (OFF_NT[0] + 48_000.0, *OFF_NT[1:]), now)
    was = replace(lab((None, 0.0, 0.0), stands(), ("supply_x",)), reference=Witness("disagrees", "another field"))
    app_state.take_lab(replace(was, field=seen))
    said = STILL_ON.replace("0 s ago", "3 s ago")
    assert hands(real)[1].startswith(said)
    if since != "ordered off":
        app_state.take_lab(replace(was, field=FieldReading()))
    if since != "on the way down":
        app_state.off.order()
        assert app_state.lab.state.now.coil_words == NOT_SINCE
    assert hands(real)[1].startswith(said)
    assert beside_coils(app_state.lab.state.now).startswith("The field says: still on")
    app_state.kept.answered()
    app_state.take_lab(replace(was, field=FieldReading(None, OFF_NT, now + 3.0)))
    assert "still on" not in hands(real)[1]


def test_the_field_is_shown_with_its_age_while_the_coils_are_read_back(real):
    real.app_state.take_lab(agreed())
    read(real, 0.0)
    real.app_state.off.order()
    assert real.side.field.values[1].text() != "–"


def test_a_doubt_that_coils_off_left_does_not_silence_the_field(real):
    """What came with it has no figures, and a supply is silent: the reference is read on."""
    real.app_state.take_lab(agreed(10.0))
    doubt = Witness("disagrees", "the reference saw another field")
    real.app_state.take_lab(replace(lab((None, 0.0, 0.0), stands(), ("supply_x",)), reference=doubt))
    read(real, 48_000.0, None)
    assert hands(real)[1].startswith(STILL_ON)


def test_what_a_mounting_makes_does_not_and_it_goes_with_the_field(real):
    real.app_state.take_lab(agreed(600.0))
    read(real, 4_000.0)
    assert hands(real)[0] == ""
    read(real, 48_000.0)
    assert hands(real) == ("✕ HANDS OFF", SAID)
    read(real, 0.0)
    assert hands(real)[0] == ""
    read(real, 48_000.0, None)
    read(real, 0.0, None)
    assert hands(real) == ("✕ HANDS OFF", "✕ Hands off: coils NOT confirmed at zero")


def test_a_reference_that_was_moved_tells_nothing(real):
    real.app_state.take_lab(agreed(600.0))
    real.app_state.take_lab(replace(lab(platform=stands()), reference=Witness(why=MOVED)))
    read(real, 48_000.0)
    assert hands(real)[0] == ""


def test_at_a_mounting_in_a_run_as_well(running):
    send(running, MOUNT)
    now = time.monotonic()
    more = Witness("not known", CHANGED, (OFF_NT[0] - 48_000.0, *OFF_NT[1:]), OFF_NT, 48_000.0, 4_500.0, now)
    says(running, platform=stands(), witness=more)
    assert running.page("Run").live.prompt.hands.text() == SAID.replace("+48", "−48")
    assert running.side.keep_off.text() == "✕ HANDS OFF"


def test_at_rest_a_zero_is_seen_by_the_ambient_field_that_the_run_had_measured(real):
    """As long after it as hands mount: by the rule of a mounting, and it does not grow young by being looked at."""
    real.app_state.take_lab(agreed(600.0))
    real.app_state.take_lab(lab(platform=stands()))  # the run broke off: nobody asked the reference since
    first = real.app_state.kept.off(real.app_state.facts, time.monotonic())
    for _ in range(2):
        read(real, 100.0, 0.001)  # a supply that says zero says some mA: they are not taken off again and again
        assert real.app_state.known.reference.verdict == "agrees"
        assert real.app_state.known.reference.why == BEFORE_HANDS
    assert real.app_state.kept.off(real.app_state.facts, time.monotonic()).field_nT == first.field_nT
    assert real.app_state.kept.off(real.app_state.facts, time.monotonic()).limit_nT >= first.limit_nT
    read(real, 3_000.0)  # more than a place wanders, less than a coil that matters: a mounting may have made it
    assert (real.app_state.known.reference.verdict, real.app_state.known.reference.why) == ("not known", BEFORE_HANDS)


def test_how_old_an_ambient_field_is_that_a_run_was_given(real):
    """Go on took it from its record, an hour old: what was seen by it is no younger."""
    now = time.monotonic()
    seen = Witness("agrees", BEFORE_HANDS, OFF_NT, OFF_NT, 0.0, LIMIT_NT + DRIFT_NT_PER_H, now)
    real.app_state.take_lab(replace(lab(platform=stands()), reference=seen))
    off = real.app_state.kept.off(real.app_state.facts, now)
    assert off.limit_nT == pytest.approx(LIMIT_NT + DRIFT_NT_PER_H)

"""The field tells of a coil that is on, where its supply is silent or says zero, at rest as in a run."""

import time
from dataclasses import replace

import pytest
from test_hands_in_the_cage import MOUNT, lab, says, send, stands
from test_hands_in_the_cage import real as real
from test_hands_in_the_cage import running as running

from labcal.bench.coils.agreement import CHANGED, MOVED
from labcal.bench.coils.state import Witness
from labcal.gui.ipc.lab_messages import InstrumentRead, ReadLab
from labcal.gui.ipc.wire import Fault

OFF_NT = (20_400.0, 1_150.0, -43_700.0)
SAID = "▲ Hands off: the reference sees +48 µT along x more than with the coils off"


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


def hands(window):
    return window.side.keep_off.text(), window.app_state.lab.state.hands[0]


@pytest.mark.parametrize("supply_x_A", [None, 0.0], ids=["silent", "says zero"])
@pytest.mark.parametrize("ago_s", [10.0, 600.0])
def test_at_rest_a_field_that_only_a_coil_makes_keeps_hands_off(real, supply_x_A, ago_s):
    real.app_state.take_lab(agreed(ago_s))
    read(real, 48_000.0, supply_x_A)
    large, said = hands(real)
    assert large == "HANDS OFF"
    assert said.startswith(SAID)  # and what else there is


def test_what_a_mounting_makes_does_not_and_it_goes_with_the_field(real):
    real.app_state.take_lab(agreed(600.0))
    read(real, 4_000.0)
    assert hands(real)[0] == ""
    read(real, 48_000.0)
    assert hands(real) == ("HANDS OFF", SAID)
    read(real, 0.0)
    assert hands(real)[0] == ""
    read(real, 48_000.0, None)
    read(real, 0.0, None)
    assert hands(real) == ("HANDS OFF", "▲ Hands off: coils NOT confirmed at zero")


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
    assert running.side.keep_off.text() == "HANDS OFF"

"""What the reference saw with the coils off is kept for the next run and after COILS OFF, as long as it tells."""

import time
from dataclasses import replace

import pytest
from test_field_as_witness import OFF_NT, agreed, hands, real_lines
from test_hands_in_the_cage import lab, stands
from test_hands_in_the_cage import real as real

from labcal.bench.coils.agreement import NO_AMBIENT
from labcal.bench.coils.state import FieldReading, Witness
from labcal.gui.ipc.answers import CoilEnd, Doubt, SwitchedOff
from labcal.gui.ipc.lab_messages import InstrumentRead, ReadLab
from labcal.gui.ipc.messages import RunProcedure, SwitchOff
from labcal.gui.viewmodels.lab_heard import looked_at

BY_FIELD = "coils at zero, by their supplies and by the field"
ORDER = RunProcedure("rotate-axis", "bench.toml", {}, "EM-07", "J. Doe")


def begins(window, field):
    """A run that has measured no ambient field yet says how the lab is."""
    state = window.app_state
    known = replace(lab(platform=stands()), reference=Witness(why=NO_AMBIENT), field=field)
    state.bench_worker.states.emit(known)
    return state.lab.state.now


@pytest.fixture
def at_rest(real):
    real_lines(real)
    real.app_state.take_lab(agreed(20.0))
    return real


def test_the_next_run_has_it_still(at_rest):
    at_rest.app_state.run.start(ORDER)
    assert begins(at_rest, FieldReading(None, OFF_NT, time.monotonic())).coil_words == "coils at zero"


def test_until_the_reference_was_read_in_that_run_it_is_said_when_it_agreed(at_rest):
    at_rest.app_state.run.start(ORDER)
    assert "agreed when it was last looked at" in begins(at_rest, FieldReading()).coil_words


@pytest.mark.parametrize("more_nT", [30_000.0, 4_000.0])
def test_a_field_that_is_another_one_confirms_nothing_there(at_rest, more_nT):
    at_rest.app_state.run.start(ORDER)
    seen = FieldReading(None, (OFF_NT[0] + more_nT, *OFF_NT[1:]), time.monotonic())
    assert begins(at_rest, seen).coil_words == f"zero by the supply's word only: {NO_AMBIENT}"


def switched(window):
    window.app_state.off.order()
    ends = tuple(CoilEnd(axis, 0.0, "zero, open", True, time.monotonic()) for axis in "xyz")
    window.app_state.off_worker.answer(SwitchOff, SwitchedOff(ends, platform=stands()))


def test_coils_off_at_rest_takes_no_agreement_back(at_rest):
    switched(at_rest)
    assert "the reference agreed when it was last looked at" in hands(at_rest)[1]


def test_coils_off_with_a_current_does(at_rest):
    """It agreed with the field of that current."""
    at_rest.app_state.take_lab(replace(lab((0.0, 0.0, 1.1), stands()), reference=agreed().reference))
    switched(at_rest)
    assert "no reference has confirmed it" in hands(at_rest)[1]


def test_a_doubt_that_was_lifted_without_figures_leaves_what_was_measured(at_rest):
    state = at_rest.app_state
    state.take_lab(looked_at(state.known, Doubt("", True)), lifted=True)
    switched(at_rest)
    seen = InstrumentRead("reference", "reference", "", "", None, False, time.monotonic(), field_nT=OFF_NT)
    state.watch.stop()
    state.watch.read_again(("reference",))
    state.watch_worker.answer(ReadLab, (seen,))
    assert BY_FIELD in hands(at_rest)[1]

"""What is said of coils and hands goes by the newest readings, be they worse or better than what was said before."""

from dataclasses import replace

import pytest
from test_field_as_witness import OFF_NT, agreed, hands, read
from test_hands_in_the_cage import lab, now_s, stands
from test_hands_in_the_cage import real as real

from labcal.bench.coils.before_hands import MOUNTING_NT
from labcal.bench.coils.state import Witness
from labcal.gui.ipc.messages import Identify
from labcal.gui.ipc.wire import Fault
from labcal.gui.viewmodels.field_witness import off_as_measured

DOUBT = Witness("disagrees", "it sees another field", advice="open the output of supply_x at its panel")


def doubted(window):
    """Coils that read zero by now, with a doubt of before, and its card."""
    window.app_state.take_lab(agreed(10.0))
    window.app_state.take_lab(replace(lab(platform=stands()), reference=DOUBT))
    window.app_state.off.warn(Fault("coils", "NOT at zero by the reference"))


def test_a_doubt_goes_with_the_first_reading_by_which_coils_and_field_are_at_rest(real):
    doubted(real)
    assert hands(real)[0] == "✕ HANDS OFF"
    assert real.fault.isVisible()
    asked = len(real.app_state.off_worker.commands(Identify))
    read(real, 0.0)
    assert hands(real)[0] == ""
    assert not real.fault.isVisible()
    assert len(real.app_state.off_worker.commands(Identify)) == asked + 1  # who keeps the doubt is told


@pytest.mark.parametrize(("more_nT", "supply_x_A"), [(48_000.0, 0.0), (0.0, None)])
def test_it_stays_while_either_of_them_is_not(real, more_nT, supply_x_A):
    doubted(real)
    read(real, more_nT, supply_x_A)
    assert hands(real)[0] == "✕ HANDS OFF"
    assert real.fault.isVisible()


@pytest.mark.parametrize(("had_A", "said"), [(0.5, True), (0.0, False)])
def test_beside_a_supply_that_fell_silent_with_its_current_a_small_field_is_a_coils(real, had_A, said):
    app_state = real.app_state
    off = off_as_measured(OFF_NT, app_state.facts, now_s(), now_s())
    small = (off.beside_silent_nT + off.least_nT) / 2
    assert MOUNTING_NT < small < off.least_nT
    app_state.take_lab(agreed(10.0))
    app_state.take_lab(lab((had_A, 0.0, 0.0), stands()))
    app_state.take_lab(lab((None, 0.0, 0.0), stands(), ("supply_x",)))
    read(real, small, None)
    assert ("still on" in hands(real)[1]) is said

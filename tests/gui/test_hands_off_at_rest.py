"""At rest HANDS OFF is as loud as in a run where a reason is known; what nobody has read yet alarms nobody."""

from dataclasses import replace

import pytest
from test_hands_in_the_cage import lab, stands
from test_hands_in_the_cage import real as real

from labcal.bench.coils.state import Heard, LabState, unread
from labcal.gui.theming.theme import GRID

SILENT = (Heard("stage", None, "silent"),)
KNOWN = {
    "a coil on": lambda: lab((0.0, 0.0, 0.4), platform=stands()),
    "a supply silent": lambda: lab((0.0, 0.0, None), platform=stands()),
    "the platform turns": lambda: lab(platform=stands(moving=True)),
    "the platform silent": lambda: replace(lab(platform=stands()), instruments=SILENT),
    "the platform silent for long": lambda: replace(lab(platform=stands(age_s=60.0)), instruments=SILENT),
    "a supply silent that was never read": lambda: LabState(unread(), instruments=(Heard("supply_z", None, "silent"),)),
}


def at(window):
    """What stands largest, in the bar and in the panel, and its state."""
    top, side = window.top.keep_off, window.side.keep_off
    assert (top.text(), top.isVisible()) == (side.text(), side.isVisible())
    assert top.property("state") == side.property("state")
    return side.text(), side.property("state") if side.text() else ""


@pytest.mark.parametrize("why", KNOWN)
def test_a_reason_that_is_known_is_hands_off_on_every_page(real, why):
    real.app_state.take_lab(KNOWN[why]())
    for page in real.lazy_pages:
        real.open_page(page)
        assert at(real) == ("HANDS OFF", "bad")
    assert real.side.keep_off.fontMetrics().height() > 2 * GRID
    real.app_state.take_lab(lab(platform=stands()))
    assert at(real) == ("", "")


def test_a_bench_that_nobody_has_read_yet_is_calm(real):
    real.app_state.take_lab(LabState(unread()))
    assert at(real) == ("▲ Hands off", "warning")
    assert (real.side.hands.text(), real.side.hands.property("state")) == ("▲ Hands off: not read yet", "warning")


def test_a_simulated_lab_whose_run_is_over_is_no_alarm(still):
    still.app_state.take_lab(replace(lab(platform=stands()), instruments=SILENT))
    assert at(still) == ("", "")

"""At rest HANDS OFF is as loud as in a run where a reason is known; what nobody has read yet alarms nobody."""

from dataclasses import replace

import pytest
from test_hands_in_the_cage import lab, stands
from test_hands_in_the_cage import real as real

from labcal.bench.coils.state import Heard, LabState, unread
from labcal.gui.ipc.messages import RunProcedure
from labcal.gui.theming.theme import GRID
from labcal.gui.viewmodels.run import RunViewModel
from labcal.record.stream import Step

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
        assert at(real) == ("✕ HANDS OFF", "bad")
    assert real.side.keep_off.fontMetrics().height() > 2 * GRID
    real.app_state.take_lab(lab(platform=stands()))
    assert at(real) == ("", "")


def test_a_bench_that_nobody_has_read_yet_is_calm(real):
    real.app_state.take_lab(LabState(unread()))
    assert at(real) == ("▲ Hands off", "off")
    assert (real.side.hands.text(), real.side.hands.property("state")) == ("▲ Hands off: not read yet", "off")


@pytest.mark.parametrize("why", KNOWN)
def test_in_a_simulated_lab_as_well_it_is_read_as_a_real_one(still, why):
    still.app_state.take_lab(KNOWN[why]())
    assert at(still) == ("✕ HANDS OFF", "bad")
    still.app_state.take_lab(lab(platform=stands()))
    assert at(still) == ("", "")


def test_a_platform_of_a_simulated_lab_that_was_read_long_ago_lets_nobody_in(still):
    still.app_state.take_lab(lab(platform=stands(age_s=58.0)))
    assert still.side.hands.text() == "▲ Hands off: the platform is not being read"
    assert still.app_state.off.to_be_read()[-1] == "stage"


def test_a_bench_that_is_open_and_was_not_read_keeps_hands_off_at_once(still):
    """Simulated or not: the panel said nothing of hands until the first look."""
    assert still.app_state.facts.virtual_time
    assert still.app_state.known is None
    panel = still.side
    assert (panel.may_go_in.text(), panel.hands.text(), panel.hands_group.isVisible()) == (
        "▲ Hands off", "▲ Hands off: not read yet", True,
    )  # fmt: skip
    assert at(still) == ("▲ Hands off", "off")


@pytest.mark.parametrize("end", [RunViewModel.stop, RunViewModel.abort])
def test_once_the_end_is_ordered_nothing_comes_unasked(still, end):
    run, panel = still.app_state.run, still.side
    run.start(RunProcedure("preflight", "bench.toml", {}, "EM-07", "J. Doe"))
    still.app_state.bench_worker.items.emit((Step(0.0, 1, 2, "x-1", 60.0, ("x-1", "x-2")),))
    run.hands_off = True
    run.changed.emit()
    assert panel.hands.text() == "Hands off: the next field or turn comes unasked"
    end(run)
    assert (panel.keep_off.text(), panel.hands.text()) == ("HANDS OFF", "Hands off: stopping")

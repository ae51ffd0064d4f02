"""What a turn has not seen is said by angle where the turn can be mended; nothing is ticked while the field is on."""

import pytest

from labcal.bench.coils.state import AT_ZERO
from labcal.gui.ipc.messages import RunProcedure
from labcal.gui.viewmodels.lab_now import platform_mark
from labcal.record.stream import COVERAGE, NOT_USED, Event, Measurement, Step

TURN = "z+20uT-nominal"
MISSED = Event(2.0, COVERAGE, f"{TURN}: not seen: 30°–58°", {"segment": TURN, "gaps_deg": [[30.0, 58.0]]})


@pytest.fixture
def running(still):
    still.open_page("Run")
    still.app_state.run.start(RunProcedure("preflight", "bench.toml", {}, "EM-07", "J. Doe"))
    say(still, Step(0.0, 1, 1, TURN, 60.0, (TURN,)))
    return still


def say(window, *items):
    window.app_state.bench_worker.items.emit(items)


def test_a_stretch_that_a_turn_has_not_seen_stands_at_the_light_of_its_axis_by_angle(running):
    say(running, MISSED, Measurement(3.0, f"{TURN}: missing sectors", 2.0, 0.0, "", 0.0))
    looks = running.page("Run").live.lights.looks
    assert "✕&nbsp;coverage" in looks["z"].text()
    assert "(not seen: 30°–58°)" in looks["z"].text()
    assert "not seen" not in looks["x"].text()
    assert running.app_state.run.message == f"{TURN}: not seen: 30°–58°"


def test_it_is_gone_where_that_turn_is_not_used(running):
    say(running, MISSED, Event(4.0, NOT_USED, "not used", {"segments": [TURN], "reason": "lift"}))
    assert "not seen" not in running.page("Run").live.lights.looks["z"].text()


def test_that_the_platform_stands_is_no_tick_while_the_coils_are_on():
    stands = "platform stands at 0°"
    assert platform_mark(stands, AT_ZERO) == ("✓", "good")
    assert platform_mark(stands, "coils on: x +0.4000 A") == ("■", "")
    assert platform_mark(f"{stands}, read 34 s ago") == ("◌", "old")  # nor is what was read long ago
    assert platform_mark("platform turns, at 12°", "coils on: x +0.4000 A") == ("●", "warning")

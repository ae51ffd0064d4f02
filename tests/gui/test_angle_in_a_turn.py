"""The platform's angle in a turn is as old as every other value: from 2 s on grey, with its age, wherever it stands."""

import time

import pytest
from test_hands_in_the_cage import MOUNT, headline, says, send
from test_hands_in_the_cage import running as running

from labcal.bench.coils.state import FRESH_S, PlatformReading


def turns(age_s):
    return PlatformReading(71.0, True, time.monotonic() - age_s)


def row(window):
    bench = window.page("Bench")
    bench.show_readings()
    at = next(r for r in range(bench.table.rowCount()) if bench.table.text(r, 0) == "platform")
    return bench.table.text(at, 4)


@pytest.mark.parametrize("age_s", [FRESH_S + 1.0, 7.0])
def test_an_angle_that_nobody_reads_any_more_says_so(running, age_s):
    says(running, (0.0, 0.0, 0.5), platform=turns(age_s))
    said = running.side.platform
    assert (said.text(), said.property("state")) == (f"◌ platform turns, at 71°, read {age_s:.0f} s ago", "old")
    assert row(running) == f"+71.0°   {age_s:.0f} s ago"
    assert running.side.keep_off.text() == "HANDS OFF"  # it turns still, for all that is known
    assert headline(running).startswith("Hands off")
    send(running, MOUNT)
    card = running.page("Run").live.prompt
    assert card.stands.text() == said.text()
    assert card.drawing.platform_words() == f"platform at 71°, {age_s:.0f} s ago"
    assert card.hands.text() == "Hands off: coils on: z +0.500 A; platform turns"


def test_a_fresh_one_has_no_age(running):
    says(running, (0.0, 0.0, 0.5), platform=turns(0.0))
    assert (running.side.platform.text(), row(running)) == ("● platform turns, at 71°", "+71.0°")

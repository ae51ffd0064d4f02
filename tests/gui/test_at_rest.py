"""Lab at rest, and the order to reach in: one sentence that stays, at its size, on every page; nothing flickers."""

import time
from dataclasses import replace

import pytest
from test_hands_in_the_cage import MOUNT, READY, headline, lab, says, send, stands
from test_hands_in_the_cage import real as real
from test_hands_in_the_cage import running as running

from labcal.bench.coils.agreement import CHANGED
from labcal.bench.coils.state import FRESH_S, LabState, PlatformReading, Witness, unread
from labcal.gui.viewmodels.lab_now import WATCHED_S
from labcal.gui.viewmodels.off_headline import off_headline


def read(age_s, verdict="agrees"):
    """A lab at rest that was read `age_s` ago."""
    now = time.monotonic()
    known = lab(platform=stands(age_s=age_s), witness=Witness(verdict, "", read_s=now - age_s))
    return replace(known, coils=tuple(replace(coil, read_s=now - age_s) for coil in known.coils))


@pytest.mark.parametrize("verdict", ["agrees", "not known"])
def test_after_coils_off_the_headline_is_one_as_long_as_the_watch_reads(real, verdict):
    said = set()
    for age_s in (0.0, FRESH_S + 0.5, WATCHED_S - 2.0):
        real.app_state.take_lab(read(age_s, verdict))
        said.add(off_headline(real.app_state.lab.state.now))
    assert said == {
        ("✓ COILS OFF: coils at zero, platform stands", "good")
        if verdict == "agrees"
        else ("■ COILS OFF: coils at zero, platform stands", "")
    }
    real.app_state.take_lab(read(WATCHED_S + 2.0, verdict))
    assert off_headline(real.app_state.lab.state.now)[1] == "warning"


def test_a_platform_that_the_run_turns_is_not_read_for_a_moment_and_alarms_nobody(running):
    says(running, platform=PlatformReading(0.0, True, time.monotonic() - FRESH_S - 1.0))
    assert running.side.platform.text() == "● platform turns, at 0°"
    assert headline(running).startswith("Hands off · ")
    says(running, platform=PlatformReading(0.0, True, time.monotonic() - WATCHED_S - 2.0))
    assert "NOT confirmed" in running.side.platform.text()
    says(running, platform=PlatformReading(fault="silent"))
    assert headline(running).startswith("HANDS OFF – ")

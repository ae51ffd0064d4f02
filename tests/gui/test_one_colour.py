"""Whether hands may go in has one colour at each moment: green where both witnesses say so, amber where one does."""

import time
from dataclasses import replace

import pytest
from PySide6.QtWidgets import QLabel
from test_hands_in_the_cage import MOUNT, send
from test_hands_in_the_cage import real as real
from test_hands_in_the_cage import running as running

from labcal.bench.coils.agreement import NO_AMBIENT
from labcal.bench.coils.state import REFERENCE_SILENT, CoilReading, LabState, PlatformReading, Witness
from labcal.gui.viewmodels.lab_now import WATCHED_S

AGREES = Witness("agrees", "", (0.0, 0.0, 0.0), (0.0, 0.0, 0.0), 0.0, 2000.0)
SILENT, NONE = Witness(why=REFERENCE_SILENT), Witness(why=NO_AMBIENT)


def read(witness, ago_s):
    at_s = time.monotonic() - ago_s
    coils = tuple(CoilReading(axis, None, 0.0, True, None, at_s) for axis in "xyz")
    seen = replace(AGREES, read_s=at_s) if witness is AGREES else witness
    return LabState(coils, seen, platform=PlatformReading(0.0, moving=False, read_s=at_s))


@pytest.mark.parametrize("ago_s", [0.0, 1.0, 2.5, 3.5])
@pytest.mark.parametrize("witness", [AGREES, SILENT, NONE], ids=["both", "silent", "none"])
def test_at_a_mounting_no_word_of_the_zero_has_another_colour(real, running, witness, ago_s):
    send(running, MOUNT)
    running.app_state.bench_worker.states.emit(read(witness, ago_s))
    places = running.side.hands_group, running.page("Run").live.prompt
    shown = [one for place in places for one in place.findChildren(QLabel) if one.isVisible()]
    of_zero = {one.text(): one.property("state") for one in shown if "zero" in one.text() or "Hands" in one.text()}
    assert len(of_zero) >= 2
    assert set(of_zero.values()) == {"good" if witness is AGREES else "alone"}, of_zero
    assert not any("not watched since" in text for text in of_zero)


@pytest.mark.parametrize("witness", [AGREES, SILENT, NONE], ids=["both", "silent", "none"])
def test_what_is_older_than_it_may_be_is_not_green_anywhere(real, running, witness):
    send(running, MOUNT)
    running.app_state.bench_worker.states.emit(read(witness, WATCHED_S + 1.5))
    places = running.side.hands_group, running.page("Run").live.prompt
    shown = [one for place in places for one in place.findChildren(QLabel) if one.isVisible()]
    assert "good" not in {one.property("state") for one in shown if "zero" in one.text() or "Hands" in one.text()}


def test_at_rest_the_words_stay_and_only_the_age_changes(real):
    said = []
    for ago_s in (0.5, 2.5, 3.5):
        real.app_state.take_lab(read(NONE, ago_s))
        said.append(real.side.hands.text())
    assert said[0] == "● Hands may go in: coils read back at zero by their supplies; " + NO_AMBIENT
    assert [one.replace(", 2 s ago", "").replace(", 3 s ago", "") for one in said] == [said[0]] * 3

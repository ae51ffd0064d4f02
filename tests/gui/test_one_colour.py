"""Whether hands may go in has one colour: green by two witnesses, amber by one, red where they may not."""

import time
from dataclasses import replace

import pytest
from PySide6.QtWidgets import QLabel
from test_hands_in_the_cage import MOUNT, READY, says, send, stands
from test_hands_in_the_cage import real as real
from test_hands_in_the_cage import running as running
from test_hands_off_everywhere import settle

from labcal.bench.coils.agreement import NO_AMBIENT
from labcal.bench.coils.state import REFERENCE_SILENT, CoilReading, LabState, PlatformReading, Witness
from labcal.gui.theming.theme import DARK, HANDS, LIGHT, state_ink
from labcal.gui.viewmodels.lab_now import WATCHED_S
from labcal.gui.widgets.close_question import CloseQuestion
from labcal.record import Segment
from labcal.record.stream import SegmentClosed, SegmentOpened

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


KEEPS_OFF = "● on", "● platform turns", "● coils on"  # what is amber would be that hands may go in
OF_HANDS = (
    *KEEPS_OFF,
    "▲ Hands off",
    "✕ HANDS OFF",
    "HANDS OFF",
    "Hands off",
    "✓ Hands may",
    "● Hands may",
    "hands off,",
)
LIGHTS = {"red": "bad", "amber": "warning", "green": "good"}


def inks(window):
    """Of every place in sight that says whether hands may go in: its words and its colour on the screen."""
    window.page("Run").live.draw()
    shown = [one for one in window.findChildren(QLabel) if one.isVisible() and one.text().startswith(OF_HANDS)]
    return {one.text(): one.palette().windowText().color().name() for one in shown}


@pytest.fixture(params=[LIGHT, DARK], ids=lambda t: t.name)
def theme(running, request):
    was = running.theme
    running.open_page("Run")
    running.set_theme(request.param)
    settle(running)
    yield request.param
    running.set_theme(was)
    settle(running)


def light(window, theme):
    """The one colour of all of them."""
    settle(window)
    shown = inks(window)
    assert len(shown) >= 2, shown
    names = {name for ink in set(shown.values()) for name, of in LIGHTS.items() if ink == getattr(theme, of)}
    assert len(set(shown.values())) == len(names) == 1, shown
    return names.pop()


def test_all_places_show_one_light_and_every_no_is_red(real, running, theme):
    for witness, may in ((AGREES, "green"), (SILENT, "amber")):
        send(running, MOUNT)
        running.app_state.bench_worker.states.emit(read(witness, 0.0))
        assert light(running, theme) == may
        send(running, READY)  # they go out now
        assert light(running, theme) == "red"
        running.app_state.run.answer("done")
        send(running, SegmentOpened(4.0, Segment("z+20uT", "rotation")))  # a turn as it was planned
        assert light(running, theme) == "red"
        send(running, SegmentClosed(5.0))
    send(running, MOUNT)
    running.app_state.bench_worker.states.emit(read(NONE, WATCHED_S + 1.5))
    assert light(running, theme) == "red"  # not read any more


def test_a_turn_as_planned_and_a_fault_are_red_and_told_apart_by_shape(real, running, theme):
    send(running, SegmentOpened(4.0, Segment("z+20uT", "rotation")))
    says(running, (0.4, 0.4, 0.4), platform=stands(moving=True))
    planned = {running.side.keep_off.text(), running.top.keep_off.text(), *inks(running)}
    assert not [one for one in planned if "✕" in one]
    assert light(running, theme) == "red"
    says(running, (0.4, 0.4, 0.4), faulty=("dut",))
    assert running.side.keep_off.text() == running.top.keep_off.text() == "✕ HANDS OFF"
    assert running.page("Run").live.headline.text().startswith("✕ HANDS OFF")
    assert light(running, theme) == "red"


def test_the_question_on_closing_has_the_same_light(real, running, qtbot):
    asked = CloseQuestion(running, "EM-07", resumable=True)
    qtbot.addWidget(asked)
    asked.setStyleSheet(running.sheet())
    for state, of in HANDS.items():
        asked.say_hands("▲ Hands off: x" if of == "bad" else "● Hands may go in: x", state)
        asked.keep_off.ensurePolished()
        assert (
            asked.keep_off.palette().windowText().color().name()
            == state_ink(running.theme, state)
            == getattr(running.theme, of)
        )

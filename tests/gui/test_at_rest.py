"""Lab at rest, and the order to reach in: one sentence that stays, at its size, on every page; nothing flickers."""

import time
from dataclasses import replace

import numpy as np
import pytest
from test_hands_in_the_cage import MOUNT, READY, headline, lab, says, send, stands
from test_hands_in_the_cage import real as real
from test_hands_in_the_cage import running as running

from labcal.bench.coils.agreement import CHANGED
from labcal.bench.coils.state import FRESH_S, CoilReading, FieldReading, LabState, PlatformReading, Witness, unread
from labcal.gui.ipc.answers import Ended
from labcal.gui.ipc.messages import RunProcedure
from labcal.gui.ipc.wire import Fault
from labcal.gui.viewmodels.lab_now import HOMES_S, WATCHED_S
from labcal.gui.viewmodels.off_headline import off_headline
from labcal.record import Segment
from labcal.record.stream import Event, SegmentOpened


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
    assert running.side.platform.text() == "◌ platform turns, at 0°, read 3 s ago"
    assert headline(running).startswith("Hands off · ")
    says(running, platform=PlatformReading(0.0, True, time.monotonic() - HOMES_S - 2.0))
    assert "NOT confirmed" in running.side.platform.text()
    says(running, platform=PlatformReading(fault="silent"))
    assert headline(running).startswith("✕ HANDS OFF – ")


def card_of(window):
    return window.page("Run").live.prompt


def lives(card):
    """Once it was seen for a second."""
    card.alive = True
    card.say_lost([])
    return [one.isEnabled() for one in card.choices.values()]


KEPT_OUT = [  # coils, platform turns, what the reference says; what stands largest, whether it can be answered
    ((0.0, 0.0, 0.0), False, "", "", True),
    ((0.0, 0.0, 0.4), False, "", "HANDS OFF", False),
    ((0.0, 0.0, None), False, "", "✕ HANDS OFF", False),
    ((0.0, 0.0, 0.0), True, "", "HANDS OFF", False),
    ((0.0, 0.0, 0.0), False, CHANGED, "▲ Hands off", True),  # what was mounted may be as magnetic
]


@pytest.mark.parametrize(("currents", "turns", "why", "said", "answered"), KEPT_OUT)
def test_an_order_to_reach_in_waits_grey_while_hands_are_kept_out(running, currents, turns, why, said, answered):
    send(running, MOUNT)
    says(running, currents, platform=stands(moving=turns), witness=Witness(why=why))
    card = card_of(running)
    assert card.text.text() == (said or "Mount it.")
    assert card.text.below.text() == "Mount it."
    assert card.text.below.isVisibleTo(card) is bool(said)
    assert card.text.below.property("state") == "old"
    assert lives(card) == [answered]
    says(running, platform=stands())
    assert (card.text.text(), card.text.below.isVisibleTo(card)) == ("Mount it.", False)
    assert lives(card) == [True]


def test_the_end_of_the_run_may_be_wanted_while_hands_are_kept_out(running):
    send(running, replace(MOUNT, choices=("done", "stop")))
    says(running, (0.0, 0.0, 0.4), platform=stands())
    assert lives(card_of(running)) == [False, True]


def test_whether_hands_are_off_is_asked_as_before_while_something_turns(running):
    send(running, READY)
    says(running, platform=stands(moving=True))
    assert card_of(running).text.text().replace("\N{NO-BREAK SPACE}", " ") == f"Next: t{READY.text[1:]}"


@pytest.mark.parametrize(("set_A", "answered"), [(0.4, True), (0.0, False)])  # by the run; by nobody that is known
def test_a_question_that_a_procedure_asks_with_its_currents_on_can_be_answered(running, set_A, answered):
    send(running, replace(MOUNT, key="switch", choices=("done",)))
    on = lab((0.0, 0.0, 0.4), platform=stands())
    coils = (*on.coils[:2], replace(on.coils[2], set_A=set_A))
    running.app_state.bench_worker.states.emit(replace(on, coils=coils))
    assert card_of(running).text.text() == "HANDS OFF"
    assert lives(card_of(running)) == [answered]


def test_no_question_stands_for_ever(running):
    turned = replace(MOUNT, key="turn-90", choices=(), drawing={"angle_deg": 90.0})
    send(running, turned)
    says(running, (0.0, 0.0, 0.4))  # a dial is turned by hand with the coils on
    card = card_of(running)
    assert card.text.text() == "Mount it."
    lives(card)
    assert card.send.isEnabled()
    send(running, replace(MOUNT, key="mode-low", choices=("done",)))
    contradicted = Witness("disagrees", "it sees 1 nT", read_s=time.monotonic())
    says(running, platform=stands(), witness=contradicted)  # a device in another mode is seen by the reference for good
    assert (card.text.text(), lives(card)) == ("✕ HANDS OFF", [True])
    says(running, platform=stands(moving=True, age_s=WATCHED_S + 5.0))  # of a simulated lab, which stands still
    assert lives(card) == [True]
    running.app_state.run.virtual_time = False
    says(running, platform=stands(moving=True, age_s=WATCHED_S + 5.0))
    assert lives(card) == [False]


def test_at_rest_the_side_panel_says_on_every_page_whether_hands_may_go_in(real):
    real.app_state.take_lab(LabState(unread()))
    for page in real.lazy_pages:
        real.open_page(page)
        assert real.side.hands.isVisible()
        assert real.side.hands.text() == "▲ Hands off: not read yet"
    assert real.side.hands.property("state") == "off"
    real.app_state.take_lab(read(FRESH_S + 1.0))
    assert real.side.hands.text() == "✓ Hands may go in: coils at zero, by their supplies and by the field"
    real.app_state.take_lab(lab((0.0, 0.0, 0.4)))
    assert (real.side.hands.text(), real.side.hands.property("state")) == ("✕ Hands off: coils on: z +0.400 A", "bad")
    real.app_state.take_lab(lab((0.0, 0.0, None)))
    assert real.side.hands.text() == "✕ Hands off: coils NOT confirmed at zero"
    assert (real.side.zero_words.isVisible(), real.side.keep_off.text()) == (False, "✕ HANDS OFF")  # said once


def test_it_stands_there_in_every_state_of_a_run(running):
    says(running, platform=stands())
    said = "● Hands may go in: coils read back at zero by their supplies"
    assert running.side.hands.text() == "▲ Hands off: the run goes on"
    send(running, READY)
    running.app_state.run.answer("done")
    assert running.side.hands.text() == "Hands off: the next field or turn comes unasked"
    assert not running.side.zero_words.isVisible(), "nothing that calms below HANDS OFF"
    send(running, Event(4.0, "pause", "paused"))
    assert running.side.hands.text().startswith(said)
    hands = running.page("Run").live.hands
    assert (hands.isVisible(), hands.text().partition(" · ")[0]) == (True, running.side.hands.text())
    assert hands.objectName() == card_of(running).hands.objectName()
    send(running, Event(5.0, "pause", "goes on"), SegmentOpened(6.0, Segment("z", "static")))
    assert running.side.hands.text() == "Hands off: the next field or turn comes unasked"
    assert not hands.isVisible()
    running.app_state.bench_worker.answer(RunProcedure, Ended("r1", "interrupted", Fault("left", "left")))
    assert running.side.hands.isVisible()
    assert not hands.isVisible()


def test_the_reading_that_confirmed_the_zero_is_shown_in_the_panel_the_table_and_the_cage(still, later):
    app_state, page = still.app_state, still.page("Bench")
    still.open_page("Bench")
    now = app_state.now_s()
    seen = (20_400.0, 1_150.0, -43_700.0)
    app_state.run.last.values["reference"] = ("x", "y", "z"), np.array([50_000.0, 0.0, 0.0])  # with the coils on
    app_state.run.last.read_s["reference"] = now - 9.0
    coils = tuple(CoilReading(axis, 0.0, 0.0, True, True, now) for axis in "xyz")
    before = LabState(coils, Witness("agrees", "", seen, seen, 0.0, 2e3, now))
    for field in (FieldReading(), FieldReading(None, (50_000.0, 0.0, 0.0), now - 9.0)):
        app_state.take_lab(replace(before, field=field))
        page.show_readings()
        row = next(r for r in range(page.table.rowCount()) if page.table.text(r, 1) == "reference")
        assert "43" in page.table.text(row, 4)
        assert "50\N{NARROW NO-BREAK SPACE}0" not in page.table.text(row, 4)
        assert page.cage.dashed == seen
        assert still.side.field.values[1].text() not in ("–", "")
    later(5.0)
    assert still.side.field_age.text() == "5 s ago"
    newer = FieldReading(None, (1.0, 2.0, 3.0), app_state.now_s())
    app_state.take_lab(replace(before, field=newer))
    assert app_state.lab.state.now.field_measured_nT == (1.0, 2.0, 3.0)

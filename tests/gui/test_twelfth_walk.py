"""Plugs pulled on a served lab: one order of acts, who is named is silent or on, and nothing is said that is past."""

import time
from dataclasses import replace
from datetime import datetime, timedelta

import pytest
from test_hands_in_the_cage import AMBIENT, READY, lab, says, send, stands
from test_hands_in_the_cage import real as real
from test_hands_in_the_cage import running as running
from test_nothing_is_cut import settle
from test_off_unanswered import ends

from labcal.bench.coils.state import CoilReading, Heard, LabState, PlatformReading, Witness, unread
from labcal.gui.ipc.answers import Ended, SwitchedOff
from labcal.gui.ipc.messages import RunProcedure, SwitchOff
from labcal.gui.ipc.wire import Fault
from labcal.gui.viewmodels import known_lab
from labcal.gui.viewmodels.bench_to_do import to_do
from labcal.gui.viewmodels.lab_now import WATCHED_S
from labcal.gui.viewmodels.lost_since import LostSince
from labcal.gui.viewmodels.off_headline import off_headline

FIRST = "COILS OFF (F12), then switch off by hand: supply_z"


def real_lines(window):
    window.app_state.facts = replace(window.app_state.facts, virtual_time=False)
    return window


def coil(axis, current_A=None, *, set_A=None, fault="", age_s=0.0):
    read_s = None if current_A is None else time.monotonic() - age_s
    return CoilReading(axis, set_A, current_A, current_A == 0.0, None, read_s, fault)


def test_one_order_of_acts_on_both_cards_and_the_bench_page(running):
    """COILS OFF first, which stops the platform too, then by hand; as the platform's own words say it."""
    real_lines(running)
    says(running, (0.0, 0.0, 1.1), stands())
    says(running, (0.0, 0.0, None), stands(moving=True), ("supply_z",))
    assert running.fault.by_hand.text() == FIRST
    assert "press COILS OFF (F12) first" in running.fault.turning.text()
    assert running.fault.remedy.text() == "By hand: at its panel, or at its mains switch."
    assert FIRST in to_do(running.app_state)
    lost = Fault("instrument", "supply_z: silent.", "Look at its plug.")
    running.app_state.bench_worker.answer(RunProcedure, Ended("r1", "interrupted", lost))
    running.app_state.off_worker.answer(SwitchOff, SwitchedOff(ends(z="supply_z: silent")))
    assert FIRST in running.page("Run").live.fault.coils.text()


def test_who_was_not_asked_yet_is_not_to_be_switched_off(real):
    real.app_state.take_lab(LabState((coil("x", 0.0), coil("y", 0.0), coil("z", 0.0)), platform=stands()))
    heard = (Heard("supply_x", fault="silent"),)
    old_s = WATCHED_S + 1.0
    known = (coil("x", fault="silent"), coil("y", 0.0, age_s=old_s), coil("z"))
    real.app_state.kept.heard.add("supply_x")
    real.app_state.take_lab(LabState(known, instruments=heard, platform=stands()))
    assert real.fault.by_hand.text().endswith("by hand: supply_x")
    assert real.fault.not_read.text() == f"Still to be read: supply_y (last read {WATCHED_S + 1} s ago), supply_z"
    settle(real)
    below = real.fault.fold.y()
    fresh = (known[0], coil("y", 0.0), coil("z", 0.0))
    real.app_state.take_lab(LabState(fresh, instruments=heard, platform=stands()))
    assert real.fault.not_read.text().strip() == ""
    settle(real)
    assert (real.fault.not_read.isVisibleTo(real.fault), real.fault.fold.y()) == (False, below)
    silent = tuple(coil(axis, fault="silent") for axis in "xyz")
    real.app_state.take_lab(LabState(silent, instruments=heard, platform=stands()))
    assert real.fault.by_hand.text().endswith("by hand: supply_x, supply_y, supply_z")


@pytest.mark.parametrize(("set_A", "named"), [(0.4, "supply_z"), (None, "supply_x, supply_z")])
def test_what_a_run_takes_to_zero_is_named_only_once_it_does_not_get_there(real, set_A, named, monkeypatch):
    """A run that lost supply_z takes the others down; at rest one that is on is on, and nobody takes it down."""
    known = (coil("x", 0.4, set_A=set_A), coil("y", 0.0), coil("z", fault="silent"))
    real.app_state.kept.heard.add("supply_z")
    real.app_state.take_lab(LabState(known, platform=stands()))
    assert real.fault.by_hand.text().endswith(f"by hand: {named}")
    monkeypatch.setattr(known_lab, "LOST_FIRST_S", 0.0)
    assert real.app_state.by_hand() == ("supply_x", "supply_z")


def test_the_bottom_line_names_who_is_lost_now_and_no_age(real):
    real.app_state.kept.heard |= {"supply_x", "supply_y"}
    real.app_state.take_lab(LabState((coil("x", fault="silent"), coil("y", 0.0), coil("z", 0.0)), platform=stands()))
    old = PlatformReading(40.0, False, time.monotonic() - 30.0)
    said_at = real.app_state.lab.state.said_at
    more = (coil("x", fault="silent"), coil("y", fault="silent"), coil("z", 0.0))
    real.app_state.take_lab(LabState(more, platform=old))
    assert real.message.text().startswith("COILS OFF (F12), then switch off by hand: supply_x, supply_y")
    assert "ago" not in real.message.text()
    assert real.app_state.lab.state.said_at == said_at
    zero = tuple(coil(axis, 0.0) for axis in "xyz")
    agrees = Witness("agrees", "", AMBIENT, AMBIENT, 0.0, 2000.0, time.monotonic())
    real.app_state.take_lab(LabState(zero, agrees, platform=stands()))
    assert "by hand" not in real.message.text()  # it is over


@pytest.mark.parametrize("silent", ["supply_y", "reference", "stage"])
def test_coils_off_is_green_only_while_everybody_it_speaks_of_answers(real, silent):
    agrees = Witness("agrees", "", AMBIENT, AMBIENT, 0.0, 2000.0, time.monotonic())
    real.app_state.take_lab(lab(platform=stands(), witness=agrees))
    assert off_headline(real.app_state.lab.state.now)[1] == "good"
    real.app_state.take_lab(lab(platform=stands(), faulty=("dut",), witness=agrees))  # of that it says nothing
    assert off_headline(real.app_state.lab.state.now)[1] == "good"
    real.app_state.take_lab(lab(platform=stands(), faulty=(silent,), witness=agrees))
    words, mark = off_headline(real.app_state.lab.state.now)
    assert mark != "good"
    assert f"No answer from {silent}" in words


def test_the_card_says_of_coils_what_the_panel_says(real):
    """Watched, they have no age; "not watched since" beside a green panel were two voices."""
    agrees = Witness("agrees", "", AMBIENT, AMBIENT, 0.0, 2000.0, time.monotonic() - 2.5)
    zero = tuple(coil(axis, 0.0, age_s=2.5) for axis in "xyz")
    real.app_state.take_lab(LabState(zero, agrees, platform=stands()))
    assert real.app_state.coil_words() == "coils at zero"


def test_since_when_somebody_is_lost_is_when_it_was_heard_last(real, monkeypatch):
    heard_s = time.monotonic() - 1.5  # so young an age is not said elsewhere
    known = LabState((), instruments=(Heard("reference", heard_s, "silent"),))
    real.app_state.take_lab(known)
    (said,) = LostSince().named(real.app_state.lab.state.now)
    at = datetime.strptime(said.partition("since ")[2].rstrip(")"), "%H:%M:%S").time()
    wall = datetime.now() - timedelta(seconds=time.monotonic() - heard_s)
    assert at in {(wall + timedelta(seconds=s)).replace(microsecond=0).time() for s in (-0.2, 0.2)}


def test_what_coils_off_says_of_the_platform_is_of_after_it(real):
    """One that was read long before it stopped is looked at again; the line says how it stands then."""
    old = PlatformReading(40.0, False, time.monotonic() - 31.0)
    real.app_state.take_lab(lab(platform=old))
    real.app_state.off.order()
    real.app_state.off_worker.answer(SwitchOff, SwitchedOff(ends()))
    assert "is not seen to stand yet" in real.message.text()
    assert "ago" not in real.message.text()
    real.app_state.take_lab(lab(platform=stands()))
    assert real.message.text().endswith("platform stands at 40°")


def test_hands_off_is_not_answered_before_the_platform_was_seen_to_stand(running, qtbot):
    """Its line is back and everybody answers: until somebody has seen it stand the button waits, and says for what."""
    real_lines(running)
    running.app_state.run.virtual_time = False
    running.open_page("Run")
    card = running.page("Run").live.prompt
    send(running, READY)
    says(running, platform=stands())
    qtbot.waitUntil(lambda: card.alive, timeout=10_000)
    says(running, platform=PlatformReading())
    assert not card.choices["done"].isEnabled()
    assert card.text.text().replace("\N{NO-BREAK SPACE}", " ") == "✕ platform NOT confirmed at a standstill"
    assert not running.app_state.path.may_answer()
    says(running, platform=stands())
    assert card.choices["done"].isEnabled()


def test_go_on_waits_for_who_is_silent_and_says_for_whom(running):
    real_lines(running)
    running.app_state.path.resumable = {"preflight"}
    lost = Fault("instrument", "dut: silent.", "Look at its plug.")
    says(running, platform=stands())
    running.app_state.bench_worker.answer(RunProcedure, Ended("r1", "interrupted", lost))
    live = running.page("Run").live
    running.app_state.take_lab(lab(platform=stands(), faulty=("dut",)))
    assert live.go_on.isVisibleTo(live)
    assert not live.go_on.isEnabled()
    assert (live.waits_for.isVisibleTo(live), live.waits_for.text()) == (True, "✕ No answer from dut")
    running.app_state.take_lab(lab(platform=stands()))
    assert live.go_on.isEnabled()
    assert not live.waits_for.isVisibleTo(live)


def test_while_a_run_begins_one_sentence_stands_until_it_has_read_the_coils(real):
    """Not red, amber and red again: nothing is energised before the coils were read."""
    app_state = real.app_state
    said = set()
    app_state.run.start(RunProcedure("preflight", "bench.toml", {}, "EM-07", "J. Doe"))
    for known in (None, LabState(unread()), LabState(unread(), platform=stands())):
        if known is not None:
            real.app_state.bench_worker.states.emit(known)
        app_state.grow_old()
        said.add((app_state.lab.state.keep_off, app_state.lab.state.hands))
    assert said == {(("▲ Hands off", "off"), ("▲ Hands off: the run begins", "off"))}
    says(real, (0.0, 0.0, 1.1), platform=stands())
    assert app_state.lab.state.keep_off == ("HANDS OFF", "bad")


def test_under_hands_off_nothing_is_ready_and_what_is_open_is_said(real):
    """After F12 at rest, with one supply silent."""
    start = real.page("Start")
    real.app_state.take_lab(lab(platform=stands()))
    assert start.question.text().startswith("Ready.")
    real.app_state.take_lab(lab(platform=PlatformReading()))
    assert real.app_state.lab.state.keep_off[1] == "bad"
    assert "Ready" not in start.question.text()
    real.app_state.off.order()
    real.app_state.off_worker.answer(SwitchOff, SwitchedOff(ends()))
    assert "x, y, z: zero, output open" in real.message.text()


def test_one_card_says_a_thing_once(running):
    """Of the coils beside "Hands may go in", of the platform in larger letters with what to do."""
    real_lines(running)
    running.app_state.run.virtual_time = False
    says(running, platform=stands())
    lost = Fault("instrument", "reference: silent.", "Look at its plug.")
    running.app_state.bench_worker.answer(RunProcedure, Ended("r1", "interrupted", lost))
    card = running.page("Run").live.fault

    def seen():
        parts = (card.hands, card.coils, card.platform, card.turning, card.text)
        return "\n".join(one.text() for one in parts if one.isVisibleTo(card))

    alone = Witness(why="the reference does not answer")
    running.app_state.take_lab(lab(platform=stands(), faulty=("reference",), witness=alone))
    card.say_hands()
    assert seen().count("by their supplies") == 1
    running.app_state.take_lab(lab(platform=PlatformReading(), faulty=("reference",), witness=alone))
    card.say_hands()
    assert seen().count("NOT confirmed at a standstill") == 1


def test_who_is_back_was_out_from_when_to_when_in_one_line_with_the_coils(real):
    real.app_state.kept.heard.add("supply_z")
    heard_s = time.monotonic() - 60.0
    out = LabState((coil("x", 0.0), coil("y", 0.0), coil("z", fault="silent")),
                   instruments=(Heard("supply_z", heard_s, "silent"),), platform=stands())  # fmt: skip
    real.app_state.take_lab(out)
    assert "by hand: supply_z" in real.message.text()
    since = datetime.now() - timedelta(seconds=60.0)
    agrees = Witness("agrees", "", AMBIENT, AMBIENT, 0.0, 2000.0, time.monotonic())
    real.app_state.take_lab(lab(platform=stands(), witness=agrees))
    said = real.message.text()
    assert said.startswith("supply_z: answers again, no answer from ")
    assert f"{since:%H:%M}" in said or f"{since + timedelta(seconds=1):%H:%M}" in said
    assert f" to {datetime.now():%H:%M}" in said
    assert "coils at zero" in said

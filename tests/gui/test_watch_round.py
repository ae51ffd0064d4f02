"""At rest the coils are looked at every second: a silent supply is missed soon, a late answer alarms nobody."""

import math
import time
from dataclasses import replace
from itertools import pairwise

import pytest
from test_hands_in_the_cage import lab, stands
from test_hands_in_the_cage import real as real

from labcal.bench.coils.state import FRESH_S, Witness
from labcal.gui.ipc.lab_messages import InstrumentRead, ReadLab
from labcal.gui.ipc.wire import Fault
from labcal.gui.viewmodels import lab_watch
from labcal.gui.viewmodels.lab_now import HOMES_S, LOOK_S, WATCHED_S
from labcal.gui.viewmodels.watch_round import COILS_S, LATE_S, WatchRound

COILS = ("supply_x", "supply_y", "supply_z")
WANTED_S = 2.5  # so long hands may be let in by a supply that has fallen silent


def is_coil(name):
    return name.startswith("supply")


def rounds(names, seconds, took, silent=()):
    """(who, when) of looks begun every second, each of which takes `took` [s] by name; `silent` from the first on."""
    looks, asked, now_s, tick_s = WatchRound(is_coil), [], 0.0, 0.0
    while now_s < seconds:
        if now_s >= tick_s:
            looks.begin(names, now_s)
            tick_s = now_s + COILS_S
        if who := looks.next(now_s):
            asked.append((who, now_s))
            seconds_s = sum(took.get(name, 0.05) for name in who)
            now_s += seconds_s
            looks.took(who, seconds_s, silent=[name for name in who if name in silent])
        else:
            now_s = tick_s
    return asked


@pytest.mark.parametrize("took", [{}, {"dut": 1.5, "reference": 1.5}], ids=["all answer", "two are silent"])
def test_the_coils_wait_for_one_answer_at_most(took):
    names = ("dut", *COILS, "reference", "stage")
    asked = rounds(names, 30.0, took)
    coils = [at_s for who, at_s in asked if who == COILS]
    longest = max(b - a for a, b in pairwise(coils))
    assert longest <= COILS_S + max([0.15, *took.values()])
    for name in ("dut", "reference", "stage"):
        times = [at_s for who, at_s in asked if who == (name,)]
        assert len(times) >= 5, "nobody is forgotten"
        assert min(b - a for a, b in pairwise(times)) > COILS_S, "the coils alone are asked so often"


@pytest.mark.parametrize("silent", [COILS[1:2], COILS[1:]], ids=["one", "two"])
def test_supplies_that_answer_are_read_as_often_however_long_a_silent_one_is_waited_for(silent):
    """Where one was out the readings of the others were grey: each look waited for it."""
    names, waits_s = ("dut", *COILS, "reference", "stage"), 1.5  # as the drivers of most supplies do
    took = {"reference": 0.6, "dut": 0.3} | dict.fromkeys(silent, waits_s)
    asked = rounds(names, 60.0, took, silent)
    healthy = tuple(name for name in COILS if name not in silent)
    looks = [(at_s, at_s + 0.05 * len(who)) for who, at_s in asked if who == healthy]
    assert len(looks) >= 30
    oldest_s = max(read_s - before_s for (before_s, _), (_, read_s) in pairwise(looks))
    assert oldest_s < FRESH_S
    for name in (*silent, "dut", "reference", "stage"):
        times = [at_s for who, at_s in asked[1:] if who == (name,)]
        assert max(b - a for a, b in pairwise(times)) <= 12.0, "nobody is forgotten"


def test_a_supply_that_answers_again_is_looked_at_with_the_others_and_alarms_as_soon_as_before():
    looks = WatchRound(is_coil)
    looks.took(COILS, 0.1)
    by_s = looks.by_s
    looks.took(COILS, 1.6, silent=COILS[1:2])
    looks.took(COILS[1:2], 1.5, silent=COILS[1:2])
    looks.took(COILS[1:2], 0.1)
    looks.begin(COILS, 10.0)
    assert looks.next(10.0) == COILS
    assert looks.by_s == by_s


def test_who_is_read_by_somebody_else_is_not_asked_on():
    looks = WatchRound(is_coil)
    looks.begin((*COILS, "reference"), 0.0)
    looks.forget()
    assert looks.next(0.0) == ()


@pytest.mark.parametrize("usual_s", [0.02, 0.2])
def test_a_silent_supply_is_missed_in_time_and_a_late_answer_is_not(usual_s):
    looks = WatchRound(is_coil)
    for _ in range(3):
        looks.took(COILS, usual_s)
    assert COILS_S + usual_s + 1.0 < looks.by_s <= WANTED_S  # a second late
    looks.took(("reference",), 0.6)
    assert looks.by_s <= WANTED_S
    looks.took(("dut",), 1.5, silent=("dut",))  # the coils wait for that one question, and are not missed by it
    assert COILS_S + 1.5 + usual_s <= looks.by_s <= WATCHED_S
    looks.took(("dut",), 0.1)
    assert looks.by_s <= WANTED_S


def test_supplies_that_are_slow_as_a_rule_are_not_missed_each_time():
    looks = WatchRound(is_coil)
    looks.took(COILS, 1.2)
    assert 2 * 1.2 < looks.by_s <= WATCHED_S
    looks = WatchRound(is_coil)
    looks.took(COILS, 3.0)
    assert looks.by_s == WATCHED_S, "however slow: what is older lets nobody in"


def test_how_long_a_silent_supply_is_waited_for_makes_it_no_slow_one():
    looks = WatchRound(is_coil)
    looks.took(COILS, 0.1)
    for _ in range(3):
        looks.took(COILS, 1.5, silent=COILS[1:2])
    assert looks.by_s <= WANTED_S


def test_what_was_learnt_of_the_lines_is_forgotten_with_them():
    """A run has had them since: they are opened anew, and who was slow may be quick."""
    looks = WatchRound(is_coil)
    looks.took(COILS, 0.1)
    looks.took(("dut",), 1.5)
    looks.forget()
    assert looks.by_s == math.inf
    looks.took(COILS, 0.1)
    assert looks.by_s <= WANTED_S


def test_whoever_wants_the_lines_ends_the_round(real):
    watch = real.app_state.watch
    watch.round.begin((*COILS, "reference"), time.monotonic())
    watch.stop()
    assert watch.round.next(time.monotonic()) == ()


@pytest.mark.parametrize(
    "fault", [None, Fault("instrument", "supply_y: no reply")], ids=["all answer", "one is silent"]
)
def test_the_round_is_told_how_long_the_supplies_took_where_all_of_them_answered(real, fault):
    app_state, now = real.app_state, time.monotonic()
    app_state.watch.stop()
    app_state.take_lab(lab(platform=stands()))
    app_state.watch.look()
    coils = tuple(InstrumentRead(name, f"coil-{name[-1]}", "", "", fault if name == COILS[1] else None, False, now,
                                 0.0, True) for name in COILS)  # fmt: skip
    app_state.watch_worker.answer(ReadLab, coils)
    by_s = app_state.watch.round.by_s
    app_state.watch.stop()
    assert math.isfinite(by_s) is (fault is None)


def looked(window, at_s):
    coils = tuple(InstrumentRead(name, f"coil-{name[-1]}", "", "a supply", None, False, at_s, 0.0, True)
                  for name in COILS)  # fmt: skip
    window.app_state.watch_worker.answer(ReadLab, coils)


def test_at_rest_a_supply_that_falls_silent_lets_nobody_in_after_that(real, monkeypatch):
    app_state, now = real.app_state, time.monotonic()
    app_state.watch.stop()
    agreed = Witness("agrees", "", (0.0, 0.0, 0.0), (0.0, 0.0, 0.0), 0.0, 2000.0, now)
    app_state.take_lab(replace(lab(platform=stands(), witness=agreed)))
    app_state.watch.look()
    looked(real, now)
    app_state.watch.stop()
    app_state.watch.round.took(COILS, 0.1)
    app_state.watch.look()  # it is asked, and does not answer
    by_s = app_state.watch.round.by_s
    monkeypatch.setattr(lab_watch.time, "monotonic", lambda: now)
    for silent_s, state in ((1.0, "good"), (by_s - 0.1, "good"), (by_s + 0.1, "off")):
        known = app_state.known.shifted(now - silent_s - app_state.known.coils[0].read_s)
        app_state.take_lab(replace(known, platform=stands()))
        assert real.side.hands.property("state") == state, (silent_s, real.side.hands.text())
    assert real.side.hands.text() == "▲ Hands off: the coils are not being read"  # with no age, as of what is fresh
    app_state.take_lab(replace(known, platform=stands(age_s=2.5)))  # which waits for the supplies' answer
    assert real.side.hands.text() == "▲ Hands off: the coils are not being read"
    assert by_s <= WANTED_S


def test_coils_that_nobody_has_asked_are_not_missed_and_no_words_change(real, monkeypatch):
    """On a loaded computer the window's own round is late: that says nothing against the lab."""
    app_state, now = real.app_state, time.monotonic()
    app_state.watch.stop()
    agreed = Witness("agrees", "", (0.0, 0.0, 0.0), (0.0, 0.0, 0.0), 0.0, 2000.0, now)
    app_state.watch.round.took(COILS, 0.1)
    monkeypatch.setattr(lab_watch.time, "monotonic", lambda: now)
    said = []
    for age_s in (0.5, 1.5, 2.5, 3.5, 3.9):
        app_state.take_lab(lab(platform=stands(), witness=agreed).shifted(-age_s))
        side = real.side
        said.append((side.hands.text(), side.hands.property("state"), side.may_go_in.text(), side.hands_age.text()))
    assert len({one[:3] for one in said}) == 1
    assert said[0][1] == "good"
    assert [one[3] for one in said] == [f"read {age_s} s ago" for age_s in (1, 2, 3, 4, 4)]
    assert side.hands_age.property("state") == "old"
    app_state.take_lab(lab(platform=stands()).shifted(-6.0))
    assert (side.hands.property("state"), side.hands_age.isHidden()) == ("off", True)


def test_an_answer_that_was_asked_for_late_is_waited_for_as_long_as_another(real, monkeypatch):
    watch, at_s = real.app_state.watch, [time.monotonic()]
    watch.stop()
    real.app_state.take_lab(lab(platform=stands()))
    monkeypatch.setattr(lab_watch.time, "monotonic", lambda: at_s[0])
    watch.look()
    at_s[0] += 0.1
    looked(real, at_s[0])
    while watch._asked is not None:  # whoever is due after them
        names = watch._asked.names
        roles = {name: one.role for name, one in real.app_state.facts.instruments.items()}
        said = tuple(InstrumentRead(name, roles[name], "", name, None, False, at_s[0]) for name in names)
        real.app_state.watch_worker.answer(ReadLab, said)
    assert watch.coils_by_s() == WATCHED_S, "nobody is asked"
    at_s[0] += COILS_S + 0.7  # the window itself was late
    watch.look()
    assert watch.coils_by_s() == pytest.approx(watch.round.by_s + 0.7)
    watch.stop()


def test_the_others_are_missed_after_their_own_round():
    looks = WatchRound(is_coil)
    assert looks.others_by_s == WATCHED_S
    for at_s in (0.0, 5.5):  # a loaded computer needs so long for all of them
        looks.took(("stage",), 0.5, now_s=at_s)
    assert looks.others_by_s == 5.5 + LATE_S
    looks.took(("stage",), 1.5, silent=("stage",), now_s=11.0)
    assert looks.others_by_s == WATCHED_S
    for at_s in (20.0, 40.0):
        looks.took(("stage",), 0.5, now_s=at_s)
    assert looks.others_by_s == HOMES_S, "however slow"
    looks.forget()
    assert looks.others_by_s == WATCHED_S


def test_between_two_looks_at_the_reference_the_coils_are_read_and_it_stays_green(real):
    """It is looked at every other second: that alone is no lesser proof of a zero."""
    now = time.monotonic()
    seen = Witness("agrees", "", (0.0, 0.0, 0.0), (0.0, 0.0, 0.0), 0.0, 2000.0, now - 2.5)
    real.app_state.take_lab(lab(platform=stands(), witness=seen))
    assert real.side.hands.property("state") == "good"
    real.app_state.take_lab(lab(platform=stands(), witness=replace(seen, read_s=now - LOOK_S - 1.5)))
    assert real.side.hands.property("state") == "good"
    assert real.side.hands_age.text() == f"read {LOOK_S + 2} s ago"
    real.app_state.take_lab(lab(platform=stands(), witness=replace(seen, read_s=now - WATCHED_S - 1.5)))
    assert real.side.hands.property("state") == "alone"  # by the supplies' word, and with its age
    assert f"{WATCHED_S + 1} s ago" in real.side.hands.text()


@pytest.mark.parametrize(("old_s", "says"), [(0.9, 1), (2.8, 3), (3.1, 4)])
def test_what_lets_hands_in_has_its_age_on_a_line_of_its_own(real, old_s, says):
    """The platform is looked at every other second, and answers a little later: the words would jump each time."""
    now = time.monotonic()
    agreed = Witness("agrees", "", (0.0, 0.0, 0.0), (0.0, 0.0, 0.0), 0.0, 2000.0, now)
    real.app_state.take_lab(lab(platform=stands(age_s=old_s), witness=agreed))
    assert real.side.hands.text() == "✓ Hands may go in: coils at zero, by their supplies and by the field"
    assert real.side.hands_age.text() == f"read {says} s ago"


def test_the_clock_of_the_watch_is_that_of_its_round():
    assert lab_watch.LOOK_MS == 1000 * COILS_S
    assert LATE_S > COILS_S


@pytest.mark.parametrize(
    ("silent", "at_most_s"),
    [(("supply_x",), 5.0), ((*COILS, "dut", "reference", "stage"), 20.0)],
    ids=["one supply", "everybody"],
)
def test_beside_silent_supplies_the_others_are_read_on(silent, at_most_s):
    names, looks, read, now_s, tick_s = ("dut", *COILS, "reference", "stage"), WatchRound(is_coil), {}, 0.0, 0.0
    while now_s < 60.0:
        if now_s >= tick_s:
            looks.begin(names, now_s)
            tick_s += COILS_S * (1 + (now_s - tick_s) // COILS_S)
        if who := looks.next(now_s):
            took_s = sum(1.5 if name in silent else 0.05 for name in who)
            now_s += took_s
            looks.took(who, took_s, silent=[name for name in who if name in silent])
            for name in who:
                read.setdefault(name, []).append(now_s)
        else:
            now_s = tick_s
    for name in names:
        assert max(b - a for a, b in pairwise([0.0, *read[name], 60.0])) <= at_most_s

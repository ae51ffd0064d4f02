"""Who gives no answer lets nobody in, is out since it was heard last, and everybody is asked whoever else is silent."""

import time
from datetime import datetime, timedelta

from test_hands_in_the_cage import lab, stands
from test_hands_in_the_cage import real as real

from labcal.bench.coils.state import CoilReading, Heard
from labcal.gui.ipc.lab_messages import InstrumentRead, ReadLab
from labcal.gui.ipc.wire import Fault
from labcal.gui.viewmodels.known_lab import KnownLab
from labcal.gui.viewmodels.last_heard import LastHeard
from labcal.gui.viewmodels.lost_since import LostSince

SUPPLIES = {"x": "supply_x", "y": "supply_y", "z": "supply_z"}


def answers(window, names, *, silent=(), ago_s=0.0):
    """The watch's answer about these."""
    said, read_s = [], time.monotonic() - ago_s
    for name in names:
        role = window.app_state.facts.instruments[name].role
        if name in silent:
            fault = Fault("instrument", f"{name}: silent")
            said.append(InstrumentRead(name, role, "", "", fault, False, time.monotonic()))
        else:
            current_A = 0.0 if role.startswith("coil-") else None
            said.append(InstrumentRead(name, role, "", name, None, False, read_s, current_A, current_A is not None))
    window.app_state.watch_worker.answer(ReadLab, tuple(said))


def wall(seconds_ago):
    return {f"{datetime.now() - timedelta(seconds=seconds_ago + near):%H:%M:%S}" for near in (-1, 0, 1)}


def test_at_rest_one_is_out_since_it_was_heard_last(real):
    app_state = real.app_state
    app_state.watch.stop()
    for name, silent in (
        ("supply_z", ()),
        ("supply_z", ("supply_z",)),
        ("reference", ()),
        ("reference", ("reference",)),
    ):
        app_state.watch.read_again((name,))
        answers(real, (name,), silent=silent, ago_s=20.0)
    since = LostSince().since(app_state.lab.state.now)
    assert since["supply_z"] in wall(20.0)
    assert since["reference"] in wall(20.0)


def test_in_a_run_a_supply_is_out_since_its_coil_was_read_last():
    heard, now = LastHeard(), time.monotonic()
    heard.keep(lab(platform=stands()).shifted(-8.0))
    lost = Heard("supply_z", now - 5.0, "silent")  # when that was found
    coils = (*lab().coils[:2], CoilReading("z", read_s=now - 5.0, fault="silent"))
    known = lab().__class__(coils, instruments=(lost,))
    heard.keep(known)
    assert abs(dict(heard.at_s(SUPPLIES))["supply_z"] - (now - 8.0)) < 1.0


def test_a_reading_that_was_missed_lets_nobody_in_again_however_long_another_kept_the_next_waiting(real):
    kept, facts = KnownLab(), real.app_state.facts
    known = lab(platform=stands())
    kept.take(known, time.monotonic())
    read_s = known.coils[0].read_s
    late = [
        kept.now(facts, read_s + age_s, driven=False, by_s=by_s).coils_late
        for age_s, by_s in ((2.2, 2.3), (2.4, 2.3), (2.6, 4.0))
    ]
    assert late == [False, True, True]
    kept.take(known.shifted(3.0), read_s + 3.0)
    assert not kept.now(facts, read_s + 3.1, driven=False, by_s=4.0).coils_late


def test_everybody_is_asked_where_every_supply_has_fallen_silent(real):
    app_state = real.app_state
    app_state.watch.stop()
    app_state.watch.read_again(SUPPLIES.values())
    answers(real, SUPPLIES.values())
    app_state.watch.read_again(SUPPLIES.values())
    answers(real, SUPPLIES.values(), silent=SUPPLIES.values())
    assert {"reversers", "reference", "stage"} <= set(app_state.off.to_be_read())


def test_after_coils_off_the_coils_are_asked_first_and_by_themselves(real):
    """Whoever else is silent keeps their answer waiting no longer than that."""
    app_state = real.app_state
    app_state.watch.stop()
    app_state.off.read_again()
    (asked,) = app_state.watch_worker.commands(ReadLab)
    assert set(asked.names) == set(SUPPLIES.values())

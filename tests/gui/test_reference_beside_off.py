"""While COILS OFF is not answered the reference is read on: nobody else says what the coils do."""

from dataclasses import replace

import pytest
from PySide6.QtCore import Qt
from test_field_as_witness import OFF_NT, agreed
from test_hands_in_the_cage import now_s
from test_off_unanswered import ends

from labcal.gui.ipc.answers import SwitchedOff
from labcal.gui.ipc.lab_messages import InstrumentRead, ReadLab
from labcal.gui.ipc.messages import RunProcedure, SwitchOff
from labcal.gui.viewmodels.known_lab import ANSWERS_S


@pytest.fixture
def wired(still):
    """The bench of the window, each instrument at a port of its own."""
    app_state = still.app_state
    instruments = {
        name: replace(one, link=f"tcp://lab:{port}")
        for port, (name, one) in enumerate(app_state.facts.instruments.items())
    }
    app_state.facts = replace(app_state.facts, virtual_time=False, instruments=instruments)
    app_state.take_lab(agreed())
    return still


def asked(window):
    """Who is asked by now, one after another."""
    window.app_state.watch.look()
    return [one.names for one in window.app_state.watch_worker.commands(ReadLab)]


def seen(window, more_nT):
    field = (OFF_NT[0] + more_nT, *OFF_NT[1:])
    said = InstrumentRead("reference", "reference", "", "a reference", None, False, now_s(), field_nT=field)
    window.app_state.watch_worker.answer(ReadLab, (said,))


def test_it_is_read_and_shown_with_its_age_as_soon_as_the_supplies_are_late(qtbot, wired, later):
    qtbot.keyClick(wired, Qt.Key.Key_F12)
    later(ANSWERS_S - 0.5)
    assert asked(wired) == []  # who may answer yet is waited for, and nothing else is begun
    later(1.0)
    assert asked(wired) == [("reference",)]
    seen(wired, 48_000.0)
    now = wired.app_state.lab.state.now
    assert now.field_measured_nT == (OFF_NT[0] + 48_000.0, *OFF_NT[1:])
    assert now.field_old_s is None
    assert wired.app_state.lab.state.hands[0].startswith("✕ Hands off: the field says: still on (x, +48 µT more")
    later(30.0)
    assert wired.app_state.lab.state.now.field_old_s == 30
    assert asked(wired) == [("reference",)]  # again


def test_a_field_as_with_the_coils_off_takes_back_no_alarm(qtbot, wired, later):
    qtbot.keyClick(wired, Qt.Key.Key_F12)
    later(ANSWERS_S + 0.5)
    assert asked(wired) == [("reference",)]
    seen(wired, 0.0)
    assert wired.side.zero_words.text() == "✕ coils NOT confirmed at zero"
    assert wired.fault.isVisible()


def test_once_it_is_answered_the_coils_come_first_again(qtbot, wired, later):
    qtbot.keyClick(wired, Qt.Key.Key_F12)
    later(ANSWERS_S + 0.5)
    assert asked(wired) == [("reference",)]
    wired.app_state.off_worker.answer(SwitchOff, SwitchedOff(ends()))
    seen(wired, 0.0)
    assert wired.app_state.watch_worker.commands(ReadLab)[0].names == ("supply_x", "supply_y", "supply_z")


def test_nobody_is_read_on_a_line_that_zero_may_need_nor_of_a_simulated_lab_nor_in_a_run(qtbot, wired, later):
    app_state = wired.app_state
    qtbot.keyClick(wired, Qt.Key.Key_F12)
    later(ANSWERS_S + 0.5)
    facts = app_state.facts
    shared = dict(facts.instruments) | {"reference": facts.instruments["supply_x"]}
    shared["reference"] = replace(shared["reference"], role="reference")
    for other in (replace(facts, instruments=shared), replace(facts, virtual_time=True)):
        app_state.facts = other
        assert asked(wired) == []
    app_state.facts = facts
    app_state.run.start(RunProcedure("preflight", "bench.toml", {}, "EM-07", "J. Doe"))
    assert asked(wired) == []

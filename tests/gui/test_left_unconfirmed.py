"""What was not confirmed when a window closed, or died, the next one says first, reads by itself, and then forgets."""

import json
import re
import time
from dataclasses import replace

import pytest
from test_hands_in_the_cage import lab, stands

from labcal.bench.coils.state import Heard, LabState, unread
from labcal.files.home import home
from labcal.gui.ipc.lab_messages import InstrumentRead, ReadLab
from labcal.gui.ipc.messages import ReadBench
from labcal.gui.ipc.wire import Fault
from labcal.gui.viewmodels.left_unconfirmed import ANEW_S, NAME, LeftUnconfirmed

LOST = (0.0, None, 0.0)
SAID = r"supply_y: not confirmed at zero when the window closed, \d\d:\d\d"


def kept():
    """What the file has, by bench file."""
    file = home() / NAME
    return json.loads(file.read_text()) if file.exists() else {}


@pytest.fixture
def real(still):
    """A bench on lines of its own, known from its file."""
    app_state = still.app_state
    facts = replace(app_state.facts, virtual_time=False)
    app_state.bench_known(app_state.bench or "/lab/bench.toml", facts)
    return still


def hands(window):
    side = window.side
    return side.hands.text(), side.keep_off.text(), side.keep_off.property("state")


def opened_anew(window):
    """As the next window finds it: nothing was read, the file is."""
    app_state, bench = window.app_state, window.app_state.bench
    facts = app_state.facts
    app_state.forget()
    app_state.left.unconfirmed = LeftUnconfirmed()
    app_state.watch.stop()
    app_state.watch_worker.asked.clear()
    app_state.facts, app_state.bench = None, ""
    app_state.grow_old()
    assert hands(window)[1] == ""
    app_state.open_bench(bench)
    said = hands(window)
    app_state.quick_worker.answer(ReadBench, facts)
    return said


def test_what_was_not_confirmed_is_said_by_the_next_window_while_its_bench_opens_and_after(real):
    real.app_state.take_lab(lab(LOST, platform=stands()))
    real.app_state.left.close()
    for words, large, state in (opened_anew(real), hands(real)):
        assert re.fullmatch(f"✕ Hands off: {SAID}", words), words
        assert (large, state) == ("✕ HANDS OFF", "bad")
    assert real.app_state.watch_worker.commands(ReadLab)[-1].names == (), "it reads all, unasked"


def test_it_is_kept_as_soon_as_it_is_known_for_a_window_may_die(real):
    real.app_state.take_lab(lab(LOST, platform=stands()))
    (said,) = kept().values()
    assert said["coils"] == ["supply_y"]
    assert time.time() - said["unix_s"] < ANEW_S


def test_it_is_gone_once_all_is_read_back_at_zero(real):
    real.app_state.take_lab(lab(LOST, platform=stands()))
    opened_anew(real)
    real.app_state.take_lab(replace(LabState(unread()), platform=stands()))
    assert kept(), "nobody has read the supplies"
    real.app_state.take_lab(lab(platform=stands()))
    assert not kept()
    assert hands(real)[1] == ""
    opened_anew(real)
    assert hands(real)[1:] == ("▲ Hands off", "off")


def test_a_platform_that_nobody_saw_stand_as_well(real):
    real.app_state.take_lab(replace(lab(platform=stands(moving=True)), instruments=(Heard("stage", None, "silent"),)))
    words, large, _ = opened_anew(real)
    assert re.fullmatch(r"✕ Hands off: stage: not confirmed at a standstill when the window closed, \d\d:\d\d", words)
    assert large == "✕ HANDS OFF"


def test_of_a_simulated_lab_nothing_is_kept(still):
    still.app_state.take_lab(lab(LOST, platform=stands()))
    assert not kept()


def test_a_file_that_is_cut_says_nothing(real):
    (home() / NAME).write_text('{"bench.toml": {"coi')
    opened_anew(real)
    assert hands(real)[1:] == ("▲ Hands off", "off")


def test_two_faults_at_once_are_two_reasons(real):
    """A silent platform is not said to stand where it did."""
    silent = (Heard("supply_x", None, "silent"), Heard("stage", None, "silent"))
    old = replace(lab((None, 0.0, 0.0), platform=stands(age_s=23.0)), instruments=silent)
    real.app_state.take_lab(old)
    reasons = "coils NOT confirmed at zero; platform NOT confirmed at a standstill"
    assert hands(real) == (f"✕ Hands off: {reasons}", "✕ HANDS OFF", "bad")
    assert real.side.platform.text() == "✕ platform NOT confirmed at a standstill"
    assert real.side.angle.text() == ""


def test_whose_lines_the_guardian_of_the_last_session_has_is_said_and_until_when(real):
    app_state, now = real.app_state, time.monotonic()
    name = next(name for name, one in app_state.facts.instruments.items() if one.role == "dut")
    app_state.watch.stop()
    app_state.watch.read_all()
    silent = Fault("instrument", "supply_y: no reply in 1.5 s.")
    app_state.watch_worker.answer(ReadLab, (
        InstrumentRead("supply_x", "coil-x", "x", read_s=now, current_A=0.0, zero=True, until=("supply_y",)),
        InstrumentRead("supply_y", "coil-y", "y", fault=silent),
        InstrumentRead("supply_z", "coil-z", "z", read_s=now - 75.0, current_A=0.0, zero=True, until=("supply_y",)),
        InstrumentRead(name, "dut", "d", held=True, until=("supply_y",)),
    ))  # fmt: skip
    has = f"the guardian of the last session has supply_x, supply_z, {name} until supply_y is read back at zero"
    assert real.message.text().replace("\n", " ") == f"1 of 4 instruments were read: ✕ supply_y; {has}"
    assert (name, "absent", "the guardian of the last session has it") in app_state.lab.state.now.lights
    app_state.forget()  # another bench: that guardian has none of its lines
    app_state.grow_old()
    assert not [one for one in app_state.lab.state.now.lights if "guardian" in one[2]]

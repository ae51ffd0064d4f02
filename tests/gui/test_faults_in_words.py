"""What goes wrong as a technician meets it: what happened, how the coils are, what to do; the window goes on."""

import errno
from pathlib import Path

import pytest
from lab_states import told
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QPushButton

from labcal.errors import InstrumentError, LimitError
from labcal.gui.ipc.answers import CoilEnd, Ended, SwitchedOff
from labcal.gui.ipc.messages import RunProcedure, SwitchOff
from labcal.gui.ipc.wire import Fault, fault_of, with_instrument_names
from labcal.gui.viewmodels.lab_now import LONG_AGO_S
from labcal.gui.widgets.fault_card import FaultCard
from labcal.record.stream import Prompt

LINKS = {"reference": "serial:///dev/ttyUSB9", "supply_x": "modbus-rtu:///dev/ttyUSB1"}
LOST = Fault("instrument", "serial:///dev/ttyUSB9: the link was lost.", "Plug it in.")
ON, ZERO, UNSURE = (1.0, 0.0, 0.0), (0.0, 0.0, 0.0), (None, 0.0, 0.0)


def fail(window, fault, *items, coils=()):
    run = window.app_state.run
    run.start(RunProcedure("preflight", "bench.toml"))
    window.app_state.bench_worker.items.emit(items)
    for currents in coils:
        told(window, currents)
    failed = window.app_state.bench_worker.asked[-1].failed
    failed(fault)
    return window.page("Run").live.fault


@pytest.mark.parametrize(
    ("coils", "words"),
    [
        ((), "coils not read back in this session"),
        ((ON, ZERO), "coils at zero"),
        ((ON, UNSURE), "coils NOT confirmed at zero. Press COILS OFF (F12)"),
        ((ON,), "coils on: x +1.0000 A. Press COILS OFF (F12)"),
    ],
)
def test_a_run_that_fails_says_how_it_left_the_coils(still, coils, words):
    card = fail(still, LOST, coils=coils)
    said = "coils not read back since they were ordered off" if "Press" in words else words  # and it was
    told = card.coils.text().removeprefix("✓ ")
    assert told.startswith(said)
    once = [one for one in (card.hands, card.coils) if one.isVisible() and told in one.text()]
    assert len(once) == 1
    asked_for_zero = bool(still.app_state.off_worker.commands(SwitchOff))
    assert asked_for_zero == ("Press" in words)  # by another worker, without being told to


def test_the_card_of_a_run_learns_that_its_coils_were_switched_off_after_it(qtbot, still):
    card = fail(still, LOST, coils=(ON,))
    qtbot.keyClick(still, Qt.Key.Key_F12)
    still.app_state.off_worker.answer(SwitchOff, SwitchedOff(tuple(CoilEnd(a, 0.0, "zero", True) for a in "xyz")))
    assert card.coils.text() == "coils read back at zero by their supplies; no reference has confirmed it"


def test_what_was_read_grows_old_in_the_window(still):
    still.app_state.run.start(RunProcedure("preflight", "bench.toml"))
    told(still)
    assert still.app_state.lab.state.now.coil_words == "coils at zero"
    told(still, age_s=7.0)
    said = still.app_state.lab.state.now.coil_words
    assert said.startswith("coils confirmed at zero at ")
    assert said.endswith(" (7 s ago); not watched since")
    assert still.side.zero_words.text().startswith("● ")  # a run goes on, and has read nothing for 7 s
    told(still, verdict="disagrees")
    assert still.app_state.lab.state.now.coil_words.startswith("NOT at zero by the reference: it sees 20400")
    assert still.app_state.run.coils_at_zero is False


def test_a_fault_names_the_instrument_and_not_its_link_alone(still):
    still.app_state.run.links = LINKS
    card = fail(still, LOST)
    assert card.text.text() == "reference (serial:///dev/ttyUSB9): the link was lost."
    assert ("reference", "fault", "no answer (link lost)") in still.app_state.lab.state.now.lights
    assert with_instrument_names(Fault("instrument", "dut: silent"), LINKS).text == "dut: silent"
    for said in ("reference (serial:///dev/ttyUSB9): it is lost.", "reference: serial:///dev/ttyUSB9: it is lost."):
        known = with_instrument_names(Fault("instrument", said), LINKS).text
        assert known == "reference (serial:///dev/ttyUSB9): it is lost."  # the name is said once


def test_a_limit_that_is_not_met_is_no_failure_of_the_instrument_that_its_words_name(still):
    fail(still, Fault("limit", "closure, DUT less reference, coils off: 2605 nT is beyond 500 nT"))
    assert "fault" not in {light for _, light, _ in still.app_state.lab.state.now.lights}
    assert still.app_state.path.next().page != "Bench"


def test_a_full_disk_is_said_as_such_and_is_no_fault_of_labcal_s():
    full = fault_of(OSError(errno.ENOSPC, "No space left on device", "/lab/runs.sqlite"))
    assert (full.kind, full.text) == ("input", "/lab/runs.sqlite: No space left on device")
    assert fault_of(InstrumentError("ref is silent", remedy="Look.")).kind == "instrument"
    assert fault_of(KeyError("x")).kind == "crash"


@pytest.mark.parametrize(
    ("error", "title"),
    [
        (InstrumentError("the disk did not take in time.", fault="store slow"), "✕ The record is not kept"),
        (InstrumentError("there was no room on the disk.", fault="disk full"), "✕ The record is not kept"),
        (InstrumentError("the guardian did not start.", fault="guardian lost"), "✕ The guardian failed"),
        (InstrumentError("set back by 3 s.", fault="clock set back"), "✕ The clock was set back"),
        (LimitError("3 A is beyond its limit of 2.5 A", fault="limit reached"), "✕ This cannot be done as asked"),
        (InstrumentError("stage: the link was lost.", fault="link lost"), "✕ An instrument failed"),
    ],
)
def test_the_title_says_what_failed_and_not_an_instrument_where_none_did(qtbot, error, title):
    card = FaultCard(closable=False)
    qtbot.addWidget(card)
    card.show_fault(fault_of(error))
    assert card.heading.text() == title


def test_a_lost_supply_is_one_card_and_that_the_coils_may_be_on_comes_first(still):
    fail(still, Fault("instrument", "supply_x: the link was lost.", "Plug it in."))
    card = still.page("Run").live.fault
    assert card.isVisible()
    still.app_state.off.order()
    still.app_state.off_worker.asked[-1].failed(Fault("instrument", "x: supply_x: the link was lost."))
    assert (still.fault.heading.text(), still.fault.isVisible()) == ("✕ HANDS OFF: the coils may be on", True)
    assert card.isHidden()
    next(one for one in still.fault.findChildren(QPushButton) if one.text() == "Close").click()
    still.app_state.grow_old()
    still.app_state.lab.update(message="seen")
    assert card.isVisible()  # who has put that one away sees what failed


def test_a_bench_that_cannot_be_read_leaves_the_one_that_is_open(still, tmp_path):
    before = still.app_state.bench
    still.app_state.open_bench(str(tmp_path / "broken.toml"))
    failed = still.app_state.quick_worker.asked[-1].failed
    failed(Fault("input", "broken.toml, line 1: is not TOML"))
    assert still.fault.isVisible()
    assert still.app_state.bench == before == str(still.app_state.settings.value("bench"))


def test_no_other_bench_is_opened_while_a_run_goes_on(still, tmp_path):
    still.app_state.run.start(RunProcedure("preflight", "bench.toml"))
    asked = len(still.app_state.quick_worker.asked)
    still.app_state.open_bench(str(tmp_path / "other.toml"))
    assert len(still.app_state.quick_worker.asked) == asked
    assert "A run goes on" in still.fault.text.text()


def test_coils_off_without_a_bench_says_so(qtbot, still, monkeypatch):
    monkeypatch.setattr(still.app_state, "bench", "")
    qtbot.keyClick(still, Qt.Key.Key_F12)
    assert still.app_state.lab.state.message == "Coils off: no bench is open, this window drives no coil."
    assert not still.app_state.off_worker.commands(SwitchOff)


def test_what_breaks_in_the_window_itself_is_a_card(still, capsys):
    error = ZeroDivisionError("division by zero")
    still.app_state.handle_exception(ZeroDivisionError, error, None)
    assert still.fault.isVisible()
    assert still.fault.fault.kind == "crash"
    assert "division by zero" in capsys.readouterr().err


def test_the_words_of_a_question_go_when_the_run_fails_under_it(still):
    card = fail(still, LOST, Prompt(1.0, "mount-x", "Mount it.", ("done",), True))
    assert card.isVisible()
    assert not still.page("Run").live.prompt.isVisible()
    assert Path(still.app_state.bench).name == "simulated.toml"


def test_after_a_run_its_zero_is_past_and_alarms_nobody(still):
    still.app_state.run.start(RunProcedure("preflight", "bench.toml"))
    told(still, age_s=5.0)
    assert still.side.zero_words.property("state") == "warning"
    still.app_state.bench_worker.answer(RunProcedure, Ended("r1", "finished"))
    still.app_state.grow_old()
    assert still.side.zero_words.text().startswith("◌ coils confirmed at zero at ")
    assert still.side.zero_words.property("state") == "old"
    still.app_state.take_lab(still.app_state.known.shifted(-LONG_AGO_S))
    assert still.side.zero_words.text().endswith("(30 min ago); not watched since")
    assert still.side.zero_words.property("state") == "warning"  # it is to be read again before anybody relies on it

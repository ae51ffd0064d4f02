"""What goes wrong as a technician meets it: what happened, how the coils are, what to do; the window goes on."""

import errno
from pathlib import Path

import pytest
from lab_states import told
from PySide6.QtCore import Qt

from labcal.errors import InstrumentError
from labcal.gui.run_vm import Order
from labcal.gui.wire import Fault, fault_of, item_to_json, with_names
from labcal.record.stream import Prompt

LINKS = {"reference": "serial:///dev/ttyUSB9", "supply_x": "modbus-rtu:///dev/ttyUSB1"}
LOST = Fault("instrument", "serial:///dev/ttyUSB9: the link is lost.", "Plug it in.")
ON, ZERO, UNSURE = (1.0, 0.0, 0.0), (0.0, 0.0, 0.0), (None, 0.0, 0.0)


def fail(window, fault, *items, coils=()):
    run = window.desk.run
    run.start(Order("preflight", "bench.toml"))
    window.desk.bench_worker.items.emit([item_to_json(item) for item in items])
    for currents in coils:
        told(window, currents)
    (_, _, failed, _) = window.desk.bench_worker.asked[-1]
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
    assert card.coils.isVisible()
    said = "coils not read back in this session" if "Press" in words else words  # by then they are asked for zero
    assert card.coils.text().startswith(said)
    asked_for_zero = any(one[0] == "off" for one in still.desk.switch.asked)
    assert asked_for_zero == ("Press" in words)  # by another worker, without being told to


def test_the_card_of_a_run_learns_that_its_coils_were_switched_off_after_it(qtbot, still):
    card = fail(still, LOST, coils=(ON,))
    qtbot.keyClick(still, Qt.Key.Key_F12)
    still.desk.switch.answer("off", [{"axis": a, "current_A": 0.0, "words": "zero", "ok": True} for a in "xyz"])
    assert card.coils.text() == "zero by the supply's word only: no reference was asked"


def test_what_was_read_grows_old_in_the_window(still):
    still.desk.run.start(Order("preflight", "bench.toml"))
    told(still)
    assert still.desk.lab.state.coil_words == "coils at zero"
    told(still, age_s=7.0)
    assert still.desk.lab.state.coil_words == "coils last read back below their zero 7 s ago, not since"
    told(still, verdict="disagrees")
    assert still.desk.lab.state.coil_words.startswith("NOT at zero by the reference: it sees 20400")
    assert still.desk.run.coils_at_zero is False


def test_a_fault_names_the_instrument_and_not_its_link_alone(still):
    still.desk.run.links = LINKS
    card = fail(still, LOST)
    assert card.text.text() == "reference (serial:///dev/ttyUSB9): the link is lost."
    assert ("reference", "fault", "failed") in still.desk.lab.state.lights
    assert with_names(Fault("instrument", "dut: silent"), LINKS).text == "dut: silent"


def test_a_full_disk_is_said_as_such_and_is_no_fault_of_labcal_s():
    full = fault_of(OSError(errno.ENOSPC, "No space left on device", "/lab/runs.sqlite"))
    assert (full.kind, full.text) == ("input", "/lab/runs.sqlite: No space left on device")
    assert fault_of(InstrumentError("ref is silent", remedy="Look.")).kind == "instrument"
    assert fault_of(KeyError("x")).kind == "crash"


def test_a_bench_that_cannot_be_read_leaves_the_one_that_is_open(still, tmp_path):
    before = still.desk.bench
    still.desk.open_bench(str(tmp_path / "broken.toml"))
    (_, _, failed, _) = still.desk.clerk.asked[-1]
    failed(Fault("input", "broken.toml, line 1: is not TOML"))
    assert still.fault.isVisible()
    assert still.desk.bench == before == str(still.desk.settings.value("bench"))


def test_no_other_bench_is_opened_while_a_run_goes_on(still, tmp_path):
    still.desk.run.start(Order("preflight", "bench.toml"))
    asked = len(still.desk.clerk.asked)
    still.desk.open_bench(str(tmp_path / "other.toml"))
    assert len(still.desk.clerk.asked) == asked
    assert "A run goes on" in still.fault.text.text()


def test_coils_off_without_a_bench_says_so(qtbot, still, monkeypatch):
    monkeypatch.setattr(still.desk, "bench", "")
    qtbot.keyClick(still, Qt.Key.Key_F12)
    assert still.desk.lab.state.message == "Coils off: no bench is open, this window drives no coil."
    assert not [one for one in still.desk.switch.asked if one[0] == "off"]


def test_what_breaks_in_the_window_itself_is_a_card(still, capsys):
    error = ZeroDivisionError("division by zero")
    still.desk.broke(ZeroDivisionError, error, None)
    assert still.fault.isVisible()
    assert still.fault.fault.kind == "crash"
    assert "division by zero" in capsys.readouterr().err


def test_the_words_of_a_question_go_when_the_run_fails_under_it(still):
    card = fail(still, LOST, Prompt(1.0, "mount-x", "Mount it.", ("done",), True))
    assert card.isVisible()
    assert not still.page("Run").live.prompt.isVisible()
    assert Path(still.desk.bench).name == "simulated.toml"

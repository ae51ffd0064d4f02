"""Several silent instruments that share a line are said to do so; nobody is blamed alone."""

import time
from dataclasses import replace

import pytest

from labcal.bench.coils.state import CoilReading, Heard, LabState, unread
from labcal.gui.viewmodels.in_common import in_common

LINKS = {
    "supply_x": "tcp://10.0.0.7:5001",
    "supply_y": "tcp://10.0.0.7:5002",
    "supply_z": "modbus-rtu:///dev/ttyUSB1?baud=9600",
    "reversers": "modbus-rtu:///dev/ttyUSB1?baud=9600",
    "dut": "serial:///dev/ttyUSB3",
    "stage": "manual://",
}


@pytest.mark.parametrize(
    ("silent", "said"),
    [
        ((), ""),
        (("dut",), ""),
        (("supply_x",), ""),
        (("supply_x", "dut"), ""),
        (
            ("supply_x", "supply_y"),
            "No answer from all 2 instruments at 10.0.0.7: look at their common line, not at each plug.",
        ),
        (
            ("supply_x", "supply_z", "reversers"),
            "No answer from 3 instruments, all 2 at /dev/ttyUSB1 among them: look at that common line first.",
        ),
        (
            ("supply_x", "supply_y", "supply_z", "reversers", "dut"),
            "No answer from all 5 instruments: is the rack’s power off, or the adapter or network gone?",
        ),
    ],
)
def test_what_the_silent_ones_share_is_said(silent, said):
    assert in_common(silent, LINKS) == said


def test_of_one_computer_alone_it_is_that():
    links = {name: f"tcp://lab:{k}" for k, name in enumerate("abcd")}
    assert in_common("abcd", links).startswith("No answer from all 4 instruments at lab")
    assert in_common("abc", links) == ""
    assert in_common("ab", dict.fromkeys("ab", "emulated://")) == ""


def test_the_panel_and_the_cards_say_it(still):
    app_state = still.app_state
    instruments = {n: replace(one, link="tcp://lab:1") for n, one in app_state.facts.instruments.items()}
    app_state.facts = replace(app_state.facts, instruments=instruments)
    app_state.take_lab(LabState(unread(), instruments=tuple(Heard(name, None, "silent") for name in instruments)))
    said = "No answer from all 7 instruments at lab: look at their common line, not at each plug."
    assert still.side.legend.text() == said
    assert still.side.legend.property("state") == "bad"
    now = time.monotonic()
    zero = tuple(CoilReading(axis, 0.0, 0.0, True, True, now) for axis in "xyz")
    app_state.take_lab(LabState(zero, instruments=(Heard("dut", None, "silent"),)))
    assert said not in still.side.legend.text()

"""Answers that other packages' tests record of these instruments (PyMeasure, InstrumentKit), at our drivers.

They write numbers otherwise than our emulators: without decimals, with short exponents, with more blanks.
"""

from __future__ import annotations

import struct
from typing import Any

import pytest

from drivers.genesys import GenesysSupply
from drivers.kepco_bop import KepcoBop
from drivers.keysight_e36300 import KeysightSupply
from drivers.newport_esp301 import Esp301Stage
from drivers.scpi_table import TableSupply
from drivers.thorlabs_apt import AptStage
from labcal.bench.driver_kit.testing import SILENT, scripted
from labcal.errors import InstrumentError

ANSWERS = {  # by whom: driver, question, answer, what is read, settings
    "kepco, PyMeasure: 4.99 mA": (KepcoBop, b"MEAS:CURR?\n", b"4.99E-3\n", 0.00499, {}),
    "kepco, PyMeasure: a set-point of 0.1 A": (KepcoBop, b"CURR?\n", b"9.989E-2\n", 0.09989, {}),
    "66xx, InstrumentKit": (TableSupply, b"CURR?\n", b"10.0\n", 10.0, {"model": "agilent-66xx"}),
    "66xx measures, InstrumentKit": (TableSupply, b"MEAS:CURR?\n", b"5e-2\n", 0.05, {"model": "agilent-66xx"}),
    "delta, InstrumentKit": (TableSupply, b"MEAS:CUR?\n", b"0.1\n", 0.1, {"model": "delta-sm"}),
    "siglent, PyMeasure": (TableSupply, b"CH1:CURR?\n", b"0.5\n", 0.5, {"model": "siglent-spd1000x"}),
    "e36312a, PyMeasure": (KeysightSupply, b"CURR? (@3)\n", b"0.5\n", 0.5, {"output": 3}),
    "esp301, InstrumentKit": (Esp301Stage, b"1TP\r", b"42\r\n", 42.0, {}),
}


@pytest.mark.parametrize("case", ANSWERS)
def test_a_number_is_read_as_they_record_it(case: str) -> None:
    driver, question, answer, value, settings = ANSWERS[case]
    with scripted(driver, [(question, answer)], **settings) as there:
        read: Any = there.angle_deg if driver is Esp301Stage else (
            there.measure_current if b"MEAS" in question else there.set_point
        )  # fmt: skip
        assert read() == pytest.approx(value, abs=1e-12)


def test_a_genesys_that_answers_without_decimals_has_taken_what_it_was_told() -> None:
    wire = [(b"ADR 6\r", b"OK\r"), (b"RMT REM\r", b"OK\r"), (b"PC 10.0000\r", b"OK\r"), (b"PC?\r", b"10\r")]
    with scripted(GenesysSupply, wire, max_current_A=20.0) as supply:
        supply.set_current(10.0)


def test_a_kdc101_as_instrumentkit_packs_it() -> None:
    """Its serial number is four bytes there, its firmware A1.A2.A3 in hexadecimal."""
    facts = struct.pack("<4s8sH4s48s12x3H", b"\1\2\3\4", b"KDC101", 16, b"\xa3\xa2\xa1\0", b"abcdefg", 42, 43, 1)
    said = struct.pack("<HHBB", 0x0006, len(facts), 0x81, 0x50) + facts
    wire = [(bytes.fromhex("120000005001"), SILENT), (bytes.fromhex("050000005001"), said)]
    with scripted(AptStage, wire, counts_per_deg=1919.64) as stage:
        who = stage.identify()
    assert (who.model, int(who.serial)) == ("KDC101", 0x04030201)
    assert who.firmware == f"{0xA1}.{0xA2}.{0xA3}"


def test_an_error_of_a_66xx_is_said_in_its_words() -> None:
    wire = [(b"CURR 0.5000\n", SILENT), (b"SYST:ERR?\n", b'-222,"Data out of range"\n')]
    with scripted(TableSupply, wire, model="agilent-66xx") as supply:
        with pytest.raises(InstrumentError, match="Data out of range") as caught:
            supply.set_current(0.5)
        assert caught.value.fault == "refused"

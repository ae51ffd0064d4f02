"""Rigol DP800: transcripts after the programming guide."""

from __future__ import annotations

import pytest

from drivers.rigol_dp800 import RigolSupply
from labcal.bench.driver_kit.testing import SILENT, scripted
from labcal.errors import InstrumentError, LimitError

OK = (b":SYST:ERR?\n", b'0,"No error"\n')


def test_identity_empties_the_error_queue() -> None:
    wire = [(b"*IDN?\n", b"RIGOL TECHNOLOGIES,DP832,DP8A000001,00.01.14\n"),
            (b":SYST:ERR?\n", b'-113,"Undefined header"\n'), OK]  # fmt: skip
    with scripted(RigolSupply, wire) as supply:
        assert supply.identify().model == "DP832"


def test_the_output_answers_in_words() -> None:
    wire = [(b":SOUR3:VOLT 5.000\n", SILENT), OK, (b":SOUR3:VOLT?\n", b"5.000\n"),
            (b":OUTP CH3,ON\n", SILENT), OK, (b":OUTP? CH3\n", b"ON\n")]  # fmt: skip
    with scripted(RigolSupply, wire, channel=3, compliance_V=5.0) as supply:
        supply.output(True)


def test_an_output_that_stays_off_is_a_fault() -> None:
    wire = [(b":OUTP CH1,OFF\n", SILENT), OK, (b":OUTP? CH1\n", b"ON\n")]
    with scripted(RigolSupply, wire) as supply, pytest.raises(InstrumentError, match="reads back 1"):
        supply.output(False)


def test_a_state_that_is_no_word_of_its_is_a_wrong_reply() -> None:
    wire = [(b":OUTP CH1,OFF\n", SILENT), OK, (b":OUTP? CH1\n", b"OF\xb2\n")]
    with scripted(RigolSupply, wire) as supply, pytest.raises(InstrumentError) as caught:
        supply.output(False)
    assert caught.value.fault == "wrong reply"


def test_the_queued_error_is_quoted() -> None:
    wire = [(b":SOUR1:CURR 1.0000\n", SILENT), (b":SYST:ERR?\n", b'-222,"Data out of range"\n')]
    with scripted(RigolSupply, wire) as supply, pytest.raises(InstrumentError, match="Data out of range"):
        supply.set_current(1.0)


def test_beyond_the_limit_nothing_is_sent() -> None:
    with scripted(RigolSupply, []) as supply, pytest.raises(LimitError, match=r"3\.2 A.*3 A"):
        supply.set_current(3.2)

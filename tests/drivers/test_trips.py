"""A supply whose protection has switched its output off says which one, and zero is never barred by it."""

from __future__ import annotations

from typing import Any

import pytest

from drivers.keysight_e36300 import KeysightSupply
from drivers.korad_ka3005p import KoradSupply
from drivers.rigol_dp800 import RigolSupply
from drivers.tti_pl import TtiSupply
from labcal.bench.testing import SILENT, scripted
from labcal.errors import InstrumentError

Wire = list[tuple[bytes, Any]]


def tti(*reply: bytes) -> Wire:
    return [(b"I1 1.0000\n", SILENT), (b"*ESR?\n", b"0\r\n"), (b"I1?\n", b"I1 1.0000\r\n"),
            (b"I1O?\n", b"0.000A\r\n"), *((b"LSR1?\n", one) for one in reply)]  # fmt: skip


def rigol(*replies: bytes) -> Wire:
    asked = (b":OUTP:OVP:QUES? CH1\n", b":OUTP:OCP:QUES? CH1\n")
    return [(b":SOUR1:CURR 1.0000\n", SILENT), (b":SYST:ERR?\n", b'0,"No error"\n'), (b":SOUR1:CURR?\n", b"1.000\n"),
            (b":MEAS:CURR? CH1\n", b"0.0000\n"), *zip(asked, replies, strict=True)]  # fmt: skip


def keysight(*replies: bytes) -> Wire:
    asked = (b"VOLT:PROT:TRIP? (@1)\n", b"CURR:PROT:TRIP? (@1)\n")
    return [(b"CURR 1.0000,(@1)\n", SILENT), (b"SYST:ERR?\n", b'+0,"No error"\n'), (b"CURR? (@1)\n", b"+1.0E+00\n"),
            (b"MEAS:CURR? (@1)\n", b"+0.0E+00\n"), *zip(asked, replies, strict=True)]  # fmt: skip


def korad(status: bytes) -> Wire:
    return [(b"ISET1:1.000", SILENT), (b"ISET1?", b"1.000"), (b"IOUT1?", b"0.000"), (b"STATUS?", status)]


@pytest.mark.parametrize(
    ("driver", "wire", "kind"),
    [
        (TtiSupply, tti(b"4\r\n"), "over-voltage"),
        (TtiSupply, tti(b"9\r\n"), "over-current"),
        (TtiSupply, tti(b"64\r\n"), "thermal"),
        (RigolSupply, rigol(b"YES\n", b"NO\n"), "over-voltage"),
        (RigolSupply, rigol(b"NO\n", b"YES\n"), "over-current"),
        (KeysightSupply, keysight(b"1\n", b"0\n"), "over-voltage"),
        (KeysightSupply, keysight(b"0\n", b"1\n"), "over-current"),
        (KoradSupply, korad(b"\x10"), "over-voltage or over-current"),
    ],
)
def test_a_trip_is_named(driver: Any, wire: Wire, kind: str) -> None:
    with scripted(driver, wire) as supply:
        supply.set_current(1.0)
        with pytest.raises(InstrumentError, match=f"its {kind} protection tripped") as caught:
            supply.measure_current()
    assert caught.value.fault == "tripped"
    assert "panel" in caught.value.remedy


@pytest.mark.parametrize(
    ("driver", "wire"),
    [(TtiSupply, tti(b"2\r\n")), (RigolSupply, rigol(b"NO\n", b"NO\n")), (KeysightSupply, keysight(b"0\n", b"0\n"))],
)
def test_a_current_that_is_missing_without_a_trip_is_handed_on(driver: Any, wire: Wire) -> None:
    with scripted(driver, wire) as supply:
        supply.set_current(1.0)
        assert supply.measure_current() == 0.0


def test_at_zero_nobody_asks_for_trips() -> None:
    wire = [(b"I1 0.0000\n", SILENT), (b"*ESR?\n", b"0\r\n"), (b"I1?\n", b"I1 0.0000\r\n"), (b"I1O?\n", b"0.000A\r\n")]
    with scripted(TtiSupply, wire) as supply:
        supply.set_current(0.0)
        assert supply.measure_current() == 0.0


def test_a_zero_that_was_only_written_asks_for_none_either() -> None:
    set_to_1_A = tti()[:3]
    wire = [*set_to_1_A, (b"I1 0.0000\n", SILENT), (b"I1O?\n", b"0.000A\r\n")]
    with scripted(TtiSupply, wire) as supply:
        supply.set_current(1.0)
        supply.write_current(0.0)
        assert supply.measure_current() == 0.0

"""Keysight E36300: channel lists, numbers with exponents, and no output that drags another along."""

from __future__ import annotations

import pytest

from drivers.keysight_e36300 import KeysightSupply
from labcal.bench.testing import SILENT, scripted
from labcal.errors import InstrumentError, LimitError

OK = (b"SYST:ERR?\n", b'+0,"No error"\n')
FREE = [(b"OUTP:PAIR?\n", b"OFF\n"), (b"OUTP:TRAC?\n", b"0\n")]


def told(text: bytes, ask: bytes, reply: bytes) -> list[tuple[bytes, bytes | None]]:
    return [(text + b"\n", SILENT), OK, (ask + b"\n", reply + b"\n")]


ON = [*told(b"VOLT 6.000,(@1)", b"VOLT? (@1)", b"+6.00000000E+00"), *told(b"OUTP 1,(@1)", b"OUTP? (@1)", b"1")]
OFF = told(b"OUTP 0,(@1)", b"OUTP? (@1)", b"0")


def test_a_current_goes_to_its_own_channel_and_comes_back_with_an_exponent() -> None:
    with scripted(KeysightSupply, told(b"CURR 1.0000,(@2)", b"CURR? (@2)", b"+1.00000000E+00"), output=2) as supply:
        supply.set_current(1.0)


def test_the_output_goes_on_uncoupled_and_with_its_compliance() -> None:
    wire = [
        *FREE,
        *told(b"VOLT 6.000,(@1)", b"VOLT? (@1)", b"+6.00000000E+00"),
        *told(b"OUTP 1,(@1)", b"OUTP? (@1)", b"1"),
    ]
    with scripted(KeysightSupply, wire) as supply:
        supply.output(True)


@pytest.mark.parametrize("state", [b"PAR\n", b"SER\n"])
def test_paired_outputs_are_not_energised(state: bytes) -> None:
    with (
        scripted(KeysightSupply, [(b"OUTP:PAIR?\n", state)]) as supply,
        pytest.raises(InstrumentError, match="pairing is") as caught,
    ):
        supply.output(True)
    assert caught.value.fault == "wrong mode"


def test_tracking_outputs_are_not_energised_but_are_switched_off() -> None:
    with scripted(
        KeysightSupply, [FREE[0], (b"OUTP:TRAC?\n", b"1\n"), *told(b"OUTP 0,(@1)", b"OUTP? (@1)", b"0")]
    ) as supply:
        with pytest.raises(InstrumentError, match="tracking is"):
            supply.output(True)
        supply.output(False)


def test_a_coupling_that_a_model_has_not_is_a_setting() -> None:
    with scripted(KeysightSupply, [FREE[0], *ON], couplings=("pairing",)) as supply:
        supply.output(True)


@pytest.mark.parametrize("amps", [3.01, -0.01, float("inf")])
def test_beyond_the_limit_nothing_is_sent(amps: float) -> None:
    with scripted(KeysightSupply, []) as supply, pytest.raises(LimitError, match="nothing was sent"):
        supply.set_current(amps)


def test_what_it_refuses_is_said_in_its_words() -> None:
    wire = [(b"CURR 2.0000,(@1)\n", SILENT), (b"SYST:ERR?\n", b'-222,"Data out of range"\n')]
    with scripted(KeysightSupply, wire) as supply, pytest.raises(InstrumentError, match="Data out of range"):
        supply.set_current(2.0)


def test_a_read_back_that_differs_is_a_fault() -> None:
    wire = told(b"CURR 0.5000,(@1)", b"CURR? (@1)", b"+5.10000000E-01")
    with scripted(KeysightSupply, wire) as supply, pytest.raises(InstrumentError) as caught:
        supply.set_current(0.5)
    assert caught.value.fault == "read-back"


@pytest.mark.parametrize("model", [b"E3631A", b"E36233A", b""])
def test_a_model_with_another_dialect_is_refused(model: bytes) -> None:
    with (
        scripted(KeysightSupply, [(b"*IDN?\n", b"HEWLETT-PACKARD," + model + b",0,2.1\n")]) as supply,
        pytest.raises(InstrumentError) as caught,
    ):
        supply.identify()
    assert caught.value.fault == "another instrument"


WATCHED = [
    *told(b"OUTP:PROT:WDOG:DEL 5", b"OUTP:PROT:WDOG:DEL?", b"5"),
    *told(b"OUTP:PROT:WDOG 1", b"OUTP:PROT:WDOG?", b"1"),
]


def test_its_watchdog_is_set_and_read_back_before_the_output_goes_on_and_fed_while_it_minds() -> None:
    with scripted(KeysightSupply, [*FREE, *WATCHED, *ON, (b"OUTP:PROT:WDOG?\n", b"1\n")], watchdog_s=5) as supply:
        supply.output(True)
        supply.feed()


def test_a_watchdog_that_is_off_again_is_a_fault() -> None:
    wire = [*FREE, *WATCHED, *ON, (b"OUTP:PROT:WDOG?\n", b"0\n")]
    with scripted(KeysightSupply, wire, watchdog_s=5) as supply:
        supply.output(True)
        with pytest.raises(InstrumentError, match="watchdog is off") as caught:
            supply.feed()
    assert caught.value.fault == "tripped"


def test_a_model_without_a_watchdog_is_not_energised_where_one_is_stated() -> None:
    wire = [*FREE, (b"OUTP:PROT:WDOG:DEL 5\n", SILENT), (b"SYST:ERR?\n", b'-113,"Undefined header"\n')]
    with (
        scripted(KeysightSupply, wire, watchdog_s=5) as supply,
        pytest.raises(InstrumentError, match="Leave watchdog_s out") as caught,
    ):
        supply.output(True)
    assert caught.value.fault == "refused"


def test_its_watchdog_is_off_before_its_panel_has_it_back() -> None:
    off = told(b"OUTP:PROT:WDOG 0", b"OUTP:PROT:WDOG?", b"0")
    zero = told(b"CURR 0.0000,(@1)", b"CURR? (@1)", b"+0.00000000E+00")
    wire = [*FREE, *WATCHED, *ON, *zero, *OFF, *off, (b"SYST:LOC\n", SILENT)]
    with scripted(KeysightSupply, wire, watchdog_s=5) as supply:
        supply.output(True)
        supply.make_safe()


def test_make_safe_opens_the_output_even_when_zeroing_fails() -> None:
    wire = [(b"CURR 0.0000,(@1)\n", SILENT), (b"SYST:ERR?\n", b'-350,"Queue overflow"\n'),
            *told(b"OUTP 0,(@1)", b"OUTP? (@1)", b"0")]  # fmt: skip
    with scripted(KeysightSupply, wire) as supply, pytest.raises(InstrumentError, match="Queue overflow"):
        supply.make_safe()

"""Korad: replies by count of bytes, strays that are passed over, and sets that were dropped."""

from __future__ import annotations

from datetime import UTC, datetime

import pytest

from drivers.emulators.korad_ka3005p import KoradEmulator
from drivers.korad_ka3005p import KoradSupply, Settings
from labcal.bench.clock import VirtualClock
from labcal.bench.driver_kit.testing import SILENT, scripted
from labcal.bench.links import EmulatedLink
from labcal.errors import InstrumentError, LimitError
from labcal.twin import open_twin


def test_a_set_has_no_line_end_and_its_read_back_a_stray_sixth_byte() -> None:
    wire = [(b"ISET1:1.250", SILENT), (b"ISET1?", b"1.250K"), (b"IOUT1?", b"1.249")]
    with scripted(KoradSupply, wire) as supply:
        supply.set_current(1.25)
        assert supply.measure_current() == 1.249


def test_newer_firmware_wants_a_line_end_which_is_a_setting() -> None:
    with scripted(KoradSupply, [(b"IOUT1?\n", b"0.499\n"), (b"STATUS?\n", b"\x51\n")], terminator="\n") as supply:
        assert supply.measure_current() == 0.499
        assert supply.enabled == 1


@pytest.mark.parametrize(
    ("said", "model", "serial", "firmware"),
    [
        (b"KORADKA3005PV2.0", "KA3005P", "", "2.0"),
        (b"TENMA 72-2540 V5.3 SN:01234567\n", "72-2540", "01234567", "5.3"),
    ],
)
def test_its_name_ends_where_the_line_falls_quiet(said: bytes, model: str, serial: str, firmware: str) -> None:
    with scripted(KoradSupply, [(b"*IDN?", [said[:5], said[5:9], said[9:]])]) as supply:
        who = supply.identify()
    assert (who.model, who.serial, who.firmware) == (model, serial, firmware)


def test_a_name_that_came_twice_is_one() -> None:
    with scripted(KoradSupply, [(b"*IDN?", b"KORADKA3005PV2.0KORADKA3005PV2.0")]) as supply:
        who = supply.identify()
    assert (who.model, who.firmware) == ("KA3005P", "2.0")


def test_an_answer_without_a_letter_is_nobody_s_name() -> None:
    wire = [(b"*IDN?", b"\0"), (b"*IDN?", b"\r\n")]
    with (
        scripted(KoradSupply, wire) as supply,
        pytest.raises(InstrumentError, match="nothing that can be read") as caught,
    ):
        supply.identify()
    assert caught.value.fault == "wrong reply"


def test_another_instrument_is_refused() -> None:
    with scripted(KoradSupply, [(b"*IDN?", b"RIGOL,DP832\n")]) as supply, pytest.raises(InstrumentError) as caught:
        supply.identify()
    assert caught.value.fault == "another instrument"


def test_before_the_output_goes_on_its_voltage_is_set() -> None:
    wire = [(b"VSET1:05.00", SILENT), (b"VSET1?", b"05.00"), (b"OUT1", SILENT), (b"STATUS?", b"\x51")]
    with scripted(KoradSupply, wire, compliance_V=5.0) as supply:
        supply.output(True)


def test_a_command_that_was_dropped_is_seen_in_the_read_back() -> None:
    wire = [(b"ISET1:0.500", SILENT), (b"ISET1?", b"0.000K")]
    with scripted(KoradSupply, wire) as supply, pytest.raises(InstrumentError) as caught:
        supply.set_current(0.5)
    assert caught.value.fault == "read-back"


def test_a_question_that_was_dropped_is_put_once_more() -> None:
    wire = [(b"IOUT1?", SILENT), (b"IOUT1?", b"0.499"), (b"*IDN?", SILENT), (b"*IDN?", b"KORADKA3005PV2.0")]
    with scripted(KoradSupply, wire) as supply:
        assert supply.measure_current() == 0.499
        assert supply.identify().model == "KA3005P"


def test_a_set_that_nothing_confirms_is_not_sent_again() -> None:
    wire = [(b"ISET1:0.500", SILENT), (b"ISET1?", SILENT), (b"ISET1?", SILENT)]
    with scripted(KoradSupply, wire) as supply, pytest.raises(InstrumentError) as caught:
        supply.set_current(0.5)
    assert caught.value.fault == "silent"


def test_sets_that_follow_each_other_at_once_reach_it_and_at_60_ms_they_are_lost() -> None:
    clock, lab = VirtualClock(datetime(2026, 1, 1, tzinfo=UTC)), open_twin({}, 1)
    link = EmulatedLink("emulated://x", KoradEmulator(lab, {"coil-x": {}}, Settings()), clock)
    steady = KoradSupply("x", link, clock, Settings())
    steady.write_off()
    steady.set_current(0.25)
    clock.wait_until(clock.now() + 1.0)
    hasty = KoradSupply("x", link, clock, Settings(gap_s=0.06))
    hasty.write_off()
    with pytest.raises(InstrumentError) as caught:
        hasty.set_current(0.5)
    assert caught.value.fault == "read-back"


def test_an_output_that_stays_on_is_a_fault() -> None:
    wire = [(b"OUT0", SILENT), (b"STATUS?", b"\x50")] * 2
    with scripted(KoradSupply, wire) as supply, pytest.raises(InstrumentError, match="enabled was set to 0 and reads"):
        supply.output(False)


def test_zero_and_off_are_told_once_more_as_it_may_have_been_deaf_and_nothing_else_is() -> None:
    off, zero = (b"OUT0", SILENT), (b"ISET1:0.000", SILENT)
    wire = [zero, (b"ISET1?", b"0.113K"), zero, (b"ISET1?", b"0.000K"), off, (b"STATUS?", b"\x51"), off,
            (b"STATUS?", b"\x11"), (b"ISET1:0.100", SILENT), (b"ISET1?", b"0.000K")]  # fmt: skip
    with scripted(KoradSupply, wire) as supply:
        supply.set_current(0.0)
        supply.output(False)
        with pytest.raises(InstrumentError, match="reads back 0 A"):
            supply.set_current(0.1)


@pytest.mark.parametrize("amps", [3.001, -0.001, float("nan")])
def test_beyond_the_limit_nothing_is_sent(amps: float) -> None:
    with scripted(KoradSupply, []) as supply, pytest.raises(LimitError, match="nothing was sent"):
        supply.set_current(amps)


def test_make_safe_opens_the_output_even_when_zeroing_fails() -> None:
    wire = [*[(b"ISET1:0.000", SILENT), (b"ISET1?", b"0.500K")] * 2, (b"OUT0", SILENT), (b"STATUS?", b"\x01")]
    with scripted(KoradSupply, wire) as supply, pytest.raises(InstrumentError, match="reads back"):
        supply.make_safe()


def test_half_a_name_is_not_the_last_word_and_another_name_is() -> None:
    with scripted(KoradSupply, [(b"*IDN?", b"ORADKA3005PV2.0"), (b"*IDN?", b"KORADKA3005PV2.0")]) as supply:
        assert supply.identify().model == "KA3005P"
    wire = [(b"*IDN?", b"HMR2300"), (b"*IDN?", b"HMR2300")]
    with scripted(KoradSupply, wire) as supply, pytest.raises(InstrumentError, match="not a Korad") as caught:
        supply.identify()
    assert caught.value.fault == "another instrument"


def test_so_is_a_number_that_comes_for_its_name_again_and_again() -> None:
    wire = [(b"*IDN?", b"0.000"), (b"*IDN?", b"0.000")]
    says = r"an answer of an earlier question came to '\*IDN\?': '0\.000'"
    with scripted(KoradSupply, wire) as supply, pytest.raises(InstrumentError, match=says) as caught:
        supply.identify()
    assert caught.value.fault == "out of step"


def test_a_name_that_comes_for_a_number_is_an_answer_of_an_earlier_question() -> None:
    name = b"KORADKA3005PV2.0"
    wire = [(b"*IDN?", name), (b"ISET1?", name), (b"IOUT1?", b"0.000")]
    with scripted(KoradSupply, wire) as supply:
        supply.identify()
        with pytest.raises(InstrumentError, match=r"an answer of an earlier question came to 'ISET1\?': 'KORAD'"):
            supply.set_point()
        assert supply.measure_current() == 0.0

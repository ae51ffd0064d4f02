"""Metrolab: units in every reply, errors, out of range, another instrument, silence, unplugging."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from drivers.metrolab import Metrolab, Settings, nanotesla
from labcal.bench.driver_kit.testing import Exchange, scripted
from labcal.errors import InstrumentError

FINE = b'0,"No error";0\n'
CHECK = b":SYST:ERR?;*STB?\n"
WORDS = (b":ABOR", b":INIT:CONT OFF", b":FORM:DATA ASCII", b":AVER:COUN 100", b":TRIG:SOUR IMM", b":TRIG:COUN 1")
FETCH = b":INIT;:FETC:ARR:X? 1,9;:FETC:ARR:Y? 1,9;:FETC:ARR:Z? 1,9\n"


def begun(*more: bytes) -> list[Exchange]:
    return [e for words in (*WORDS, *more) for e in ((words + b"\n", None), (CHECK, FINE))]


def polled(*replies: object, **settings: object) -> tuple[np.ndarray, dict[str, int]]:
    with scripted(Metrolab, [*begun(), *((FETCH, reply) for reply in replies)], **settings) as meter:
        meter.start()
        blocks = meter.read_until(meter._clock.now() + 0.1 * (len(replies) - 1) + 0.05)
        lost = {e.data["fault"]: e.data["lost"] for e in meter.events()}
        return np.vstack([b.values for b in blocks]) if blocks else np.empty((0, 3)), lost


def test_it_says_who_it_is_after_its_old_errors_are_read() -> None:
    idn = b"Metrolab Technology SA,THM1176-LF,0000123,EL v2.0 C v3.0\n"
    wire: list[Exchange] = [(b"*IDN?\n", idn), (CHECK, b'-113,"Undefined header";4\n'), (CHECK, FINE)]
    with scripted(Metrolab, wire) as meter:
        assert meter.identify().model == "THM1176-LF"
    with scripted(Metrolab, [(b"*IDN?\n", b"KEITHLEY,2000,1,2\n")]) as meter, pytest.raises(InstrumentError) as caught:
        meter.identify()
    assert caught.value.fault == "another instrument"


def test_the_unit_is_the_replys() -> None:
    values, lost = polled(b"0.000020000T;-0.000000010T;4.8E-05T\n", [b"20.5uT;-1", b"0nT;0.5G\n"])
    np.testing.assert_allclose(values, [[20000, -10, 48000], [20500, -10, 50000]])
    assert lost == {}


@pytest.mark.parametrize("bad", [b"1T;2T\n", b"1;2;3\n", b"0.1V;0T;0T\n", b"\xff\xfe;0T;0T\n", b"\n", b"0T;0T;0T;0T\n"])
def test_a_bad_reply_costs_itself_and_gives_no_value(bad: bytes) -> None:
    values, lost = polled(bad, b"1E-6T;0T;0T\n")
    np.testing.assert_allclose(values, [[1000, 0, 0]])
    assert lost == {"bad frame": 1}


@pytest.mark.parametrize("reply", [b"9.9E37T;0T;0T\n", b"0.0002T;0T;0T\n"])
def test_out_of_range_is_a_fault(reply: bytes) -> None:
    with pytest.raises(InstrumentError) as caught:
        polled(reply)
    assert caught.value.fault == "overloaded"


@pytest.mark.parametrize("text", ["0.0000205T", "0.0000205 T", " 2.05E-5  T ", "20.5 uT", "20500nT", ".205 G"])
def test_a_blank_may_stand_between_value_and_unit(text: str) -> None:
    assert nanotesla(text) == pytest.approx(20_500.0)


def test_a_setting_that_it_refuses_is_a_fault_with_its_words() -> None:
    wire = [*begun(), (b":SENS:FLUX:RANG 0.1T\n", None), (CHECK, b'-222,"Data out of range";4\n')]
    with scripted(Metrolab, wire, range_T="0.1") as meter, pytest.raises(InstrumentError, match="out of range"):
        meter.start()


@pytest.mark.parametrize("settings", [{"range_T": "0.1;*RST"}, {"rate": 0.0}, {"average": 0}, {"digits": 99}])
def test_settings_that_make_no_sense_are_refused(settings: dict[str, object]) -> None:
    with pytest.raises(ValueError, match=r"rate|range_T"):
        Settings(**settings)


@given(st.text(max_size=30))
def test_any_text_is_a_number_with_a_unit_or_none(text: str) -> None:
    value = nanotesla(text)
    assert value is None or text.strip()[-1] in "TG"

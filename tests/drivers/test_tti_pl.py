"""Aim-TTi: transcripts in the manual's own words, and what each fault becomes."""

from __future__ import annotations

import pytest

from drivers.tti_pl import TtiSupply
from labcal.bench.driver_kit.testing import SILENT, scripted
from labcal.errors import InstrumentError, LimitError

OK = (b"*ESR?\n", b"0\r\n")


def test_identity_clears_the_events_of_the_time_before() -> None:
    wire = [(b"*IDN?\n", b"THURLBY THANDAR, PL303QMT-P, 123456, 3.02-4.06\r\n"), (b"*ESR?\n", b"128\r\n")]
    with scripted(TtiSupply, wire) as supply:
        who = supply.identify()
    assert (who.model, who.serial) == ("PL303QMT-P", "123456")


def test_another_instrument_is_refused_by_name() -> None:
    wire = [(b"*IDN?\n", b"RIGOL TECHNOLOGIES,DP832,X,1\r\n")]
    with scripted(TtiSupply, wire) as supply, pytest.raises(InstrumentError, match="RIGOL") as caught:
        supply.identify()
    assert caught.value.fault == "another instrument"


def test_a_current_goes_out_with_four_decimals_and_is_read_back() -> None:
    wire = [(b"I2 1.2500\n", SILENT), OK, (b"I2?\n", b"I2 1.2500\r\n")]
    with scripted(TtiSupply, wire, output=2) as supply:
        supply.set_current(1.25)


@pytest.mark.parametrize("amps", [3.0001, -0.1, float("nan")])
def test_beyond_the_limit_nothing_is_sent(amps: float) -> None:
    with scripted(TtiSupply, []) as supply, pytest.raises(LimitError, match="nothing was sent"):
        supply.set_current(amps)


def test_a_read_back_that_differs_is_a_fault() -> None:
    wire = [(b"I1 0.5000\n", SILENT), OK, (b"I1?\n", b"I1 0.4500\r\n")]
    with scripted(TtiSupply, wire) as supply, pytest.raises(InstrumentError, match=r"reads back 0\.45") as caught:
        supply.set_current(0.5)
    assert caught.value.fault == "read-back"


@pytest.mark.parametrize(
    ("wire", "says"),
    [
        ([(b"*ESR?\n", b"16\r\n"), (b"EER?\n", b"200\r\n")], "another interface holds the lock"),
        ([(b"*ESR?\n", b"32\r\n")], "does not know"),
        ([(b"*ESR?\n", b"128\r\n")], "switched off and on"),
        ([(b"*ESR?\n", b"~\x80#\r\n")], "event register"),
        ([(b"*ESR?\n", b"66\r\n")], "failed: its event register is 66"),
    ],
)
def test_what_the_supply_refuses_is_said_in_words(wire: list[tuple[bytes, bytes]], says: str) -> None:
    with scripted(TtiSupply, [(b"I1 0.5000\n", SILENT), *wire]) as supply, pytest.raises(InstrumentError, match=says):
        supply.set_current(0.5)


def test_a_measured_current_comes_with_its_unit_even_in_pieces() -> None:
    with scripted(TtiSupply, [(b"I1O?\n", [b"0.4", b"99A\r", b"\n"])]) as supply:
        assert supply.measure_current() == 0.499


def test_make_safe_opens_the_output_even_when_zeroing_fails() -> None:
    wire = [(b"I1 0.0000\n", SILENT), (b"*ESR?\n", b"16\r\n"), (b"EER?\n", b"5\r\n"),
            (b"OP1 0\n", SILENT), OK, (b"OP1?\n", b"0\r\n")]  # fmt: skip
    with scripted(TtiSupply, wire) as supply, pytest.raises(InstrumentError, match="execution error 5"):
        supply.make_safe()


def test_before_the_output_closes_the_compliance_voltage_is_set() -> None:
    wire = [(b"V1 20.000\n", SILENT), OK, (b"V1?\n", b"V1 20.000\r\n"), (b"OP1 1\n", SILENT), OK, (b"OP1?\n", b"1\r\n")]
    with scripted(TtiSupply, wire) as supply:
        supply.output(True)


def test_an_answer_of_an_earlier_question_is_called_so_and_no_refusal() -> None:
    wire = [(b"I1O?\n", b"0.024A\r\n"), (b"I1 0.0000\n", SILENT), (b"*ESR?\n", b"0.031A\r\n")]
    says = r"an answer of an earlier question came to '\*ESR\?': '0\.031A'; the line is out of step"
    with scripted(TtiSupply, wire) as supply:
        assert supply.measure_current() == 0.024
        with pytest.raises(InstrumentError, match=says) as caught:
            supply.set_current(0.0)
    assert caught.value.fault == "out of step"


def test_so_is_one_that_is_read_as_a_number() -> None:
    wire = [(b"I1O?\n", b"0.024A\r\n"), (b"I1?\n", b"0.024A\r\n")]
    with scripted(TtiSupply, wire) as supply:
        assert supply.measure_current() == 0.024
        with pytest.raises(InstrumentError, match="an answer of an earlier question came to 'I1"):
            supply.set_point()


def test_one_that_is_like_no_other_is_said_as_it_came() -> None:
    wire = [(b"I1O?\n", b"0.024A\r\n"), (b"I1 0.0000\n", SILENT), (b"*ESR?\n", b"p\r\n")]
    with scripted(TtiSupply, wire) as supply:
        supply.measure_current()
        with pytest.raises(InstrumentError, match="its event register came back as 'p'"):
            supply.set_current(0.0)


@pytest.mark.parametrize("damaged", [b"0.031A\x0c\r\n", b"0.03-1A\r\n"])
def test_a_damaged_one_is_no_answer_of_an_earlier_question(damaged: bytes) -> None:
    wire = [(b"I1O?\n", b"0.024A\r\n"), (b"I1 0.0000\n", SILENT), (b"*ESR?\n", damaged)]
    with scripted(TtiSupply, wire) as supply:
        assert supply.measure_current() == 0.024
        with pytest.raises(InstrumentError) as caught:
            supply.set_current(0.0)
    assert caught.value.fault != "out of step"


def test_who_it_is_is_asked_again_where_an_earlier_answer_came_and_nothing_that_comes_late_counts_from_then_on() -> (
    None
):
    who = b"THURLBY THANDAR, PL303QMT-P, 123456, 3.02-4.06\r\n"
    twice = (b"*IDN?\n", [who] * 2)  # it hears everything twice
    wire = [(b"*IDN?\n", b"I1 0.3914\r\n"), twice, (b"*ESR?\n", [b"0\r\n"] * 2), (b"I1O?\n", [b"0.024A\r\n"] * 2)]
    with scripted(TtiSupply, wire) as supply:
        assert supply.identify().serial == "123456"
        assert supply.measure_current() == 0.024


def test_one_that_names_itself_by_no_name_twice_is_another() -> None:
    wire = [(b"*IDN?\n", b"7\r\n"), (b"*IDN?\n", b"7\r\n")]
    with scripted(TtiSupply, wire) as supply, pytest.raises(InstrumentError, match="not an Aim-TTi") as caught:
        supply.identify()
    assert caught.value.fault == "another instrument"

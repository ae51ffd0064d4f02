"""Who answers, compared; and what came over a line as it is quoted."""

from __future__ import annotations

import pytest

from labcal.bench.driver_kit.identities import one_at_two_links, refuse_other, the_same
from labcal.bench.driver_kit.roles import Identity
from labcal.bench.links.quoting import SENTENCE, SHOWN, abridged, quoted
from labcal.errors import InstrumentError

TTI = Identity("THURLBY THANDAR", "PL303QMT-P", "512340", "3.02")


@pytest.mark.parametrize(
    ("now", "said"),
    [
        (Identity("THURLBY THANDAR", "PL303QMT-P", "512341", "3.02"), "PL303QMT-P 512341 answers, before it was PL303"),
        (Identity("THURLBY THANDAR", "PL303QMT-P", "512340\0", "3.02"), r"512340\x00 answers, before it was PL303QMT"),
        (Identity("THURLBY THANDAR", "PL303QMT-P", "512340\u200b", "3.02"), r"512340\u200b answers"),
        (
            Identity("THURLBY THANDAR", "PL303QMT-P", "512340", "3.03\r"),
            r"512340 with firmware '3.03\r' answers, before it was one with firmware '3.02'",
        ),
    ],
)
def test_what_is_not_the_same_is_said(now: Identity, said: str) -> None:
    refuse_other("supply_x", TTI, TTI)
    with pytest.raises(InstrumentError) as caught:
        refuse_other("supply_x", now, TTI)
    assert caught.value.fault == "another instrument"
    assert said in caught.value.what


LINKS = {"x": "tcp://192.0.2.1:9221", "y": "tcp://192.0.2.2:9221", "z": "tcp://192.0.2.1:9221?gap_ms=5"}


def test_one_supply_at_two_links_is_a_fault_of_both() -> None:
    faults = one_at_two_links({"x": TTI, "y": TTI}, LINKS)
    assert set(faults) == {"x", "y"}
    assert "the same instrument answers on both links" in faults["y"].what
    assert "answers here and as x" in faults["y"].what


def test_two_outputs_of_one_supply_and_supplies_without_a_number_are_none() -> None:
    assert not one_at_two_links({"x": TTI, "z": TTI}, LINKS)
    for number in ("", "0", "000 "):
        same = Identity("KORAD", "KA3005P", number)
        assert not one_at_two_links({"x": same, "y": same}, LINKS)
    assert not one_at_two_links({"x": TTI, "y": Identity("RIGOL", "DP832", TTI.serial)}, LINKS)


def test_no_more_of_a_reply_is_quoted_than_can_be_read() -> None:
    assert quoted(b"ready\r\n") == r"b'ready\r\n'"
    assert quoted("x" * SHOWN) == repr("x" * SHOWN)
    assert quoted("x" * 3_000_000) == f"'{'x' * SHOWN}' … and 2999960 more"
    assert abridged("no\x1b[31m red") == r"no\x1b[31m red"
    assert abridged("x" * 3_000_000) == "x" * SENTENCE + " …"


OTHER, DAMAGED = (
    Identity("THURLBY THANDAR", "PL303QMT-P", "512399"),
    Identity("THURLBY THANDAR", "PL303QMTmP", "512340"),
)


@pytest.mark.parametrize(
    ("said", "before"), [([TTI], None), ([TTI], TTI), ([DAMAGED, TTI], TTI), ([OTHER, DAMAGED, TTI], TTI)]
)
def test_a_name_that_came_damaged_once_is_asked_for_again(said: list[Identity], before: Identity | None) -> None:
    answers = iter(said)
    assert the_same("supply_x", lambda: next(answers), before) == TTI
    assert next(answers, None) is None


@pytest.mark.parametrize(
    ("said", "fault"),
    [
        ([OTHER, OTHER], "another instrument"),
        ([DAMAGED, OTHER, OTHER], "another instrument"),
        ([DAMAGED, OTHER, DAMAGED], "wrong reply"),
    ],
)
def test_another_is_who_gives_the_same_other_name_twice_in_a_row(said: list[Identity], fault: str) -> None:
    answers = iter(said)
    with pytest.raises(InstrumentError) as caught:
        the_same("supply_x", lambda: next(answers), TTI)
    assert caught.value.fault == fault
    assert next(answers, None) is None

"""The judge on truths that are written by hand: it must see each fault that it names, and none that is not there."""

from __future__ import annotations

import math

import pytest
from judge import claims, false_claims, flowing, rises, zero_for_good, zero_heard
from lateness import sum_between

TAU_S = 0.02
UP_AND_DOWN = [[0.0, 0.0, 0.0], [10.0, 0.0, 1.0], [20.0, 1.0, 0.0004]]


def truth(flow):
    return {"flow": dict.fromkeys("xyz", flow), "tau_s": dict.fromkeys("xyz", TAU_S)}


def test_what_flows_follows_its_orders_through_the_inductance() -> None:
    assert flowing(UP_AND_DOWN, TAU_S, 5.0) == 0.0
    assert flowing(UP_AND_DOWN, TAU_S, 10.02) == pytest.approx(1 - math.exp(-1))
    assert flowing(UP_AND_DOWN, TAU_S, 15.0) == pytest.approx(1.0)
    assert flowing(UP_AND_DOWN, TAU_S, 30.0) == pytest.approx(0.0004)


def test_zero_is_when_the_current_is_small_for_good() -> None:
    at = zero_for_good(UP_AND_DOWN, TAU_S, 30.0)
    assert at is not None
    assert flowing(UP_AND_DOWN, TAU_S, at) == pytest.approx(0.005, abs=1e-4)
    assert zero_for_good(UP_AND_DOWN[:2], TAU_S, 30.0) is None
    again = [*UP_AND_DOWN, [21.0, 0.0004, 0.3], [22.0, 0.3, 0.0]]
    assert 22.0 < zero_for_good(again, TAU_S, 30.0) < 22.2


def test_zero_is_heard_at_the_first_order_of_zero_after_it_was_due() -> None:
    heard = [[1.0, 0.5], [2.0, 0.3], [3.0, 0.0]]
    assert zero_heard(heard, 1.5) == 3.0
    assert zero_heard(heard, 3.5) == 3.5
    assert zero_heard(heard[:2], 1.5) is None


def test_an_order_larger_than_one_before_is_seen_only_after_zero_was_ordered() -> None:
    sent = [[0.0, 0.4], [1.0, 1.8], [2.0, 0.9], [2.1, 0.0], [2.6, 1.7], [2.7, 0.0]]
    assert rises(sent, 1.5) == [(2.6, 1.7, 0.0)]
    assert rises(sent[:4], 1.5) == []
    assert rises(sent[:2], -1.0) == [(1.0, 1.8, 0.4)]


@pytest.mark.parametrize(
    ("words", "axes"),
    [
        ("session: stopped; coils at zero", "xyz"),
        ("another: the coils stay at zero.", "xyz"),
        ("guardian.log: [1] read back: coil x +0.0010 A, zero, open; coil z -0.0010 A, zero, not open", "xz"),
        ("session: coils NOT at zero by the reference", ""),
        ("session: coils at zero by the supply's word only", ""),
        ("guardian.log: [1] to zero: the session is done with it", ""),
    ],
)
def test_a_sentence_claims_what_it_says_and_no_more(words: str, axes: str) -> None:
    assert [claim.axes for claim in claims([(1.0, words)])] == [axes] * bool(axes)


def test_a_claim_is_false_while_current_flows_and_true_after() -> None:
    said = "session: coils at zero"
    assert [found[1] for found in false_claims([(15.0, said)], truth(UP_AND_DOWN))] == list("xyz")
    assert false_claims([(25.0, said)], truth(UP_AND_DOWN)) == []


def test_only_the_time_in_which_the_machine_kept_others_waiting_counts() -> None:
    late = [(5.0, 1.0), (10.2, 0.3), (30.0, 2.0)]
    assert sum_between(late, 10.0, 12.0) == pytest.approx(0.3)

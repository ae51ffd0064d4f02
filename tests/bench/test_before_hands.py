"""While hands mount, the ambient field of before them says zero where that excludes a current that matters, no more."""

from __future__ import annotations

import numpy as np
import pytest

from labcal.bench.coils.agreement import BEFORE_HANDS, CHANGED, LIMIT_NT, FieldCheck
from labcal.bench.coils.before_hands import MATTERS, MOUNTING_NT, least_that_matters_nT

MATRIX = np.array([[49_942.0, -221.0, 169.0], [-301.0, 49_951.0, 101.0], [-179.0, 151.0, 49_944.0]])
AMBIENT = np.array([20_400.0, 1_150.0, -43_700.0])
STRONG, WEAK = np.full(3, 2.5), np.full(3, 0.5)  # A, of a cage of 125 uT and of one of 25 uT
NOISE = np.random.default_rng(1).normal(0.0, 3.0, (5, 3))


def mounting(limit_A: np.ndarray = STRONG, **outdated: bool) -> FieldCheck:
    """Its ambient field was measured; hands are at the DUT since 10 s."""
    check = FieldCheck(MATRIX, limit_A)
    check.streaming = True
    check.take_ambient(AMBIENT, 0.0)
    check.expect(np.zeros(3), 0.0, 0.0)
    check.outdated(10.0, **{"by_hands": True, **outdated})
    return check


def sees(check: FieldCheck, field_nT: np.ndarray, at_s: float = 11.0) -> None:
    check.see(at_s + np.arange(5) / 10, field_nT + NOISE)


def test_a_field_as_before_hands_agrees_with_the_zero() -> None:
    check = mounting()
    sees(check, AMBIENT + (0.0, 900.0, 0.0))
    assert (check.witness.verdict, check.witness.why) == ("agrees", BEFORE_HANDS)
    assert check.ambient_nT is None  # no current is judged by it


@pytest.mark.parametrize(
    ("changed_nT", "why"), [(LIMIT_NT + 200.0, BEFORE_HANDS), (LIMIT_NT + MOUNTING_NT + 200.0, CHANGED)]
)
def test_what_a_mounting_may_have_changed_proves_nothing_and_is_no_doubt(changed_nT: float, why: str) -> None:
    check = mounting()
    sees(check, AMBIENT + (changed_nT, 0.0, 0.0))
    sees(check, AMBIENT + (changed_nT, 0.0, 0.0), 60.0)
    assert (check.witness.verdict, check.witness.why) == ("not known", why)


def test_no_current_that_matters_is_called_zero_however_a_mounting_hides_it() -> None:
    hides = np.random.default_rng(2)
    for axis in range(3):
        current_A = np.zeros(3)
        current_A[axis] = MATTERS * STRONG[axis]
        coils = 0.9 * MATRIX @ current_A
        against = -MOUNTING_NT * coils / np.linalg.norm(coils) + hides.normal(0.0, 10.0, 3)
        check = mounting()
        sees(check, AMBIENT + coils + against)
        assert check.witness.verdict == "not known"


def test_the_least_field_that_matters_is_that_of_the_weakest_direction() -> None:
    tilted = np.column_stack([(50_000.0, 0.0, 0.0), 50_000.0 * np.array([0.6, 0.8, 0.0]), (0.0, 0.0, 50_000.0)])
    least = least_that_matters_nT(tilted, STRONG, 0.1)
    currents = np.random.default_rng(3).uniform(-1.0, 1.0, (20_000, 3))
    currents *= MATTERS / np.abs(currents).max(axis=1, keepdims=True)  # one axis at it, the others below
    made = 0.9 * np.linalg.norm(currents * STRONG @ tilted.T, axis=1)
    assert least <= made.min()
    assert least == pytest.approx(0.9 * MATTERS * 2.5 * 50_000.0 * np.sqrt(1 - 0.6), rel=1e-6)


@pytest.mark.parametrize("outdated", [{"reference_moved": True}, {"by_hands": False}])
def test_a_reference_that_moved_or_coils_that_changed_the_place_end_it(outdated: dict[str, bool]) -> None:
    check = mounting(**outdated)
    sees(check, AMBIENT)
    assert check.witness.verdict == "not known"


def test_a_weak_cage_is_at_zero_by_the_supplies_alone() -> None:
    check = mounting(WEAK)
    sees(check, AMBIENT)
    assert (check.witness.verdict, check.witness.why) == ("not known", BEFORE_HANDS)


def test_it_wears_out_with_the_hours() -> None:
    check = mounting(np.full(3, 1.01))  # what matters is 45 nT more than hides behind a mounting
    sees(check, AMBIENT)
    assert check.witness.verdict == "agrees"
    sees(check, AMBIENT, 1800.0)
    assert check.witness.verdict == "not known"


def test_a_doubt_of_before_is_not_lifted_by_it() -> None:
    check = FieldCheck(MATRIX, STRONG)
    check.streaming = True
    check.take_ambient(AMBIENT, 0.0)
    check.expect(np.zeros(3), 0.0, 0.0)
    for at_s in (1.0, 5.0):
        sees(check, AMBIENT + (9_000.0, 0.0, 0.0), at_s)
    assert check.witness.verdict == "disagrees"
    check.outdated(10.0, by_hands=True)
    sees(check, AMBIENT)
    assert check.witness.verdict == "disagrees"

"""How often a stream samples, whatever its stamps are like: together, missing, backwards, alone."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from labcal.record import period_s


def test_where_all_stamps_differ_it_is_the_median_step() -> None:
    t = np.cumsum(np.random.default_rng(1).uniform(0.5, 1.5, 101))
    assert period_s(t) == np.median(np.diff(t))


@given(together=st.integers(1, 60), seed=st.integers(0, 5))
def test_lines_that_arrive_together_share_the_time_since_those_before(together: int, seed: int) -> None:
    t = np.arange(3000) * 1e-3
    arrived = t[np.minimum((np.arange(3000) // together + 1) * together, 3000) - 1]
    assert period_s(np.random.default_rng(seed).permutation(arrived)) == pytest.approx(1e-3, rel=0.01)


def test_bursts_of_one_line_and_of_many_are_weighed_by_their_samples() -> None:
    ends = np.cumsum(np.tile([0.1e-3, 19.9e-3], 200))
    assert period_s(np.repeat(ends, np.tile([1, 19], 200))) == pytest.approx(1e-3, rel=0.06)


def test_a_gap_does_not_move_it() -> None:
    t = np.arange(2000) * 0.01
    assert period_s(t[(t < 3) | (t > 19)]) == pytest.approx(0.01)


@pytest.mark.parametrize("t", [[], [3.0], [3.0, 3.0, 3.0]])
def test_without_two_moments_there_is_none(t: list[float]) -> None:
    assert np.isnan(period_s(np.array(t)))


def test_backwards_is_as_forwards() -> None:
    assert period_s(np.array([3.0, 2.0, 1.0])) == 1.0

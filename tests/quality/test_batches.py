"""Batches: what is pooled, how far, and whether the intervals hold."""

from __future__ import annotations

import numpy as np
import pytest

from labcal.quality.batches import pool

Groups = dict[str, tuple[list[float], list[float]]]


def fleet(draw: np.random.Generator, theta: np.ndarray, devices: int, within: float, u: float) -> Groups:
    made: Groups = {}
    for j, centre in enumerate(theta):
        made[str(j)] = (list(centre + draw.normal(0, np.hypot(within, u), devices)), [u] * devices)
    return made


def test_a_batch_that_stands_out_is_first_and_keeps_what_it_is() -> None:
    draw = np.random.default_rng(1)
    found = pool(fleet(draw, np.array([0.2, 0.1, 3.1, 0.3, -0.1]), 12, 0.5, 0.4))
    assert found.batches[0].name == "2"
    assert found.batches[0].value == pytest.approx(3.1, abs=3 * found.batches[0].u)
    assert 0.1 < found.batches[0].u < 0.4
    assert found.within == pytest.approx(0.5, abs=0.3)


def test_batches_that_do_not_differ_are_drawn_together_and_one_device_more_than_twenty() -> None:
    draw = np.random.default_rng(2)
    groups = fleet(draw, np.zeros(8), 20, 1.0, 0.5)
    groups["lonely"] = ([4.0], [0.5])
    found = {b.name: b for b in pool(groups).batches}
    assert abs(found["lonely"].value) < 0.6 * abs(found["lonely"].own_mean)
    assert found["lonely"].u > found["0"].u


@pytest.mark.parametrize(
    "between", [pytest.param(0.0, marks=pytest.mark.slow), 0.5, pytest.param(3.0, marks=pytest.mark.slow)]
)
def test_intervals_hold_the_truth_as_often_as_they_say(between: float) -> None:
    draw, inside, n = np.random.default_rng(3), 0, 0
    for _ in range(20):
        theta = draw.normal(1.0, between, 6)
        for batch in pool(fleet(draw, theta, 5, 0.6, 0.5)).batches:
            inside += abs(batch.value - theta[int(batch.name)]) <= 1.96 * batch.u
            n += 1
    assert 0.88 <= inside / n <= (0.995 if between else 1.0)


def test_the_pooled_estimate_is_nearer_the_truth_than_each_mean() -> None:
    draw, pooled, alone = np.random.default_rng(4), 0.0, 0.0
    for _ in range(12):
        theta = draw.normal(0, 0.3, 8)
        for batch in pool(fleet(draw, theta, 3, 0.8, 0.5)).batches:
            pooled += (batch.value - theta[int(batch.name)]) ** 2
            alone += (batch.own_mean - theta[int(batch.name)]) ** 2
    assert pooled < 0.7 * alone


def test_two_batches_stand_by_themselves() -> None:
    found = pool({"a": ([1.0, 1.2], [0.1, 0.1]), "b": ([3.0, 3.1], [0.1, 0.1])})
    assert not found.pooled
    assert [b.value for b in found.batches] == pytest.approx([3.05, 1.1])
    with pytest.raises(ValueError, match="no device"):
        pool({"a": ([], [])})

"""Stated uncertainties hold what they say, from both sides, where reference and axes are as wrong as they are declared.

The short form of `make coverage`. Errors of reference and mounting are one draw a run: runs count, not rows.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import pytest
from trials import KINDS, Trial, trial, trial_of_the_loop
from wrong_lab import Declared

from labcal.loop import uncertainty

FEW = {"vector": 7, "axis": 6, "scalar": 6}  # of each lab
MANY = {"vector": 7, "axis": 12, "scalar": 12}


@pytest.fixture(scope="module", params=[FEW, pytest.param(MANY, marks=pytest.mark.slow)], ids=["few", "many"])
def trials(request: pytest.FixtureRequest) -> dict[str, list[Trial]]:
    """By kind of reference: runs of both labs, half of them with a current at work."""
    return {
        kind: [
            trial(seed, kind, effect=("none", "offset-current")[seed % 2], twin=twin)
            for twin in (False, True)
            for seed in range(n)
        ]
        for kind, n in request.param.items()
    }


def interval(trials: Sequence[Trial], u_times: float = 1.0) -> tuple[float, float]:
    """The 99.9 % interval of the mean square of error over u, were u so many times as large; over runs."""
    squares = np.array([one.square for one in trials]) / u_times**2
    half = 3.29 * squares.std(ddof=1) / np.sqrt(len(squares))
    return float(squares.mean() - half), float(squares.mean() + half)


def test_errors_of_the_field_are_as_large_as_stated(trials: dict[str, list[Trial]]) -> None:
    everything = [one for of in trials.values() for one in of]
    low, high = interval(everything)
    assert low < 1 < high
    assert interval(everything, 2.0)[1] < 1 < interval(everything, 0.5)[0]  # twice or half as large would be seen
    assert 0.9 < np.mean([one.covered for one in everything]) < 0.99


@pytest.mark.parametrize("kind", KINDS)
def test_errors_of_each_kind_of_reference_are_as_large_as_stated(trials: dict[str, list[Trial]], kind: str) -> None:
    low, high = interval(trials[kind])
    assert low < 1 < high


def test_without_what_is_declared_intervals_would_miss(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(uncertainty, "declared_errors", lambda run: ())
    blind = [trial(seed, "axis", effect="none", twin=False) for seed in range(6)]
    assert np.mean([one.covered for one in blind]) < 0.6


def test_where_nothing_is_wrong_noise_alone_is_stated() -> None:
    quiet = [trial(seed, "axis", effect="offset-current", twin=False, declared=Declared()) for seed in range(6)]
    assert 0.93 < np.mean([one.covered for one in quiet]) < 0.97


@pytest.mark.slow
def test_what_the_loop_chose_by_itself_is_as_uncertain_as_stated(monkeypatch: pytest.MonkeyPatch) -> None:
    """Two runs tell declared errors from none; all of the campaign's are `make coverage`."""

    def mean_square() -> float:
        runs = [trial_of_the_loop(seed, "axis", effect="none", twin=False) for seed in range(2)]
        return float(np.mean([one.square for one in runs]))

    assert 0.2 < mean_square() < 3.0
    monkeypatch.setattr(uncertainty, "declared_errors", lambda run: ())
    assert mean_square() > 6.0

"""Two causes of which each hides the other: found together, named only where each earns its place."""

from __future__ import annotations

from types import ModuleType
from typing import Any

import numpy as np
import pytest

from labcal.loop.selection import pairs, stepwise
from labcal.loop.selection.stepwise import stepwise_forward

Channels = dict[str, np.ndarray]
CYCLE_S = 47.0
QUANTITIES = ("current", "temperature", "voltage", "power")


def _alike(t: np.ndarray) -> tuple[Channels, np.ndarray]:
    """Two loads on one switch and against each other; in every other cycle the second goes off five seconds early."""
    phase, level = np.mod(t, CYCLE_S), 0.4 + 0.2 * np.mod(t // CYCLE_S, 3)
    early = (np.mod(t, 2 * CYCLE_S) > CYCLE_S) & (phase > 14)
    first, second = (phase < 19) * level, ((phase < 19) & ~early) * level
    return {"i_one": first, "i_other": second}, 150.0 * (first - second)


def _by_turns(t: np.ndarray) -> tuple[Channels, np.ndarray]:
    """Two loads by turns that act alike; in every other cycle the second is back five seconds early."""
    loads, _ = _alike(t)
    loads["i_other"] = 0.8 - loads["i_other"]
    return loads, 150.0 * (loads["i_one"] + loads["i_other"])


@pytest.mark.parametrize("case", [_alike, _by_turns])
def test_two_loads_that_hide_each_other_are_found_together(
    making: ModuleType, searching: Any, monkeypatch: pytest.MonkeyPatch, case: Any
) -> None:
    t = making.recorded()[0]["t_s"]
    draw = np.random.default_rng(7)
    channels, size = case(t)
    channels = {name: i + draw.normal(0, 0.003, len(t)) for name, i in channels.items()}
    pool = searching(channels, dict.fromkeys(channels, "current"), size[:, None] * [1.0, -0.7, 0.5])
    accepted, _ = stepwise_forward(pool)
    assert {name for c in accepted for name in c.term.channels} == {"i_one", "i_other"}
    assert {c.family.id for c in accepted} <= {"offset-current", "offset-current-squared"}
    monkeypatch.setattr(stepwise, "best_set", lambda *given: None)
    accepted, _ = stepwise_forward(pool)
    assert {name for c in accepted for name in c.term.channels} == {"i_one", "i_other"}
    monkeypatch.setattr(stepwise, "score_pairs", lambda *given: [])
    assert stepwise_forward(pool)[0] == []


def test_whatever_follows_a_channel_is_paired_in_its_plainest_look(making: ModuleType, searching: Any) -> None:
    channels, _ = _alike(making.recorded()[0]["t_s"])
    pool = searching(channels, {"i_one": "current", "i_other": "temperature"})
    listed = pairs.shortlist(pool, pool.rank(pool.candidates))
    following = {c.cause for c in pool.candidates if c.term.channels}
    assert {cause for cause, _ in following} > {"offset-current", "offset-current-squared", "gain-temperature"}
    for cause in following:
        assert min(c.size for c in pool.candidates if c.cause == cause) in {c.size for c in listed if c.cause == cause}


def _distracted(t: np.ndarray, seed: int) -> Channels:
    """Eight channels that say nothing: walks, sines, loads, and each now and then nearly the one before."""
    draw, found = np.random.default_rng(seed), list[np.ndarray]()
    for _ in range(8):
        period = draw.uniform(15, 400)
        kinds = (
            draw.normal(0, 1, len(t)).cumsum(),
            np.sin(2 * np.pi * (t / period + draw.uniform())),
            (np.mod(t / period + draw.uniform(), 1.0) < draw.uniform(0.2, 0.8)) * 1.0,
            found[-1] + draw.normal(0, 0.05, len(t)) if found else t,
        )
        chosen = kinds[draw.integers(len(kinds))]
        found.append(chosen / max(np.std(chosen), 1e-9) + draw.normal(0, 0.01, len(t)))
    return {f"c{number}": values for number, values in enumerate(found)}


@pytest.mark.parametrize(
    "seeds",
    [range(100, 101), *(pytest.param(seeds, marks=pytest.mark.slow) for seeds in (range(101, 103), range(200, 320)))],
    ids=["one", "two", "many"],
)
def test_nothing_is_made_of_pairs_where_nothing_is_at_work(
    making: ModuleType, searching: Any, monkeypatch: pytest.MonkeyPatch, seeds: range
) -> None:
    """Of 120 runs none gains a name; the heaviest pair stays far below what a name needs."""
    null_distribution = list[float]()
    plain = stepwise.score_pairs

    def noted(*given: Any) -> Any:
        found = plain(*given)
        null_distribution.extend(pair.evidence for pair in found[:1])
        return found

    monkeypatch.setattr(stepwise, "score_pairs", noted)
    quantities = {f"c{n}": QUANTITIES[n % 4] for n in range(8)}
    for seed in seeds:
        channels = _distracted(making.recorded()[0]["t_s"], seed)
        assert stepwise_forward(searching(channels, quantities, seed=seed))[0] == []
    assert len(null_distribution) == len(seeds)
    assert max(null_distribution) < 6.0

"""A right name whose form is not whole is told as a part; a name that only resembles what is there is not."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from types import ModuleType

import numpy as np
import pytest

from labcal import session
from labcal.loop import close_loop
from labcal.loop.candidates.scorer import CandidateSet
from labcal.loop.data.linear_problem import LinearProblem
from labcal.loop.selection import discrepancy
from labcal.loop.selection.discrepancy import stands_beside_discrepancy

Rows = dict[str, np.ndarray]
DIRECTIONS = np.array([1.0, -0.7, 0.5])


def _nameless(rows: Rows) -> np.ndarray:
    """A smooth function of the field that no file describes [nT]."""
    x, y, z = (rows["dut"] - 800).T / 50e3
    return 120.0 * np.column_stack([np.sin(5 * y * z), np.cos(4 * x), np.sin(6 * z * x)])


def _load(rows: Rows) -> np.ndarray:
    return np.asarray(200.0 * (np.mod(rows["t_s"], 47.0) < 19.0)[:, None] * DIRECTIONS)


@pytest.mark.parametrize("loaded", [pytest.param(True, marks=pytest.mark.slow), False])
def test_a_load_beside_something_nameless_stands_and_a_curve_of_the_field_does_not(
    started: Callable[..., LinearProblem], loaded: bool
) -> None:
    pool = CandidateSet.of(started(lambda rows: _nameless(rows) + loaded * _load(rows)), 0.85)
    best = {w.candidate.family.id: w.candidate for w in pool.rank(pool.candidates)}
    assert stands_beside_discrepancy(pool, [best["offset-current"]], best["offset-current"]) == loaded
    for effect in ("nonlinearity", "offset-drift"):
        assert not stands_beside_discrepancy(pool, [best[effect]], best[effect])


def test_a_load_stands_over_a_gain_in_the_same_load_however_much_is_recorded(
    searching: Callable[..., CandidateSet], monkeypatch: pytest.MonkeyPatch
) -> None:
    """Bent by the field a gain would take the offset, where misfit is projected out: neither of the two is bent."""
    monkeypatch.setattr(discrepancy, "MOST_DIRECTIONS", 200)  # reached by fewer channels
    t = searching({}, {}).problem.scene.t_s
    load = np.where(np.mod(t, 67.0) < 31.0, 0.5 + 0.2 * np.mod(t // 67.0, 3), 0.0)
    others = {f"q{k}": np.sin(t / (17.0 + 9 * k)) for k in range(4)}
    channels = {"i": load, "p": np.sin(t / 41.0) + 0.5 * np.sin(t / 13.0), **others}
    quantities = {"i": "current", "p": "voltage", **dict.fromkeys(others, "power")}
    knee = np.outer(np.clip(channels["p"] - 0.3, 0, None), [180.0, -140.0, 100.0])
    pool = searching(channels, quantities, knee + np.outer(load, [450.0, -300.0, 240.0]))
    bent, current = (
        next(c for c in pool.candidates if c.cause == cause)
        for cause in (("offset-channel", ("p",)), ("offset-current", ("i",)))
    )
    assert stands_beside_discrepancy(pool, [bent, current], current)


@pytest.mark.slow
def test_a_part_is_told_with_how_much_it_carries(making: ModuleType, tmp_path: Path) -> None:
    rows, segments = making.recorded()
    level = 0.4 + 0.3 * np.mod(rows["t_s"] // 47.0, 3)
    rows["i_load"] = (np.mod(rows["t_s"], 47.0) < 19.0) * level
    rows["dut"] = rows["dut"] + _nameless(rows) + 250.0 * rows["i_load"][:, None] * DIRECTIONS
    closed = close_loop(session.load_run(str(making.written(tmp_path, rows, segments))))
    assert ("offset-current", ("i_load",)) in [(e.effect, e.channels) for e in closed.accepted]
    assert closed.verdict == "partly-explained"
    assert "% of its square above the noise" in closed.summary

"""Loads that are switched between two samples of slow telemetry, and channels that were where they are drawn."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray

from labcal.loop import close_loop
from labcal.loop.close import candidates_of, prepare, relinearised
from labcal.loop.refit import refit
from labcal.loop.selection.select import select
from labcal.loop.selection.unseen_switching import by_chance, misses_more, switched_unseen
from labcal.record import Channel, Run
from labcal.testing.made_up_runs import made_up_run

Array = NDArray[np.float64]
EACH_nT = np.array([900.0, -600.0, 400.0])


def _clock(rows: int) -> Array:
    return made_up_run(rows=rows).run.t_s


def _switched(t_s: Array) -> Array:
    """A load of three levels, each held for a while."""
    edges = np.cumsum(np.random.default_rng(5).exponential(25.0, 400)) - 30.0
    return np.random.default_rng(6).choice([-1.0, 0.0, 1.0], 401)[np.searchsorted(edges, t_s)]


def _drawn(t_s: Array, late_s: float = 0.0, every_s: float = 6.0) -> Array:
    """The same as its telemetry has it: samples drawn straight to the next one, each as it was some time before."""
    at = np.arange(t_s[0] - every_s, t_s[-1] + 2 * every_s, every_s)
    return np.interp(t_s, at, _switched(at - late_s))


def _run(load: Array, telemetry: Array) -> Run:
    made = made_up_run(rows=len(load) // 6, channels=[Channel("i_rod", "A", "current", telemetry)])
    return made.with_effect(load[:, None] * EACH_nT)


@pytest.mark.parametrize(
    "late_s", [pytest.param(0.0, marks=pytest.mark.slow), pytest.param(1.5, marks=pytest.mark.slow)]
)
def test_a_load_switched_between_two_samples_is_explained_where_it_is_known(late_s: float) -> None:
    t_s = _clock(120)
    closed = close_loop(_run(_switched(t_s), _drawn(t_s, late_s)))
    assert [effect.effect for effect in closed.accepted] == ["offset-current"]
    assert closed.verdict == "explained"
    found = {p.name: p.value for p in closed.accepted[0].parameters}
    assert [found[f"c_{axis}"] for axis in "xyz"] == pytest.approx(EACH_nT.tolist(), abs=15.0)


def test_a_row_between_two_levels_of_quick_telemetry_is_as_unknown() -> None:
    """No row is on its way to the next level for longer than one; the load was at either."""
    t_s = _clock(120)
    load, telemetry = _switched(t_s), _drawn(t_s, every_s=0.45)
    between = np.abs(telemetry - np.round(telemetry)) > 0.02
    between[1:-1] &= ~between[2:] & ~between[:-2]  # two of them are a load that was switched on and off again
    problem, level, _ = prepare(_run(load, telemetry))
    pool = relinearised(candidates_of(problem.run, problem))
    found = select(pool, level)
    assert [c.family.id for c in found.accepted] == ["offset-current"]
    assert between.sum() > 5
    assert switched_unseen(pool, found)[between].all()


@pytest.mark.parametrize(
    "at_s", [pytest.param(1.5, marks=pytest.mark.slow), 3.0, pytest.param(4.5, marks=pytest.mark.slow)]
)
def test_a_load_that_is_switched_once_between_two_samples_is_no_step(at_s: float) -> None:
    """A step on the run's clock fits every row; the load all but those on which nobody knows it, and goes first."""
    t_s = _clock(80)
    before = float(t_s[len(t_s) // 2])
    load = (t_s > before + at_s).astype(float)
    drawn = np.interp(t_s, [before, before + 6.0], [0.0, 1.0])
    closed = close_loop(_run(load, drawn))
    assert [effect.effect for effect in closed.accepted] == ["offset-current"]
    assert closed.after.holdout_rms_nT < 1.05 * closed.noise_floor_nT


def test_a_load_that_is_where_its_telemetry_draws_it_loses_no_row() -> None:
    t_s = _clock(80)
    drawn = _drawn(t_s)
    problem, level, _ = prepare(_run(drawn, drawn))
    pool = relinearised(candidates_of(problem.run, problem))
    found = select(pool, level)
    assert [c.family.id for c in found.accepted] == ["offset-current"]
    assert not switched_unseen(pool, found).any()


def test_ways_are_missed_more_where_chance_would_not_put_so_many_of_the_largest() -> None:
    squares, ways = np.arange(1000.0), np.zeros(1000, dtype=bool)
    ways[[3, 400, 800, 998, 999]] = True
    assert misses_more(squares, ways)
    assert not misses_more(squares[::-1], ways)
    spread = np.zeros(1000, dtype=bool)
    spread[::5] = True
    assert not misses_more(squares, spread)


@pytest.mark.slow
def test_a_fit_with_named_effects_leaves_out_the_same_rows() -> None:
    t_s = _clock(80)
    run = _run(_switched(t_s), _drawn(t_s))
    closed = close_loop(run)
    again = refit(run, closed.accepted)
    assert np.allclose(again.affine.K, closed.fit().affine.K, atol=1e-6)
    assert [p.value for p in again.effects[0].parameters] == pytest.approx(
        [p.value for p in closed.accepted[0].parameters], rel=1e-6
    )


@pytest.mark.parametrize(
    ("n", "m", "k"), [(30, 5, 0), (30, 5, 1), (30, 5, 3), (30, 5, 5), (30, 20, 12), (9_000, 400, 31)]
)
def test_the_share_by_chance_is_that_of_the_hypergeometric_distribution(n: int, m: int, k: int) -> None:
    from scipy.stats import hypergeom

    assert by_chance(n, m, k) == pytest.approx(float(hypergeom.sf(k - 1, n, m, m)), rel=1e-9)

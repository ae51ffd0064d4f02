"""Loads that slow telemetry draws straight between two samples, and wild rows that are nobody's clock."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from types import ModuleType

import numpy as np

from labcal import session
from labcal.loop.candidates.scorer import CandidateSet
from labcal.loop.close import prepare
from labcal.loop.data.checks import check_data
from labcal.loop.data.noise_floor import NoiseFloor
from labcal.loop.policy import POLICY
from labcal.loop.selection.crossval import block_folds
from labcal.loop.selection.equivalents import leads_over_relatives
from labcal.loop.selection.select import prefer_computable, select
from labcal.model.switched import drawn_between_levels

ONE = np.array([0, 60])  # a segment


def drawn(rows: int) -> np.ndarray:
    """A load that goes on in so many equal steps at row 20, and off at row 40."""
    at = np.array([0, 20, 20 + rows, 40, 40 + rows, 60])
    return np.interp(np.arange(60.0), at, [0.0, 0.0, 1.0, 1.0, 0.0, 0.0])


def test_rows_on_a_straight_way_between_two_levels_are_unknown() -> None:
    seen = np.flatnonzero(drawn_between_levels(drawn(4), ONE))
    assert seen.tolist() == [20, 21, 22, 23, 24, 40, 41, 42, 43, 44]


def test_one_row_between_two_levels_is_a_way_and_a_pulse_of_one_row_is_none() -> None:
    assert np.flatnonzero(drawn_between_levels(drawn(2), ONE)).tolist() == [20, 21, 22, 40, 41, 42]
    pulse = drawn(1)
    pulse[10] = 0.4
    assert not drawn_between_levels(pulse, ONE).any()


def test_a_switch_and_what_moves_smoothly_are_known() -> None:
    assert not drawn_between_levels(drawn(1), ONE).any()
    assert not drawn_between_levels(np.sin(np.arange(60.0) / 7), ONE).any()
    assert not drawn_between_levels(np.full(60, 2.0), ONE).any()
    bent = drawn(4)
    bent[22] += 0.15  # no straight line: somebody saw it there
    bent[42] += 0.15
    assert not drawn_between_levels(bent, ONE).any()


def test_a_burst_is_no_fault_of_a_clock(making: ModuleType, tmp_path: Path) -> None:
    rows, segments = making.recorded()
    wild = np.random.default_rng(4).normal(0, 12000.0, (10, 3))
    for start in (90, 270):  # segments begin there: a reference whose stamps are moved has no such rows
        rows["dut"][start : start + 5] += wild[:5]
    problem, level, _ = prepare(session.load_run(str(making.written(tmp_path, rows, segments))))
    assert float(np.sqrt(np.mean(problem.residual_nT**2))) > 5 * level.nT
    assert check_data(problem, level) is None


def test_the_square_of_a_load_is_its_square_however_late_the_load_was_recorded(
    searching: Callable[..., CandidateSet],
) -> None:
    t, draw = searching({}, {}).problem.scene.t_s, np.random.default_rng(0)
    knots = np.arange(-9.8, t[-1] + 20.0, 9.0)
    level = draw.choice([0.1, 0.5, 0.9, 1.6], len(knots))
    now, late = (level[np.searchsorted(knots, t - by_s)] for by_s in (0.0, 1.4))
    pool = searching({"i": late}, {"i": "current"}, np.outer(now**2, [300.0, -200.0, 100.0]))
    (found,) = select(pool, NoiseFloor(35.0, "declared", None)).accepted
    assert found.cause == ("offset-current-squared", ("i",))
    assert abs(found.term.at("delay_s") + 1.4) < 0.25  # half a row


def test_a_row_that_is_a_mean_over_the_switching_does_not_make_it_the_square(
    searching: Callable[..., CandidateSet],
) -> None:
    t = searching({}, {}).problem.scene.t_s
    acts = 0.6 * (np.mod(t, 41.0) < 17.0)
    amps, switched = acts.copy(), np.flatnonzero(np.diff(acts) < 0)[::4] + 1
    amps[switched] = 0.3
    acts[switched] = 0.15
    pool = searching({"i": amps}, {"i": "current"}, np.outer(acts, [800.0, -500.0, 300.0]))
    square = next(c for c in pool.candidates if c.family.second_order and not c.term.shape)
    assert leads_over_relatives(pool, [], square)[0][1] > POLICY.equivalent_nats
    (first,) = prefer_computable(pool, block_folds(pool.problem, 0.0), [square], ())
    assert first.cause == ("offset-current", ("i",))

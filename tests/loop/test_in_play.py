"""Selections repeated without a fold are offered what they might take, and no more: the answer is the same, sooner."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from labcal.loop.candidates.scorer import CandidateSet
from labcal.loop.data.linear_problem import LinearProblem
from labcal.loop.data.noise_floor import NoiseFloor
from labcal.loop.selection.proof import in_play, nested_selection
from labcal.loop.selection.select import select

Rows = dict[str, np.ndarray]
LEVEL = NoiseFloor(36.0, "declared", None)


def a_current(rows: Rows) -> np.ndarray:
    return np.asarray(150.0 * rows["i_load"][:, None] * [1.0, -0.7, 0.5])


def a_current_and_a_weak_temperature(rows: Rows) -> np.ndarray:
    return np.asarray(a_current(rows) + 12.0 * (rows["temp"] - 20)[:, None] * [0.3, 1.0, -0.2])


@pytest.mark.parametrize("added", [a_current, pytest.param(a_current_and_a_weak_temperature, marks=pytest.mark.slow)])
def test_a_fold_takes_of_what_is_in_play_what_it_takes_of_all(
    started: Callable[..., LinearProblem], added: Callable[[Rows], np.ndarray]
) -> None:
    pool = CandidateSet.of(started(added), 0.85)
    found = select(pool, LEVEL)
    offered = in_play(pool, found.accepted, found.rankings)
    assert len(offered) < 0.7 * len(pool.candidates)
    assert {c.cause for c in found.accepted} <= {c.cause for c in offered}
    of_all, of_few = (nested_selection(LEVEL, found.blocks, len(found.accepted), offered=o) for o in (None, offered))
    for fold in np.unique(found.blocks.fold):
        part = pool.on(found.blocks.training(pool.problem.scene.t_s, fold) & pool.rows)
        one, other = ([(c.cause, c.term.shape) for c in choose(part)] for choose in (of_all, of_few))
        assert one == other
        assert one

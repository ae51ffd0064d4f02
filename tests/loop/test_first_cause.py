"""Which cause comes first where no form reaches the noise: evidence is of these rows, held-out blocks decide."""

from __future__ import annotations

import numpy as np
import pytest

from labcal.loop.candidates.scorer import CandidateSet
from labcal.loop.close import prepare
from labcal.loop.data.noise_floor import NoiseFloor
from labcal.loop.selection.crossval import block_folds, cross_validate, fixed_choice
from labcal.loop.selection.heldout_rules import is_sure_first
from labcal.record import Channel
from labcal.testing.made_up_runs import made_up_run

AWAY = 20.0  # nT, beside which nothing is known


@pytest.mark.parametrize(("first", "sure"), [("gain-temperature", False), ("offset-temperature", True)])
def test_one_that_leaves_more_of_held_out_rows_than_another_does_not_come_first(
    first: str, sure: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    """An offset that follows a temperature, and popcorn that nothing follows; whatever evidence says of the gains.

    The noise is not stated: what differs from row to row bounds it from below alone.
    """
    monkeypatch.setattr("labcal.loop.selection.heldout_rules.equally_likely", lambda *_: [])
    rows, draw = 120, np.random.default_rng(3)
    t_s = made_up_run(rows=rows).run.t_s
    T = 20 + 6 * np.sin(t_s / 19.0) + np.sin(t_s / 4.0)
    popcorn = 60.0 * (np.searchsorted(np.cumsum(draw.exponential(12.0, 400)), t_s) % 2)
    made = made_up_run(rows=rows, channels=[Channel("T", "degC", "temperature", T)], declared=False)
    run = made.with_effect((T - 20)[:, None] * [60.0, -40.0, 30.0] + popcorn[:, None] * [1.0, 0.5, -0.8])
    problem = prepare(run)[0]
    pool = CandidateSet.of(problem, 0.85)
    own = [c for c in pool.candidates if c.family.id == first]
    null = pool.null_model()
    chosen = max((pool.score(c, null) for c in own), key=lambda w: w.evidence).candidate
    blocks = block_folds(problem, 1.0)
    steps = [cross_validate(pool, blocks, fixed_choice([chosen]))]
    level = NoiseFloor(AWAY, "differences", None)
    assert steps[0].after > 1.15 * level.nT
    assert is_sure_first(pool, blocks, [chosen], steps, level) is sure

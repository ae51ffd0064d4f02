"""Blocks that are held out: enough of them where a run has few segments and remembers itself for long."""

from __future__ import annotations

from types import SimpleNamespace
from typing import cast

import numpy as np
import pytest

from labcal.loop.data.linear_problem import LinearProblem
from labcal.loop.selection.crossval import block_folds


@pytest.mark.parametrize(("segments", "fewest"), [(1, 5), (2, 6), (6, 12)])
def test_a_run_of_few_segments_and_a_long_memory_still_has_folds_to_hold_out_of_the_rest(
    segments: int, fewest: int
) -> None:
    t_s = np.arange(600.0)
    scene = SimpleNamespace(t_s=t_s, segment=(np.arange(600) * segments // 600))
    folds = block_folds(cast(LinearProblem, SimpleNamespace(scene=scene)), correlation_s=500.0)
    assert len(np.unique(folds.block)) == fewest
    assert len(np.unique(folds.fold)) >= 3

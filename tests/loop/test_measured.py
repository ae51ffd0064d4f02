"""The loop on a recording that nobody here made, beside a plain regression by hand on the same blocks."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from labcal.loop import close_loop
from labcal.loop.close import prepare
from labcal.loop.selection.crossval import block_folds
from labcal.store import read_bundle

BY_HAND = 1.2  # times its held-out error; wanted is no more than that error itself


@pytest.mark.slow
def test_a_device_that_was_warmed_is_predicted_nearly_as_well_as_by_hand(shared: Path) -> None:
    """By hand: all nine gains and three offsets, and each of them straight in the temperature (24 parameters)."""
    run = read_bundle(shared / "data" / "av-mageval")
    problem, _, _ = prepare(run)
    rows, reference = problem.run, problem.run.reference_vector
    assert reference is not None
    warm = (rows.channel("temp_dut").values - 24.0)[:, None]
    design = np.hstack([rows.reading, np.ones_like(warm), rows.reading * warm, warm])
    blocks, left = block_folds(problem, 1.0), np.full(len(rows), np.nan)
    for fold in range(5):
        known, held = blocks.training(problem.scene.t_s, fold), blocks.fold == fold
        x, *_ = np.linalg.lstsq(design[known], reference[known], rcond=None)
        left[held] = np.linalg.norm(design[held] @ x - reference[held], axis=1)
    closed = close_loop(run)
    assert {e.effect for e in closed.accepted} & {"gain-temperature", "offset-temperature"}
    assert closed.after.holdout_rms_nT < BY_HAND * np.sqrt(np.nanmean(left**2))

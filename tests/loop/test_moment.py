"""The moment of a step: as sure as the run makes it."""

from __future__ import annotations

from pathlib import Path
from types import ModuleType

import numpy as np
import pytest

from labcal import session
from labcal.loop import close_loop

STEP_nT = 400.0


# 95 % of a chi of as many degrees of freedom
@pytest.mark.parametrize(("runs", "low", "high"), [(2, 0.16, 1.92), pytest.param(5, 0.4, 1.7, marks=pytest.mark.slow)])
def test_a_step_that_a_magnitude_does_not_see_at_once_is_known_less_closely(
    making: ModuleType, tmp_path: Path, runs: int, low: float, high: float
) -> None:
    """At right angles to the field where it happens: it shows only as the device turns on, by 20 nT a row."""
    off, u = [], []
    for seed in range(runs):
        rows, segments = making.recorded(seed=seed)
        row = 200 + 7 * seed
        field = (rows["dut"] - 800) / 1.05
        across = np.cross(field[row], np.array([0.0, 1.0, 0.0]))
        rows["dut"] = rows["dut"] + (np.arange(len(field)) >= row)[:, None] * STEP_nT * across / np.linalg.norm(across)
        free = [{"id": segment["id"], "kind": "free"} for segment in segments]
        closed = close_loop(session.load_run(str(making.written(tmp_path / str(seed), rows, free))))
        assert [effect.effect for effect in closed.accepted] == ["offset-step"]
        moment = next(p for p in closed.accepted[0].parameters if p.name == "t_step_s")
        off.append(moment.value - (rows["t_s"][row] - 0.25))
        u.append(moment.u)
    pull = np.sqrt(np.mean(np.square(off)) / np.mean(np.square(u)))
    assert low < pull < high
    assert np.sqrt(np.mean(np.square(u))) > 0.5  # more than a row

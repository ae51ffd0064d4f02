"""Rows that stand out along a load's own field are the load, which the channel missed; others are wild readings."""

from __future__ import annotations

import numpy as np
import pytest

from labcal.loop import close_loop
from labcal.record import Channel
from labcal.testing.made_up_runs import made_up_run

EACH_nT = np.array([900.0, -600.0, 400.0])
ASIDE_nT = np.array([600.0, 900.0, 0.0])  # as long, at right angles to it
WILD = {"offset-current", "outliers"}


@pytest.mark.parametrize(
    ("times", "named"),
    [
        (EACH_nT, {"offset-current"}),
        pytest.param(ASIDE_nT, WILD, marks=pytest.mark.slow),
        pytest.param(3 * EACH_nT, WILD, marks=pytest.mark.slow),
    ],
    ids=["the load's own", "another direction", "more than it has ever been"],
)
def test_a_row_that_stands_out_as_the_load_would_is_no_wild_reading(times: np.ndarray, named: set[str]) -> None:
    t_s = made_up_run(rows=120).run.t_s
    load = (np.floor(t_s / 25.0).astype(int) % 3 == 1).astype(float)
    made = made_up_run(rows=120, channels=[Channel("i_valve", "A", "current", load)])
    missed = np.zeros(len(t_s))
    missed[np.flatnonzero(load == 0)[7::37]] = 1.0
    assert missed.sum() > 8
    closed = close_loop(made.with_effect(load[:, None] * EACH_nT + missed[:, None] * times))
    assert {effect.effect for effect in closed.accepted} == named
    found = {p.name: p.value for e in closed.accepted if e.effect == "offset-current" for p in e.parameters}
    assert [found[f"c_{axis}"] for axis in "xyz"] == pytest.approx(EACH_nT.tolist(), abs=15.0)

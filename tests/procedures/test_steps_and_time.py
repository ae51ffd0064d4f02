"""Every procedure names its steps before it asks for anything, and says truly how long each takes and what is left."""

from __future__ import annotations

from collections.abc import Callable
from itertools import pairwise
from pathlib import Path

import pytest
from scalar_lab import SCALAR, sensor
from short_settings import EACH, SHORT

from labcal.demo import simulated_bench
from labcal.record.stream import Block, Item, Prompt, Step
from labcal.runner import find
from labcal.runner.prompts import first_choice
from labcal.testing.procedures import ProcedureTrial

OFF_S, OFF_PART = 8.0, 0.15  # of what is left, that it may be wrong by


@pytest.mark.parametrize("name", EACH)
def test_steps_and_time_left_are_true(name: str, bench_file: Callable[..., Path]) -> None:
    bench = bench_file(sensor(1), *SCALAR) if name == "scalar-cage" else simulated_bench()
    trial = ProcedureTrial(find(name), SHORT.get(name, {}), bench, first_choice)
    assert trial.run().status == "finished"
    items = [item for item in trial.items if not isinstance(item, Block)]
    steps = [item for item in items if isinstance(item, Step)]
    begins = next(n for n, item in enumerate(items) if isinstance(item, Step))
    assert not any(isinstance(item, Prompt) for item in items[:begins])
    assert tuple(step.name for step in steps) == steps[0].names
    ends_s = _ends_s(trial.items)
    for step in steps:
        assert step.left_s == pytest.approx(ends_s - step.t_s, rel=OFF_PART, abs=OFF_S), step.name
        assert step.whole_s == steps[0].left_s or name == "preflight"  # which knows its rate after sync-check
    for step, following in pairwise(steps):
        assert step.step_s == pytest.approx(following.t_s - step.t_s, rel=0.3, abs=12.0), step.name


def _ends_s(items: list[Item]) -> float:
    return max(float(item.t_s[-1]) if isinstance(item, Block) else item.t_s for item in items)

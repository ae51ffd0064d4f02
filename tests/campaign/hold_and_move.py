"""A real procedure for the campaign: ambient measured, then a field and its half in turn, with readings in between."""

from __future__ import annotations

from contextlib import ExitStack
from typing import Annotated

import numpy as np

from labcal.bench.bench import Bench
from labcal.bench.parameters import Limits
from labcal.bench.steps import Plan, Procedure, coils_off, energise, measure_ambient, ready, rest


def hold_and_move(
    bench: Bench,
    *,
    field_nT: Annotated[tuple[float, ...], Limits(-1e5, 1e5, unit="nT"), "x, y, z in C"] = (0.0, 0.0, 30e3),
    dwell_s: Annotated[float, Limits(0.1, 60, unit="s"), "at each field"] = 1.5,
    times: Annotated[int, Limits(1, 10_000), "how often"] = 400,
) -> Procedure:
    """Hold a field and its half in turn."""
    plan = Plan((("held", 2 * times * dwell_s),))
    with ExitStack() as afterwards:
        afterwards.callback(bench.cage.zero)  # the undo, before anything is energised
        yield from measure_ambient(bench, 1.0)
        yield from ready(bench, "The coils go on. Hands off?")
        yield plan.begin(bench, "held")
        for number in range(times):
            yield from energise(bench, np.array(field_nT) * (1.0 if number % 2 == 0 else 0.5))
            yield from rest(bench, f"held-{number + 1}", dwell_s)
        yield from coils_off(bench)

"""Step the field along z and read the DUT at each step."""

from __future__ import annotations

from contextlib import ExitStack
from typing import Annotated

from labcal.bench import Bench
from labcal.bench.parameters import Limits
from labcal.bench.steps import Plan, Procedure, dut_nT, energise, measured, ready, rest

NEEDS, LASTS_MIN = "the DUT mounted, any way up", 1
STEPS = (1, 2, 3)
DWELL_S = 3.0


def example_steps(
    bench: Bench, *, top_nT: Annotated[float, Limits(1_000, 60_000, unit="nT"), "largest field"] = 30_000.0
) -> Procedure:
    """Step the field along z and read the DUT at each step."""
    plan = Plan(tuple((f"step-{n}", DWELL_S) for n in STEPS))
    with ExitStack() as afterwards:
        afterwards.callback(bench.cage.zero)  # the undo, before anything is energised
        yield from ready(bench, "The field steps along z. Hands off?")
        for n in STEPS:
            yield plan.begin(bench, f"step-{n}")
            yield from energise(bench, (0.0, 0.0, top_nT * n / len(STEPS)))
            seen = dut_nT(bench, (yield from rest(bench, f"step-{n}", DWELL_S)))
            yield from measured(bench, f"z at step {n}", seen.mean[2], seen.u_mean[2], "nT")

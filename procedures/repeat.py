"""The same rotation again and again in one mounting, with pauses: what the DUT and the lab do by themselves."""

from __future__ import annotations

from contextlib import ExitStack
from typing import Annotated, Literal

from labcal.bench.bench import Bench
from labcal.bench.mounting import AXES, SET_UP, inclined_field, plan_with_set_up, set_up
from labcal.bench.parameters import Limits
from labcal.bench.rotation import Rotation, rotate_once
from labcal.bench.steps import Procedure, coils_off, energise, record

NEEDS, LASTS_MIN = "the DUT on the platform", 9

ZERO_S, STEP_S = 10.0, 6.0  # coils-off zero before; of lab time for the field to come and go
SEPARATES = (("offset-step", "offset-drift"), ("offset-current", "offset-drift"), ("periodic", "offset-drift"))


def repeat(
    bench: Bench,
    *,
    times: Annotated[int, Limits(2, 100), "how often"] = 4,
    pause_s: Annotated[float, Limits(0, 86_400, unit="s"), "coils off between two turns"] = 60.0,
    axis: Annotated[Literal["x", "y", "z"], "body axis mounted along the platform axis"] = "z",
    magnitude_nT: Annotated[float, Limits(1_000, 100_000, unit="nT"), "magnitude of the field"] = 50_000.0,
    inclination_deg: Annotated[float, Limits(35, 65, unit="deg"), "field from the platform axis"] = 50.0,
    rate_deg_per_s: Annotated[float, Limits(0.1, 60, unit="deg/s"), "of every turn"] = 6.0,
    mode: Annotated[str, "the DUT's power mode"] = "nominal",
) -> Procedure:
    """Repeat one rotation, with the coils off in between."""
    turns = [
        Rotation(f"{axis}-again-{n + 1}", AXES[axis], mode, rate_deg_per_s, 360.0 * ((n + 1) % 2), mounting=axis)
        for n in range(times)
    ]
    plan = plan_with_set_up(ZERO_S, [(turn.name, turn.seconds() + STEP_S + pause_s) for turn in turns])
    with ExitStack() as afterwards:
        afterwards.callback(bench.cage.zero)  # the undo, before anything is energised
        yield plan.begin(bench, SET_UP)
        yield from set_up(
            bench, axis, ZERO_S, f"The coils go to {magnitude_nT / 1000:g} µT and the platform turns.", mode
        )
        for turn in turns:
            yield plan.begin(bench, turn.name)
            yield from energise(bench, inclined_field(bench, magnitude_nT, inclination_deg))
            yield from rotate_once(bench, turn)
            yield from coils_off(bench)
            yield from record(bench, pause_s)

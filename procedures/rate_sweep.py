"""The same rotation slower and faster, there and back, without remounting: a delay grows with the rate."""

from __future__ import annotations

from contextlib import ExitStack
from typing import Annotated, Literal

from labcal.bench.bench import Bench
from labcal.bench.mounting import AXES, SET_UP, inclined_field, plan_with_set_up, set_up
from labcal.bench.parameters import Limits
from labcal.bench.rotation import Rotation, rotate_once
from labcal.bench.steps import Procedure, coils_off, energise_again

NEEDS, LASTS_MIN = "the DUT on a platform with a motor", 7

SEPARATES = (("lag", "hysteresis"), ("lag", "axis-tilt"), ("hysteresis", "axis-tilt"))


def rate_sweep(
    bench: Bench,
    *,
    axis: Annotated[Literal["x", "y", "z"], "body axis mounted along the platform axis"] = "z",
    magnitude_nT: Annotated[float, Limits(1_000, 100_000, unit="nT"), "magnitude of the field"] = 50_000.0,
    inclination_deg: Annotated[float, Limits(35, 65, unit="deg"), "field from the platform axis"] = 50.0,
    rates_deg_per_s: Annotated[tuple[float, ...], Limits(0.1, 60, unit="deg/s"), "each there and back"] = (3, 6, 12),
    mode: Annotated[str, "the DUT's power mode"] = "nominal",
    zero_s: Annotated[float, Limits(2, 600, unit="s"), "coils-off zero before"] = 10.0,
) -> Procedure:
    """Turn there and back at several rates in one mounting."""
    turns = [
        Rotation(f"{axis}-{rate:g}dps-{way}", AXES[axis], mode, rate, to_deg, mounting=axis)
        for rate in rates_deg_per_s
        for way, to_deg in (("forth", 360.0), ("back", 0.0))
    ]
    plan = plan_with_set_up(zero_s, [(turn.name, turn.seconds()) for turn in turns])
    with ExitStack() as afterwards:
        afterwards.callback(bench.cage.zero)  # the undo, before anything is energised
        yield plan.begin(bench, SET_UP)
        yield from set_up(
            bench, axis, zero_s, f"The coils go to {magnitude_nT / 1000:g} µT and the platform turns.", mode
        )
        for turn in turns:
            yield plan.begin(bench, turn.name)
            yield from energise_again(bench, inclined_field(bench, magnitude_nT, inclination_deg))
            yield from rotate_once(bench, turn)
        yield from coils_off(bench)

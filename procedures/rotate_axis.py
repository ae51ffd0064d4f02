"""Turn the DUT about one body axis in one steady field: the unit of which a preflight is made."""

from __future__ import annotations

from contextlib import ExitStack
from typing import Annotated, Literal

from labcal.bench.bench import Bench
from labcal.bench.mounting import AXES, SET_UP, inclined_field, plan_with_set_up, set_up
from labcal.bench.parameters import Limits
from labcal.bench.rotation import Rotation, fastest_rate, refuse_too_fast, rotate_once
from labcal.bench.steps import Procedure, coils_off, energise_again, measured

NEEDS, LASTS_MIN = "the DUT on the platform", 2


def rotate_axis(
    bench: Bench,
    *,
    axis: Annotated[Literal["x", "y", "z"], "body axis mounted along the platform axis"] = "z",
    magnitude_nT: Annotated[float, Limits(1_000, 100_000, unit="nT"), "magnitude of the field"] = 50_000.0,
    inclination_deg: Annotated[float, Limits(35, 65, unit="deg"), "field from the platform axis"] = 50.0,
    rate_deg_per_s: Annotated[float, Limits(0, 60, unit="deg/s"), "0: as fast as timing and the range allow"] = 0.0,
    timing_nT: Annotated[float, Limits(0.1, 1_000, unit="nT"), "error that timing may make"] = 10.0,
    u_time_s: Annotated[float, Limits(1e-6, 1, unit="s"), "timing uncertainty"] = 0.005,
    step_deg: Annotated[float, Limits(0, 90, unit="deg"), "0: continuous, else stepped"] = 0.0,
    dwell_s: Annotated[float, Limits(0.5, 60, unit="s"), "recorded at each stop"] = 2.0,
    turns: Annotated[int, Limits(1, 20), "full turns, there and back by turns"] = 1,
    mode: Annotated[str, "the DUT's power mode"] = "nominal",
    zero_s: Annotated[float, Limits(2, 600, unit="s"), "coils-off zero before"] = 10.0,
) -> Procedure:
    """Turn the DUT about one body axis in one steady field; one axis is not enough for a calibration by itself."""
    refuse_too_fast(bench, rate_deg_per_s)
    rate = rate_deg_per_s or fastest_rate(bench, magnitude_nT, inclination_deg, u_time_s, timing_nT)
    rotations = [
        Rotation(name, AXES[axis], mode, rate, 360.0 * ((n + 1) % 2), axis, step_deg, dwell_s)
        for n, name in enumerate(_names(axis, magnitude_nT, turns))
    ]
    plan = plan_with_set_up(zero_s, [(one.name, one.seconds()) for one in rotations])
    with ExitStack() as afterwards:
        afterwards.callback(bench.cage.zero)  # the undo, before anything is energised
        yield plan.begin(bench, SET_UP)
        yield from measured(bench, "rotation rate", rate, 0.0, "deg/s")
        yield from set_up(
            bench, axis, zero_s, f"The coils go to {magnitude_nT / 1000:g} µT and the platform turns.", mode
        )
        for one in rotations:
            yield plan.begin(bench, one.name)
            yield from energise_again(bench, inclined_field(bench, magnitude_nT, inclination_deg))
            yield from rotate_once(bench, one)
        yield from coils_off(bench)


def _names(axis: str, magnitude_nT: float, turns: int) -> list[str]:
    """Of its segments, which are its steps."""
    return [f"{axis}+{magnitude_nT / 1000:g}uT" + (f"-{n + 1}" if turns > 1 else "") for n in range(turns)]

"""One rotation forwards, the same backwards, without remounting: a tilt stays, a delay changes its sign."""

from __future__ import annotations

from typing import Annotated, Literal

from labcal.bench.bench import Bench
from labcal.bench.parameters import Limits
from labcal.bench.steps import Procedure
from procedures.rate_sweep import rate_sweep

NEEDS, LASTS_MIN = "the DUT on the platform", 2

SEPARATES = (("lag", "axis-tilt"), ("lag", "hysteresis"), ("hysteresis", "axis-tilt"))


def reverse(
    bench: Bench,
    *,
    axis: Annotated[Literal["x", "y", "z"], "body axis mounted along the platform axis"] = "z",
    magnitude_nT: Annotated[float, Limits(1_000, 100_000, unit="nT"), "magnitude of the field"] = 50_000.0,
    inclination_deg: Annotated[float, Limits(35, 65, unit="deg"), "field from the platform axis"] = 50.0,
    rate_deg_per_s: Annotated[float, Limits(0.1, 60, unit="deg/s"), "of both turns"] = 6.0,
    mode: Annotated[str, "the DUT's power mode"] = "nominal",
) -> Procedure:
    """Turn once forwards and once backwards at one rate."""
    yield from rate_sweep(
        bench, axis=axis, magnitude_nT=magnitude_nT, inclination_deg=inclination_deg,
        rates_deg_per_s=(rate_deg_per_s,), mode=mode,
    )  # fmt: skip

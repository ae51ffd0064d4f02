"""The bare turning fixture under the reference: what platform and motor add to the field, moving, holding and off."""

from __future__ import annotations

from contextlib import ExitStack
from typing import Annotated

import numpy as np
from numpy.typing import NDArray

from labcal.bench.bench import Bench
from labcal.bench.parameters import Limits
from labcal.bench.steps import Plan, Procedure, coils_off, measured, record, to_angle, turn
from labcal.bench.streams.samples import Samples, samples
from labcal.record.stream import Prompt

NEEDS, LASTS_MIN = "the bare fixture with the motor, a vector reference at the DUT's place", 2

Array = NDArray[np.float64]
SEPARATES = (("cage-field", "reference-drift"), ("cage-field", "field-gradient"))


def platform_signature(
    bench: Bench,
    *,
    rate_deg_per_s: Annotated[float, Limits(0.1, 60, unit="deg/s"), "of the turn"] = 6.0,
    dwell_s: Annotated[float, Limits(1, 600, unit="s"), "recorded with the motor holding, and off"] = 20.0,
    limit_nT: Annotated[float, Limits(0.1, 1e5, unit="nT"), "largest signature that passes"] = 20.0,
) -> Procedure:
    """Measure the platform's own field with the reference at the DUT's place, coils off."""
    plan = Plan(
        (("turning", 360 / rate_deg_per_s), ("holding", dwell_s), ("motor off", dwell_s)), frozenset({"motor off"})
    )
    with ExitStack() as afterwards:
        afterwards.callback(bench.cage.zero)
        yield plan.begin(bench, "turning")
        yield from coils_off(bench)
        yield from to_angle(bench, 0.0)
        text = "Take the DUT away and put the reference at its place, on a stand that does not turn."
        drawing = {"reference_m": [0.0, 0.0, 0.0], "dut_away": True}
        yield Prompt(bench.clock.now(), "reference-at-DUT", text, acts=True, drawing=drawing)
        blocks = yield from turn(bench, 360.0, rate_deg_per_s)
        turning, angle = samples(blocks, "reference"), samples(blocks, "angle", "angle_deg")
        yield plan.begin(bench, "holding")
        holding = samples((yield from record(bench, dwell_s)), "reference")
        yield plan.begin(bench, "motor off")
        yield Prompt(bench.clock.now(), "motor-off", "Switch the platform's motor off at its plug.", acts=True)
        off = samples((yield from record(bench, dwell_s)), "reference")
        yield Prompt(bench.clock.now(), "motor-on", "Switch the platform's motor on again.", acts=True)
    amplitude, u = harmonic(turning, angle)
    yield from measured(bench, "once a turn", amplitude, u, "nT", limit_nT)
    for name, one, other in (("turning less holding", turning, holding), ("holding less off", holding, off)):
        difference = float(np.linalg.norm(one.mean - other.mean))
        u = float(np.hypot(one.u_mean.max(), other.u_mean.max()))
        yield from measured(bench, name, difference, u, "nT", limit_nT)


def harmonic(reference: Samples, angle: Samples) -> tuple[float, float]:
    """Amplitude [nT] of the part of the field that turns with the angle, and its standard uncertainty.

    Least squares of each component on 1, cos θ, sin θ; the amplitude is the root sum square over the components.
    """
    inside = reference.between(angle.t_s[0], angle.t_s[-1])
    theta = np.radians(angle.at(inside.t_s)[:, 0])
    basis = np.column_stack([np.ones_like(theta), np.cos(theta), np.sin(theta)])
    solution, left, _, _ = np.linalg.lstsq(basis, inside.values, rcond=None)
    variance = float(np.sum(left)) / (inside.values.size - 3 * inside.values.shape[1])
    return float(np.linalg.norm(solution[1:])), float(np.sqrt(variance * np.linalg.inv(basis.T @ basis)[1, 1]))

"""The field stepped up, down and up again along one direction: does the DUT follow in a straight line."""

from __future__ import annotations

from contextlib import ExitStack
from functools import partial
from typing import Annotated, Literal

import numpy as np
from numpy.typing import NDArray

from labcal.bench.bench import Bench
from labcal.bench.mounting import AXES, SET_UP, attitude, plan_with_set_up, set_up
from labcal.bench.parameters import Limits
from labcal.bench.stated import as_positions
from labcal.bench.steps import Procedure, coils_off, dut_nT, energise, measured, note, rest
from labcal.bench.streams.samples import samples
from labcal.errors import InputError
from labcal.geometry import unit
from labcal.record import Run
from labcal.record.stream import Event
from labcal.uncertainty.verdicts import half_expanded, in_body, largest, u_declared, u_of_size, uncovered

NEEDS, LASTS_MIN = "the DUT at rest in the cage", 3

Array = NDArray[np.float64]
SWEEPS = ("field upwards", "field downwards", "field upwards again")
ZERO_S, STEP_S = 10.0, 1.5  # coils-off zero before; of lab time for a step beside its dwell
SEPARATES = (
    ("nonlinearity", "cross-field"),
    ("nonlinearity", "hysteresis"),
    ("offset-temperature", "gain-temperature"),
)


def linearity(
    bench: Bench,
    *,
    axis: Annotated[Literal["x", "y", "z"], "body axis along the platform axis and the field"] = "z",
    second_axis: Annotated[Literal["none", "x", "y", "z"], "body axis stepped together with it"] = "none",
    field_nT: Annotated[float, Limits(1_000, 100_000, unit="nT"), "largest field"] = 50_000.0,
    steps: Annotated[int, Limits(2, 50), "steps of one sign"] = 5,
    dwell_s: Annotated[float, Limits(0.5, 600, unit="s"), "recorded at each step"] = 4.0,
    mode: Annotated[str, "the DUT's power mode"] = "nominal",
    limit_nT: Annotated[float, Limits(0.1, 1e5, unit="nT"), "largest departure that passes"] = 200.0,
    u_mounting_deg: Annotated[float, Limits(0, 10, unit="deg"), "how well the axis is mounted; 0: not stated"] = 0.0,
) -> Procedure:
    """Step the field along a body axis (or two together) and measure the departure from a straight line."""
    if bench.config.reference.kind != "vector":
        raise InputError("linearity needs a vector reference")
    at_zero = attitude(bench, axis)
    direction = np.asarray(AXES[axis]) + (np.zeros(3) if second_axis == "none" else np.asarray(AXES[second_axis]))
    along_B = unit(direction)
    up = list(np.linspace(-1, 1, 2 * steps + 1))
    ladder = [*up, *reversed(up), *up]
    sweep_s = len(up) * (dwell_s + STEP_S)
    plan = plan_with_set_up(ZERO_S, [(name, sweep_s) for name in SWEEPS])
    with ExitStack() as afterwards:
        afterwards.callback(bench.cage.zero)  # the undo, before anything is energised
        yield plan.begin(bench, SET_UP)
        yield from set_up(bench, axis, ZERO_S, f"The field steps up to ±{field_nT / 1000:g} µT.", mode)
        fields, readings = list[Array](), list[Array]()
        for number, fraction in enumerate(ladder):
            if number % len(up) == 0:
                yield plan.begin(bench, SWEEPS[number // len(up)])
            yield from energise(bench, fraction * field_nT * (along_B @ at_zero))
            name = f"step-{number}-{fraction * field_nT / 1000:+.3g}uT"
            blocks = yield from rest(bench, name, dwell_s, mode=mode, body_from_cage=at_zero)
            fields.append(samples(blocks, "reference").mean)
            readings.append(dut_nT(bench, blocks).mean)
        yield from coils_off(bench)
    positions = as_positions(bench, fields, [at_zero] * len(fields), u_mounting_deg)
    if left := uncovered(positions, ["the reference's own linearity"]):
        yield note(bench, left)
    along_DUT = np.array(readings) @ along_B
    true = in_body(positions) @ along_B
    slope, worst, u = straightness(true, along_DUT)
    dof = len(along_DUT) // 3  # repeats
    of_slope = u / float(np.linalg.norm(true - true.mean()))
    of_reference = u_declared(positions, partial(_slope, along_B, along_DUT))
    u_slope = half_expanded((of_slope, dof), (of_reference, np.inf))
    u_worst = u_of_size(positions, partial(_departures, along_B, along_DUT), largest, u, dof)
    yield from measured(bench, "slope", slope, u_slope, "")
    yield from measured(bench, "departure from a straight line", worst, u_worst, "nT", limit_nT)
    seen = np.column_stack([true, along_DUT]).tolist()
    yield Event(bench.clock.now(), "linearity", "field and reading along the direction", {"field_reading_nT": seen})


def _slope(along_B: Array, along_DUT: Array, positions: Run) -> float:
    """With the reference of these positions."""
    return straightness(in_body(positions) @ along_B, along_DUT)[0]


def _departures(along_B: Array, along_DUT: Array, positions: Run) -> Array:
    return _beside_the_line(in_body(positions) @ along_B, along_DUT)[1]


def straightness(field_nT: Array, reading_nT: Array) -> tuple[float, float, float]:
    """Slope, largest departure (signed) from the line, and a reading's standard uncertainty from repeats."""
    slope, left = _beside_the_line(field_nT, reading_nT)
    third = len(left) // 3
    repeats = (left[:third] - left[-third:]) / np.sqrt(2)
    return slope, float(left[np.argmax(np.abs(left))]), float(np.sqrt(np.mean(repeats**2)))


def _beside_the_line(field_nT: Array, reading_nT: Array) -> tuple[float, Array]:
    """The slope, and what the line of least squares leaves (n,) [nT]."""
    slope, offset = np.polyfit(field_nT, reading_nT, 1)
    return float(slope), reading_nT - slope * field_nT - offset

"""The DUT warmed and left to cool in a steady field: how its reading follows its temperature."""

from __future__ import annotations

from contextlib import ExitStack
from typing import Annotated

import numpy as np
from numpy.typing import NDArray

from labcal.bench.bench import Bench
from labcal.bench.mounting import SET_UP, attitude, how_to_mount, plan_with_set_up
from labcal.bench.parameters import Limits
from labcal.bench.steps import (
    Blocks,
    Procedure,
    coils_off,
    dut_nT,
    energise,
    measure_ambient,
    measured,
    mount,
    ready,
    rest,
    switch_mode,
)
from labcal.bench.streams.samples import Samples, samples, thinned
from labcal.errors import InputError
from labcal.record.stream import Prompt

NEEDS, LASTS_MIN = "the DUT with its thermometer, a means to warm it", 21

Array = NDArray[np.float64]
EVERY_S, FEWEST = 1.0, 10  # a mean is kept, and so many a visit: a DUT warms slowly, and long runs must fit in
SEPARATES = (("offset-temperature", "offset-drift"), ("offset-temperature", "gain-temperature"))


def temperature_drift(
    bench: Bench,
    *,
    channel: Annotated[str, "temperature channel of the DUT; empty: the first"] = "",
    fields_nT: Annotated[tuple[float, ...], Limits(-1e5, 1e5, unit="nT"), "along the platform axis"] = (0.0, 50_000.0),
    rounds: Annotated[int, Limits(2, 1_000), "times every field is visited"] = 20,
    dwell_s: Annotated[float, Limits(1, 3_600, unit="s"), "recorded at each visit"] = 30.0,
    mode: Annotated[str, "the DUT's power mode"] = "nominal",
) -> Procedure:
    """Measure offset and gain against the DUT's temperature while it changes."""
    temperatures = [c.name for c in bench.dut.channels if c.quantity == "temperature"]
    name = channel or next(iter(temperatures), "")
    if name not in temperatures:
        raise InputError(f"the DUT has no temperature channel {name!r}; it has {', '.join(temperatures) or 'none'}")
    visits = [(f"round {n + 1}", len(fields_nT) * (dwell_s + 1.5)) for n in range(rounds)]
    plan = plan_with_set_up(10.0, visits)
    at_zero, kept = attitude(bench, "z"), {field: Blocks() for field in fields_nT}
    with ExitStack() as afterwards:
        afterwards.callback(bench.cage.zero)  # the undo, before anything is energised
        yield plan.begin(bench, SET_UP)
        yield from mount(bench, "mount-z", at_zero, how_to_mount("z"))
        yield from switch_mode(bench, mode)
        yield Prompt(bench.clock.now(), "warm", "Warm the DUT within its limits, then let it cool.", acts=True)
        largest = max(map(abs, fields_nT)) / 1000
        yield from ready(bench, f"The field goes to {largest:g} µT as the DUT warms and cools. Hands off?")
        yield from measure_ambient(bench, 10.0)
        for number, (step, _) in enumerate(visits):
            yield plan.begin(bench, step)
            for field_nT in fields_nT:
                yield from energise(bench, field_nT * np.asarray(bench.config.platform.axis_cage))
                segment = f"{field_nT / 1000:+g}uT-{number + 1}"
                visit = yield from rest(bench, segment, dwell_s, mode=mode, body_from_cage=at_zero)
                kept[field_nT] += thinned(visit, min(EVERY_S, dwell_s / FEWEST))
        yield from coils_off(bench)
    for field_nT, blocks in kept.items():
        slopes, u = against(
            dut_nT(bench, blocks), samples(blocks, "reference"), at_zero, samples(blocks, "channel", name)
        )
        for axis, slope in zip("xyz", slopes, strict=True):
            yield from measured(bench, f"{axis} at {field_nT / 1000:+g} µT per {name}", slope, u, "nT/degC")


def against(dut: Samples, reference: Samples, body_from_cage: Array, temperature: Samples) -> tuple[Array, float]:
    """Slope (3,) [nT/degC] of the reading less the reference with temperature, and its standard uncertainty."""
    inside = dut.between(max(reference.t_s[0], temperature.t_s[0]), min(reference.t_s[-1], temperature.t_s[-1]))
    excess = inside.values - reference.at(inside.t_s) @ body_from_cage.T
    warm = temperature.at(inside.t_s)[:, 0]
    basis = np.column_stack([warm - warm.mean(), np.ones_like(warm)])
    solution, left, _, _ = np.linalg.lstsq(basis, excess, rcond=None)
    u = float(np.sqrt(np.sum(left) / (3 * (len(warm) - 2)) / np.sum(basis[:, 0] ** 2)))
    return np.asarray(solution[0]), u

"""A decaying alternation on each coil for cage and surroundings. It is no deperm of a spacecraft."""

from __future__ import annotations

from contextlib import ExitStack
from typing import Annotated

import numpy as np
from numpy.typing import NDArray

from labcal.bench.bench import Bench
from labcal.bench.parameters import Limits
from labcal.bench.steps import Plan, Procedure, Work, coils_off, drive, measure_ambient, measured, note, ready, record

NEEDS, LASTS_MIN = "nothing magnetic in the cage that must not be touched", 3

Array = NDArray[np.float64]
ZERO_S, STEP_S = 10.0, 1.9  # before and after; of lab time for a reversal beside its hold


def degauss(
    bench: Bench,
    *,
    field_nT: Annotated[float, Limits(1_000, 200_000, unit="nT"), "first amplitude, within coil and DUT limits"] = 50e3,
    cycles: Annotated[int, Limits(5, 500), "reversals"] = 30,
    last_nT: Annotated[float, Limits(10, 10_000, unit="nT"), "last amplitude"] = 200.0,
    hold_s: Annotated[float, Limits(0.05, 10, unit="s"), "at each amplitude"] = 0.5,
) -> Procedure:
    """Alternate each coil's current with falling amplitude, and compare the ambient field before and after."""
    coils = tuple((f"coil {name}", cycles * (hold_s + STEP_S)) for name in "xyz")
    plan = Plan((("field before", ZERO_S), *coils, ("field after", ZERO_S)))
    with ExitStack() as afterwards:
        afterwards.callback(bench.cage.zero)  # the undo, before anything is energised
        yield note(bench, "For cage and surroundings; this is no deperm of a spacecraft.")
        yield plan.begin(bench, "field before")
        yield from measure_ambient(bench, ZERO_S, name="before")
        before = bench.cage.ambient_nT
        yield from ready(bench, f"Each coil alternates from ±{field_nT / 1000:g} µT downwards. Hands off?")
        for coil, (step, _) in enumerate(coils):
            yield plan.begin(bench, step)
            yield from _one_coil(bench, coil, amplitudes(field_nT, last_nT, cycles), hold_s)
        bench.cage.check.outdated(bench.clock.now())  # by what degaussing is for
        yield plan.begin(bench, "field after")
        yield from coils_off(bench)
        yield from measure_ambient(bench, ZERO_S, name="after")
        changed = float(np.linalg.norm(bench.cage.ambient_nT - before))
        yield from measured(bench, "change of the ambient field", changed, 0.0, "nT")


def amplitudes(first_nT: float, last_nT: float, cycles: int) -> Array:
    """Signed amplitudes (cycles,) [nT]: geometric, every one reversed."""
    return np.geomspace(first_nT, last_nT, cycles) * (-1.0) ** np.arange(cycles)


def _one_coil(bench: Bench, coil: int, steps_nT: Array, hold_s: float) -> Work[None]:
    per_ampere = float(np.linalg.norm(bench.cage.matrix_nT_per_A[:, coil]))
    for step_nT in steps_nT:
        yield from drive(bench, step_nT / per_ampere * np.eye(3)[coil])
        yield from record(bench, hold_s)

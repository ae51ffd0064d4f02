"""Each load of the spacecraft switched on and off: how far it bends the DUT's reading, per ampere, and how late."""

from __future__ import annotations

from contextlib import ExitStack
from typing import Annotated

import numpy as np
from numpy.typing import NDArray

from labcal.bench.bench import Bench
from labcal.bench.mounting import SET_UP, attitude, plan_with_set_up, set_up
from labcal.bench.parameters import Limits
from labcal.bench.steps import Blocks, Procedure, Work, dut_nT, measured, rest
from labcal.bench.streams.samples import Samples, samples
from labcal.errors import InputError
from labcal.record.stream import Event, Prompt

NEEDS, LASTS_MIN = "the DUT on the platform, loads of the spacecraft that can be switched", 3

Array = NDArray[np.float64]
STEP_S = 0.6  # of lab time for a load on, or off, beside its dwell
SEPARATES = (
    ("offset-current", "offset-drift"),
    ("offset-current", "offset-temperature"),
    ("offset-current", "offset-current-squared"),
    ("offset-channel", "offset-drift"),
)


def current_coupling(
    bench: Bench,
    *,
    loads: Annotated[tuple[str, ...] | None, "channels to switch; none: every current channel of the DUT"] = None,
    repeats: Annotated[int, Limits(2, 50), "times each load is switched on"] = 3,
    dwell_s: Annotated[float, Limits(2, 600, unit="s"), "on, and off, each time"] = 10.0,
    mode: Annotated[str, "the DUT's power mode"] = "nominal",
) -> Procedure:
    """Switch each load and measure the bias per ampere (3 × N) and its delay, coils off."""
    currents = tuple(c.name for c in bench.dut.channels if c.quantity == "current")
    chosen = loads or currents
    for load in chosen:
        if load not in currents:
            raise InputError(f"the DUT has no current channel {load!r}; it has {', '.join(currents) or 'none'}")
    plan = plan_with_set_up(5.0, [(load, 2 * repeats * (dwell_s + STEP_S)) for load in chosen], frozenset(chosen))
    matrix: dict[str, list[float]] = {}
    with ExitStack() as afterwards:
        afterwards.callback(bench.cage.zero)
        yield plan.begin(bench, SET_UP)
        yield from set_up(bench, "z", 5.0, "Every load is switched in turn, the others stay off.", mode)
        for load in chosen:
            yield from _switched(bench, load, False)
        for load in chosen:
            yield plan.begin(bench, load)
            blocks = yield from _on_and_off(bench, load, repeats, dwell_s, mode)
            coupling, u, late = coupled(dut_nT(bench, blocks), samples(blocks, "channel", load), dwell_s)
            for name, value in zip("xyz", coupling, strict=True):
                yield from measured(bench, f"{load}: bias {name}", value, u, "nT/A")
            yield from measured(bench, f"{load}: delay", late, 0.0, "s")
            matrix[load] = coupling.tolist()
    yield Event(bench.clock.now(), "current-coupling", "bias per ampere, one column a load", {"nT_per_A": matrix})


def _switched(bench: Bench, load: str, on: bool) -> Work[None]:
    text = f"Switch the load {load} {'on' if on else 'off'}."
    yield Prompt(
        bench.clock.now(), f"{load}-{'on' if on else 'off'}", text, acts=True, drawing={"load": load, "on": on}
    )


def _on_and_off(bench: Bench, load: str, repeats: int, dwell_s: float, mode: str) -> Work[Blocks]:
    kept: Blocks = []
    for number in range(repeats):
        for on in (False, True):
            yield from _switched(bench, load, on)
            name = f"{load}-{'on' if on else 'off'}-{number + 1}"
            kept += yield from rest(bench, name, dwell_s, mode=mode, body_from_cage=attitude(bench, "z"))
    yield from _switched(bench, load, False)
    return kept


def coupled(dut: Samples, current: Samples, dwell_s: float) -> tuple[Array, float, float]:
    """Bias per ampere (3,) [nT/A], its standard uncertainty, and the delay [s] that fits best.

    Least squares of the reading on the current a delay before and on a cubic in time (ambient and drift), over
    delays up to half a dwell, positive or negative.
    """
    delays = np.linspace(-dwell_s / 2, dwell_s / 2, 81)
    fits = [_regress(dut, current, delay) for delay in delays]
    best = int(np.argmin([left for _, _, left in fits]))
    coupling, u, _ = fits[best]
    return coupling, u, float(delays[best])


def _regress(dut: Samples, current: Samples, delay_s: float) -> tuple[Array, float, float]:
    middle, half = (dut.t_s[0] + dut.t_s[-1]) / 2, (dut.t_s[-1] - dut.t_s[0]) / 2
    inside = np.abs(dut.t_s - middle) < half - np.abs(delay_s) - 1.0
    t = (dut.t_s[inside] - middle) / half
    drive = np.interp(dut.t_s[inside] - delay_s, current.t_s, current.values[:, 0])
    basis = np.column_stack([drive, np.ones_like(t), t, t**2, t**3])
    solution, left, _, _ = np.linalg.lstsq(basis, dut.values[inside], rcond=None)
    total = float(np.sum(left))
    variance = total / (3 * (len(t) - 5))
    u = float(np.sqrt(variance * np.linalg.inv(basis.T @ basis)[0, 0]))
    return np.asarray(solution[0]), u, total / int(inside.sum())

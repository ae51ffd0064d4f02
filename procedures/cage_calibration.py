"""The cage measured: currents up, down and up again on each coil, the reference at the DUT's place, then at its own."""

from __future__ import annotations

from contextlib import ExitStack
from dataclasses import dataclass
from typing import Annotated

import numpy as np
from numpy.typing import NDArray

from labcal.bench.bench import Bench
from labcal.bench.parameters import Limits
from labcal.bench.samples import samples
from labcal.bench.steps import Plan, Procedure, Work, coils_off, drive, measured, ready, record
from labcal.errors import InputError
from labcal.fit.cage import CageFit, fit_cage
from labcal.record.stream import Event, Prompt

Array = NDArray[np.float64]
AT_DUT = (0.0, 0.0, 0.0)
READS = 4  # of the currents at each step


@dataclass(frozen=True, slots=True, eq=False)
class Sweep:
    """Every step of one place: `currents_A` (n, 3) as measured, `fields_nT` (n, 3) in C, `coil` (n,), `up` (n,)."""

    currents_A: Array
    fields_nT: Array
    coil: NDArray[np.intp]
    up: NDArray[np.bool_]
    noise_nT: float
    settling_s: float


def cage_calibration(
    bench: Bench,
    *,
    field_nT: Annotated[float, Limits(1_000, 100_000, unit="nT"), "largest step of each coil"] = 40_000.0,
    steps: Annotated[int, Limits(2, 20), "steps of one sign, from zero to the largest"] = 3,
    dwell_s: Annotated[float, Limits(0.5, 60, unit="s"), "recorded at each step"] = 2.0,
    limit_ppm: Annotated[float, Limits(1, 1e5, unit="ppm"), "largest uncertainty of the matrix that passes"] = 500.0,
    linearity_nT: Annotated[float, Limits(1, 1e5, unit="nT"), "largest departure from the line that passes"] = 150.0,
    hysteresis_nT: Annotated[float, Limits(1, 1e5, unit="nT"), "largest difference of up and down that passes"] = 100.0,
) -> Procedure:
    """Measure the current-to-field matrix and offset at the DUT's place and at the reference's; a draft."""
    if bench.config.reference.kind != "vector":
        raise InputError("cage-calibration needs a vector reference")
    own = bench.config.reference.position_m
    places = {"DUT": AT_DUT} if own is None else {"DUT": AT_DUT, "reference": own}
    ladder = _ladder(steps)
    seconds = len(places) * 3 * len(ladder) * (dwell_s + 1.0) / len(places)
    plan = Plan(tuple((f"sweep at the {place}'s place", seconds) for place in places))
    with ExitStack() as afterwards:
        afterwards.callback(bench.cage.zero)  # the undo, before anything is energised
        found: dict[str, CageFit] = {}
        for place, position_m in places.items():
            yield plan.begin(bench, f"sweep at the {place}'s place")
            yield from _reference_at(bench, place, position_m)
            yield from ready(bench, f"Each coil goes to ±{field_nT / 1000:g} µT in turn. Hands off?")
            sweep = yield from _sweep(bench, field_nT, ladder, dwell_s)
            found[place] = fit_cage(sweep.currents_A, sweep.fields_nT)
            yield from _judge(bench, place, sweep, found[place], (limit_ppm, linearity_nT, hysteresis_nT))
        yield _draft(bench, found)


def _ladder(steps: int) -> list[tuple[float, bool]]:
    """Fractions of the largest current and whether they are approached from below: up, down, up, through both signs."""
    up = [n / steps for n in range(-steps, steps + 1)]
    return [*((f, True) for f in up), *((f, False) for f in reversed(up)), *((f, True) for f in up)]


def _reference_at(bench: Bench, place: str, position_m: tuple[float, float, float]) -> Work[None]:
    yield from coils_off(bench)
    x, y, z = (1000 * v for v in position_m)
    text = f"Put the reference at the {place}'s place: {x:.0f}, {y:.0f}, {z:.0f} mm from the DUT's place, in C."
    yield Prompt(bench.clock.now(), f"reference-at-{place}", text, acts=True, drawing={"reference_m": list(position_m)})


def _sweep(bench: Bench, field_nT: float, ladder: list[tuple[float, bool]], dwell_s: float) -> Work[Sweep]:
    """Every coil by itself, with the ladder's currents, approached from the side that the ladder says."""
    currents, fields, coils, ups, noises = list[Array](), list[Array](), list[int](), list[bool](), list[float]()
    settling = 0.0
    for coil in range(3):
        largest_A = field_nT / float(np.linalg.norm(bench.cage.matrix_nT_per_A[:, coil]))
        for fraction, up in ladder:
            begun = bench.clock.now()
            yield from drive(bench, fraction * largest_A * np.eye(3)[coil])
            driven = bench.clock.now()
            blocks = yield from record(bench, dwell_s, from_s=begun)
            seen = samples(blocks, "reference")
            still = seen.between(driven + dwell_s / 4, np.inf)
            currents.append(np.mean([bench.cage.currents_A() for _ in range(READS)], axis=0))
            fields.append(still.mean)
            coils.append(coil)
            ups.append(up)
            noises.append(float(np.sqrt(np.mean(np.diff(still.values, axis=0) ** 2) / 2)))
            settling = max(settling, settling_time(seen.t_s - begun, seen.values[:, coil], 5 * noises[-1]))
    yield from coils_off(bench)
    return Sweep(np.array(currents), np.array(fields), np.array(coils), np.array(ups), float(np.mean(noises)), settling)


def settling_time(t_s: Array, values: Array, within_nT: float) -> float:
    """When `values` (n,) last lay further than `within_nT` from where they end [s]."""
    outside = np.flatnonzero(np.abs(values - np.median(values[-3:])) > within_nT)
    return float(t_s[outside[-1]]) if len(outside) else 0.0


def hysteresis(sweep: Sweep, fit: CageFit) -> tuple[float, float]:
    """The largest mean difference of residuals up less down over the coils [nT], and its standard uncertainty."""
    worst, u = 0.0, 0.0
    for coil in range(3):
        along = fit.residual_nT[:, coil]
        up, down = along[(sweep.coil == coil) & sweep.up], along[(sweep.coil == coil) & ~sweep.up]
        difference = float(up.mean() - down.mean())
        if abs(difference) >= abs(worst):
            worst, u = difference, float(np.sqrt(up.var(ddof=1) / len(up) + down.var(ddof=1) / len(down)))
    return worst, u


def _judge(bench: Bench, place: str, sweep: Sweep, fit: CageFit, limits: tuple[float, float, float]) -> Work[None]:
    size = np.linalg.norm(fit.matrix_nT_per_A, axis=0)
    ppm = float(1e6 * np.max(fit.u_matrix_nT_per_A / size))
    up_down, u_up_down = hysteresis(sweep, fit)
    departure = float(np.abs(fit.residual_nT).max())
    yield from measured(bench, f"{place}: uncertainty of the matrix", ppm, 0.0, "ppm", limits[0])
    yield from measured(bench, f"{place}: departure from the line", departure, sweep.noise_nT / 3, "nT", limits[1])
    yield from measured(bench, f"{place}: up less down", up_down, u_up_down, "nT", limits[2])
    yield from measured(bench, f"{place}: noise", sweep.noise_nT, 0.0, "nT")
    yield from measured(bench, f"{place}: settling time", sweep.settling_s, 0.0, "s")


def _draft(bench: Bench, found: dict[str, CageFit]) -> Event:
    """What was found, for the record: a draft, until someone writes it into bench.toml and says so."""
    data = {place: _as_data(fit) for place, fit in found.items()}
    if "reference" in found:
        here, there = found["DUT"], found["reference"]
        data["DUT less reference"] = {
            "matrix_nT_per_A": (here.matrix_nT_per_A - there.matrix_nT_per_A).tolist(),
            "offset_nT": (here.offset_nT - there.offset_nT).tolist(),
            "covariance": (here.covariance + there.covariance).tolist(),
        }
    rows = ", ".join(f"[{', '.join(f'{v:.1f}' for v in row)}]" for row in found["DUT"].matrix_nT_per_A)
    return Event(bench.clock.now(), "cage-calibration", f"draft: matrix_nT_per_A = [{rows}]", data)


def _as_data(fit: CageFit) -> dict[str, list[object]]:
    return {
        "matrix_nT_per_A": fit.matrix_nT_per_A.tolist(),
        "offset_nT": fit.offset_nT.tolist(),
        "covariance": fit.covariance.tolist(),
    }

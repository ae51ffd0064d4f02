"""The cage measured: each coil up, down and up again in either polarity, at the DUT's place and at the reference's."""

from __future__ import annotations

from collections.abc import Callable
from contextlib import ExitStack
from dataclasses import dataclass, replace
from functools import partial
from typing import Annotated

import numpy as np
from numpy.typing import NDArray

from labcal.bench.bench import Bench
from labcal.bench.parameters import Limits
from labcal.bench.stated import as_positions
from labcal.bench.steps import Plan, Procedure, Work, coils_off, drive, measured, note, ready, record
from labcal.bench.streams.samples import samples
from labcal.errors import InputError
from labcal.fit.cage import CageFit, fit_cage
from labcal.record import Run
from labcal.record.stream import Event, Prompt
from labcal.uncertainty import declared_errors
from labcal.uncertainty.verdicts import largest, u_of_size, uncovered

NEEDS, LASTS_MIN = "a vector reference, first at the DUT's place, then at its own", 5

Array = NDArray[np.float64]
AT_DUT = (0.0, 0.0, 0.0)
READS = 4  # of the currents at each step
SPREAD = 0.04  # of each step: no two alike, so that what a supply's last digit hides differs every time
LOWEST = 0.1  # of the largest current: what a supply lets through at zero, its read-back does not show
GOLDEN = 0.6180339887498949


@dataclass(frozen=True, slots=True)
class Rung:
    """One step of a ladder: the signed fraction of the largest current, and whether |I| came to it from below."""

    fraction: float
    rising: bool
    sign: int  # of the polarity relay


@dataclass(frozen=True, slots=True, eq=False)
class Sweep:
    """Every step of one place: `currents_A` (n, 3) as measured, `fields_nT` (n, 3) in C, `coil` and `sign` (n,)."""

    t_s: Array
    currents_A: Array
    fields_nT: Array
    coil: NDArray[np.intp]
    sign: NDArray[np.intp]
    rising: NDArray[np.bool_]
    noise_nT: float  # of one sample
    settling_s: float
    u_nT: float  # of one step's mean, by noise


def cage_calibration(
    bench: Bench,
    *,
    field_nT: Annotated[float, Limits(1_000, 100_000, unit="nT"), "largest step of each coil"] = 40_000.0,
    steps: Annotated[int, Limits(2, 20), "steps of one sign, from zero to the largest"] = 3,
    dwell_s: Annotated[float, Limits(0.5, 60, unit="s"), "recorded at each step"] = 2.0,
    limit_ppm: Annotated[float, Limits(1, 1e5, unit="ppm"), "largest uncertainty of the matrix that passes"] = 500.0,
    change_ppm: Annotated[float, Limits(1, 1e6, unit="ppm"), "largest change from bench.toml that passes"] = 3_000.0,
    relay_ppm: Annotated[float, Limits(1, 1e6, unit="ppm"), "largest difference of the polarities"] = 5_000.0,
    linearity_nT: Annotated[float, Limits(1, 1e5, unit="nT"), "largest departure from the line that passes"] = 150.0,
    hysteresis_nT: Annotated[float, Limits(1, 1e5, unit="nT"), "largest difference of up and down that passes"] = 100.0,
) -> Procedure:
    """Measure the current-to-field matrix and offset at the DUT's place and at the reference's; a draft."""
    if bench.config.reference.kind != "vector":
        raise InputError("cage-calibration needs a vector reference")
    own = bench.config.reference.position_m
    places = {"DUT": AT_DUT} if own is None else {"DUT": AT_DUT, "reference": own}
    rungs = ladder(steps)
    sweeps = tuple((f"sweep at the {place}'s place", 3 * len(rungs) * (dwell_s + 1.0)) for place in places)
    plan = Plan(sweeps, frozenset(name for name, _ in sweeps))
    limits = (limit_ppm, change_ppm, relay_ppm, linearity_nT, hysteresis_nT)
    with ExitStack() as afterwards:
        afterwards.callback(bench.cage.zero)  # the undo, before anything is energised
        found: dict[str, tuple[Sweep, CageFit]] = {}
        for place, position_m in places.items():
            yield plan.begin(bench, f"sweep at the {place}'s place")
            yield from _reference_at(bench, place, position_m)
            yield from ready(bench, f"Each coil goes to ±{field_nT / 1000:g} µT in turn. Hands off?")
            sweep = yield from _sweep(bench, field_nT, rungs, dwell_s)
            fit = _fit(sweep)
            found[place] = sweep, fit
            yield from _judge(bench, place, sweep, fit, limits)
        yield _draft(bench, found)


def ladder(steps: int) -> list[Rung]:
    """Up, down and up again in the one polarity, then in the other: the contacts switch once, at zero."""
    up = [n / steps for n in range(1, steps + 1)]
    once = [*((f, True) for f in up), *((f, False) for f in (*reversed(up[:-1]), LOWEST)), *((f, True) for f in up)]
    spread = (1 - SPREAD * (n * GOLDEN % 1) for n in range(2 * len(once)))
    return [Rung(sign * f * next(spread), rising, sign) for sign in (1, -1) for f, rising in once]


def _reference_at(bench: Bench, place: str, position_m: tuple[float, float, float]) -> Work[None]:
    yield from coils_off(bench)
    x, y, z = (1000 * v for v in position_m)
    text = f"Put the reference at the {place}'s place: {x:.0f}, {y:.0f}, {z:.0f} mm from the DUT's place, in C."
    yield Prompt(bench.clock.now(), f"reference-at-{place}", text, acts=True, drawing={"reference_m": list(position_m)})


def _sweep(bench: Bench, field_nT: float, rungs: list[Rung], dwell_s: float) -> Work[Sweep]:
    """Every coil by itself, rung by rung."""
    times, currents, fields = list[float](), list[Array](), list[Array]()
    noises, of_means, settling = list[float](), list[Array](), 0.0
    for coil in range(3):
        largest_A = field_nT / float(np.linalg.norm(bench.cage.matrix_nT_per_A[:, coil]))
        for rung in rungs:
            begun = bench.clock.now()
            yield from drive(bench, rung.fraction * largest_A * np.eye(3)[coil], confirm_signs=False)
            driven = bench.clock.now()
            blocks = yield from record(bench, dwell_s, from_s=begun)
            seen = samples(blocks, "reference")
            still = seen.between(driven + dwell_s / 4, np.inf)
            times.append(float(still.t_s.mean()))
            currents.append(np.mean([bench.cage.currents_A() for _ in range(READS)], axis=0))
            fields.append(still.mean)
            of_means.append(still.u_mean)
            noises.append(float(np.sqrt(np.mean(np.diff(still.values, axis=0) ** 2) / 2)))
            ramped = driven - bench.config.cage.settle_s
            settling = max(settling, settling_time(seen.t_s - ramped, seen.values[:, coil], 5 * noises[-1]))
    yield from coils_off(bench)
    return Sweep(
        np.array(times), np.array(currents), np.array(fields), np.repeat(np.arange(3), len(rungs)),
        np.tile([r.sign for r in rungs], 3), np.tile([r.rising for r in rungs], 3), float(np.mean(noises)), settling,
        float(np.sqrt(np.mean(np.square(of_means)))),
    )  # fmt: skip


def settling_time(t_s: Array, values: Array, within_nT: float) -> float:
    """When `values` (n,) last lay further than `within_nT` from where they end [s after the ramp]; 0 where never."""
    outside = np.flatnonzero(np.abs(values - np.median(values[-3:])) > within_nT)
    return max(float(t_s[outside[-1]]), 0.0) if len(outside) else 0.0


def hysteresis(sweep: Sweep) -> tuple[Array, Array]:
    """How much more field (3,) [nT] each coil makes where |I| came from below than from above; u (3,) by noise.

    The last term of b = m I + b0 + d t + h (±1/2), each coil's own component.
    """
    found = []
    for coil in range(3):
        rows = sweep.coil == coil
        side = sweep.sign[rows] * (sweep.rising[rows] - 0.5)
        columns = np.column_stack([_steady(sweep, rows), sweep.currents_A[rows, coil], side])
        found.append(_last_of(columns, sweep.fields_nT[rows, coil]))
    values, u = np.array(found).T
    return values, u


def polarities(sweep: Sweep) -> tuple[Array, Array]:
    """The difference (3,) [ppm] of each coil's constant in either polarity, and its standard uncertainty by noise.

    The last term of b = m I + b0 + d t + m δ |I| / 2, from the steps that were approached from below.
    """
    found = []
    for coil in range(3):
        rows = (sweep.coil == coil) & sweep.rising
        amps, field = sweep.currents_A[rows, coil], sweep.fields_nT[rows, coil]
        constant = float(np.polyfit(amps, field, 1)[0])
        columns = np.column_stack([_steady(sweep, rows), amps, 1e-6 * constant * np.abs(amps) / 2])
        found.append(_last_of(columns, field))
    values, u = np.array(found).T
    return values, u


def _steady(sweep: Sweep, rows: NDArray[np.bool_]) -> Array:
    t = sweep.t_s[rows]
    return np.column_stack([np.ones_like(t), t - t.mean()])


def _last_of(columns: Array, field_nT: Array) -> tuple[float, float]:
    """The coefficient of the last of `columns` (n, p) in `field_nT` (n,) by least squares, and its uncertainty."""
    solution, left, _, _ = np.linalg.lstsq(columns, field_nT, rcond=None)
    variance = float(left[0]) / (len(columns) - columns.shape[1]) * np.linalg.inv(columns.T @ columns)[-1, -1]
    return float(solution[-1]), float(np.sqrt(variance))


def worst(values: Array) -> float:
    """The one of largest size, with its sign."""
    return float(values[np.argmax(np.abs(values))])


def _judge(bench: Bench, place: str, sweep: Sweep, fit: CageFit, limits: tuple[float, ...]) -> Work[None]:
    positions = as_positions(bench, sweep.fields_nT)
    if left := uncovered(positions, ["the supplies' read-back", "where the reference was put"]):
        yield note(bench, f"{place}: {left}")
    u_ppm = _with_declared(sweep, fit, positions).u_matrix_nT_per_A * _ppm(fit)
    yield from measured(bench, f"{place}: uncertainty of the matrix", u_ppm.max(), 0.0, "ppm", limits[0])
    if place == "DUT":
        of = partial(_change, bench, sweep)
        u_noise = (fit.u_matrix_nT_per_A * _ppm(fit)).ravel()
        u = u_of_size(positions, of, largest, u_noise)
        yield from measured(bench, "DUT: change from bench.toml", worst(of(positions)), u, "ppm", limits[1])
    for name, figure, unit, limit in (
        ("polarity + less −", polarities, "ppm", limits[2]),
        ("departure from the line", departure, "nT", limits[3]),
        ("up less down", hysteresis, "nT", limits[4]),
    ):
        values, u_noise = figure(sweep)
        u = u_of_size(positions, partial(_with_reference, figure, sweep), largest, u_noise)
        yield from measured(bench, f"{place}: {name}", worst(values), u, unit, limit)
    yield from measured(bench, f"{place}: noise", sweep.noise_nT, 0.0, "nT")
    yield from measured(bench, f"{place}: settling time", sweep.settling_s, 0.0, "s")


def _with_declared(sweep: Sweep, fit: CageFit, positions: Run) -> CageFit:
    """The fit, its covariance that of noise and of all that is declared of the reference."""

    def parameters(run: Run) -> Array:
        seen = _fit(_seen_by(sweep, run))
        return np.append(seen.matrix_nT_per_A.ravel(), seen.offset_nT)

    moved = np.array([error.moves(positions, parameters) for error in declared_errors(positions)]).reshape(-1, 12)
    return replace(fit, covariance=fit.covariance + moved.T @ moved)


def _seen_by(sweep: Sweep, positions: Run) -> Sweep:
    """The sweep with the reference of these positions."""
    assert positions.reference_vector is not None
    return replace(sweep, fields_nT=positions.reference_vector)


def departure(sweep: Sweep) -> tuple[Array, Array]:
    """What the fit leaves of each component of each step (3 n,) [nT], and its standard uncertainty by noise."""
    left = _fit(sweep).residual_nT.ravel()
    return left, np.full(left.shape, sweep.u_nT)


def _fit(sweep: Sweep) -> CageFit:
    return fit_cage(sweep.currents_A, sweep.fields_nT, sweep.coil, sweep.t_s)


def _with_reference(figure: Callable[[Sweep], tuple[Array, Array]], sweep: Sweep, positions: Run) -> Array:
    return figure(_seen_by(sweep, positions))[0]


def _change(bench: Bench, sweep: Sweep, positions: Run) -> Array:
    """What each matrix element (9,) is more than bench.toml's [ppm of its coil], by the reference given."""
    fit = _fit(_seen_by(sweep, positions))
    return np.asarray(((fit.matrix_nT_per_A - bench.cage.matrix_nT_per_A) * _ppm(_fit(sweep))).ravel())


def _ppm(fit: CageFit) -> Array:
    """What a nT/A of each coil (3,) is [ppm] of its constant."""
    return np.asarray(1e6 / np.linalg.norm(fit.matrix_nT_per_A, axis=0))


def _draft(bench: Bench, found: dict[str, tuple[Sweep, CageFit]]) -> Event:
    """What was found, for the record: a draft, until someone approves it."""
    data = {
        place: _as_data(_with_declared(sweep, fit, as_positions(bench, sweep.fields_nT)))
        for place, (sweep, fit) in found.items()
    }
    if len(found) == 2:
        data["DUT less reference"] = _difference(*found.values())
    fit = found["DUT"][1]
    rows = ", ".join(f"[{', '.join(f'{v:.1f}' for v in row)}]" for row in fit.matrix_nT_per_A)
    return Event(bench.clock.now(), "cage-calibration", f"draft: matrix_nT_per_A = [{rows}]", data)


def _difference(at_dut: tuple[Sweep, CageFit], at_reference: tuple[Sweep, CageFit]) -> dict[str, list[object]]:
    """M_DUT − M_ref and the ambient difference: b_DUT = b_ref + (M_DUT − M_ref) I + difference, with covariance.

    The two sweeps lie apart in time: the drift seen, times that, is taken for the uncertainty of the difference. What
    is declared of the reference that was at both is not in it: it goes with the reading that is carried.
    """
    (first, here), (second, there) = at_dut, at_reference
    apart_s = float(second.t_s.mean() - first.t_s.mean())
    drifted = apart_s * np.sqrt((here.drift_nT_per_s**2 + there.drift_nT_per_s**2) / 2)
    return {
        "matrix_nT_per_A": (here.matrix_nT_per_A - there.matrix_nT_per_A).tolist(),
        "offset_nT": (here.offset_nT - there.offset_nT).tolist(),
        "covariance": (here.covariance + there.covariance + np.diag([*np.zeros(9), *drifted**2])).tolist(),
    }


def _as_data(fit: CageFit) -> dict[str, list[object]]:
    return {
        "matrix_nT_per_A": fit.matrix_nT_per_A.tolist(),
        "offset_nT": fit.offset_nT.tolist(),
        "covariance": fit.covariance.tolist(),
    }

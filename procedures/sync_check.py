"""A pseudo-random square wave on one coil, then a turn to and fro: how late DUT, reference and angle are."""

from __future__ import annotations

from contextlib import ExitStack
from typing import Annotated, Literal

import numpy as np
from numpy.typing import NDArray

from labcal.bench.bench import Bench
from labcal.bench.mounting import AXES, SET_UP, across, plan_with_set_up, set_up
from labcal.bench.parameters import Limits
from labcal.bench.steps import (
    Blocks,
    Procedure,
    Work,
    coils_off,
    drive,
    dut_nT,
    measured,
    record,
    turn,
)
from labcal.bench.streams.samples import Samples, samples

NEEDS, LASTS_MIN = "the DUT on the platform, a vector reference", 1

Array = NDArray[np.float64]
SPREAD = 9  # points over one sample period
STEP_S, STOOD_S = 1.0, 1.0  # lab time of a step beside its chip; recorded after each turn


def sync_check(
    bench: Bench,
    *,
    axis: Annotated[Literal["x", "y", "z"], "body axis mounted along the platform axis"] = "z",
    step_nT: Annotated[float, Limits(1_000, 50_000, unit="nT"), "height of the wave; one ramp step at most"] = 8_000.0,
    chips: Annotated[int, Limits(7, 127), "steps of the pseudo-random wave"] = 15,
    chip_s: Annotated[float, Limits(0.5, 10, unit="s"), "length of a step"] = 1.0,
    turn_deg: Annotated[float, Limits(10, 180, unit="deg"), "turned to and fro"] = 40.0,
    limit_s: Annotated[float, Limits(1e-3, 5, unit="s"), "longest delay that passes"] = 0.5,
) -> Procedure:
    """Measure the delay of DUT, reference and angle against the set-point and each other."""
    plan = plan_with_set_up(4.0, [("sync-check", check_sync_s(bench, chips, chip_s, turn_deg))])
    with ExitStack() as afterwards:
        afterwards.callback(bench.cage.zero)  # the undo, before anything is energised
        yield plan.begin(bench, SET_UP)
        yield from set_up(bench, axis, 4.0, f"A square wave of {step_nT / 1000:g} µT follows.")
        yield plan.begin(bench, "sync-check")
        yield from check_sync(bench, axis, step_nT, chips, chip_s, turn_deg, limit_s)


def check_sync_s(bench: Bench, chips: int, chip_s: float, turn_deg: float) -> float:
    """Lab time [s] of `check_sync`: the wave with its ramps, and a turn to and fro."""
    return chips * (chip_s + STEP_S) + 2 * (turn_deg / _rate_of(bench) + STOOD_S)


def check_sync(
    bench: Bench, axis: str, step_nT: float, chips: int, chip_s: float, turn_deg: float, limit_s: float
) -> Work[float]:
    """The steps themselves, with the DUT mounted; returns the timing uncertainty [s] of DUT against the angle."""
    wave, blocks = yield from _square_wave(bench, step_nT, chips, chip_s)
    yield from coils_off(bench)  # nothing flows while this computes
    for who, stream in (("DUT", dut_nT(bench, blocks)), ("reference", samples(blocks, "reference"))):
        late, u = delay(stream, wave[:, 0], wave[:, 1])
        yield from measured(bench, f"{who} behind the set-point", late, u, "s", limit_s)
    if not bench.platform.motorised:
        yield from coils_off(bench)
        return 0.0
    late, u = yield from _behind_the_angle(bench, axis, step_nT, turn_deg)
    yield from measured(bench, "DUT behind the angle", late, u, "s", limit_s)
    yield from coils_off(bench)
    return u


def chips_on(count: int) -> list[int]:
    """A maximum-length sequence of ones and zeros (x⁷ + x⁶ + 1), from its start. No sign: no relay has to switch."""
    state, on = 0b1011001, list[int]()
    for _ in range(count):
        on.append(state & 1)
        state = state >> 1 | ((state ^ state >> 1) & 1) << 6
    return on


def _square_wave(bench: Bench, step_nT: float, chips: int, chip_s: float) -> Work[tuple[Array, Blocks]]:
    """The corners (t, level) of the wave as it was asked for, and what the streams sent meanwhile."""
    step_A = np.linalg.solve(bench.cage.matrix_nT_per_A, step_nT * across(bench))
    corners, kept, last = list[tuple[float, float]](), Blocks(), 0
    for on in chips_on(chips):
        begun = bench.clock.now()
        yield from drive(bench, on * step_A, confirm_signs=False)  # it would come late
        kept += yield from record(bench, chip_s, from_s=begun)
        corners += [(begun, last), (begun, on), (bench.clock.now(), on)]
        last = on
    return np.array(corners), kept


def delay(stream: Samples, t_s: Array, level: Array) -> tuple[float, float]:
    """Delay [s] of `stream` behind the wave with corners `t_s`, `level`, and its standard uncertainty.

    Least squares over the delay with one gain and offset an axis, the wave averaged over one sample period; the
    uncertainty from the curvature of the sum.
    """
    seen = stream.between(t_s[0], t_s[-1])
    coarse = np.linspace(-1.0, 1.0, 41)
    near = coarse[np.argmin([_left_over(seen, t_s + d, level) for d in coarse])]
    delays = near + np.linspace(-0.15, 0.15, 61)
    sums = np.array([_left_over(seen, t_s + d, level) for d in delays])
    best = int(np.argmin(sums))
    off = delays - delays[best]
    bowl = np.abs(off) <= max(seen.period_s / 2, 0.01) + 1e-9  # narrower, noise decides its shape
    a, b, c = np.polyfit(off[bowl], sums[bowl], 2)
    variance = max(c, 0.0) / max(1, seen.values.size - 7)
    return float(delays[best] + np.clip(-b / (2 * a), off[bowl].min(), off[bowl].max())), float(
        np.sqrt(variance / abs(a))
    )


def _left_over(seen: Samples, t_s: Array, level: Array) -> float:
    within = seen.period_s * np.linspace(-0.5, 0.5, SPREAD)[:, None]  # an edge falls anywhere between two samples
    model = np.interp(seen.t_s + within, t_s, level).mean(axis=0)
    basis = np.column_stack([np.ones_like(model), model])
    _, left, _, _ = np.linalg.lstsq(basis, seen.values, rcond=None)
    return float(np.sum(left))


def _behind_the_angle(bench: Bench, axis: str, step_nT: float, turn_deg: float) -> Work[tuple[float, float]]:
    """Turn to and fro in a steady field: what the DUT shows late has the sign of the rate."""
    start, rate = bench.platform.angle_deg(), _rate_of(bench)
    yield from drive(bench, np.linalg.solve(bench.cage.matrix_nT_per_A, step_nT * across(bench)))
    kept: Blocks = []
    for to_deg in (start + turn_deg, start):
        kept += yield from turn(bench, to_deg, rate)
        kept += yield from record(bench, STOOD_S)
    return behind(dut_nT(bench, kept), samples(kept, "angle", "angle_deg"), np.asarray(AXES[axis]))


def _rate_of(bench: Bench) -> float:
    return min(bench.platform.max_rate_deg_per_s, 10.0)


def behind(dut: Samples, angle: Samples, axis: Array) -> tuple[float, float]:
    """Delay [s] of the DUT behind the angle and its standard uncertainty, from a turn to and fro about `axis` (3,).

    Least squares of the reading on 1, cos θ and sin θ of the angle and on their derivatives in time (first order
    in the delay): m(t) = a + b·c(t − τ) gives τ as the part along −dc/dt.
    """
    moments, first = np.unique(angle.t_s, return_index=True)  # at one moment there is no rate
    unwrapped = np.radians(np.unwrap(angle.values[first, 0], period=360.0))
    inside = dut.between(moments[0], moments[-1])
    theta = np.interp(inside.t_s, moments, unwrapped)
    rate = np.interp(inside.t_s, moments, np.gradient(unwrapped, moments))
    flat = np.column_stack([np.ones_like(theta), np.cos(theta), np.sin(theta)])
    plane = inside.values @ _across(axis)
    fixed = np.linalg.lstsq(flat, plane, rcond=None)[0]
    slope = np.column_stack([-np.sin(theta), np.cos(theta)]) * rate[:, None]
    column = -(slope @ fixed[1:]).ravel()
    basis = np.zeros((column.size, 7))
    basis[:, 0] = column
    basis[0::2, 1:4], basis[1::2, 4:7] = flat, flat
    solution, left, _, _ = np.linalg.lstsq(basis, plane.ravel(), rcond=None)
    variance = float(left[0]) / (column.size - 7)
    return float(solution[0]), float(np.sqrt(variance * np.linalg.inv(basis.T @ basis)[0, 0]))


def _across(axis: Array) -> Array:
    """Two unit vectors (3, 2) across `axis`."""
    _, _, vt = np.linalg.svd(axis[None, :])
    return np.asarray(vt[1:].T)

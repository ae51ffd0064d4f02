"""Positions that no fit has seen: heading and magnitude error before and after the calibration, against limits."""

from __future__ import annotations

from contextlib import ExitStack
from dataclasses import dataclass
from functools import partial
from typing import Annotated, Literal

import numpy as np
from numpy.typing import NDArray

from labcal.bench.bench import Bench
from labcal.bench.mounting import AXES, SET_UP, plan_with_set_up, set_up
from labcal.bench.parameters import Limits
from labcal.bench.position import position
from labcal.bench.rotation import Rotation
from labcal.bench.stated import as_positions
from labcal.bench.steps import (
    Procedure,
    Work,
    coils_off,
    energise,
    measured,
    note,
    record,
    recorded,
    turn,
)
from labcal.bench.streams.samples import samples
from labcal.geometry import rotation, shortest_rotation
from labcal.model import Calibration
from labcal.model.apply import apply
from labcal.model.readings import Readings
from labcal.record import Run
from labcal.record.stream import Block
from labcal.uncertainty.verdicts import in_body, largest, rms, u_of_size, uncovered

NEEDS, LASTS_MIN = "the DUT on the platform, its calibration file", 8

Array = NDArray[np.float64]
GOLDEN = (np.sqrt(5) - 1) / 2
ZERO_S, STEP_S = 10.0, 6.0  # coils-off zero before; of lab time for a position beside its dwell and turn
ANOTHER_CLOCK_S = 1e9  # this run's times are not those of the run that was fitted


@dataclass(frozen=True, slots=True, eq=False)
class PositionMeans:
    """Means at each position: `reading` (n, 3) [DUT unit], the reference and attitudes as a run, channels (n,).

    `u_nT` (n,) is the standard uncertainty of one component of DUT less reference, by noise; `u_angle_deg` that of
    each angle by itself.
    """

    t_s: Array
    reading: Array
    positions: Run  # B but for one phase
    u_nT: Array
    u_angle_deg: float
    channels: dict[str, Array]


def verify(
    bench: Bench,
    *,
    axis: Annotated[Literal["x", "y", "z"], "body axis mounted along the platform axis"] = "z",
    positions: Annotated[int, Limits(4, 500), "fields and angles"] = 24,
    magnitude_nT: Annotated[float, Limits(1_000, 100_000, unit="nT"), "of the field"] = 35_000.0,
    dwell_s: Annotated[float, Limits(0.5, 60, unit="s"), "recorded at each position"] = 3.0,
    rate_deg_per_s: Annotated[float, Limits(0.1, 60, unit="deg/s"), "between positions"] = 15.0,
    mode: Annotated[str, "the DUT's power mode"] = "nominal",
    heading_deg: Annotated[float, Limits(0.001, 180, unit="deg"), "rms heading error that passes"] = 0.3,
    error_nT: Annotated[float, Limits(0.1, 1e5, unit="nT"), "rms magnitude error that passes"] = 50.0,
    u_mounting_deg: Annotated[float, Limits(0, 10, unit="deg"), "how well the axis is mounted; 0: not stated"] = 0.0,
    calibration: Calibration | None = None,
) -> Procedure:
    """Measure heading and magnitude error at independent positions; `calibration`, where it is stated, is judged."""
    angles, fields = spread(bench, positions, magnitude_nT)
    turns_s = np.abs(np.diff(angles, prepend=0.0)) / rate_deg_per_s
    spots = [(f"position {n + 1}", dwell_s + STEP_S + float(turn_s)) for n, turn_s in enumerate(turns_s)]
    plan = plan_with_set_up(ZERO_S, spots)
    found: list[list[Block]] = []
    with ExitStack() as afterwards:
        afterwards.callback(bench.cage.zero)  # the undo, before anything is energised
        yield plan.begin(bench, SET_UP)
        yield from set_up(
            bench, axis, ZERO_S, f"The field goes to {magnitude_nT / 1000:g} µT, the platform turns.", mode
        )
        for (step, _), angle, field_nT in zip(spots, angles, fields, strict=True):
            yield plan.begin(bench, step)
            yield from turn(bench, float(angle), rate_deg_per_s)
            yield from energise(bench, field_nT)
            still = Rotation(step.replace(" ", "-"), AXES[axis], mode, rate_deg_per_s, mounting=axis).segment(bench)
            found.append((yield from recorded(bench, still, record(bench, dwell_s))))
        yield from coils_off(bench)
    seen = _seen(bench, found, axis, u_mounting_deg)
    if left := uncovered(seen.positions, _unknown(bench)):
        yield note(bench, left)
    if seen.positions.reference_vector is None:
        yield note(bench, "No heading is judged: of the field the reference tells the magnitude alone.")
    yield from _judge(bench, "before", seen.reading * bench.config.dut.nominal_nT_per_unit, seen, axis)
    if calibration is not None:
        names, modes = np.full(positions, "verify"), np.full(positions, mode)
        after = apply(calibration, Readings(seen.reading, seen.t_s + ANOTHER_CLOCK_S, names, modes, seen.channels))
        yield from _judge(bench, "after", after.field_nT, seen, axis, heading_deg, error_nT)


def _unknown(bench: Bench) -> list[str]:
    """What nobody stated of the platform."""
    axis = [] if bench.config.platform.u_axis_cage_deg else ["the direction of the platform's axis in the cage"]
    return axis if _u_angle_deg(bench) else [*axis, "the platform's angle"]


def _u_angle_deg(bench: Bench) -> float:
    """Standard uncertainty of one angle: the platform's noise, or how well a dial is read; 0 where neither is known."""
    return bench.config.platform.angle_noise_deg or (bench.by_hand.u_reading_deg if bench.by_hand else 0.0)


def spread(bench: Bench, count: int, magnitude_nT: float) -> tuple[Array, Array]:
    """Angles (count,) [deg] and fields (count, 3) [nT, C]: directions all over but the poles, angles unlike them."""
    n = np.arange(count)
    up = 0.8 * (1 - (2 * n + 1) / count)  # not along the axis, where there is no heading
    around = 2 * np.pi * GOLDEN * n
    level = np.sqrt(1 - up**2)
    directions = np.column_stack([level * np.cos(around), level * np.sin(around), up])
    return 360 * np.mod(n * GOLDEN**2 + 0.13, 1.0), magnitude_nT * directions


def _seen(bench: Bench, found: list[list[Block]], axis: str, u_mounting_deg: float) -> PositionMeans:
    platform_axis = bench.config.platform.axis_cage
    at_zero = shortest_rotation(platform_axis, AXES[axis])
    dut = [samples(blocks, "dut") for blocks in found]
    spots = [position(bench, blocks) for blocks in found]
    angle = np.array([samples(blocks, "angle", "angle_deg").mean[0] for blocks in found])
    reference = np.array([spot.reference for spot in spots])
    attitudes = np.array([rotation(AXES[axis], -np.radians(deg)) @ at_zero for deg in angle])
    field = reference[:, 0] if reference.shape[1] == 1 else reference
    positions = as_positions(bench, field, attitudes, u_mounting_deg)
    u = np.array([spot.u for spot in spots])
    names = [channel.name for channel in bench.dut.channels]
    channels = {name: np.array([samples(b, "channel", name).mean[0] for b in found]) for name in names}
    return PositionMeans(
        np.array([s.t_s.mean() for s in dut]),
        np.array([s.mean for s in dut]),
        positions,
        u,
        _u_angle_deg(bench),
        channels,
    )


def _judge(
    bench: Bench,
    when: str,
    field_nT: Array,
    seen: PositionMeans,
    axis: str,
    heading_deg: float | None = None,
    error_nT: float | None = None,
) -> Work[None]:
    rows = (("heading", _u_heading_deg(seen, axis), "deg", heading_deg), ("magnitude", seen.u_nT, "nT", error_nT))
    of_a_magnitude = seen.positions.reference_vector is None  # there is no heading in it
    for which, (name, u_noise, unit, limit) in list(enumerate(rows))[of_a_magnitude:]:
        of = partial(_errors, which, field_nT, axis)
        for what, size, allowed in (("rms", rms, limit), ("largest", largest, None)):
            u = u_of_size(seen.positions, of, size, u_noise)
            value = float(size(of(seen.positions)))
            yield from measured(bench, f"{when}: {what} {name} error", value, u, unit, allowed)


def _u_heading_deg(seen: PositionMeans, axis: str) -> Array:
    """Of each heading (n,), by noise: that of the field over its part across the axis, and the angle's own."""
    if seen.positions.reference_vector is None:
        return np.zeros(len(seen.u_nT))
    across = np.linalg.norm(np.cross(in_body(seen.positions), AXES[axis]), axis=1)
    return np.asarray(np.hypot(np.degrees(seen.u_nT / across), seen.u_angle_deg))


def _errors(which: int, field_nT: Array, axis: str, positions: Run) -> Array:
    """The heading errors (n,) [deg] (`which` 0) or the magnitude errors (n,) [nT] (1)."""
    if positions.reference_vector is None:
        return np.asarray(np.linalg.norm(field_nT, axis=1) - positions.magnitude_nT)
    return errors(field_nT, in_body(positions), np.asarray(AXES[axis]))[which]


def errors(field_nT: Array, true_nT: Array, axis: Array) -> tuple[Array, Array]:
    """Heading error (n,) [deg] about `axis`, free of the mounting's one phase, and magnitude error (n,) [nT]."""
    across = np.linalg.svd(axis[None, :])[2][1:]
    seen, true = (np.exp(1j * np.arctan2(*(b @ across.T).T[::-1])) for b in (field_nT, true_nT))
    turned = seen * np.conj(true)
    heading = np.degrees(np.angle(turned * np.conj(turned.mean())))
    return heading, np.linalg.norm(field_nT, axis=1) - np.linalg.norm(true_nT, axis=1)

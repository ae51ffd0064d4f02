"""Small steps on each coil with the DUT still, then a small turn: everything points where it is said to."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import ExitStack
from typing import Annotated, Literal

import numpy as np
from numpy.typing import NDArray

from labcal.bench.bench import Bench
from labcal.bench.mounting import AXES, SET_UP, across, attitude, plan_with_set_up, set_up
from labcal.bench.parameters import Limits
from labcal.bench.steps import (
    Procedure,
    Work,
    coils_off,
    drive,
    dut_nT,
    measured,
    record,
    turn,
)
from labcal.bench.streams.samples import samples
from labcal.errors import LimitNotMet
from labcal.geometry import unit
from labcal.record.stream import Event

NEEDS, LASTS_MIN = "the DUT on the platform, a vector reference", 1

Array = NDArray[np.float64]
NAMES = ("x", "y", "z")
STEP_S = 1.5  # of lab time for a step beside its dwell


def axes_check(
    bench: Bench,
    *,
    axis: Annotated[Literal["x", "y", "z"], "body axis mounted along the platform axis"] = "z",
    step_nT: Annotated[float, Limits(500, 50_000, unit="nT"), "step of the field on each coil"] = 5_000.0,
    dwell_s: Annotated[float, Limits(0.5, 60, unit="s"), "recorded at each step"] = 2.0,
    turn_deg: Annotated[float, Limits(5, 90, unit="deg"), "the small turn"] = 20.0,
    limit_deg: Annotated[float, Limits(1, 40, unit="deg"), "how far an axis may point beside"] = 15.0,
) -> Procedure:
    """Check sign, order and handedness of cage, reference and DUT, and the sense of the angle."""
    plan = plan_with_set_up(2 * dwell_s, [("axes-check", check_axes_s(bench, dwell_s, turn_deg))])
    with ExitStack() as afterwards:
        afterwards.callback(bench.cage.zero)  # the undo, before anything is energised
        yield plan.begin(bench, SET_UP)
        yield from set_up(bench, axis, 2 * dwell_s, f"The coils step by {step_nT / 1000:g} µT and the platform turns.")
        yield plan.begin(bench, "axes-check")
        yield from check_axes(bench, axis, step_nT, dwell_s, turn_deg, limit_deg)


def check_axes_s(bench: Bench, dwell_s: float, turn_deg: float) -> float:
    """Lab time [s] of `check_axes`: ten steps, each with its ramp, and a turn to and fro."""
    return 10 * (dwell_s + STEP_S) + 2 * turn_deg / _rate_of(bench)


def check_axes(
    bench: Bench, axis: str, step_nT: float, dwell_s: float, turn_deg: float, limit_deg: float
) -> Work[None]:
    """The steps themselves, with the DUT mounted. Raises LimitNotMet in words where something is the wrong way."""
    matrix, at_zero = bench.cage.matrix_nT_per_A, attitude(bench, axis)
    made = matrix * (step_nT / np.linalg.norm(matrix, axis=0))  # columns: the field step of each coil
    reference, dut = yield from _steps_seen(bench, step_nT / np.linalg.norm(matrix, axis=0), dwell_s)
    words: list[str] = []
    if reference is not None:
        words += yield from _compare(bench, "reference", reference @ np.linalg.inv(made), limit_deg)
    of_dut = yield from _compare(bench, "DUT", dut @ np.linalg.inv(at_zero @ made), limit_deg)
    words += another_up(bench.config.platform.axis_cage, dut @ np.linalg.inv(made), axis) or of_dut
    if not words:
        words += yield from _sense_of_angle(bench, axis, step_nT, dwell_s, turn_deg, limit_deg)
    yield from coils_off(bench)
    yield Event(bench.clock.now(), "axes", "; ".join(words) or "axes, handedness and angle are as stated")
    if words:
        what = "Mount it again where it is not mounted as asked; else look at its axes."
        raise LimitNotMet(f"axes-check: {'; '.join(words)}. {what}")


def _steps_seen(bench: Bench, step_A: Array, dwell_s: float) -> Work[tuple[Array | None, Array]]:
    """Columns: what reference (None where scalar) and DUT saw of each coil's step, up less down."""
    seen_by_reference, seen_by_dut = np.zeros((3, 3)), np.zeros((3, 3))
    vector = bench.config.reference.kind == "vector"
    for coil in range(3):
        for sign in (1, -1):
            yield from drive(bench, sign * step_A[coil] * np.eye(3)[coil], confirm_signs=False)
            blocks = yield from record(bench, dwell_s)
            seen_by_dut[:, coil] += sign * dut_nT(bench, blocks).mean / 2
            if vector:
                seen_by_reference[:, coil] += sign * samples(blocks, "reference").mean / 2
    return (seen_by_reference if vector else None), seen_by_dut


def _compare(bench: Bench, who: str, seen: Array, limit_deg: float) -> Work[list[str]]:
    """`seen` (3, 3) ought to be the unit matrix: row i is what axis i shows of the directions x, y, z."""
    directions = unit(seen)
    for name, row, wanted in zip(NAMES, directions, np.eye(3), strict=True):
        beside = float(np.degrees(np.arccos(np.clip(row @ wanted, -1, 1))))
        yield from measured(bench, f"{who} {name} axis: angle off its direction", beside, 1.0, "deg", limit_deg)
    return describe(who, seen, limit_deg)


def another_up(axis_cage: Sequence[float], body_from_cage: Array, axis: str) -> list[str]:
    """Which body axis stands along the platform's in place of `axis`; none where its axes are wrong."""
    up = unit(body_from_cage @ np.asarray(axis_cage))
    nearest = int(np.argmax(np.abs(up)))
    shown = ("−" if up[nearest] < 0 else "") + NAMES[nearest].upper()
    if np.linalg.det(body_from_cage) < 0 or shown == axis.upper():
        return []
    return [f"body {shown} is up, not {axis.upper()}"]


def describe(who: str, seen: Array, limit_deg: float) -> list[str]:
    """What is wrong with axes that show `seen` (3, 3) of the true directions, in words; nothing where all is right."""
    directions, words = unit(seen), list[str]()
    for name, row in zip(NAMES, directions, strict=True):
        nearest = int(np.argmax(np.abs(row)))
        shown = ("−" if row[nearest] < 0 else "+") + NAMES[nearest]
        if shown != f"+{name}":
            words.append(f"the {who}'s {name} axis shows {shown}")
        elif row[nearest] < np.cos(np.radians(limit_deg)):
            words.append(f"the {who}'s {name} axis points {np.degrees(np.arccos(row[nearest])):.0f}° beside")
    if np.linalg.det(directions) < 0:
        words.append(f"the {who}'s axes are left-handed")
    return words


def _sense_of_angle(
    bench: Bench, axis: str, step_nT: float, dwell_s: float, turn_deg: float, limit_deg: float
) -> Work[list[str]]:
    """Turn by +`turn_deg` in a field across the axis: in the body the field turns the other way."""
    start, rate = bench.platform.angle_deg(), _rate_of(bench)
    before = yield from _seen_across(bench, step_nT, dwell_s)
    yield from turn(bench, start + turn_deg, rate)
    after = yield from _seen_across(bench, step_nT, dwell_s)
    yield from turn(bench, start, rate)
    seen = -turned_by(AXES[axis], before, after)
    yield from measured(bench, "turn seen by the DUT, less turn made", seen - turn_deg, 1.0, "deg", limit_deg)
    if abs(seen - turn_deg) <= limit_deg:
        return []
    if abs(seen + turn_deg) <= limit_deg:
        return ["the angle runs the wrong way round: turn angle_sign in bench.toml"]
    return [f"a turn by {turn_deg:g}° is seen by the DUT as {seen:.0f}°"]


def _rate_of(bench: Bench) -> float:
    return min(bench.platform.max_rate_deg_per_s, 10.0)


def _seen_across(bench: Bench, step_nT: float, dwell_s: float) -> Work[Array]:
    """What the DUT sees of a field step across the platform axis, up less down: free of offset and ambient."""
    step_A, seen = np.linalg.solve(bench.cage.matrix_nT_per_A, step_nT * across(bench)), np.zeros(3)
    for sign in (1, -1):
        yield from drive(bench, sign * step_A, confirm_signs=False)
        blocks = yield from record(bench, dwell_s)
        seen += sign * dut_nT(bench, blocks).mean / 2
    return seen


def turned_by(axis: Sequence[float], before: Array, after: Array) -> float:
    """The right-handed angle [deg] about `axis` (3,) from `before` (3,) to `after` (3,), both seen across it."""
    u = np.asarray(axis)
    a, b = before - (before @ u) * u, after - (after @ u) * u
    return float(np.degrees(np.arctan2(u @ np.cross(a, b), a @ b)))

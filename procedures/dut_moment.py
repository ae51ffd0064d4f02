"""The DUT turned beside the reference at two distances: its own magnetic moment, permanent and induced."""

from __future__ import annotations

from contextlib import ExitStack
from dataclasses import dataclass
from typing import Annotated, Literal

import numpy as np
from numpy.typing import NDArray

from labcal.bench.bench import Bench
from labcal.bench.mounting import AXES, across, set_up
from labcal.bench.parameters import Limits
from labcal.bench.samples import Samples, samples
from labcal.bench.steps import Plan, Procedure, Work, coils_off, energise, measured, turn
from labcal.errors import InputError
from labcal.geometry import rotate, shortest_rotation, unit
from labcal.record.stream import Event, Prompt

NEEDS, LASTS_MIN = "the DUT on the platform, a vector reference that can be moved beside it", 2

Array = NDArray[np.float64]
SEPARATES = (("dut-dipole-at-reference", "field-gradient"), ("dut-dipole-at-reference", "cage-field"))
MU0_OVER_4PI = 1e-7  # T m/A


def dut_moment(
    bench: Bench,
    *,
    mountings: Annotated[tuple[Literal["x", "y", "z"], ...], "body axes up, in turn: two give all"] = ("z", "x"),
    distances_m: Annotated[tuple[float, ...], Limits(0.05, 5, unit="m"), "of the reference above it"] = (
        0.15,
        0.25,
    ),
    field_nT: Annotated[float, Limits(0, 100_000, unit="nT"), "reversed between turns: the induced part"] = 50e3,
    rate_deg_per_s: Annotated[float, Limits(0.1, 60, unit="deg/s"), "of every turn"] = 12.0,
    limit_Am2: Annotated[float, Limits(1e-6, 100, unit="A m2"), "largest moment that passes"] = 0.1,
) -> Procedure:
    """Measure the DUT's dipole from what turns with it at the reference, at two distances and in two fields."""
    if bench.config.reference.kind != "vector":
        raise InputError("dut-moment needs a vector reference")
    up = np.asarray(bench.config.platform.axis_cage)
    turns = [(axis, d, sign) for axis in mountings for d in distances_m for sign in (1, -1)]
    names = (f"{axis} up, {d:g} m, {sign * field_nT / 1000:+g} µT" for axis, d, sign in turns)
    plan = Plan(tuple((name, 360 / rate_deg_per_s + 10) for name in names))
    found: list[Seen] = []
    with ExitStack() as afterwards:
        afterwards.callback(bench.cage.zero)  # the undo, before anything is energised
        mounted = ""
        for (step, _), (axis, distance, sign) in zip(plan.steps, turns, strict=True):
            if axis != mounted:
                yield from set_up(bench, axis, 5.0, f"The field goes to ±{field_nT / 1000:g} µT and the DUT turns.")
                mounted = axis
            yield plan.begin(bench, step)
            place = distance * up
            yield from _reference_at(bench, place)
            yield from energise(bench, sign * field_nT * unit(up + across(bench)))
            blocks = yield from turn(bench, 0.0 if bench.platform.angle_deg() > 180 else 360.0, rate_deg_per_s)
            seen, angle = samples(blocks, "reference"), samples(blocks, "angle", "angle_deg")
            for name, value in moment(seen, angle, place, axis, up).items():
                found.append(Seen(name, sign, value))
        yield from coils_off(bench)
    yield from _told(bench, found, limit_Am2)


@dataclass(frozen=True, slots=True)
class Seen:
    """One component of the moment [A m²], from one turn in the field (`sign` 1) or in the reversed one (-1)."""

    component: str
    sign: int
    value_Am2: float


def _reference_at(bench: Bench, place_m: Array) -> Work[None]:
    yield from coils_off(bench)
    text = f"Put the reference {np.linalg.norm(place_m) * 1000:.0f} mm above the DUT, on the platform axis."
    yield Prompt(bench.clock.now(), "reference", text, acts=True, drawing={"reference_m": place_m.tolist()})


def _told(bench: Bench, found: list[Seen], limit_Am2: float) -> Work[None]:
    """The part that keeps its sign with the field's is permanent, the part that turns with it is induced."""
    permanent: dict[str, float] = {}
    for component in sorted({one.component for one in found}):
        plus, minus = (
            np.array([one.value_Am2 for one in found if one.component == component and one.sign == sign])
            for sign in (1, -1)
        )
        for name, values in (("permanent", (plus + minus) / 2), ("induced", (plus - minus) / 2)):
            u = float(np.ptp(values) / 2)
            yield from measured(bench, f"{name} moment {component}", values.mean(), u, "A m2", limit_Am2)
        permanent[component] = float(((plus + minus) / 2).mean())
    text = "what does not turn with it is not seen: of the induced moment, the part that follows the field"
    yield Event(bench.clock.now(), "dut-moment", text, {"permanent_Am2": permanent})


def moment(seen: Samples, angle: Samples, place_m: Array, axis: str, up: Array) -> dict[str, float]:
    """The two components [A m²] of the moment across the body axis `axis` mounted along `up` (3,), by body axis.

    B = µ0 / 4π (3 (m·r̂) r̂ − m) / r³ (Jackson, Classical Electrodynamics, 3rd ed., eq. 5.56), linear in m: least
    squares with a constant field beside it.
    """
    inside = seen.between(angle.t_s[0], angle.t_s[-1])
    theta, at_zero = np.radians(angle.at(inside.t_s)[:, 0]), shortest_rotation(up, AXES[axis])
    names = [name for name in AXES if name != axis]
    columns = [_dipole(rotate(up, theta, at_zero.T @ np.asarray(AXES[name])), place_m).ravel() for name in names]
    steady = np.tile(np.eye(3), (len(theta), 1))
    solution = np.linalg.lstsq(np.column_stack([*columns, steady]), inside.values.ravel(), rcond=None)[0]
    return dict(zip(names, solution[:2].tolist(), strict=True))


def _dipole(m: Array, place_m: Array) -> Array:
    """Field (n, 3) [nT] at `place_m` of moments `m` (n, 3) [A m²] at the origin."""
    r = float(np.linalg.norm(place_m))
    along = place_m / r
    return np.asarray(1e9 * MU0_OVER_4PI * (3 * np.outer(m @ along, along) - m) / r**3)

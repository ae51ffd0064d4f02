"""The field over the working volume: computed from the coils' geometry, and probed where one can reach."""

from __future__ import annotations

from contextlib import ExitStack
from importlib import import_module
from typing import Annotated, Any

import numpy as np
from numpy.typing import NDArray

from labcal.bench.bench import Bench
from labcal.bench.parameters import Limits
from labcal.bench.steps import Plan, Procedure, Work, coils_off, drive, measured, ready, record
from labcal.bench.streams.samples import samples
from labcal.errors import InputError
from labcal.record.stream import Event, Prompt

NEEDS, LASTS_MIN = "a vector reference that can be moved, the coils' geometry in bench.toml", 3

Array = NDArray[np.float64]
SEPARATES = (("field-gradient", "cage-field"), ("field-gradient", "axis-tilt"))
SPACING = 0.5445  # of a square Helmholtz pair, in sides
STEP_S = 2.7  # of lab time for a point and sign beside its dwell


def cage_map(
    bench: Bench,
    *,
    side_m: Annotated[float, Limits(0.1, 20, unit="m"), "side of the square coils"] = 1.5,
    spacing: Annotated[float, Limits(0.1, 2), "distance of a pair, in sides"] = SPACING,
    radius_m: Annotated[float, Limits(0.01, 5, unit="m"), "of the working volume"] = 0.15,
    probes: Annotated[int, Limits(0, 50), "points probed with the reference on each axis"] = 2,
    field_nT: Annotated[float, Limits(1_000, 100_000, unit="nT"), "of each coil while probed"] = 40_000.0,
    dwell_s: Annotated[float, Limits(0.5, 60, unit="s"), "recorded at each point and sign"] = 2.0,
    homogeneity_ppm: Annotated[float, Limits(1, 1e6, unit="ppm"), "largest departure that passes"] = 5_000.0,
    model_ppm: Annotated[float, Limits(1, 1e6, unit="ppm"), "probe against computed that passes"] = 2_000.0,
) -> Procedure:
    """Map the field of each coil over the working volume, computed and probed."""
    if bench.config.reference.kind != "vector":
        raise InputError("cage-map needs a vector reference")
    computed = [departures(axis, side_m, spacing, _points(radius_m, 4)) for axis in range(3)]
    worst = float(1e6 * max(np.abs(c).max() for c in computed))
    yield from measured(bench, "computed departure in the volume", worst, 0.0, "ppm", homogeneity_ppm)
    points = _points(radius_m, probes) if probes else np.zeros((0, 3))
    if not len(points):
        return
    steps = tuple((f"point {n}", 6 * (dwell_s + STEP_S)) for n in range(len(points) + 1))
    plan = Plan(steps, frozenset(name for name, _ in steps))
    with ExitStack() as afterwards:
        afterwards.callback(bench.cage.zero)  # the undo, before anything is energised
        yield plan.begin(bench, "point 0")
        centre, u_nT = yield from _probed(bench, np.zeros(3), field_nT, dwell_s)
        seen: list[list[float]] = []
        for number, point in enumerate(points, 1):
            yield plan.begin(bench, f"point {number}")
            here, u = yield from _probed(bench, point, field_nT, dwell_s)
            u_nT = max(u_nT, u)
            seen.append([float(np.linalg.norm(h) / np.linalg.norm(c) - 1) for h, c in zip(here, centre, strict=True)])
        yield from coils_off(bench)
    expected = np.column_stack([departures(axis, side_m, spacing, points) for axis in range(3)])
    off = float(1e6 * np.abs(np.array(seen) - expected).max())
    yield from measured(bench, "probe less computed", off, 1e6 * np.sqrt(2) * u_nT / field_nT, "ppm", model_ppm)
    data = {"points_m": points.tolist(), "probed": seen, "computed": expected.tolist()}
    yield Event(bench.clock.now(), "cage-map", "departure from the centre, each coil", data)


def departures(axis: int, side_m: float, spacing: float, points_m: Array) -> Array:
    """|B| at `points_m` (n, 3) over |B| at the centre, less one (n,), of a square pair about `axis` (magpylib)."""
    magpylib: Any = import_module("magpylib")  # slow to import, and without types
    square = 0.5 * side_m * np.array([[1, 1, 0], [-1, 1, 0], [-1, -1, 0], [1, -1, 0], [1, 1, 0]], dtype=float)
    total = np.zeros((len(points_m) + 1, 3))
    for place in (-spacing / 2, spacing / 2):
        loop = np.roll(square + [0, 0, place * side_m], axis + 1, axis=1)
        wire = magpylib.current.Polyline(current=1.0, vertices=loop)
        total += np.asarray(wire.getB(np.vstack([points_m, np.zeros(3)])))
    size = np.linalg.norm(total, axis=1)
    return np.asarray(size[:-1] / size[-1] - 1)


def _points(radius_m: float, count: int) -> Array:
    """`count` points on each of the three axes, from −radius to +radius, without the centre: (3 count, 3)."""
    steps = np.linspace(-radius_m, radius_m, count)
    return np.vstack([np.outer(steps[steps != 0], direction) for direction in np.eye(3)])


def _probed(bench: Bench, point: Array, field_nT: float, dwell_s: float) -> Work[tuple[Array, float]]:
    """Field per coil (3, 3) [nT], rows the coils, at one point: half the difference of both signs, free of ambient.

    And the largest standard uncertainty of a component by noise.
    """
    yield from coils_off(bench)
    x, y, z = np.round(1000 * point) + 0.0  # no −0
    text = f"Put the reference at {x:.0f}, {y:.0f}, {z:.0f} mm from the DUT's place, in C, turned as it always stands."
    yield Prompt(bench.clock.now(), "probe", text, acts=True, drawing={"reference_m": point.tolist()})
    yield from ready(bench, f"Each coil goes to ±{field_nT / 1000:g} µT. Hands off?")
    seen, u = np.zeros((3, 3)), 0.0
    for coil in range(3):
        current = field_nT / float(np.linalg.norm(bench.cage.matrix_nT_per_A[:, coil]))
        flows = 0.0
        for sign in (1, -1):
            yield from drive(bench, sign * current * np.eye(3)[coil])
            blocks = yield from record(bench, dwell_s)
            reading = samples(blocks, "reference")
            seen[coil] += sign * reading.mean / 2
            u = max(u, float(reading.u_mean.max()) / np.sqrt(2))
            flows += sign * float(bench.cage.currents_A()[coil]) / 2
        seen[coil] *= current / flows
    return seen, u

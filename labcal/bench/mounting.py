"""How the DUT is mounted on the platform, and fields stated relative to the platform's axis."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from labcal.bench.bench import Bench
from labcal.bench.steps import Plan, Work, measure_ambient, mount, ready, switch_mode
from labcal.geometry import rotate, shortest_rotation, unit
from labcal.record.vector import Vector

Array = NDArray[np.float64]
AXES: dict[str, Vector] = {"x": (1.0, 0.0, 0.0), "y": (0.0, 1.0, 0.0), "z": (0.0, 0.0, 1.0)}
SET_UP, MOVES_S = "mounting and zero", 3.0  # the step that `set_up` is, and its lab time beside the zero
MARK = {"x": "body Y towards the cage's Y", "y": "body X towards the cage's X", "z": "body X towards the cage's X"}


def attitude(bench: Bench, axis: str) -> Array:
    """`body_from_cage` (3, 3) at angle 0 with the body axis "x", "y" or "z" along the platform axis.

    The shortest turn that carries the platform axis onto the body axis: the same as `record.carry` assumes.
    """
    return shortest_rotation(bench.config.platform.axis_cage, AXES[axis])


def how_to_mount(axis: str) -> str:
    """What the technician reads."""
    return f"Mount the DUT with body {axis.upper()} up along the platform axis, {MARK[axis]}, at platform angle 0."


def across(bench: Bench) -> Array:
    """A unit vector (3,) in C across the platform axis, as near to the cage's x (else y) as it goes."""
    axis = np.asarray(bench.config.platform.axis_cage)
    start = np.eye(3)[int(abs(axis[0]) > 0.9)]
    return unit(start - (start @ axis) * axis)


def inclined_field(bench: Bench, magnitude_nT: float, inclination_deg: float, azimuth_deg: float = 0.0) -> Array:
    """A field (3,) [nT, C] inclined to the platform axis; a negative magnitude reverses it."""
    axis = np.asarray(bench.config.platform.axis_cage)
    tilt = np.radians(inclination_deg)
    sideways = rotate(axis, np.radians([azimuth_deg]), across(bench))[0]
    return np.asarray(magnitude_nT * (np.cos(tilt) * axis + np.sin(tilt) * sideways))


def plan_with_set_up(zero_s: float, steps: Sequence[tuple[str, float]], asks: frozenset[str] = frozenset()) -> Plan:
    """The plan of a procedure that begins with `set_up`, which is its first step."""
    return Plan(((SET_UP, zero_s + MOVES_S), *steps), asks)


def set_up(bench: Bench, axis: str, zero_s: float, question: str, mode: str | None = None) -> Work[None]:
    """How most procedures begin: mount, the DUT's power mode, hands off, the ambient field with the coils off."""
    yield from mount(bench, f"mount-{axis}", attitude(bench, axis), how_to_mount(axis))
    if mode is not None:
        yield from switch_mode(bench, mode)
    yield from ready(bench, f"{question} Hands off?")
    yield from measure_ambient(bench, zero_s)

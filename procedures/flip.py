"""The DUT turned by 180° about two of its axes in a steady field: its offset, whatever the reference's zero is."""

from __future__ import annotations

from contextlib import ExitStack
from typing import Annotated

import numpy as np
from numpy.typing import NDArray

from labcal.bench.bench import Bench
from labcal.bench.mounting import attitude
from labcal.bench.parameters import Limits
from labcal.bench.steps import Plan, Procedure, dut_nT, measured, mount, record
from labcal.bench.streams.samples import Samples
from labcal.geometry import rotation
from labcal.record.stream import Event

NEEDS, LASTS_MIN = "the DUT free to be turned over by hand", 1

Array = NDArray[np.float64]
TURNS = {"as it stands": np.eye(3)} | {
    f"turned by 180° about its {name}": rotation(axis, np.pi) for name, axis in zip("xyz", np.eye(3), strict=True)
}


def flip(
    bench: Bench,
    *,
    dwell_s: Annotated[float, Limits(1, 600, unit="s"), "recorded in each attitude"] = 10.0,
    u_mounting_deg: Annotated[float, Limits(0.01, 10, unit="deg"), "how well an attitude is met"] = 0.5,
) -> Procedure:
    """Measure the DUT's offset from four attitudes in the ambient field, coils off.

    The four attitudes add up to nothing, I + Rx + Ry + Rz = 0, so the mean of the readings is the offset.
    """
    plan = Plan(tuple((name, dwell_s + 0.5) for name in TURNS), frozenset(TURNS))
    seen: list[Samples] = []
    with ExitStack() as afterwards:
        afterwards.callback(bench.cage.zero)
        for number, (name, turned) in enumerate(TURNS.items()):
            yield plan.begin(bench, name)
            text = f"Mount the DUT with body Z up, body X towards the cage's X; then {name}."
            yield from mount(bench, f"flip-{number}", turned @ attitude(bench, "z"), text)
            blocks = yield from record(bench, dwell_s)
            seen.append(dut_nT(bench, blocks))
    readings = np.array([one.mean for one in seen])
    offset = np.mean(readings, axis=0)
    spread = float(np.max(np.linalg.norm(readings - offset, axis=1)))
    noise = float(np.linalg.norm([one.u_mean.max() for one in seen])) / len(seen)
    u = float(np.hypot(noise, spread * np.radians(u_mounting_deg) / 2))
    for name, value in zip("xyz", offset, strict=True):
        yield from measured(bench, f"offset {name}", value, u, "nT")
    yield Event(bench.clock.now(), "flip", "offset from four attitudes", {"offset_nT": offset.tolist()})

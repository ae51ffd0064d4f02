"""The DUT turned beside the reference at two distances, in a field and its reverse: its own magnetic moment."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import ExitStack
from dataclasses import dataclass
from typing import Annotated, Literal

import numpy as np
from numpy.typing import NDArray

from labcal.bench.bench import Bench
from labcal.bench.mounting import AXES, across, attitude, how_to_mount
from labcal.bench.parameters import Limits
from labcal.bench.rotation import Rotation, refuse_too_fast
from labcal.bench.stated import as_positions
from labcal.bench.steps import (
    Plan,
    Procedure,
    Work,
    coils_off,
    energise,
    measure_ambient,
    measured,
    mount,
    note,
    ready,
    record,
    recorded,
    switch_mode,
    turn,
)
from labcal.bench.streams.samples import samples
from labcal.errors import InputError
from labcal.fit.dipole import PAIRS, DipoleFit, Dwell, fit_dipole
from labcal.geometry import rotation, unit
from labcal.record.stream import Event, Prompt
from labcal.uncertainty.verdicts import uncovered

NEEDS, LASTS_MIN = "the DUT on a platform with a motor, a vector reference that can be moved beside it", 9

Array = NDArray[np.float64]
SEPARATES = (("dut-dipole-at-reference", "field-gradient"), ("dut-dipole-at-reference", "cage-field"))
AWAY, ZERO_S = "away", 5.0
AS_IT_STANDS_M = 0.005  # so near to where bench.toml has it, the reference is at its working place
AT_REST = (1, -1, 1, -1, 1, -1)  # signs of the field: a drift of the place does not follow them
TURNING = (1, -1, -1, 1)  # there, back, there, back: a late angle is no induced moment


def dut_moment(
    bench: Bench,
    *,
    mountings: Annotated[tuple[Literal["x", "y", "z"], ...], "body axes up, in turn: at least two"] = ("z", "x"),
    distances_m: Annotated[tuple[float, ...], Limits(0.05, 5, unit="m"), "of the reference above it: at least two"] = (
        0.15,
        0.25,
    ),
    u_place_m: Annotated[float, Limits(0, 0.1, unit="m"), "uncertainty of each coordinate of its place"] = 0.001,
    field_nT: Annotated[float, Limits(1_000, 100_000, unit="nT"), "reversed between turns: the induced part"] = 50e3,
    rate_deg_per_s: Annotated[float, Limits(0.1, 60, unit="deg/s"), "of every turn"] = 12.0,
    rest_s: Annotated[float, Limits(2, 600, unit="s"), "in each field at rest, with the DUT and without"] = 5.0,
    mode: Annotated[str, "the DUT's power mode"] = "nominal",
    limit_Am2: Annotated[float, Limits(1e-6, 100, unit="A m2"), "largest moment that passes"] = 0.1,
) -> Procedure:
    """Measure the DUT's permanent and induced dipole from what the reference sees of it at two distances."""
    _refuse(bench, mountings, distances_m, rate_deg_per_s)
    up = np.asarray(bench.config.platform.axis_cage)
    field = field_nT * unit(up + across(bench))
    stands = [Stand(k, d * up, m) for k, d in enumerate(distances_m) for m in (AWAY, *mountings)]
    rests, turns = len(AT_REST) * (rest_s + 2), len(TURNING) * (360 / rate_deg_per_s + 4) + 12
    steps = tuple((stand.name, rests + (stand.mounting != AWAY) * turns) for stand in stands)
    plan = Plan(steps, frozenset(name for name, _ in steps))
    looks: list[Dwell] = []
    with ExitStack() as afterwards:
        afterwards.callback(bench.cage.zero)  # the undo, before anything is energised
        for stand in stands:
            yield plan.begin(bench, stand.name)
            if stand.mounting == AWAY:
                yield from _reference_at(bench, stand.place_m)
            yield from _prepared(bench, stand, mode, ask=None if looks else field_nT)
            looks += yield from _at_rest(bench, stand, field, rest_s, session=len(looks))
            for number, sign in enumerate(TURNING if stand.mounting != AWAY else ()):
                looks += yield from _turned(bench, stand, sign * field, number, rate_deg_per_s, mode, len(looks))
        yield from coils_off(bench)
    if left := uncovered(as_positions(bench, field[None]), ["the reference's turn against the cage"]):
        yield note(bench, left)
    found = fit_dipole(looks, np.outer(distances_m, up), u_place_m)
    yield from _report(bench, found.with_scale(1e-6 * (bench.reference_stated.u_scale_ppm or 0.0)), field_nT, limit_Am2)


@dataclass(frozen=True, slots=True)
class Stand:
    """Where the reference stands, by number and as a place (3,) [m, C], and how the DUT is mounted, if it is."""

    place: int
    place_m: Array
    mounting: str  # a body axis, or AWAY

    @property
    def name(self) -> str:
        """What its step is called."""
        how = "DUT away" if self.mounting == AWAY else f"{self.mounting} up"
        return f"{np.linalg.norm(self.place_m):g} m, {how}"


def _refuse(bench: Bench, mountings: Sequence[str], distances_m: Sequence[float], rate_deg_per_s: float) -> None:
    if bench.config.reference.kind != "vector":
        raise InputError("dut-moment needs a vector reference")
    if not bench.platform.motorised:
        raise InputError("dut-moment needs a platform with a motor")
    for name, given in (("mountings", mountings), ("distances_m", distances_m)):
        if len(given) < 2 or len(set(given)) < len(given):
            raise InputError(f"{name} must be at least two, and different")
    refuse_too_fast(bench, rate_deg_per_s)


def _reference_at(bench: Bench, place_m: Array) -> Work[None]:
    yield from coils_off(bench)
    text = f"Put the reference {np.linalg.norm(place_m) * 1000:.0f} mm above the DUT's place, on the platform axis."
    yield Prompt(bench.clock.now(), "reference", text, acts=True, drawing={"reference_m": place_m.tolist()})


def _prepared(bench: Bench, stand: Stand, mode: str, ask: float | None) -> Work[None]:
    """The DUT taken away or mounted; at the first time (`ask` the field) with the ambient field and a question."""
    if stand.mounting != AWAY:
        yield from mount(
            bench, f"mount-{stand.mounting}", attitude(bench, stand.mounting), how_to_mount(stand.mounting)
        )
        yield from switch_mode(bench, mode)
        return
    yield from coils_off(bench)
    text = "Take the DUT off the platform, some metres away. Leave the reference and all else as it is."
    yield Prompt(bench.clock.now(), "dut-away", text, acts=True, drawing={"dut_away": True})
    if ask is not None:
        yield from measure_ambient(bench, ZERO_S)
        yield from ready(bench, f"The field goes to ±{ask / 1000:g} µT, later with the DUT turning in it. Hands off?")


def _at_rest(bench: Bench, stand: Stand, field_nT: Array, rest_s: float, session: int) -> Work[list[Dwell]]:
    """The field to and fro while nothing moves: with the DUT and without, the difference is its own."""
    looks: list[Dwell] = []
    still = None if stand.mounting == AWAY else attitude(bench, stand.mounting).T
    for sign in AT_REST:
        yield from energise(bench, sign * field_nT)
        seen = samples((yield from record(bench, rest_s)), "reference")
        turned = None if still is None else np.tile(still, (len(seen), 1, 1))
        looks.append(Dwell(session, stand.place, seen.t_s, seen.values, sign * field_nT, turned))
    return looks


def _turned(
    bench: Bench, stand: Stand, field_nT: Array, number: int, rate_deg_per_s: float, mode: str, session: int
) -> Work[list[Dwell]]:
    """A turn: with a steady field of its own beside it, only what turns is taken from it.

    It is a segment of the record where the reference stands as bench.toml says, and nowhere else.
    """
    yield from energise(bench, field_nT)
    work, working = turn(bench, 0.0 if number % 2 else 360.0, rate_deg_per_s), bench.config.reference.position_m
    if working is not None and np.linalg.norm(stand.place_m - working) < AS_IT_STANDS_M:
        name, axis = f"{stand.mounting}-{number + 1}", stand.mounting
        work = recorded(bench, Rotation(name, AXES[axis], mode, rate_deg_per_s, mounting=axis).segment(bench), work)
    blocks = yield from work
    angle, seen = samples(blocks, "angle", "angle_deg"), samples(blocks, "reference")
    seen = seen.between(angle.t_s[0], angle.t_s[-1])
    turned = rotation(bench.config.platform.axis_cage, np.radians(angle.at(seen.t_s)[:, 0]))
    cage_from_body = turned @ attitude(bench, stand.mounting).T
    return [Dwell(session, stand.place, seen.t_s, seen.values, field_nT, cage_from_body)]


def _report(bench: Bench, found: DipoleFit, field_nT: float, limit_Am2: float) -> Work[None]:
    per_T = 1e9 * limit_Am2 / field_nT
    for axis, value, u in zip("xyz", found.permanent_Am2, found.u[:3], strict=True):
        yield from measured(bench, f"permanent moment {axis}", value, u, "A m2", limit_Am2)
    for (i, j), u in zip(PAIRS, found.u[3:], strict=True):
        name, value = f"induced moment {'xyz'[i]}{'xyz'[j]}", found.induced_Am2_per_T[i, j]
        yield from measured(bench, name, value, u, "A m2/T", per_T)
    largest = found.largest_induced_Am2(field_nT)
    yield from measured(bench, f"largest induced moment in {field_nT / 1000:g} µT", *largest, "A m2", limit_Am2)
    data = {
        "permanent_Am2": found.permanent_Am2.tolist(),
        "induced_Am2_per_T": found.induced_Am2_per_T.tolist(),
        "covariance": found.covariance.tolist(),
        "order": ["p_x", "p_y", "p_z", *(f"X_{'xyz'[i]}{'xyz'[j]}" for i, j in PAIRS)],
    }
    yield Event(bench.clock.now(), "dut-moment", "moment m = p + X b of the DUT, in its body axes", data)

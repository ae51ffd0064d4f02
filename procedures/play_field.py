"""A history of the field played to the DUT: from a table, along an orbit in the IGRF, or as a simulator sends it."""

from __future__ import annotations

import csv
from contextlib import ExitStack
from datetime import UTC, datetime, timedelta
from pathlib import Path
from typing import Annotated, Literal

import numpy as np
from numpy.typing import NDArray

from labcal.bench.bench import Bench
from labcal.bench.parameters import Limits
from labcal.bench.steps import (
    Blocks,
    Plan,
    Procedure,
    Work,
    coils_off,
    energise,
    measure_ambient,
    ready,
    record,
    recorded,
)
from labcal.bench.streams.samples import samples
from labcal.errors import InputError
from labcal.record.physical import LARGEST_FIELD_nT
from labcal.record.run import Segment
from procedures.from_outside import AMBIENT, follow
from procedures.tracking_error import rms_error

NEEDS, LASTS_MIN = "the DUT at rest in the cage; a table of the field, an orbit, or a simulator", 10

Array = NDArray[np.float64]
EARTH_KM, MU_KM3_S2, DAY_S = 6371.2, 398_600.4418, 86_164.1


def play_field(
    bench: Bench,
    *,
    file: Annotated[Path | None, "CSV t_s,b_x,b_y,b_z [s, nT in C]; none: the orbit below"] = None,
    source: Annotated[str | None, "udp://HOST:PORT: as a simulator sends it (docs/field-source.md)"] = None,
    altitude_km: Annotated[float, Limits(150, 40_000, unit="km"), "of the circular orbit"] = 500.0,
    inclination_deg: Annotated[float, Limits(0, 180, unit="deg"), "of the orbit"] = 97.4,
    epoch: Annotated[str, "start, ISO 8601 UTC"] = "2026-01-01T00:00:00",
    attitude: Annotated[Literal["inertial", "nadir"], "how the satellite is held"] = "nadir",
    duration_s: Annotated[float, Limits(10, 86_400, unit="s"), "of orbit time, at most of a source"] = 600.0,
    step_s: Annotated[float, Limits(0.5, 600, unit="s"), "between two set-points"] = 10.0,
    speed: Annotated[float, Limits(0.1, 100), "orbit seconds played in one second"] = 1.0,
    silent_s: Annotated[float, Limits(0.1, 10, unit="s"), "that the source may be silent"] = 1.0,
    max_age_s: Annotated[float, Limits(0.01, 10, unit="s"), "of a field from the source, beside its quickest"] = 0.5,
    limit_nT: Annotated[float, Limits(0.1, 1e5, unit="nT"), "rms tracking error that passes"] = 100.0,
) -> Procedure:
    """Play a field history, with the tracking error recorded."""
    if bench.config.reference.kind != "vector":
        raise InputError("play-field needs a vector reference")
    if source is not None and file is not None:
        raise InputError("play-field takes a file or a source, not both")
    if source is not None:
        yield from follow(bench, source, duration_s, silent_s, max_age_s, limit_nT)
        return
    t, b = read_history(file) if file else orbit_field(
        np.arange(0.0, duration_s, step_s), altitude_km, inclination_deg, _utc(epoch), attitude
    )  # fmt: skip
    holds = np.diff(t, append=2 * t[-1] - t[-2]) / speed
    plan = Plan((AMBIENT, ("play", float(holds.sum()))), frozenset({"play"}))
    strongest = float(np.linalg.norm(b, axis=1).max())
    with ExitStack() as afterwards:
        afterwards.callback(bench.cage.zero)  # the undo, before anything is energised
        yield plan.begin(bench, AMBIENT[0])
        yield from measure_ambient(bench, AMBIENT[1])
        yield plan.begin(bench, "play")
        yield from ready(bench, f"Fields up to {strongest / 1000:.1f} µT are played. Hands off?")
        errors = yield from recorded(bench, Segment("play", "free"), _played(bench, b, holds))
        yield from coils_off(bench)
    yield from rms_error(bench, "rms tracking error", errors + b, b, limit_nT)


def _played(bench: Bench, b_nT: Array, holds_s: Array) -> Work[Array]:
    """Set every field at its time; returns the reference's mean less what was wanted (n, 3) [nT]."""
    errors: list[Array] = []
    due = bench.clock.now()
    for wanted, hold in zip(b_nT, holds_s, strict=True):
        due += float(hold)
        yield from energise(bench, wanted)
        blocks: Blocks = yield from record(bench, max(due - bench.clock.now(), 0.2))
        errors.append(samples(blocks, "reference").mean - wanted)
    return np.array(errors)


def read_history(path: Path) -> tuple[Array, Array]:
    """Times (n,) [s] and fields (n, 3) [nT, C] of a CSV file. Raises InputError with line and column."""
    columns = ("t_s", "b_x", "b_y", "b_z")
    if not path.is_file():
        raise InputError("is no regular file" if path.exists() else "there is no such file", file=path)
    with path.open(newline="", encoding="utf-8") as lines:
        rows = csv.DictReader(lines)
        for name in columns:
            if name not in (rows.fieldnames or ()):
                raise InputError("this column is missing", file=path, line=1, column=name)
        table = np.array([[_number(row[c], path, n, c) for c in columns] for n, row in enumerate(rows, 2)])
    if len(table) < 2:
        raise InputError("two rows at least are needed", file=path)
    backwards = np.flatnonzero(np.diff(table[:, 0]) <= 0)
    if len(backwards):
        raise InputError("time does not go on", file=path, line=int(backwards[0]) + 3, column="t_s")
    return table[:, 0], table[:, 1:]


def _number(text: str | None, path: Path, line: int, column: str) -> float:
    try:
        value = float(text or "")
    except ValueError:
        value = np.nan
    if not np.isfinite(value):
        raise InputError(f"{(text or '')[:40]!r} is no finite number", file=path, line=line, column=column)
    if abs(value) > LARGEST_FIELD_nT:
        raise InputError(f"{value:g} is beyond {LARGEST_FIELD_nT:g}", file=path, line=line, column=column)
    return value


def _utc(text: str) -> datetime:
    try:
        stated = datetime.fromisoformat(text)
    except ValueError:
        raise InputError(f"epoch = {text!r}: expected ISO 8601, as 2026-01-01T00:00:00") from None
    return stated if stated.tzinfo else stated.replace(tzinfo=UTC)


def orbit_field(
    t_s: Array, altitude_km: float, inclination_deg: float, epoch: datetime, attitude: str
) -> tuple[Array, Array]:
    """Times (n,) [s] and the IGRF (n, 3) [nT] on a circular orbit, from its ascending node over Greenwich.

    "inertial": x to the node, z to the north pole. "nadir": z down, y against the orbit's normal, x ahead.
    """
    where, ahead = _circular(t_s, altitude_km, inclination_deg)
    inertial = _igrf_inertial(t_s, where, epoch)
    if attitude == "inertial":
        return t_s, inertial
    down = -where / np.linalg.norm(where, axis=1, keepdims=True)
    axes = np.stack([ahead, np.cross(down, ahead), down], axis=1)
    return t_s, np.einsum("nij,nj->ni", axes, inertial)


def _circular(t_s: Array, altitude_km: float, inclination_deg: float) -> tuple[Array, Array]:
    """Place (n, 3) [km] and direction of flight (n, 3), both inertial."""
    radius, tilt = EARTH_KM + altitude_km, np.radians(inclination_deg)
    u = np.sqrt(MU_KM3_S2 / radius**3) * t_s
    node, up = np.array([1.0, 0.0, 0.0]), np.array([0.0, np.cos(tilt), np.sin(tilt)])
    where = radius * (np.outer(np.cos(u), node) + np.outer(np.sin(u), up))
    return where, np.outer(-np.sin(u), node) + np.outer(np.cos(u), up)


def _igrf_inertial(t_s: Array, where_km: Array, epoch: datetime) -> Array:
    """IGRF (n, 3) [nT] at inertial places (n, 3), with Greenwich along x at `epoch`."""
    import ppigrf

    radius = np.linalg.norm(where_km, axis=1)
    colatitude = np.arccos(where_km[:, 2] / radius)
    ascension = np.arctan2(where_km[:, 1], where_km[:, 0])
    longitude = ascension - 2 * np.pi * t_s / DAY_S
    middle = (epoch + timedelta(seconds=float(t_s.mean()))).replace(tzinfo=None)
    b_r, b_south, b_east = (
        np.asarray(b).ravel() for b in ppigrf.igrf_gc(radius, np.degrees(colatitude), np.degrees(longitude), middle)
    )
    out = where_km / radius[:, None]
    east = np.column_stack([-np.sin(ascension), np.cos(ascension), np.zeros_like(ascension)])
    south = np.cross(east, out)
    return np.asarray(b_r[:, None] * out + b_south[:, None] * south + b_east[:, None] * east)

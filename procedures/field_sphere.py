"""The field turned instead of the sensor: directions all over at several magnitudes, with the DUT at rest."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import ExitStack
from dataclasses import dataclass
from typing import Annotated, Literal

import numpy as np
from numpy.typing import NDArray

from labcal.bench.bench import Bench
from labcal.bench.mounting import SET_UP, attitude, plan_with_set_up, set_up
from labcal.bench.parameters import Limits
from labcal.bench.position import position
from labcal.bench.stated import as_positions
from labcal.bench.steps import (
    Blocks,
    Procedure,
    Work,
    coils_off,
    energise,
    measured,
    note,
    record,
    rest,
)
from labcal.bench.streams.samples import samples
from labcal.errors import InputError
from labcal.fit.field_sphere import SphereFit, fit_sphere
from labcal.fit.harmonics import Shell, shells
from labcal.model.affine import MAP_PARAMETERS
from labcal.record import Run
from labcal.record.stream import Event
from labcal.uncertainty import declared_errors
from labcal.uncertainty.verdicts import u_of_size, uncovered
from procedures.tracking_error import of_length

NEEDS, LASTS_MIN = "the DUT at rest in the cage; a vector reference at its place, or an approved cage calibration", 12

Array = NDArray[np.float64]
SEPARATES = (
    ("nonlinearity", "cross-field"),
    ("offset-temperature", "gain-temperature"),
    ("offset-current", "cross-field"),
)
GOLDEN = (np.sqrt(5) - 1) / 2
ZERO_EVERY = 12  # fields
STEP_S = 2.6  # of lab time for a field beside its dwell: ramp, signs, margins
UNSEEN_TURN = 2.0  # rad, of the lattice that no fit sees


@dataclass(frozen=True, slots=True, eq=False)
class Visits:
    """Means of every visit: `reading` and `field_nT` (n, 3) [nominal nT in B; nT in C], `u_nT` of their difference."""

    t_s: Array
    reading: Array
    field_nT: Array
    u_nT: float


def field_sphere(
    bench: Bench,
    *,
    n_directions: Annotated[int, Limits(8, 500), "of the field, all over the sphere"] = 48,
    magnitudes_nT: Annotated[tuple[float, ...], Limits(1_000, 100_000, unit="nT"), "of the field, each in all"] = (
        20_000.0,
        35_000.0,
        50_000.0,
    ),
    dwell_s: Annotated[float, Limits(0.5, 60, unit="s"), "recorded in each field"] = 1.7,
    verify: Annotated[int, Limits(0, 200), "fields that no fit sees, at the end"] = 8,
    axis: Annotated[Literal["x", "y", "z"], "body axis along the platform axis"] = "z",
    mode: Annotated[str, "the DUT's power mode"] = "nominal",
    error_nT: Annotated[float, Limits(0.1, 1e5, unit="nT"), "rms error at those fields that passes"] = 50.0,
    drift_nT: Annotated[float, Limits(0.1, 1e5, unit="nT"), "change of the zero through the run that passes"] = 100.0,
) -> Procedure:
    """Calibrate the DUT at rest: the coils play directions all over; K and k in the cage's frame."""
    _refuse(bench, magnitudes_nT)
    fields, unseen = played(n_directions, magnitudes_nT), unseen_fields(verify, magnitudes_nT)
    each_s = dwell_s + STEP_S
    steps = (("sphere", len(fields) * each_s), *((("verify", verify * each_s),) if verify else ()))
    plan = plan_with_set_up(5.0, steps)
    with ExitStack() as afterwards:
        afterwards.callback(bench.cage.zero)  # the undo, before anything is energised
        yield plan.begin(bench, SET_UP)
        yield from set_up(
            bench, axis, 5.0, f"The field goes to {max(magnitudes_nT) / 1000:g} µT in all directions.", mode
        )
        yield note(bench, _where_from(bench))
        yield plan.begin(bench, "sphere")
        seen = yield from _visited(bench, fields, dwell_s, attitude(bench, axis), mode)
        fit = _fitted(bench, seen)
        if left := uncovered(as_positions(bench, seen.field_nT), ["the DUT's mounting"]):
            yield note(bench, left)
        found = shells(seen.field_nT, fit.residual_nT)
        yield from _report(bench, fit, seen, found, drift_nT)
        if verify:
            yield plan.begin(bench, "verify")
            yield from _verified(bench, fit, seen, (yield from _unseen(bench, unseen, dwell_s)), error_nT)
        yield from coils_off(bench)


def played(n_directions: int, magnitudes_nT: Sequence[float]) -> Array:
    """The fields (n, 3) [nT, C] in their order: every direction at every magnitude, visits to zero among them.

    The directions are a Fibonacci lattice, taken by the stride next to its golden part, so that some neighbours in time
    go all round the sphere; the magnitude changes from field to field, and every other round goes backwards: what
    drifts through the run looks like no field.
    """
    directions, order = lattice(n_directions), strided(n_directions)
    fields = list[Array]()
    for turn in range(len(magnitudes_nT)):
        for k in reversed(order) if turn % 2 else order:
            if len(fields) % (ZERO_EVERY + 1) == 0:
                fields.append(np.zeros(3))
            fields.append(magnitudes_nT[(k + turn) % len(magnitudes_nT)] * directions[k])
    return np.array([*fields, np.zeros(3)])


def unseen_fields(count: int, magnitudes_nT: Sequence[float]) -> Array:
    """Fields (count, 3) of another lattice, turned away from the first, of magnitudes between the same ends."""
    size = np.linspace(min(magnitudes_nT), max(magnitudes_nT), count)
    shuffled = size[np.argsort((np.arange(count) * GOLDEN) % 1)]
    return np.asarray(shuffled[:, None] * lattice(count, UNSEEN_TURN))


def lattice(count: int, turned_rad: float = 0.0) -> Array:
    """Unit vectors (count, 3) spread evenly: equal steps of z, the golden angle about it (a Fibonacci lattice)."""
    n = np.arange(count)
    up, around = 1 - (2 * n + 1) / max(count, 1), 2 * np.pi * GOLDEN * n + turned_rad
    level = np.sqrt(1 - up**2)
    return np.column_stack([level * np.cos(around), level * np.sin(around), up])


def strided(count: int) -> list[int]:
    """0 to `count` in steps next to its golden part, so that neighbours are far apart and some cover the whole."""
    free = [k for k in range(1, count + 1) if np.gcd(k, count) == 1]
    stride = min(free, key=lambda k: abs(k - GOLDEN * count))
    return [(place * stride) % count for place in range(count)]


def _refuse(bench: Bench, magnitudes_nT: Sequence[float]) -> None:
    if bench.config.reference.kind != "vector":
        raise InputError("field-sphere needs a vector reference; for a scalar one see scalar-cage")
    if bench.reference_kind == "none":
        raise InputError("the reference stands elsewhere: field-sphere needs [cage] calibration, from cage-calibration")
    for corner in np.vstack([np.eye(3), -np.eye(3)]):
        bench.cage.refuse_beyond_limits(max(magnitudes_nT) * corner)


def _where_from(bench: Bench) -> str:
    if bench.carry is None:
        return "the field is the reference's, measured at the DUT"
    return "the field is that of the calibrated cage, its ambient part followed by the reference"


def _visited(bench: Bench, fields_nT: Array, dwell_s: float, body_from_cage: Array, mode: str) -> Work[Visits]:
    """Every field played and recorded as a segment of its own."""
    found = list[Blocks]()
    for name, field in zip(names(fields_nT), fields_nT, strict=True):
        yield from energise(bench, field)
        found.append((yield from rest(bench, name, dwell_s, mode=mode, body_from_cage=body_from_cage)))
    return _means(bench, found)


def names(fields_nT: Array) -> Iterator[str]:
    """What the segments are called: by number and magnitude, zero visits as such."""
    for number, size in enumerate(np.linalg.norm(fields_nT, axis=1), 1):
        yield f"{number}-{size / 1000:g}uT" if size else f"{number}-zero"


def _unseen(bench: Bench, fields_nT: Array, dwell_s: float) -> Work[Visits]:
    """Fields for judging only: no segments, so that no fit of the record sees them."""
    found = list[Blocks]()
    for field in fields_nT:
        yield from energise(bench, field)
        found.append((yield from record(bench, dwell_s)))
    return _means(bench, found)


def _means(bench: Bench, found: Sequence[Blocks]) -> Visits:
    spots = [position(bench, blocks) for blocks in found]
    t = np.array([float(samples(blocks, "dut").t_s.mean()) for blocks in found])
    u = float(np.sqrt(np.mean([spot.u**2 for spot in spots])))
    return Visits(t, np.array([s.dut for s in spots]), np.array([s.reference for s in spots]), u)


def _fitted(bench: Bench, seen: Visits) -> SphereFit:
    positions = as_positions(bench, seen.field_nT)
    others = [(e, seen.field_nT + e.moves(positions, reference_field_nT)) for e in declared_errors(positions)]
    try:
        return fit_sphere(seen.reading, seen.field_nT, seen.t_s, others)
    except ValueError as error:
        raise InputError(str(error)) from error


def _report(bench: Bench, fit: SphereFit, seen: Visits, found: Sequence[Shell], drift_nT: float) -> Work[None]:
    """K, k, the drift of the zero, and what no such map holds, by degree; an event with the covariance."""
    for name, value, u in zip(MAP_PARAMETERS, fit.affine.parameters, fit.u, strict=True):
        yield from measured(bench, name.replace("_", " "), value, u, "nT" if name.startswith("k") else "1")
    lasted = float(np.ptp(seen.t_s))
    worst = int(np.argmax(np.abs(fit.drift_nT_per_s)))
    drift, u = lasted * fit.drift_nT_per_s[worst], lasted * fit.u_drift_nT_per_s[worst]
    yield from measured(bench, "drift of the zero", drift, u, "nT", drift_nT)
    for shell in found:
        for degree, (rms, noise) in enumerate(zip(shell.rms_nT, shell.noise_nT, strict=True)):
            yield from measured(bench, f"{shell.magnitude_nT / 1000:.3g} µT, degree {degree}", rms, noise, "nT")
    if not found:
        yield note(bench, "too few directions for harmonics: what K and k do not hold is not reported by degree")
    text = "K and k in the cage's frame, k in the middle of the run"
    yield Event(bench.clock.now(), "field-sphere", text, _data(fit, found))


def _data(fit: SphereFit, found: Sequence[Shell]) -> dict[str, object]:
    return {
        "K": fit.affine.K.tolist(),
        "k_nT": fit.affine.k_nT.tolist(),
        "covariance": fit.covariance.tolist(),
        "contributions": [{"source": c.source, "type": c.type, "u": c.u, "unit": c.unit} for c in fit.contributions],
        "shells": [
            {
                "magnitude_nT": shell.magnitude_nT,
                "coefficients_nT": shell.coefficients_nT.tolist(),
                "rms_nT": shell.rms_nT.tolist(),
                "noise_nT": shell.noise_nT.tolist(),
                "p": shell.p.tolist(),
            }
            for shell in found
        ],
    }


def _verified(bench: Bench, fit: SphereFit, seen: Visits, unseen: Visits, error_nT: float) -> Work[None]:
    """Errors at fields that no fit has seen, as uncertain as the reference that tells them.

    The largest is told in units of its U by noise alone (k = 2): fit and test have the reference in common.
    """
    late = fit.drift_nT_per_s * (unseen.t_s - seen.t_s.mean())[:, None]
    calibrated = fit.affine.apply(unseen.reading) - late

    def errors(run: Run) -> Array:
        return np.asarray((calibrated - reference_field_nT(run)).ravel())

    positions = as_positions(bench, unseen.field_nT)
    u = u_of_size(positions, errors, of_length, unseen.u_nT)
    yield from measured(bench, "verify: rms error", float(of_length(errors(positions))), u, "nT", error_nT)
    U = 2 * np.sqrt(_variance(fit, unseen.reading) + unseen.u_nT**2)
    largest = float(np.abs((calibrated - unseen.field_nT) / U).max())
    yield from measured(bench, "verify: largest error in units of U by noise", largest, 0.0, "1")


def reference_field_nT(positions: Run) -> Array:
    """The fields (n, 3) [nT, C] as the reference tells them."""
    assert positions.reference_vector is not None
    return positions.reference_vector


def _variance(fit: SphereFit, reading: Array) -> Array:
    """Of each component of K m − k (n, 3) [nT²], as the residuals show it."""
    A = np.column_stack([reading, -np.ones(len(reading))])
    place = [[3 * i, 3 * i + 1, 3 * i + 2, 9 + i] for i in range(3)]
    return np.column_stack([np.einsum("ni,ij,nj->n", A, fit.covariance_a[np.ix_(p, p)], A) for p in place])

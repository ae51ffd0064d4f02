"""The cage measured by an absolute scalar sensor alone: coil by coil, and by a constant modulus that rotates."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from contextlib import ExitStack
from dataclasses import fields
from functools import partial
from itertools import combinations
from typing import Annotated, TypeVar

import numpy as np
from numpy.typing import NDArray

from labcal.bench.bench import Bench
from labcal.bench.parameters import Limits
from labcal.bench.stated import as_positions
from labcal.bench.steps import Plan, Procedure, Work, coils_off, drive, measured, note, ready, record
from labcal.bench.streams.samples import samples
from labcal.errors import InputError
from labcal.fit.scalar_cage import (
    UPPER,
    Magnitudes,
    ScalarCage,
    by_components,
    fit_scalar_cage,
    largest_En,
    with_matrix,
)
from labcal.record import Run
from labcal.record.stream import Event, Prompt
from labcal.uncertainty import declared_errors
from labcal.uncertainty.verdicts import u_declared, uncovered
from procedures.field_sphere import lattice, strided

NEEDS, LASTS_MIN = "an absolute scalar sensor in the cage's centre", 7

Array = NDArray[np.float64]
T = TypeVar("T")
STEP_S = 1.6  # of lab time for a field beside its dwell
PARTS = (1.0, 0.55)  # of the largest current and the largest modulus: what a supply lets through at zero shows in two
OFF_EVERY = 10  # components, then all coils off
EARTH_nT = 65_000.0  # at most, at a place that is not known yet
UNSEEN_TURN = 2.0  # rad, of the lattice that no fit sees


def scalar_cage(
    bench: Bench,
    *,
    field_nT: Annotated[float, Limits(1_000, 100_000, unit="nT"), "of each coil alone"] = 40_000.0,
    modulus_nT: Annotated[float, Limits(1_000, 100_000, unit="nT"), "of the field that rotates"] = 50_000.0,
    n_directions: Annotated[int, Limits(16, 200), "of the field that rotates, at two moduli"] = 32,
    dwell_s: Annotated[float, Limits(0.5, 60, unit="s"), "recorded in each field"] = 2.0,
    verify: Annotated[int, Limits(4, 200), "fields that no fit sees, at the end"] = 12,
    error_nT: Annotated[float, Limits(0.01, 1e5, unit="nT"), "rms error of the magnitude there that passes"] = 5.0,
    square_deg: Annotated[float, Limits(0.001, 10, unit="deg"), "departure from square that passes"] = 1.0,
) -> Procedure:
    """Measure the current-to-field matrix, its squareness and the ambient field by a scalar sensor in the centre."""
    if bench.config.reference.kind != "scalar":
        raise InputError(
            "scalar-cage needs a scalar reference ([reference] kind); for a vector one see cage-calibration"
        )
    singles = components(field_nT / np.linalg.norm(bench.cage.matrix_nT_per_A, axis=0))
    turning, fresh = rotating(modulus_nT, n_directions, verify)
    each_s = dwell_s + STEP_S
    plan = Plan((("components", len(singles) * each_s), ("constant modulus", len(turning) * each_s)))
    with ExitStack() as afterwards:
        afterwards.callback(bench.cage.zero)  # the undo, before anything is energised
        yield plan.begin(bench, "components")
        yield from coils_off(bench)
        text, place = (
            "Put the scalar sensor into the cage's centre, its dead zones away from the fields.",
            [0.0, 0.0, 0.0],
        )
        yield Prompt(bench.clock.now(), "sensor-in-the-centre", text, acts=True, drawing={"reference_m": place})
        largest = max(2**0.5 * field_nT, modulus_nT + EARTH_nT) / 1000  # of two coils together; against the place's
        yield from ready(bench, f"The coils go up to {largest:.0f} µT, then the field rotates. Hands off?")
        first = yield from _seen(bench, singles, dwell_s)
        A, b0 = _asked(lambda: by_components(first))
        yield plan.begin(bench, "constant modulus")
        second = yield from _seen(bench, [np.linalg.solve(A, b - b0) for b in turning], dwell_s)
        yield from coils_off(bench)
    yield from _report(bench, first, second, fresh, error_nT, square_deg)


def components(largest_A: Array) -> list[Array | None]:
    """Currents (3,): each coil alone and every two together, in all signs, at two sizes; None: all coils off.

    Far from any pattern in time, so that what is periodic, the mains folded down, looks like no coil.
    """
    signed, steps = list[Array](), list[Array | None]()
    for part in PARTS:
        signed += [part * largest_A * s * np.eye(3)[j] for j in range(3) for s in (1, -1)]
        for j, k in combinations(range(3), 2):
            signed += [part * largest_A * (s * np.eye(3)[j] + r * np.eye(3)[k]) for s in (1, -1) for r in (1, -1)]
    for number, place in enumerate(strided(len(signed))):
        if number % OFF_EVERY == 0:
            steps.append(None)
        steps.append(signed[place])
    return [*steps, None]


def rotating(modulus_nT: float, n_directions: int, verify: int) -> tuple[Array, NDArray[np.bool_]]:
    """Total fields (n, 3) of constant modulus, two moduli by turns, and which of them no fit is to see (n,).

    Those stand among the others and not behind them, so that the place's field is known when they are played.
    """
    sizes = [(part, u) for part in PARTS for u in lattice(n_directions)]
    fields = [sizes[place][0] * modulus_nT * sizes[place][1] for place in strided(len(sizes))]
    unseen = modulus_nT * lattice(verify, UNSEEN_TURN)
    places = np.linspace(1, len(fields) - 1, verify).astype(int)
    kept, fresh = np.insert(np.array(fields), places, unseen, axis=0), np.zeros(len(fields) + verify, dtype=np.bool_)
    fresh[places + np.arange(verify)] = True
    return kept, fresh


def _seen(bench: Bench, steps: Sequence[Array | None], dwell_s: float) -> Work[Magnitudes]:
    """Each set of currents driven and the mean magnitude recorded; currents as the supplies hold them."""
    t, held, signs, magnitudes = list[float](), list[Array](), list[Array](), list[float]()
    for currents in steps:
        if currents is None:
            yield from coils_off(bench)
        else:
            yield from drive(bench, currents)
        held.append(np.zeros(3) if currents is None else bench.cage.set_points_A())
        signs.append(np.zeros(3) if currents is None else np.copysign(1.0, held[-1]))
        reading = samples((yield from record(bench, dwell_s)), "reference", "ref_f")
        t.append(float(reading.t_s.mean()))
        magnitudes.append(float(reading.mean[0]))
    return Magnitudes(np.array(t), np.array(held), np.array(signs), np.array(magnitudes))


def _asked(work: Callable[[], T]) -> T:
    """What an estimator answers; what it refuses is said as a wrong input."""
    try:
        return work()
    except ValueError as error:
        raise InputError(str(error)) from error


def _report(
    bench: Bench, first: Magnitudes, second: Magnitudes, fresh: NDArray[np.bool_], error_nT: float, square_deg: float
) -> Work[None]:
    """Both methods, each by its own fields, and together; then what fields tell that no fit has seen."""

    def fitted(seen: Magnitudes, start: ScalarCage | None = None) -> ScalarCage:
        positions = as_positions(bench, seen.magnitude_nT)
        moved = [(e, e.moves(positions, reference_magnitude_nT)) for e in declared_errors(positions)]
        others = [(error, seen.magnitude_nT + by) for error, by in moved]
        return _asked(lambda: fit_scalar_cage(seen, others=others, start=start))

    turning = second.select(~fresh)
    every = joined(first, turning)
    if left := uncovered(
        as_positions(bench, every.magnitude_nT), ["the supplies' currents", "where the sensor was put"]
    ):
        yield note(bench, left)
    found = fitted(every)
    for name, values, u, unit, limit in _rows(found, square_deg):
        for part, value, uncertainty in zip(name, values, u, strict=True):
            yield from measured(bench, part, value, uncertainty, unit, limit)
    apart = largest_En(fitted(first), fitted(turning, found))
    yield from measured(bench, "components against constant modulus, largest E_n", apart, 0.0, "1")
    yield from _verified(bench, found, every, second.select(fresh), error_nT)
    rows = ", ".join(f"[{', '.join(f'{v:.1f}' for v in row)}]" for row in found.matrix_nT_per_A)
    yield Event(bench.clock.now(), "scalar-cage", f"x along coil x: matrix_nT_per_A = [{rows}]", _data(found, every))


def joined(one: Magnitudes, other: Magnitudes) -> Magnitudes:
    """Both, in this order."""
    pairs = ((getattr(one, f.name), getattr(other, f.name)) for f in fields(Magnitudes))
    return Magnitudes(*(np.concatenate(pair) for pair in pairs))


def _rows(found: ScalarCage, square_deg: float) -> list[tuple[list[str], Array, Array, str, float | None]]:
    u = np.sqrt(np.diag(found.covariance))
    return [
        ([f"constant {a}" for a in "xyz"], *found.constants(), "nT/A", None),
        ([f"{a} from square" for a in ("xy", "xz", "yz")], *found.angles_deg(), "deg", square_deg),
        ([f"ambient {a}" for a in "xyz"], found.ambient_nT, u[6:9], "nT", None),
        ([f"current at zero {a}" for a in "xyz"], found.leak_A, u[9:12], "A", None),
    ]


def _verified(bench: Bench, found: ScalarCage, seen: Magnitudes, fresh: Magnitudes, error_nT: float) -> Work[None]:
    """Rms error of the magnitude at fields that no fit has seen: with bench.toml's matrix, and with the one found.

    Each as uncertain as the sensor that tells the magnitudes.
    """
    stated = bench.cage.matrix_nT_per_A
    before = np.linalg.norm(fresh.currents_A @ stated.T + with_matrix(stated, seen), axis=1)
    noise = float(np.std(found.residual_nT)) / np.sqrt(len(fresh))
    positions = as_positions(bench, fresh.magnitude_nT)
    rows = (("verify: rms error with bench.toml's matrix", before, None),
            ("verify: rms error", found.magnitude_nT(fresh), error_nT))  # fmt: skip
    for name, made_nT, limit in rows:
        figure = partial(_rms_error, made_nT)
        u = float(np.hypot(noise, u_declared(positions, figure)))
        yield from measured(bench, name, figure(positions), u, "nT", limit)


def _rms_error(made_nT: Array, positions: Run) -> float:
    return float(np.sqrt(np.mean((made_nT - reference_magnitude_nT(positions)) ** 2)))


def reference_magnitude_nT(positions: Run) -> Array:
    """The magnitudes (n,) [nT] as the sensor tells them."""
    assert positions.reference_magnitude is not None
    return positions.reference_magnitude


def _data(found: ScalarCage, seen: Magnitudes) -> dict[str, object]:
    return {
        "t_s": seen.t_s.tolist(),  # the ambient field is its mean at these times
        "matrix_nT_per_A": found.matrix_nT_per_A.tolist(),
        "ambient_nT": found.ambient_nT.tolist(),
        "leak_A": found.leak_A.tolist(),
        "covariance": found.covariance.tolist(),
        "covariance_of": [
            *(f"A_{'xyz'[i]}{'xyz'[j]}" for i, j in UPPER),
            *(f"b_{a}" for a in "xyz"),
            *(f"rho_{a}" for a in "xyz"),
        ],
    }

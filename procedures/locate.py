"""Where DUT and reference stand in the cage: by gradients made on purpose, one half of a coil pair reversed by hand."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import ExitStack
from dataclasses import dataclass, replace
from typing import Annotated

import numpy as np
from numpy.typing import NDArray

from labcal.bench.bench import Bench
from labcal.bench.config import GeometryConfig
from labcal.bench.parameters import Limits
from labcal.bench.steps import Plan, Procedure, Work, coils_off, drive, measured, note, ready, record
from labcal.bench.streams.samples import samples
from labcal.errors import InputError
from labcal.fit.locate import ROUND, SQUARE, CoilResponses, Coils, LocatedSensor, locate, shifts
from labcal.record.stream import Event, Prompt, Stream

NEEDS, LASTS_MIN = "[cage.geometry] with halves that a person can reverse; a vector reference", 5

Array = NDArray[np.float64]
SEPARATES = (("field-gradient", "cage-field"), ("field-gradient", "axis-tilt"))
AXES = "xyz"
SIGNS = (1, -1, -1, 1)  # what drifts evenly drops out
SENSORS: tuple[Stream, ...] = ("reference", "dut")
READS, STEP_S = 8, 2.0  # of a current; of lab time for a sign beside its dwell


@dataclass(frozen=True, slots=True, eq=False)
class Response:
    """Of one coil: both sensors (3,) per A by name, `u` of an element, and the relative uncertainty of the current."""

    of: dict[str, Array]
    u: dict[str, float]
    u_current: float


@dataclass(frozen=True, slots=True, eq=False)
class Located:
    """A sensor's place, and how it moves (4, 3) [m] with the coils' size and the balance of halves, by their u."""

    place: LocatedSensor
    shifts_m: Array

    @property
    def u_m(self) -> Array:
        """Standard uncertainty (3,) of the coordinates."""
        return np.asarray(np.sqrt(np.diag(self.place.covariance) + np.sum(self.shifts_m**2, axis=0)))


def locate_sensors(
    bench: Bench,
    *,
    field_nT: Annotated[float, Limits(1_000, 100_000, unit="nT"), "of each coil with both halves alike"] = 40_000.0,
    dwell_s: Annotated[float, Limits(0.5, 60, unit="s"), "recorded at each sign"] = 2.0,
    apart_mm: Annotated[float, Limits(0.1, 1_000, unit="mm"), "from where the reference is stated that passes"] = 20.0,
    misfit_mm: Annotated[float, Limits(0.1, 1_000, unit="mm"), "of the coils' geometry that passes"] = 5.0,
) -> Procedure:
    """Find where DUT and reference stand, from the gradients of coil pairs with one half reversed."""
    geometry = _geometry(bench)
    driven_s = len(SIGNS) * (dwell_s + STEP_S)  # of one coil
    swapped = tuple((f"coil {axis}", driven_s) for axis in sorted(geometry.halves))
    plan = Plan((("as they should be", 3 * driven_s), *swapped), frozenset(name for name, _ in swapped))
    with ExitStack() as afterwards:
        afterwards.callback(bench.cage.zero)  # the undo, before anything is energised
        yield plan.begin(bench, "as they should be")
        yield from ready(bench, f"Each coil goes to ±{field_nT / 1000:g} µT. Hands off?")
        normal = []
        for coil in range(3):
            normal.append((yield from _driven(bench, coil, field_nT, dwell_s)))
        opposed = dict[int, Response]()
        for axis in sorted(geometry.halves):
            yield plan.begin(bench, f"coil {axis}")
            opposed[AXES.index(axis)] = yield from _with_a_half_reversed(bench, axis, field_nT, dwell_s)
        yield from coils_off(bench)
    found: dict[str, Located] = {name: _place(bench, name, normal, opposed) for name in SENSORS}
    yield from _report(bench, found, apart_mm, misfit_mm)


def _geometry(bench: Bench) -> GeometryConfig:
    geometry = bench.config.cage.geometry
    if bench.config.reference.kind != "vector":
        raise InputError("locate needs a vector reference")
    if geometry is None:
        raise InputError(
            "locate needs the coils' geometry: state [cage.geometry] size_m, and in halves the coils of which one half "
            "can be reversed at its terminals"
        )
    if not geometry.halves:
        raise InputError(
            "no coil's halves can be reversed ([cage.geometry] halves): near its middle the field of a pair does not "
            "change with the place to first order, and tells none"
        )
    return geometry


def _with_a_half_reversed(bench: Bench, axis: str, field_nT: float, dwell_s: float) -> Work[Response]:
    """One coil's pair with its halves opposed, and put back."""
    yield from _leads(bench, axis, True)
    yield from ready(bench, f"Coil {axis} makes a gradient now, with the current of {field_nT / 1000:g} µT. Hands off?")
    response = yield from _driven(bench, AXES.index(axis), field_nT, dwell_s, confirm_signs=False)
    yield from _leads(bench, axis, False)
    return response


def _leads(bench: Bench, axis: str, reversed_: bool) -> Work[None]:
    yield from coils_off(bench)
    half = f"of the half of coil {axis} that stands towards +{axis}"
    text = f"Swap the two leads {half}. They must come back before anything else is measured, also if this run is "
    text = f"{text}stopped." if reversed_ else f"Put the two leads {half} back as they were."
    drawing = {"half": axis, "reversed": reversed_}
    yield Prompt(
        bench.clock.now(), f"half-{axis}-{'reversed' if reversed_ else 'back'}", text, acts=True, drawing=drawing
    )


def _driven(bench: Bench, coil: int, field_nT: float, dwell_s: float, *, confirm_signs: bool = True) -> Work[Response]:
    """The response of both sensors to one coil, by both signs of its current."""
    largest_A = field_nT / float(np.linalg.norm(bench.cage.matrix_nT_per_A[:, coil]))
    currents, means, us = list[float](), dict[str, list[Array]](), dict[str, list[float]]()
    for sign in SIGNS:
        yield from drive(bench, sign * largest_A * np.eye(3)[coil], confirm_signs=confirm_signs)
        blocks = yield from record(bench, dwell_s)
        currents.append(float(np.mean([bench.cage.currents_A()[coil] for _ in range(READS)])))
        for name in SENSORS:
            seen = samples(blocks, name)
            means.setdefault(name, []).append(seen.mean)
            us.setdefault(name, []).append(float(seen.u_mean.max()))
    flowed = float(np.mean(np.array(SIGNS) * currents))
    return Response(
        {name: np.array(SIGNS) @ np.array(each) / len(SIGNS) / flowed for name, each in means.items()},
        {name: float(np.sqrt(np.mean(np.square(each)) / len(SIGNS)) / abs(flowed)) for name, each in us.items()},
        _scatter(np.array(SIGNS) * currents) / abs(flowed),
    )


def _scatter(currents_A: Array) -> float:
    """Standard uncertainty of the mean of the four: two of either sign, what a supply adds to both signs left out."""
    apart = np.array([currents_A[0] - currents_A[3], currents_A[1] - currents_A[2]])
    return float(np.sqrt(np.mean(apart**2) / 2) / np.sqrt(len(currents_A)))


def _place(bench: Bench, name: str, normal: Sequence[Response], opposed: dict[int, Response]) -> Located:
    geometry = _geometry(bench)
    reversed_ = np.zeros((3, 3))
    for coil, response in opposed.items():
        reversed_[:, coil] = response.of[name]
    every = [*normal, *opposed.values()]
    seen = CoilResponses(
        np.column_stack([response.of[name] for response in normal]), reversed_, tuple(sorted(opposed)),
        float(np.sqrt(np.mean([response.u[name] ** 2 for response in every]))),
        float(np.sqrt(np.mean([response.u_current**2 for response in every]))),
    )  # fmt: skip
    coils = Coils(
        np.array(geometry.size_m), np.array(geometry.spacing), bench.cage.matrix_nT_per_A,
        SQUARE if geometry.shape == "square" else ROUND,
    )  # fmt: skip
    try:
        place = locate(seen, coils)
        return Located(place, shifts(seen, coils, place, geometry.u_size_m, geometry.u_halves))
    except ValueError as error:
        raise InputError(f"{name}: {error}") from error


def _report(bench: Bench, found: dict[str, Located], apart_mm: float, misfit_mm: float) -> Work[None]:
    """Both places, the reference's against the one stated, and the distance of the two; an event with all of it."""
    for name, one in found.items():
        for axis, value, u in zip(AXES, one.place.place_m, one.u_m, strict=True):
            yield from measured(bench, f"{name}: {axis}", 1e3 * value, 1e3 * u, "mm")
        if one.place.misfit_m:
            yield from measured(bench, f"{name}: misfit", 1e3 * one.place.misfit_m, 0.0, "mm", misfit_mm)
    reference, dut = (found[name] for name in SENSORS)
    between = reference.place.place_m - dut.place.place_m
    stated = np.array(bench.config.reference.position_m)
    common = reference.shifts_m - dut.shifts_m  # of geometry: what moves both alike moves neither from the other
    u = np.sqrt(np.diag(reference.place.covariance + dut.place.covariance) + np.sum(common**2, axis=0))
    for axis, value, less, u_axis in zip(AXES, between, between - stated, u, strict=True):
        yield from measured(bench, f"reference from DUT: {axis}", 1e3 * value, 1e3 * u_axis, "mm")
        yield from measured(bench, f"less what is stated: {axis}", 1e3 * less, 1e3 * u_axis, "mm", apart_mm)
    if np.linalg.norm(between + stated) < np.linalg.norm(between - stated) / 2:
        yield note(bench, "the places are as if the halves towards − had been reversed, or position_m has another sign")
    yield from _of_the_coils(bench, reference, dut)
    data = {
        "place_m": {name: one.place.place_m.tolist() for name, one in found.items()},
        "u_m": {name: one.u_m.tolist() for name, one in found.items()},
        "reference_from_dut_m": between.tolist(),
        "u_reference_from_dut_m": u.tolist(),
    }
    text = f"[reference] position_m = [{', '.join(f'{v:.4f}' for v in between)}]"
    yield Event(bench.clock.now(), "locate", text, data)


def _of_the_coils(bench: Bench, reference: Located, dut: Located) -> Work[None]:
    """What each coil's field at the reference is more than at the DUT: the share of the cage's own gradient.

    As uncertain as the two places, and as the coils' size and the balance of their halves, which move those as well.
    """
    geometry = _geometry(bench)
    corners = SQUARE if geometry.shape == "square" else ROUND
    coils = Coils(np.array(geometry.size_m), np.array(geometry.spacing), bench.cage.matrix_nT_per_A, corners)
    there, here = reference.place.place_m, dut.place.place_m
    by = 1e6 * _departure(coils, there, here)
    other = [
        replace(coils, size_m=coils.size_m + geometry.u_size_m),
        *(replace(coils, imbalance=geometry.u_halves * one) for one in np.eye(3)),
    ]
    shifted = zip(other, reference.shifts_m, dut.shifts_m, strict=True)  # other coils, and so other places
    moved = [_departure(changed, there + one, here + another) for changed, one, another in shifted]
    moved += [_departure(coils, there + step, here) for step in _one_by_one(reference.place.covariance)]
    moved += [_departure(coils, there, here + step) for step in _one_by_one(dut.place.covariance)]
    u = np.linalg.norm(1e6 * np.array(moved) - by, axis=0)
    for axis, value, u_axis in zip(AXES, by, u, strict=True):
        yield from measured(bench, f"coil {axis}: field at the reference over that at the DUT", value, u_axis, "ppm")


def _one_by_one(covariance: Array) -> Array:
    """Steps (3, 3), one a row, independent of each other, whose squares add up to `covariance`."""
    return np.asarray(np.linalg.cholesky(covariance).T)


def _departure(coils: Coils, there_m: Array, here_m: Array) -> Array:
    """Size of each coil's field (3,) at one place over that at another, less one."""
    there, here = (np.linalg.norm(coils.field(place, False), axis=0) for place in (there_m, here_m))
    return np.asarray(there / here - 1)

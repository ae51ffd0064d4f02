"""The reference itself: due date, its zero by half turns, and one magnitude in every direction."""

from __future__ import annotations

import re
from contextlib import ExitStack
from datetime import date
from typing import Annotated

import numpy as np
from numpy.typing import NDArray

from labcal.bench.bench import Bench
from labcal.bench.parameters import Limits
from labcal.bench.steps import Plan, Procedure, Work, coils_off, energise, measured, note, ready, record
from labcal.bench.streams.samples import Samples, samples
from labcal.errors import InputError, LimitNotMet
from labcal.geometry import rotation
from labcal.record.stream import Prompt
from labcal.uncertainty.verdicts import half_expanded

NEEDS, LASTS_MIN = "the reference on the platform", 2

Array = NDArray[np.float64]
LEFT_OF_A_WALK = np.sqrt([6.0, 2.0, 2.0]) / 8  # of its change from first to last, in the mean of four attitudes
HALF_TURNS = {name: rotation(axis, np.pi) for name, axis in zip("xyz", np.eye(3), strict=True)}


def reference_check(
    bench: Bench,
    *,
    due_days: Annotated[int, Limits(1, 3_650), "age of its calibration that passes"] = 365,
    dwell_s: Annotated[float, Limits(1, 600, unit="s"), "recorded in each attitude and field"] = 10.0,
    magnitude_nT: Annotated[float, Limits(1_000, 100_000, unit="nT"), "of the field in six directions"] = 50_000.0,
    zero_nT: Annotated[float, Limits(0.1, 1e5, unit="nT"), "largest zero that passes"] = 50.0,
    scale_ppm: Annotated[float, Limits(1, 1e6, unit="ppm"), "largest spread of the magnitude that passes"] = 5_000.0,
    standard_nT: Annotated[float, Limits(0, 1e5, unit="nT"), "ambient magnitude by a standard; 0: none"] = 0.0,
    u_standard_nT: Annotated[float, Limits(0, 1e5, unit="nT"), "of the standard; 0: not stated"] = 0.0,
    u_turn_deg: Annotated[float, Limits(0, 10, unit="deg"), "how truly it is turned by 180°; 0: not stated"] = 0.0,
    u_cage_ppm: Annotated[float, Limits(0, 1e6, unit="ppm"), "of the cage's field, by direction; 0: not stated"] = 0.0,
) -> Procedure:
    """Check the reference's due date, its zero by 180° turns, and its magnitude against direction and a standard."""
    if bench.config.reference.kind != "vector":
        raise InputError("reference-check needs a vector reference")
    _enforce_due_date(bench, due_days)
    steps = (("zero by half turns", 5 * (dwell_s + 0.5)), ("six directions", 6 * (dwell_s + 2)))
    plan = Plan(steps, frozenset({"six directions"}))
    with ExitStack() as afterwards:
        afterwards.callback(bench.cage.zero)  # the undo, before anything is energised
        yield plan.begin(bench, "zero by half turns")
        yield from coils_off(bench)
        stated = {
            "the standard": u_standard_nT or not standard_nT,
            "the half turns": u_turn_deg,
            "the cage": u_cage_ppm,
        }
        if left := [name for name, u in stated.items() if not u]:
            yield note(bench, f"Not covered by the uncertainties, because it is not stated: {', '.join(left)}.")
        ambient, zero, u = yield from _zero(bench, dwell_s, zero_nT, u_turn_deg)
        if standard_nT:
            off = float(np.linalg.norm(ambient)) - standard_nT
            yield from measured(
                bench, "magnitude less the standard's", off, float(np.hypot(u, u_standard_nT)), "nT", zero_nT
            )
        yield plan.begin(bench, "six directions")
        bench.cage.ambient_nT = ambient
        yield from ready(bench, f"The field goes to {magnitude_nT / 1000:g} µT in six directions. Hands off?")
        yield from _six_directions(bench, dwell_s, magnitude_nT, zero, scale_ppm, u_cage_ppm)
        yield from coils_off(bench)


def _enforce_due_date(bench: Bench, due_days: int) -> None:
    """Raise LimitNotMet where the calibration that bench.toml states is older than `due_days`."""
    stated = re.search(r"\d{4}-\d{2}-\d{2}", bench.config.reference.calibration or "")
    if stated is None:
        return
    age = (bench.clock.utc().date() - date.fromisoformat(stated.group())).days
    if age > due_days:
        raise LimitNotMet(f"the reference's calibration of {stated.group()} is {age} days old, beyond {due_days}")


def _zero(bench: Bench, dwell_s: float, limit_nT: float, u_turn_deg: float) -> Work[tuple[Array, Array, float]]:
    """Four attitudes that add up to nothing: the mean reading is the zero.

    Returns the ambient field (3,) and the zero (3,) [nT, C], and the standard uncertainty of one component.
    """
    turned = np.asarray(bench.config.reference.cage_from_sensor)
    seen = [(yield from _standing(bench, "as it always stands", np.eye(3), dwell_s))]
    for name, half in HALF_TURNS.items():
        seen.append((yield from _standing(bench, f"turned by 180° about its own {name}", half, dwell_s)))
    again = yield from _standing(bench, "as it always stands", np.eye(3), dwell_s)
    zero = np.mean([turned.T @ standing.mean for standing in seen], axis=0)
    in_sensor = np.array([turned.T @ standing.mean for standing in (*seen, again)])
    noise = np.sqrt([(turned.T**2) @ standing.u_mean**2 for standing in (*seen, again)])
    u = u_of_zero(in_sensor, noise, np.radians(u_turn_deg))
    for name, value, of_axis in zip("xyz", zero, u, strict=True):
        yield from measured(bench, f"zero {name}", value, of_axis, "nT", limit_nT)
    return np.asarray(again.mean - turned @ zero), turned @ zero, float(np.hypot(u.max(), again.u_mean.max()))


def u_of_zero(means_nT: Array, u_nT: Array, u_turn_rad: float) -> Array:
    """Half the U of 95.45 % (3,) [nT] of the mean of four attitudes, by means and noise (5, 3) in the sensor's axes.

    The fifth stands as the first. An attitude that is missed by a small turn w reads w × b too much: with three of
    four turned to, each on its own, an axis is uncertain by sqrt(3) / 4 u_w times the field across it. The field of the
    place changes meanwhile; by how much, beyond noise, shows in the fifth. Of a random walk of four steps w there is
    left (w1 + 2 w2 + w3) / 4 in x, (w1 + w3) / 4 in y and (w1 − w3) / 4 in z: sqrt(6), sqrt(2) and sqrt(2) of an eighth
    of that change, which one walk of three components tells with three degrees of freedom.
    """
    first, again = means_nT[0], means_nT[-1]
    noise = np.linalg.norm(u_nT[:4], axis=0) / 4
    across = np.sqrt(np.maximum(np.sum(first**2) - first**2, 0.0))
    missed = u_turn_rad * across * np.sqrt(len(HALF_TURNS)) / 4
    beyond = np.sum((again - first) ** 2) - np.sum(u_nT[0] ** 2 + u_nT[-1] ** 2)
    moved = LEFT_OF_A_WALK * float(np.sqrt(max(beyond, 0.0) / len(first)))
    known = np.hypot(noise, missed)
    return np.array([half_expanded((a, np.inf), (b, len(first))) for a, b in zip(known, moved, strict=True)])


def _standing(bench: Bench, how: str, half: Array, dwell_s: float) -> Work[Samples]:
    yield from _ask_to_turn(bench, how, half)
    blocks = yield from record(bench, dwell_s)
    return samples(blocks, "reference")


def _ask_to_turn(bench: Bench, how: str, half: Array) -> Work[None]:
    drawing = {"reference_turned": half.tolist()}
    yield Prompt(bench.clock.now(), "turn-reference", f"Put the reference {how}.", acts=True, drawing=drawing)


def _six_directions(
    bench: Bench, dwell_s: float, magnitude_nT: float, zero: Array, limit_ppm: float, u_cage_ppm: float
) -> Work[None]:
    """One applied field in six directions: what the magnitude departs from its mean is scale and orthogonality.

    The zero (3,) [nT, C] is taken off; by how much it is wrong the ambient field is too, and both cancel.
    """
    ratios, u_nT = list[float](), 0.0
    for direction in (*np.eye(3), *-np.eye(3)):
        yield from energise(bench, magnitude_nT * direction)
        blocks = yield from record(bench, dwell_s)
        applied = float(np.linalg.norm(bench.cage.field_nT()))
        seen = samples(blocks, "reference")
        ratios.append(float(np.linalg.norm(seen.mean - zero)) / applied)
        u_nT = max(u_nT, float(seen.u_mean.max()))
    spread_ppm, u_ppm = 1e6 * (max(ratios) - min(ratios)) / 2, 1e6 * u_nT / magnitude_nT / np.sqrt(2)
    u = float(np.hypot(u_ppm, u_cage_ppm / np.sqrt(2)))  # half the difference of two directions
    yield from measured(bench, "magnitude against direction", spread_ppm, u, "ppm", limit_ppm)

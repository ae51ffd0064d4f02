"""What a run declares of its reference and its mounting, each error as the run that it would have been.

Standard uncertainties, normal, constant through the run: a common factor of the reference, a zero for each of its axes,
a turn of the reference's axes, of the platform's axes in the cage and of those in the body, each independent about
every axis, and an offset between the clocks. What became of the reference since its certificate is in
`labcal.uncertainty.conditions`. What is not declared is not here.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import partial
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from labcal.geometry import rotation_vector
from labcal.record import Run, Segment
from labcal.uncertainty import conditions

Array = NDArray[np.float64]
STEP = 0.1  # standard deviations, of a derivative


class Perturbation(Protocol):
    """What an error does to a run."""

    def __call__(self, run: Run, times: float = 1.0) -> Run:
        """The run as it would have been recorded, so many standard deviations off."""
        ...


@dataclass(frozen=True, slots=True, eq=False)
class DeclaredError:
    """One declared error: its standard uncertainty, and the run with an error of that size."""

    source: str
    u: float
    unit: str
    change: Perturbation
    each_mounting: bool = False  # whether a remounting draws it anew

    def moves(self, run: Run, of: Callable[[Run], Array]) -> Array:
        """What one standard deviation of it changes of what is read off a run, to first order (GUM, 5.1.3, note 2).

        By the difference of a tenth either way: what goes with the square of a turn is no sensitivity, and must not
        look like a change of scale.
        """
        return np.asarray((of(self.change(run, STEP)) - of(self.change(run, -STEP))) / (2 * STEP))


def declared_errors(run: Run) -> tuple[DeclaredError, ...]:
    """Every error that `run` declares, each independent of the others."""
    return (*_of_the_reference(run), *_of_its_conditions(run), *_of_the_mounting(run), *_of_the_clocks(run))


def _of_the_reference(run: Run) -> list[DeclaredError]:
    reference, found = run.reference, list[DeclaredError]()
    if reference.kind == "none":
        return found
    if ppm := reference.u_scale_ppm:
        found.append(DeclaredError("reference scale", ppm, "ppm", partial(_scaled, ppm=ppm)))
    if zero := reference.u_offset_nT:
        axes = np.eye(3) if reference.kind == "vector" else np.ones((1, 1))
        names = [f" {axis}" for axis in "xyz"] if reference.kind == "vector" else [""]
        for name, axis in zip(names, axes, strict=True):
            found.append(DeclaredError(f"reference zero{name}", zero, "nT", partial(_offset, by=zero * axis)))
    if (deg := reference.u_align_deg) and reference.kind == "vector":
        for name, turn in _turns():
            change = partial(_aligned, by=np.radians(deg) * turn)
            found.append(DeclaredError(f"reference alignment about {name}", deg, "deg", change))
    return found


def _of_its_conditions(run: Run) -> list[DeclaredError]:
    """Its temperature, its drift since its certificate, the gradient between it and the device."""
    vector, found = run.reference.kind == "vector", list[DeclaredError]()
    if run.reference.kind == "none":
        return found
    axes = "xyz" if vector else " "
    for source, u, unit, by in conditions.zeros(run):
        for number, axis in enumerate(axes):
            change = partial(conditions.with_zero, by=by, axis=number)
            found.append(DeclaredError(f"{source} {axis}".strip(), u, unit, change))
    for source, u, unit, by in conditions.factors(run):
        found.append(DeclaredError(source, u, unit, partial(conditions.with_factors, by=by)))
    return found


def _of_the_mounting(run: Run) -> list[DeclaredError]:
    found = list[DeclaredError]()
    for where, stated, turned in (
        ("body", [s.u_axis_body_deg for s in run.segments], _turned_in_body),
        ("cage", [s.u_axis_cage_deg for s in run.segments], _turned_in_cage),
    ):
        known = np.array([u for u in stated if u])
        if not len(known):
            continue
        typical = float(np.sqrt(np.mean(known**2)))
        sizes = np.radians([typical if u is None else u for u in stated])
        for name, turn in _turns():
            change = partial(turned, turn=turn, sizes=sizes)
            source = f"rotation axes in the {where} about {name}"
            found.append(DeclaredError(source, typical, "deg", change, each_mounting=where == "body"))
    return found


def _of_the_clocks(run: Run) -> list[DeclaredError]:
    shared = run.reference.u_time_s or 0.0
    late_s = np.array([s.u_time_s or shared for s in run.segments])[run.segment_index]
    if not (late_s > 0).any():
        return []
    return [DeclaredError("time", float(np.sqrt(np.mean(late_s**2))), "s", partial(_delayed, late_s=late_s))]


def _turns() -> list[tuple[str, Array]]:
    return list(zip("xyz", np.eye(3), strict=True))


def _scaled(run: Run, times: float = 1.0, *, ppm: float) -> Run:
    by = 1 + 1e-6 * ppm * times
    if run.reference_vector is not None:
        run = replace(run, reference_vector=run.reference_vector * by)
    return run if run.reference_magnitude is None else replace(run, reference_magnitude=run.reference_magnitude * by)


def _offset(run: Run, times: float = 1.0, *, by: Array) -> Run:
    if run.reference_vector is not None:
        return replace(run, reference_vector=run.reference_vector + times * by)
    assert run.reference_magnitude is not None
    return replace(run, reference_magnitude=run.reference_magnitude + times * by)


def _aligned(run: Run, times: float = 1.0, *, by: Array) -> Run:
    return _reference_turned(run, times * by)


def _reference_turned(run: Run, by: Array, rows: NDArray[np.bool_] | slice = slice(None)) -> Run:
    """The reference (n, 3) of some rows turned by the rotation vector `by` [rad]."""
    if run.reference_vector is None:
        return run
    vector = run.reference_vector.copy()
    vector[rows] = vector[rows] @ rotation_vector(by).T
    return replace(run, reference_vector=vector)


def _turned_in_body(run: Run, times: float = 1.0, *, turn: Array, sizes: Array) -> Run:
    """Axes and attitudes of every segment turned in the body, each by its own size [rad]."""
    segments = list[Segment]()
    for index, (segment, size) in enumerate(zip(run.segments, times * sizes, strict=True)):
        R = rotation_vector(size * turn)
        if segment.axis_body is not None:
            segment = replace(segment, axis_body=_vector(R @ np.asarray(segment.axis_body)))
        if segment.body_from_cage is not None:
            x, y, z = map(_vector, R @ np.asarray(segment.body_from_cage))
            segment = replace(segment, body_from_cage=(x, y, z))
        if segment.reference_frame == "body":
            run = _reference_turned(run, size * turn, run.segment_index == index)
        segments.append(segment)
    return replace(run, segments=tuple(segments))


def _turned_in_cage(run: Run, times: float = 1.0, *, turn: Array, sizes: Array) -> Run:
    """The platform's axis turned in the cage: to it the reference seems turned the other way."""
    for index, (segment, size) in enumerate(zip(run.segments, times * sizes, strict=True)):
        if segment.reference_frame == "cage":
            run = _reference_turned(run, -size * turn, run.segment_index == index)
    return run


def _vector(v: Array) -> tuple[float, float, float]:
    x, y, z = v.tolist()
    return x, y, z


def _delayed(run: Run, times: float = 1.0, *, late_s: Array) -> Run:
    """Reference and angle as they were `late_s` (n,) later; where a neighbour is missing they stay."""
    vector, magnitude, angle = run.reference_vector, run.reference_magnitude, run.angle_deg
    late_s = times * late_s
    return replace(
        run,
        reference_vector=None if vector is None else vector + late_s[:, None] * _rate(run, vector),
        reference_magnitude=None if magnitude is None else magnitude + late_s * _rate(run, magnitude),
        angle_deg=None if angle is None else angle + late_s * _rate(run, angle, unwrapped=True),
    )


def _rate(run: Run, values: Array, *, unwrapped: bool = False) -> Array:
    """Change per second of `values` (n, …) within each segment; zero where it is not known."""
    out = np.zeros_like(values)
    for index in range(len(run.segments)):
        rows = run.rows(index)
        if len(rows) > 1:
            part = np.unwrap(values[rows], period=360.0) if unwrapped else values[rows]
            with np.errstate(all="ignore"):
                rate = np.gradient(part, run.t_s[rows], axis=0)
            out[rows] = np.where(np.isfinite(rate), rate, 0.0)
    return out

"""The rows that the loop works on, and the base model fitted to them."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from labcal.errors import InputError
from labcal.fit.vector.identifiability import Identifiability, identify
from labcal.fit.vector.ml import MaximumLikelihood, estimate
from labcal.fit.vector.observations import AXIS, SCALAR, VECTOR, Observations, observe
from labcal.fit.vector.solve import LEAST_SQUARES, ParameterisationName, Solution, solve
from labcal.fit.vector.system import Noise, evaluate
from labcal.loop import policy
from labcal.loop.data.linear_problem import Base
from labcal.loop.data.resolution import rounding_noise
from labcal.record import Run, Segment

Array = NDArray[np.float64]
MIN_ROWS = 30  # fewer usable rows than this are refused
ITERATIONS = 30  # of the fit without robust weights, at most


def select_rows(run: Run) -> tuple[Run, Observations]:
    """The rows that the loop works on: vectors where most rows offer them, else axes, or magnitudes.

    Raises InputError where there are too few.
    """
    if run.reference.kind == "none":
        raise InputError(f"run {run.run_id} has no reference: there is no residual to explain")
    try:
        seen = observe(run)
    except ValueError as error:
        raise InputError(f"run {run.run_id}: {error}") from None
    vector = seen.kind == VECTOR
    if 2 * vector.sum() >= len(seen):
        rows = seen.rows[vector]
        cut = run.select(rows)
        seen = observe(cut)
    elif vector.any():
        cut = along_axes(run.select(seen.rows))
        seen = observe(cut)
        if bool((seen.kind == VECTOR).any()) or 2 * (seen.kind == AXIS).sum() < len(seen):
            cut = run.select(seen.rows)
            seen = observe(cut, as_scalar=True)
    else:
        cut = run.select(seen.rows)
        seen = observe(cut)
    if len(seen) < MIN_ROWS:
        raise InputError(f"run {run.run_id} has {len(seen)} rows with a reading and a reference; {MIN_ROWS} are needed")
    return cut, seen


def along_axes(run: Run) -> Run:
    """The run without its angles, where a segment at rest that knows its attitude offers one axis, as those turned do.

    The rows of one run have to offer equally many numbers here; the frame is known from axes as well.
    """
    segments = tuple(
        _along_an_axis(s) if s.kind == "static" and s.reference_frame == "cage" else s for s in run.segments
    )
    return replace(run, segments=segments, angle_deg=None)


def _along_an_axis(segment: Segment) -> Segment:
    """A segment at rest as one that turns about its axis, or, where only its attitude is stated, about the cage's z."""
    if segment.body_from_cage is None:
        return segment
    cage, body = segment.axis_cage, segment.axis_body
    if cage is None or body is None:
        x, y, z = (row[2] for row in segment.body_from_cage)
        cage, body = (0.0, 0.0, 1.0), (x, y, z)
    return replace(segment, kind="rotation", axis_cage=cage, axis_body=body, body_from_cage=None)


def declared_noise(run: Run) -> float:
    """Noise of one axis of one reading with its rounding [DUT units]; where none is declared a thousandth of it."""
    if run.dut.noise_nT:
        return float(np.hypot(run.dut.noise_nT / run.dut.nominal_nT_per_unit, rounding_noise(run)))
    return 1e-3 * float(np.sqrt(np.mean(run.reading**2)))


def noise_model(run: Run, seen: Observations) -> Noise:
    """The declared noise of reading, reference, angle and time."""
    angle = np.array([np.radians(s.angle_noise_deg or 0.0) for s in run.segments])[run.segment_index]
    time = np.array([s.u_time_s or 0.0 for s in run.segments])[run.segment_index]
    return Noise(declared_noise(run), run.reference.noise_nT or 0.0, angle, time)


def fit_base(run: Run, seen: Observations) -> tuple[Base, MaximumLikelihood]:
    """The largest base that the run determines, fitted robustly. Raises InputError where not even an offset is."""
    scalar = bool((seen.kind == SCALAR).all())
    full: ParameterisationName = "symmetric" if scalar else "affine"
    names: tuple[tuple[Base, ParameterisationName], ...] = (
        ("affine", full),
        ("gain-offset", "gain-offset"),
        ("offset", "offset"),
    )
    why = ""
    for base, name in names:
        with np.errstate(all="ignore"):
            try:
                found = estimate(run, parameterisation=name, as_scalar=scalar)
            except (ValueError, np.linalg.LinAlgError) as error:
                why = str(error)
                continue
        if is_determined(found, base) or (
            scalar and is_determined(replace(found, identified=determined_by_geometry(found)), base)
        ):
            return base, found
        why = found.identified.why_not or why
    raise InputError(f"run {run.run_id} does not even determine an offset: {why}")


def is_determined(found: MaximumLikelihood, base: Base) -> bool:
    """Whether the run determines it closely enough; of an offset alone nothing more is asked."""
    field = float(found.observations.magnitude.max())
    loose = found.identified.worst_u_nT >= policy.POLICY.max_field_uncertainty * field
    return found.identified.why_not is None and (base == "offset" or not loose)


def determined_by_geometry(found: MaximumLikelihood) -> Identifiability:
    """What these readings would determine if the fitted map were true: a strong effect is no lack of excitation."""
    start = found.solution
    field = evaluate(found.observations, found.noise, start.theta, start.phase).field
    seen = replace(found.observations, magnitude=np.linalg.norm(field, axis=1))
    exact = solve(seen, found.noise, found.parameterisation, start.theta, start.phase, LEAST_SQUARES)
    return identify(seen, found.noise, found.parameterisation, exact, LEAST_SQUARES)


def least_squares(seen: Observations, noise: Noise, near: MaximumLikelihood) -> Solution:
    """The base fit without robust weights, once outliers are set aside."""
    start = near.solution
    return solve(seen, noise, near.parameterisation, start.theta, start.phase, LEAST_SQUARES, iterations=ITERATIONS)

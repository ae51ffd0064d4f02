"""The noise floor: the rms that noise alone would leave, and where it is known from."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from labcal.fit.vector.system import Noise
from labcal.loop import policy
from labcal.loop.data.linear_problem import LinearProblem, linearise
from labcal.loop.data.outliers import hampel_outliers
from labcal.loop.data.resolution import ROUNDING, rounding_noise
from labcal.loop.noise.differences import white_level
from labcal.model.effects import Scene
from labcal.model.effects.regressors import stretches

Array = NDArray[np.float64]
Source = Literal["declared", "static", "differences"]
MIN_STEPS_PER_ROW = 3.0  # steps of the encoder between two rows
ANGLE_DECIMALS = 6  # of a degree, below which changes of the angle are the same
MIN_CHANGING = 0.1  # of the rows: fewer changes are the beginnings and ends of motions
STEP_TOLERANCE = 0.1  # of a step, that a change may be off a multiple of it
ROWS_EACH = 10  # of a static stretch, for each number that is fitted to it


@dataclass(frozen=True, slots=True)
class NoiseFloor:
    """The noise floor [nT], its source, and the ratio of measured to declared noise where both are known.

    Of a noise that is not stated also for how long it remembers itself, where that is known to be in the floor.
    """

    nT: float
    source: Source
    measured_over_declared: float | None
    memory_s: float | None = None


def noise_floor(problem: LinearProblem) -> tuple[LinearProblem, NoiseFloor]:
    """The problem whitened by the actual noise, and its floor: declared, else static stretches, else differences."""
    level, source = static_noise(problem), "static"
    if level is None:
        rounding = rounding_noise(problem.run) / problem.noise.reading
        level, source = white_level(problem.y, problem.scene.segment, rounding), "differences"
    if problem.run.dut.noise_nT:
        ratio = level if source == "static" else None
        return problem, NoiseFloor(_expected_rms(problem), "declared", ratio)
    noise, p = _reading_noise_of(problem, max(level, 1e-6)), problem
    problem = linearise(p.run, p.observations, noise, p.base, p.parameterisation, p.theta, p.phase)
    return problem, NoiseFloor(_expected_rms(problem), "static" if source == "static" else "differences", None)


def _reading_noise_of(problem: LinearProblem, level: float) -> Noise:
    """The noise whose whitened residual has level one where that of the problem's has `level`.

    What the run declares of reference, angle and time stays as it is: the rest of what is seen is the reading's. It is
    taken to be a material part at least, for none of them is declared more closely, and no less than their rounding:
    of readings in steps coarser than the noise most are like their neighbours.
    """
    whole, own = _variances(problem)
    seen = level**2 * whole
    of_readings = max(seen - (whole - own), policy.POLICY.material_share * seen)
    found = problem.noise.reading * float(np.sqrt(of_readings / own))
    return replace(problem.noise, reading=max(found, rounding_noise(problem.run)))


def noise_beside_readings(problem: LinearProblem) -> float:
    """What reference, angle and time add to the noise of what the reported rms is over [nT]: no noise of the device."""
    whole, own = _variances(problem)
    return float(np.sqrt(max(whole - own, 0.0)))


def _expected_rms(problem: LinearProblem) -> float:
    """Contract: sqrt(tr C + quantisation), its projection for magnitudes, times sqrt(1 + p / n)."""
    return float(np.sqrt(_variances(problem)[0] * (1 + problem.T.shape[2] / problem.y.size)))


def _variances(problem: LinearProblem) -> tuple[float, float]:
    """Of what the reported rms is over [nT²]: the noise of a row, and the part of it that is the readings' own."""
    W, K = problem.whiten, problem.affine.K
    of_readings = K @ problem.noise.covariance(1.0) @ K.T
    if problem.kind == "vector":
        whole = float(np.mean(np.sum(np.linalg.inv(W) ** 2, axis=(1, 2)))) + _angle_step(problem)
        return whole, float(np.trace(of_readings))
    size = np.linalg.norm(W[:, 0], axis=1)
    along = W[:, 0] / size[:, None]
    return float(np.mean(size**-2)), float(np.mean(np.sum(along @ of_readings * along, axis=1)))


def _angle_step(problem: LinearProblem) -> float:
    """Variance [nT²] of the field across the axis from the angle's rounding.

    Rounding lets the motion between rows change by whole steps within a segment; the smallest such change is the step
    where the motion itself is several times that. Where a motion begins and ends it changes without any rounding.
    """
    rig, angle = problem.scene.rig, problem.run.angle_deg
    if rig is None or angle is None or not np.isfinite(rig.angle_rad).any():
        return 0.0
    turning = np.isfinite(rig.angle_rad)
    segment, turned = problem.scene.segment[turning], np.unwrap(angle[turning], period=360.0)
    inside = segment[4:] == segment[:-4]
    changes = np.abs(np.round(np.diff(turned, 2)[1:-1][inside], ANGLE_DECIMALS))
    step = float(changes[changes > 0].min(initial=np.inf))
    if (
        np.count_nonzero(changes) < MIN_CHANGING * len(changes)
        or not np.isfinite(step)
        or step * MIN_STEPS_PER_ROW > np.median(np.abs(np.diff(turned)))
    ):
        return 0.0
    if np.median(np.abs(changes / step - np.round(changes / step))) > STEP_TOLERANCE:
        return 0.0
    across = np.cross(np.nan_to_num(rig.axis_body), rig.prediction_nT)
    return float(np.mean(np.sum(across**2, axis=1)) * np.radians(step) ** 2 / ROUNDING)


def static_noise(problem: LinearProblem) -> float | None:
    """Spread of the residual in segments whose field stands still; None without any.

    Counted about what follows a channel or the power mode there: a load that is switched at rest is no noise. Nor are
    wild readings.
    """
    square, free = 0.0, 0
    good = ~hampel_outliers(problem.y, problem.scene.segment)
    for part in stretches(problem.scene.segment):
        field = problem.scene.field_nT[part]
        still = float(field.std(axis=0).max()) < policy.POLICY.still_share * float(np.linalg.norm(field.mean(axis=0)))
        known = _regressors_at_rest(problem.scene, part)
        if still and len(field) > ROWS_EACH * known.shape[1]:
            y, known = problem.y[part][good[part]], known[good[part]]
            found, _, rank, _ = np.linalg.lstsq(known, y, rcond=1e-9)
            square += float(np.sum((y - known @ found) ** 2))
            free += (len(y) - int(rank)) * y.shape[1]
    return float(np.sqrt(square / free)) if free else None


def _regressors_at_rest(scene: Scene, part: slice) -> Array:
    """Regressors of the residual in a stretch at rest (n, columns): a constant, and channels and modes that change."""
    drives = [values[part] for values in scene.channels.values()]
    if scene.mode is not None:
        drives += [(scene.mode[part] == mode).astype(float) for mode in np.unique(scene.mode[part])[1:]]
    moving = [(x - x.mean()) / x.std() for x in drives if x.std() > 0]
    return np.column_stack([np.ones(part.stop - part.start), *moving])

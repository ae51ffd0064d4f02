"""Tests of a residual for structure, each a statistic with its significance and a sentence.

White from row to row (Ljung & Box, Biometrika 65, 1978), independent of every channel, angle, field and of time
(cross-correlation, its band by Bartlett's formula from both autocorrelations), and no worse than its own repeats.
Every significance level is corrected for multiplicity (Bonferroni).
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.special import chdtrc, fdtrc, ndtr

from labcal.loop import policy
from labcal.loop.data.linear_problem import LinearProblem
from labcal.loop.noise.autocorrelation import LAGS, ljung_box, predictable_share
from labcal.loop.noise.cross_correlation import MAX_LAG, Series, cross_correlation
from labcal.loop.result import ResidualTest
from labcal.model.effects.regressors import stretches
from labcal.model.gaps import bridged

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]
MIN_ROWS = 3 * LAGS  # rows of a segment that an autocorrelation needs
CELLS = 24  # directions that count as one condition each,
SIZES = 1.3  # with the magnitudes within this factor
SPIRAL = 1 + np.sqrt(5)  # twice the golden ratio: half turns from one direction to the next spread them evenly
MIN_VISITS = 2  # visits of a condition before it is a repeat


def residual_tests(problem: LinearProblem, good: Mask) -> tuple[ResidualTest, ...]:
    """The tests of a whitened residual over the valid rows `good`."""
    y = np.where(good[:, None], problem.y, 0.0)
    return (whiteness_test(problem, y), *independence_tests(problem, y), *lack_of_fit_test(problem, good))


def rows_per_sample(problem: LinearProblem) -> int:
    """Rows for each independent sample: where the reference is slower than the device, several rows share one."""
    ref = problem.run.reference_vector
    if ref is None or not problem.noise.reference_nT:
        return 1
    bends = np.abs(np.diff(ref, 2, axis=0)).max(axis=1)
    moving = float(np.max(bends)) if len(bends) else 0.0
    kinks = int((bends > 1e-6 * max(moving, 1e-9)).sum())
    return max(1, round(len(ref) / max(kinks, 1))) if moving > 0 and kinks >= MIN_ROWS else 1


def whiteness_test(problem: LinearProblem, y: Array) -> ResidualTest:
    """Ljung and Box in each segment, the worst of them, at every independent sample."""
    step, worst, trials = rows_per_sample(problem), (1.0, 0.0, "", 0.0), 0
    for rows in stretches(problem.scene.segment):
        part = y[rows][::step]
        if len(part) < MIN_ROWS:
            continue
        trials += 1
        q = ljung_box(part)
        p = float(chdtrc(LAGS * part.shape[1], q))
        name = problem.run.segments[int(problem.scene.segment[rows][0])].id
        worst = min(worst, (p, q, name, predictable_share(part)))
    p, q, name = min(1.0, trials * worst[0]), worst[1], worst[2]
    share = worst[3]
    passes = p >= policy.POLICY.significance or share < policy.POLICY.material_share
    says = "white from row to row" if passes else f"follows itself from row to row, most in segment {name}"
    return ResidualTest("whiteness", name, q, p, share, passes, says)


def independence_tests(problem: LinearProblem, y: Array) -> Iterator[ResidualTest]:
    """One test for each drive: its largest cross-correlation with a component of y at any lag."""
    own = [Series.of(part) for part in y.T]
    for name, drive in covariates(problem).items():
        other = Series.of(drive)
        z, r = max(cross_correlation(part, other) for part in own)
        trials = y.shape[1] * (2 * MAX_LAG + 1)
        p = min(1.0, trials * 2 * float(ndtr(-z)))
        share = r**2
        passes = p >= policy.POLICY.significance or share < policy.POLICY.material_share
        says = f"independent of {name}" if passes else f"goes with {name} (correlation {r:+.2f})"
        yield ResidualTest("independence", name, r, p, share, passes, says)


def covariates(problem: LinearProblem) -> Mapping[str, Array]:
    """Covariates of a residual, by name: (n,) each, over the problem's rows."""
    scene = problem.scene
    found = {"time": scene.t_s - scene.t_s.mean()}
    for axis, values in zip("xyz", reference_field(problem).T, strict=True):
        found[f"the field along {axis}"] = values
    found["the field's magnitude"] = problem.observations.magnitude
    if scene.rig is not None and np.isfinite(scene.rig.angle_rad).any():
        angle = np.nan_to_num(scene.rig.angle_rad)
        found |= {"the angle's sine": np.sin(angle), "the angle's cosine": np.cos(angle)}
    for channel in problem.run.channels:
        if np.isfinite(channel.values).any():
            found[channel.name] = bridged(problem.run.t_s, channel.values)[0]
    return {name: values for name, values in found.items() if float(np.std(values)) > 0}


def reference_field(problem: LinearProblem) -> Array:
    """The field (n, 3) [nT, B] by the reference where it is a vector: the reading's holds the residual's own noise."""
    rig = problem.scene.rig
    return problem.scene.field_nT if rig is None else rig.prediction_nT


def lack_of_fit_test(problem: LinearProblem, good: Mask) -> Iterator[ResidualTest]:
    """Lack of fit: the means of conditions that were visited repeatedly, against the spread between visits."""
    visits = _visits(problem, good)
    repeated = [np.array(v) for v in visits.values() if len(v) > MIN_VISITS]
    if len(repeated) < 3:
        return
    within = sum(float(np.sum((v - v.mean(axis=0)) ** 2)) for v in repeated)
    between = sum(len(v) * float(np.sum(v.mean(axis=0) ** 2)) for v in repeated)
    q = repeated[0].shape[1]
    free = q * sum(len(v) - 1 for v in repeated), q * len(repeated)
    ratio = (between / free[1]) / max(within / free[0], 1e-300)
    p = float(fdtrc(free[1], free[0], ratio))
    share = max(between - free[1], 0.0) / float(np.sum(problem.y[good] ** 2))
    passes = p >= policy.POLICY.significance or share < policy.POLICY.material_share
    says = (
        "no lack of fit against repeats"
        if passes
        else (f"comes again wherever the field is the same ({100 * share:.0f} % of its square)")
    )
    yield ResidualTest("lack-of-fit", "repeated conditions", ratio, p, share, passes, says)


@dataclass(frozen=True, slots=True)
class _Cell:
    """Where a field points and how large it is."""

    direction: int
    size: int


def _visits(problem: LinearProblem, good: Mask) -> dict[_Cell, list[Array]]:
    """Means of y over each stay in a cell of directions and magnitudes, times the root of its rows."""
    b = reference_field(problem)
    i = np.arange(CELLS) + 0.5
    z, turn = 1 - 2 * i / CELLS, np.pi * SPIRAL * i
    centres = np.column_stack([np.sqrt(1 - z**2) * np.cos(turn), np.sqrt(1 - z**2) * np.sin(turn), z])
    direction = np.argmax(b @ centres.T, axis=1)
    magnitude = np.round(np.log(np.maximum(problem.observations.magnitude, 1.0)) / np.log(SIZES)).astype(np.intp)
    key = (direction * (magnitude.max() + 1) + magnitude) * (problem.scene.segment.max() + 1) + problem.scene.segment
    found: dict[_Cell, list[Array]] = {}
    for rows in stretches(key):
        kept = problem.y[rows][good[rows]]
        if len(kept) > 1:
            cell = _Cell(int(direction[rows][0]), int(magnitude[rows][0]))
            found.setdefault(cell, []).append(kept.sum(axis=0) / np.sqrt(len(kept)))
    return found

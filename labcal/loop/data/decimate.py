"""Decimation for the search: means of consecutive rows of one segment, times the root of their number.

Everything in the search is linear in rows, so that a bin's y, T and columns fit together as those of a row do, and
white noise keeps its variance. What is reported (held-out and in-sample errors, the final fit) is about all rows.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from labcal.loop import policy
from labcal.loop.data.linear_problem import Bins, LinearProblem
from labcal.loop.noise.periodogram import periodogram, running_median
from labcal.model.effects.regressors import stretches

Array = NDArray[np.float64]
TARGET_ROWS = 6000  # rows after decimation, about
MAX_TURN_RAD = 0.35  # rad that the field may turn within a bin,
USUAL_TURN = 90  # percentile of its turns from row to row: single jumps are none
LINE_CONTRAST = 15.0  # times its neighbourhood: a line in the spectrum that is not chance,


def decimate(problem: LinearProblem) -> LinearProblem:
    """The problem with about TARGET_ROWS rows; itself where it has hardly more, or where what is fast would be lost."""
    m = rows_per_bin(problem)
    if m == 1:
        return problem
    bins = _bins(problem, m)
    scene = problem.scene.select(bins.start)
    scene = replace(scene, t_s=np.add.reduceat(problem.scene.t_s, bins.start) / bins.count)
    y, T, whiten = (bins.averaged(part) for part in (problem.y, problem.T, problem.whiten))
    return replace(problem, scene=scene, y=y, T=T, whiten=whiten, bins=bins, whole=problem)


def rows_per_bin(problem: LinearProblem) -> int:
    """How many rows go together: few enough for the field's turning, and for any line in the residual's spectrum."""
    field = problem.scene.field_nT / np.linalg.norm(problem.scene.field_nT, axis=1)[:, None]
    turn = np.linalg.norm(np.diff(field, axis=0), axis=1)
    turn = turn[np.diff(problem.scene.segment) == 0]
    fastest = float(np.percentile(turn, USUAL_TURN)) if len(turn) else 0.0
    m = min(round(len(problem) / TARGET_ROWS), int(MAX_TURN_RAD / max(fastest, 1e-9)))
    if m < 2:
        return 1
    rig = problem.scene.rig
    frames = [problem.y] if rig is None else [problem.y, np.einsum("nji,nj->ni", rig.to_body, problem.y)]
    return 1 if any(_has_fast_line(problem.scene.t_s, y, m) for y in frames) else m


def _has_fast_line(t_s: Array, y: Array, m: int) -> bool:
    """Whether a whitened residual (n, q) has a line that bins of m rows would lose."""
    frequency, power = periodogram(t_s, y)
    share = 2 * power / (len(y) * y.size)
    lines = frequency[(power > LINE_CONTRAST * running_median(power)) & (share > policy.POLICY.material_share)]
    return bool((lines > 0.5 * frequency[-1] / m).any())


def _bins(problem: LinearProblem, m: int) -> Bins:
    start = np.concatenate([np.arange(part.start, part.stop, m) for part in stretches(problem.scene.segment)])
    count = np.diff(np.append(start, len(problem)))
    return Bins(start, count)

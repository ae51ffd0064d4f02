"""Plausibility of a recording's rows, from the readings alone: saturated, or an outlier among its neighbours."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from labcal.model.calibration import Calibration
from labcal.model.effects.set_aside import beyond_limits, limits_of, saturation_record
from labcal.model.records import EffectRecord, Parameter

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]
PLATEAU = 3  # rows in a row at one extreme value, while the other axes move
MOVES = 1e-3  # of the largest reading: what counts as moving
NORMAL, SECOND = 1.4826, 6.0  # standard deviation over median absolute deviation; variance of a second difference
TURNS_WITHIN = 10.0  # steps of a reading
OUT_OF_LINE = 10.0  # standard deviations from the line through the neighbours


def saturation_limits(reading: Array, unit: str) -> EffectRecord | None:
    """The finding `saturation` of a run's readings (n, 3): the values that an axis stops at; None where it never does.

    Its parameters are `upper_x`, `lower_x` …, in the DUT's unit.
    """
    limits = []
    for axis, name in enumerate("xyz"):
        stuck = np.unique(reading[_plateau(reading, axis), axis])
        for side, extreme in (("lower", np.nanmin), ("upper", np.nanmax)):
            if (end := float(extreme(reading[:, axis]))) in stuck:
                limits.append(Parameter(f"{side}_{name}", end, 0.0, unit))
    return saturation_record(limits) if limits else None


def stated_limits(calibration: Calibration) -> list[tuple[int, str, float]]:
    """Where the calibration says that readings stop: the axis, ">=" or "<=", and the value in the DUT's unit."""
    return limits_of(calibration.findings)


def saturated(calibration: Calibration, reading: Array) -> Mask:
    """Rows (n,) beyond the limits of the calibration's finding `saturation`, or on a plateau at an axis' extreme."""
    out = beyond_limits(calibration.findings, reading)
    for axis in range(3):
        out |= _plateau(reading, axis)
    return out


def _plateau(reading: Array, axis: int) -> Mask:
    """Runs of at least PLATEAU rows at the column's largest or smallest value while another axis moves.

    Not by its noise; nor where the column turns there within one step of its own: rounded, it stands for a while.
    """
    column, out = reading[:, axis], np.zeros(len(reading), dtype=bool)
    if not np.isfinite(column).any():
        return out
    others, step = [other for other in range(3) if other != axis], _least_step(column)
    scatter = np.array([_scatter(reading[:, other]) for other in others])
    moves = np.maximum(MOVES * max(np.nanmax(reading), -np.nanmin(reading)), OUT_OF_LINE * scatter)
    for extreme in (np.nanmax(column), np.nanmin(column)):
        at = np.r_[False, column == extreme, False]
        for start, stop in zip(np.flatnonzero(~at[:-1] & at[1:]), np.flatnonzero(at[:-1] & ~at[1:]), strict=True):
            moved = bool((np.ptp(reading[start:stop, others], axis=0) > moves).any())
            if stop - start >= PLATEAU and moved and not _is_rounded(column, int(start), int(stop), step):
                out[start:stop] = True
    return out


def _least_step(column: Array) -> float:
    """The least difference between two values of a column (n,); inf where all are alike."""
    values = column[np.isfinite(column)]
    values.sort()
    steps = np.diff(values)
    return float(steps[steps > 0].min(initial=np.inf))


def _scatter(column: Array) -> float:
    """Standard deviation of a column (n,) from row to row, by the median of its second differences."""
    second = np.diff(column, 2)
    second = np.abs(second[np.isfinite(second)])
    return NORMAL * float(np.median(second, overwrite_input=True)) / float(np.sqrt(SECOND)) if len(second) else 0.0


def _is_rounded(column: Array, start: int, stop: int, step: float) -> bool:
    """Whether rows from `start` to `stop` stand at an extreme as a smooth course does that turns within one step.

    A parabola that stays within a step over so many rows is nine steps lower as many rows farther on; one more is
    the rounding there. What runs into the end of a range comes from farther.
    """
    beside = [row for row in (2 * start - stop, 2 * stop - start - 1) if 0 <= row < len(column)]
    return bool(beside) and bool((np.abs(column[beside] - column[start]) <= TURNS_WITHIN * step).all())


def bends(field_nT: Array) -> Array:
    """How far [nT] each row but the first and the last of a field (n, 3) is from the line through its neighbours."""
    between = (field_nT[:-2] + field_nT[2:]) / 2
    return np.asarray(np.nan_to_num(np.linalg.norm(field_nT[1:-1] - between, axis=1)))


def second_difference_outliers(bend: Array, segment: NDArray[Any] | None, noise_nT: float) -> Mask:
    """Rows (n,) far from the line through their two neighbours, and further than those from theirs: by their `bends`.

    Second differences of the field itself: a recording has no reference, so no residual, and its field moves. Where a
    residual is known, the loop compares with the median of the neighbours instead (`labcal.loop.data.outliers`).

    The spread is the recording's own (median), never below the noise. A step of the field makes two rows alike and
    is no outlier, nor is a corner of its course, which lies on the line through the two rows before or the two after;
    the ends of a segment have one neighbour and are never flagged. `bend` is 0 at the recording's ends.
    """
    if len(bend) < 5:
        return np.zeros(len(bend), dtype=bool)
    ends = np.zeros(len(bend), dtype=bool)
    ends[[0, -1]] = True
    if segment is not None:
        change = segment[1:] != segment[:-1]
        ends[1:] |= change
        ends[:-1] |= change
    bend[ends] = 0.0
    limit = OUT_OF_LINE * max(float(np.median(bend[bend > 0])) if (bend > 0).any() else 0.0, noise_nT, 1e-9)
    out, rows = np.zeros(len(bend), dtype=bool), np.flatnonzero(bend > limit)  # never the first row nor the last
    known = np.where(ends, np.inf, bend)
    from_lines = 2 * np.minimum(known[rows - 1], known[rows + 1])  # through the two rows before, and the two after
    out[rows] = (bend[rows] > 1.5 * np.maximum(bend[rows - 1], bend[rows + 1])) & (from_lines > limit)
    return out

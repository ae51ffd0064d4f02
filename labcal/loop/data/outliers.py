"""Rows without information about the sensor: readings far from their neighbours, single or in bursts."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from labcal.loop import policy
from labcal.loop.noise.differences import SIGMA_PER_MAD
from labcal.model.effects.regressors import stretches

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]
WINDOW = 4  # neighbours on either side
LONGEST_OUTLIER = WINDOW // 2  # rows in a row: of more the median of the neighbours is no measure
WIDE_WINDOW = 12  # neighbours on either side of a burst
LONGEST_BURST = WIDE_WINDOW  # rows in a row: of more, half of a row's neighbours would be wild


def hampel_outliers(residual: Array, segment: NDArray[np.intp], effects: Array | None = None) -> Mask:
    """Rows (n,) whose whitened residual (n, q) is far from the median of its neighbours (Hampel's identifier).

    A residual stands still where the model is right, so the median serves; the field itself, which `apply` has to judge
    by, moves, and is compared with the line through two neighbours (`labcal.model.plausibility`).

    Where the accepted `effects` (n, q) themselves jump, as a switched current does, a row between the levels is none.
    Stretches of a few rows count where their readings are as far from each other: a level that holds is a process.
    Wild neighbours hide a row between them: what is near one is judged again without them.
    """
    jump = 0.0 if effects is None else _local_span(effects)
    away, limit = _from_neighbours(residual, segment, WINDOW)
    far = np.asarray((np.abs(away) > limit + jump).any(axis=1))
    out = np.asarray((far & ~_in_long_runs(far, LONGEST_OUTLIER)) | _bursts(residual, segment, jump))
    return out | _between(residual, segment, jump, out)


def _between(residual: Array, segment: NDArray[np.intp], jump: Array | float, wild: Mask) -> Mask:
    """Rows (n,) that are far from those of their neighbours that are not `wild`, where at least half are not; few."""
    if not wild.any():
        return wild
    away, limit = _from_neighbours(np.where(wild[:, None], np.nan, residual), segment, WINDOW, residual)
    hidden = ~wild & (np.abs(away) > limit + jump).any(axis=1) & (_near(wild, segment) <= WINDOW)
    hidden &= ~_in_long_runs(hidden | wild, LONGEST_BURST)
    return hidden if np.mean(hidden | wild) <= policy.POLICY.max_outlier_share else np.zeros_like(hidden)


def _near(wild: Mask, segment: NDArray[np.intp]) -> NDArray[np.intp]:
    """How many of a row's nearest neighbours are wild (n,)."""
    out = np.zeros(len(wild), dtype=np.intp)
    for part in stretches(segment):
        if (rows := part.stop - part.start) > 2 * WINDOW:
            out[part] = wild[part][_nearest(rows, 2 * WINDOW)].sum(axis=0)
    return out


def _bursts(residual: Array, segment: NDArray[np.intp], jump: Array | float) -> Mask:
    """Stretches of three rows and more (n,) that are far from their neighbours and from each other; few of all rows.

    Wild neighbours widen a row's limit, and the middle of a burst would pass: it is judged again without them.
    """
    away, limit = _from_neighbours(residual, segment, WIDE_WINDOW)
    far = np.asarray((np.abs(away) > limit + jump).any(axis=1))
    if (wild := far & ~_in_long_runs(far, LONGEST_BURST)).any():
        away, limit = _from_neighbours(np.where(wild[:, None], np.nan, residual), segment, WIDE_WINDOW, residual)
        far |= np.asarray((np.abs(away) > limit + jump).any(axis=1))
    limit = limit + jump
    change = np.max(np.abs(np.diff(residual, axis=0)) / np.maximum(limit[1:], 1e-300), axis=1)
    out = np.zeros_like(far)
    for start, stop in _runs(far):
        several = LONGEST_OUTLIER < stop - start <= LONGEST_BURST
        out[start:stop] = several and bool(np.median(change[start : stop - 1]) > 1)
    return out if out.mean() <= policy.POLICY.max_outlier_share else np.zeros_like(out)


def _from_neighbours(
    neighbours: Array, segment: NDArray[np.intp], window: int, residual: Array | None = None
) -> tuple[Array, Array]:
    """Distance of each row from the median of its neighbours (n, q), and the distance that makes an outlier.

    The rows are those of `residual`, if it is given, and neighbours that are nan do not count.
    """
    away, around = _neighbourhood(neighbours, segment, window, residual)
    spread = SIGMA_PER_MAD * np.median(np.abs(away), axis=0)
    return away, policy.POLICY.outlier_sigmas * np.maximum(np.maximum(spread, 1.0), SIGMA_PER_MAD * around)


def outlier_distance(residual: Array, good: Mask) -> float:
    """The median size of the rows set aside, over the rms of the others; 0 where none is."""
    if good.all():
        return 0.0
    sizes = np.abs(residual).max(axis=1)
    return float(np.median(sizes[~good]) / np.sqrt(np.mean(residual[good] ** 2)))


def _local_span(effects: Array) -> Array:
    """The span of the effects over each row and its two neighbours (n, q)."""
    padded = np.pad(effects, ((1, 1), (0, 0)), mode="edge")
    near = np.stack([padded[:-2], padded[1:-1], padded[2:]])
    return np.asarray(near.max(axis=0) - near.min(axis=0))


def _neighbourhood(
    neighbours: Array, segment: NDArray[np.intp], window: int, residual: Array | None
) -> tuple[Array, Array]:
    """Distance of each row from the median of its neighbours (n, q), and their own median distance from it."""
    away, around = np.zeros_like(neighbours), np.zeros_like(neighbours)
    rows, median = (neighbours, np.median) if residual is None else (residual, _median_of_known)
    for part in stretches(segment):
        y = neighbours[part]
        if len(y) < 2 * window + 1:
            continue
        near = y[_nearest(len(y), 2 * window)]
        middle = median(near, axis=0)
        away[part], around[part] = rows[part] - middle, median(np.abs(near - middle), axis=0)
    return away, around


def _nearest(rows: int, neighbours: int) -> NDArray[np.intp]:
    """The numbers of the nearest rows (neighbours, rows) of each row, itself left out; of one near an end, one-sided.

    Each once: rows that were mirrored at an end would count a burst there twice.
    """
    at = np.arange(rows)
    others = np.clip(at - neighbours // 2, 0, rows - neighbours - 1) + np.arange(neighbours)[:, None]
    return np.asarray(others + (others >= at))


def _median_of_known(values: Array, axis: int) -> Array:
    """The median along an axis without what is nan (nan where all is): `np.nanmedian` masks, at six times the time."""
    in_order = np.sort(values, axis=axis)  # nan goes last
    count = np.sum(~np.isnan(values), axis=axis, keepdims=True)
    low, high = (np.take_along_axis(in_order, np.maximum(k, 0), axis) for k in ((count - 1) // 2, count // 2))
    return np.asarray(np.where(count > 0, (low + high) / 2, np.nan).squeeze(axis))


def _in_long_runs(mask: Mask, longest: int) -> Mask:
    """Members of stretches of more rows than `longest`."""
    out = np.zeros_like(mask)
    for start, stop in _runs(mask):
        out[start:stop] = stop - start > longest
    return out


def _runs(mask: Mask) -> list[tuple[int, int]]:
    """Where stretches of members begin, and where they end."""
    edges = np.flatnonzero(np.diff(np.concatenate([[0], mask.astype(int), [0]]))).tolist()
    return list(zip(edges[::2], edges[1::2], strict=True))

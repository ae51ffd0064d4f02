"""Rows at a device's saturation limit: readings pile up there, and the field goes beyond it."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from labcal.loop import policy
from labcal.loop.data.linear_problem import LinearProblem
from labcal.record import Run

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]
NEIGHBOUR_READINGS = 10  # distinct readings next to an extreme that it is compared with


def at_saturation_limit(run: Run) -> Mask:
    """Rows (n,) with an axis at its saturation limit: a reading that it reaches often and never exceeds.

    Where chance piles up no extreme of the run as high, the others of the same device may be low; an end of any axis
    as far from zero as one that is a limit is one, however few rows reach it.
    """
    ends = [(values, extreme) for values in run.reading.T for extreme in (np.nanmax(values), np.nanmin(values))]
    chances = [_chance_of_pile_up(values, float(extreme)) for values, extreme in ends]
    if min(chances) > policy.POLICY.saturation_significance:
        return np.zeros(len(run), dtype=bool)
    pairs = zip(ends, chances, strict=True)
    limits = {abs(float(extreme)) for (_, extreme), chance in pairs if chance < policy.POLICY.significance}
    return np.asarray(np.any([values == extreme for values, extreme in ends if abs(float(extreme)) in limits], axis=0))


def _chance_of_pile_up(values: Array, extreme: float) -> float:
    """How often as many rows or more would lie at the extreme if it were as frequent as the readings next to it."""
    from scipy.special import pdtrc

    distinct = np.unique(np.abs(values[np.isfinite(values)] - extreme))
    if len(distinct) < 2 * NEIGHBOUR_READINGS:
        return 1.0
    stuck = int((values == extreme).sum())
    near = int((np.abs(values - extreme) <= distinct[NEIGHBOUR_READINGS]).sum()) - stuck
    return float(pdtrc(stuck - 1, (near + 1) / NEIGHBOUR_READINGS))


def beyond_limit(everything: LinearProblem, stuck: Mask) -> Mask:
    """Of the rows `stuck` (n,) at an extreme of an axis those where the field, as the base carries it, goes beyond.

    A field that turns back there, or stands there, piles up coarse readings as well, and then they are as they should
    be. Where one end is a limit, one as far from zero is too, whatever a base that lacks an effect says of it.
    Magnitudes do not tell what an axis would read: of these all are taken.
    """
    if everything.kind != "vector":
        return stuck
    missing = np.asarray(-np.linalg.solve(everything.affine.K, everything.residual_nT.T).T)
    ends = [end for axis in range(3) for end in _ends(everything.run.reading[:, axis], missing[:, axis], stuck)]
    limits = {limit for limit, _, beyond in ends if beyond}
    return np.asarray(np.any([there for limit, there, _ in ends if limit in limits], axis=0)) & stuck


def _ends(values: Array, missing: Array, stuck: Mask) -> Iterator[tuple[float, Mask, bool]]:
    """How far from zero each end of an axis is, the rows `stuck` there, and whether the field goes beyond it."""
    half_step = float(np.diff(np.unique(values)).min(initial=np.inf)) / 2
    for extreme, outward in ((np.nanmax(values), missing), (np.nanmin(values), -missing)):
        there = stuck & (values == extreme)
        if there.any():
            yield abs(float(extreme)), there, float(np.median(outward[there])) > half_step

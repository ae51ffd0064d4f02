"""One travelling standard at several benches: the reference value, and E_n of each (ISO/IEC 17043; ISO 13528).

Without a pilot the reference is the weighted mean of the largest subset that agrees (Cox, Metrologia 39 (2002) 589 and
44 (2007) 187); with one it is the pilot's line through its own measurements, which carries the standard's drift.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.special import chdtrc

from labcal.quality.drift import FEWEST, drift

Array = NDArray[np.float64]
COVERAGE = 2.0
CONSISTENT = 0.05  # probability of a larger χ², below which the results do not agree


@dataclass(frozen=True, slots=True)
class Degree:
    """A measurement beside the reference value at its time: difference, its U (k = 2), E_n; if it counted."""

    bench: str
    value: float
    reference: float
    difference: float
    U: float
    e_n: float | None
    counted: bool


@dataclass(frozen=True, slots=True)
class Intercomparison:
    """All measurements, and whether those in the reference agree: χ², degrees of freedom, probability."""

    degrees: tuple[Degree, ...]
    chi2: float
    dof: int
    p: float
    by: str  # what the reference value is


def compare_benches(
    benches: Sequence[str], values: Array, u: Array, times: Array | None = None, pilot: str | None = None
) -> Intercomparison:
    """Results `values` (n,) with standard `u` (n,) of `benches`, at `times` (n,) where a pilot saw the standard drift.

    Raises ValueError for fewer than two benches, an uncertainty that is not known, a pilot that measured nothing.
    """
    if len(set(benches)) < 2:
        raise ValueError("a comparison needs two benches")
    if not (np.isfinite(u) & (u > 0)).all():
        unknown = [bench for bench, one in zip(benches, u, strict=True) if not one > 0]
        raise ValueError(f"{unknown[0]} states no uncertainty" if unknown else "an uncertainty is no number")
    if pilot is not None and pilot not in benches:
        raise ValueError(f"the pilot {pilot} measured nothing: {', '.join(sorted(set(benches)))} did")
    return _by_mean(benches, values, u) if pilot is None else _by_pilot(benches, values, u, times, pilot)


def _by_mean(benches: Sequence[str], values: Array, u: Array) -> Intercomparison:
    counted = np.ones(len(values), dtype=bool)
    while True:
        weight = counted / u**2
        mean, variance = float(weight @ values / weight.sum()), 1 / float(weight.sum())
        off = (values - mean) ** 2 * weight
        dof = int(counted.sum()) - 1
        p = float(chdtrc(dof, off.sum())) if dof else 1.0
        if p >= CONSISTENT or dof < 2:
            break
        counted[int(np.argmax(off))] = False
    u_of = np.sqrt(np.maximum(u**2 + np.where(counted, -variance, variance), 0.0))
    left_out = ", without those that disagree" if not counted.all() else ""
    degrees = _degrees(benches, values, np.full(len(values), mean), u_of, counted)
    return Intercomparison(degrees, float(off.sum()), dof, p, f"weighted mean{left_out}")


def _by_pilot(benches: Sequence[str], values: Array, u: Array, times: Array | None, pilot: str) -> Intercomparison:
    own = np.array([bench == pilot for bench in benches])
    when = np.zeros(len(values)) if times is None else times
    if own.sum() >= FEWEST and np.ptp(when[own]) > 0:
        line, by = drift(when[own], values[own], u[own]), f"{pilot}'s line through {int(own.sum())} measurements"
        at = [line.at(float(t)) for t in when]
        reference, spread = np.array([a for a, _ in at]), np.array([b for _, b in at])
        dof, squares = int(own.sum()) - 2, float((((values - reference) / u)[own] ** 2).sum())
    else:
        weight = own / u**2
        mean = float(weight @ values / weight.sum())
        squares, dof = float((weight * (values - mean) ** 2).sum()), int(own.sum()) - 1
        reference, by = np.full(len(values), mean), f"{pilot}'s mean of {int(own.sum())}"
        moved = float(np.ptp(values[own]) / np.sqrt(12))  # the standard may have moved as far as the pilot saw it move
        spread = np.full(len(values), np.hypot(1 / np.sqrt(weight.sum()), moved))
    degrees = _degrees(benches, values, reference, np.where(own, u, np.hypot(u, spread)), own)
    return Intercomparison(degrees, squares, dof, float(chdtrc(dof, squares)) if dof else 1.0, by)


def _degrees(
    benches: Sequence[str], values: Array, reference: Array, u_difference: Array, counted: NDArray[np.bool_]
) -> tuple[Degree, ...]:
    found = []
    for bench, x, ref, s, c in zip(benches, values, reference, u_difference, counted, strict=True):
        U = COVERAGE * float(s)
        e_n = (float(x) - float(ref)) / U if U > 0 else None
        found.append(Degree(bench, float(x), float(ref), float(x - ref), U, e_n, bool(c)))
    return tuple(found)

"""When to calibrate again: the methods of ILAC-G24 (OIML D 10) side by side, for one figure with a permitted change.

Each takes what was found at the calibrations so far. None is right by itself: the guide names what each is good for.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from labcal.quality.drift import Drift, drift

Array = NDArray[np.float64]
SHORTEST_D, LONGEST_D = 30.0, 1826.0  # no method proposes less or more
LONGER, SHORTER = 1.25, 0.5  # steps of the staircase
EASY = 0.8  # of what is permitted: found within it, the next interval is longer
COVERAGE = 2.0
METHODS = ("staircase", "control chart", "in-use time", "drift")


@dataclass(frozen=True, slots=True)
class IntervalProposal:
    """What one method proposes: days until the next calibration, hours of use where it counts these; and why."""

    method: str
    days: float | None
    hours: float | None
    why: str


def proposals(
    days: Array, values: Array, u: Array, permitted: float, interval_d: float, hours: Array | None = None
) -> tuple[IntervalProposal, ...]:
    """Each method on the `values` (n,) with standard `u` (n,) that were found at `days` (n,), in order.

    `permitted` is how far the figure may move from one calibration to the next, `interval_d` the interval that holds
    now, `hours` (n,) the use so far at each. Raises ValueError for fewer than two calibrations.
    """
    if len(days) < 2:
        raise ValueError(f"an interval needs two calibrations, and here are {len(days)}")
    if not permitted > 0:
        raise ValueError("the change that is permitted must be larger than zero")
    return (
        _staircase(values, permitted, interval_d),
        _control_chart(days, values, u, permitted),
        _in_use(days, values, u, permitted, hours),
        _drift(days, values, u, permitted),
    )


def _staircase(values: Array, permitted: float, interval_d: float) -> IntervalProposal:
    """Method 1: one step up or down by what the last calibration found."""
    share = abs(values[-1] - values[-2]) / permitted
    factor = LONGER if share <= EASY else 1.0 if share <= 1 else SHORTER
    word = {LONGER: "longer", 1.0: "as it is", SHORTER: "shorter"}[factor]
    why = f"the last change was {share:.0%} of what is permitted: {word}"
    return IntervalProposal(METHODS[0], _bounded(factor * interval_d), None, why)


def _control_chart(days: Array, values: Array, u: Array, permitted: float) -> IntervalProposal:
    """Method 2: the drift as it was so far and the scatter about it reach the limit together."""
    return _by_line(METHODS[1], days, values, u, permitted, cautious=False)


def _drift(days: Array, values: Array, u: Array, permitted: float) -> IntervalProposal:
    """The largest drift that its interval allows, after the U of the calibration itself is taken off."""
    return _by_line(METHODS[3], days, values, u, permitted, cautious=True)


def _by_line(method: str, x: Array, values: Array, u: Array, permitted: float, *, cautious: bool) -> IntervalProposal:
    found = _line(x, values, u)
    if isinstance(found, str):
        return IntervalProposal(method, None, None, found)
    rate, taken = _rate_and_taken(found, u, cautious=cautious)
    what = "U of a calibration" if cautious else "scatter (k = 2)"
    if taken >= permitted:
        return IntervalProposal(
            method, SHORTEST_D, None, f"{what} is {taken:.3g}, all that is permitted: calibrate better"
        )
    days = _bounded((permitted - taken) / max(rate, 1e-300))
    return IntervalProposal(method, days, None, f"{what} {taken:.3g}, then {365.25 * rate:.3g} a year")


def _rate_and_taken(found: Drift, u: Array, *, cautious: bool) -> tuple[float, float]:
    """The drift a day that is reckoned with, and what of the permitted change is taken before it begins."""
    typical = float(np.nan_to_num(u[-1]))
    scatter = float(np.hypot(found.scatter, typical))
    if not cautious:
        return abs(found.rate), COVERAGE * scatter
    return max(map(abs, found.interval)), COVERAGE * scatter


def _in_use(days: Array, values: Array, u: Array, permitted: float, hours: Array | None) -> IntervalProposal:
    """Method 3: the same by hours of use, and what that is in days as it is used now."""
    if hours is None or not np.ptp(hours) > 0:
        return IntervalProposal(METHODS[2], None, None, "how long it was in use is not known")
    if not np.ptp(days) > 0:
        return IntervalProposal(
            METHODS[2], None, None, "all calibrations are of one day: hours of use a day are not known"
        )
    found = _line(hours, values, u)
    if isinstance(found, str):
        return IntervalProposal(METHODS[2], None, None, found)
    rate, taken = _rate_and_taken(found, u, cautious=False)
    if taken >= permitted:
        return IntervalProposal(METHODS[2], SHORTEST_D, None, f"scatter (k = 2) is {taken:.3g}, all that is permitted")
    allowed, a_day = (permitted - taken) / max(rate, 1e-300), float(np.ptp(hours) / np.ptp(days))
    within = _bounded(allowed / a_day)
    return IntervalProposal(
        METHODS[2], within, within * a_day, f"{1000 * rate:.3g} in 1000 h, {a_day:.2g} h of use a day"
    )


def _line(x: Array, values: Array, u: Array) -> Drift | str:
    """The drift along `x`, or why there is none."""
    try:
        return drift(x, values, u)
    except ValueError as few:
        return str(few)


def _bounded(days: float) -> float:
    return float(np.clip(days, SHORTEST_D, LONGEST_D))

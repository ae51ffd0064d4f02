"""How a sensor's figures moved: the drift of each, when to calibrate it again, and one standard at several benches."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from math import isfinite

import numpy as np
from numpy.typing import NDArray

from labcal.errors import InputError
from labcal.quality.drift import Drift, drift
from labcal.quality.intercomparison import Intercomparison, compare_benches
from labcal.quality.recalibration import IntervalProposal, proposals
from labcal.years.history import DAYS_A_YEAR, Calibrated

Array = NDArray[np.float64]
PERMITTED = re.compile(r"\s*([\w -]+?)\s*=\s*([0-9.]+(?:[eE][+-]?[0-9]+)?)\s*(nT|ppm|deg)\s*")
USUAL_D = 365.0


@dataclass(frozen=True, slots=True, eq=False)
class Trend:
    """One figure over the years: `days` since the first (n,), values and u (n,), its drift a year or why there is none.

    `proposals` are there where a change is permitted.
    """

    quantity: str
    unit: str
    days: Array
    values: Array
    u: Array
    drift: Drift | str
    proposals: tuple[IntervalProposal, ...] = ()


def trends(
    found: Sequence[Calibrated], permitted: Mapping[str, tuple[float, str]], interval_d: float | None = None
) -> tuple[Trend, ...]:
    """The trend of every figure of one sensor's calibrations, in order of time.

    `permitted` {"offset" or "offset x": (change, unit)}; `interval_d` is the interval that holds now, else that between
    the last two calibrations. Raises InputError where a name or unit is none of a figure's, or two dates are the same.
    """
    names = list(found[0].figures)
    _refuse_unknown(names, found[0], permitted)
    days = np.array([one.days for one in found])
    days = days - days[0]
    if len(days) > 1 and np.diff(days).min() <= 0:
        raise InputError("two calibrations began at the same moment: which was first is not known")
    if interval_d is None:
        interval_d = float(days[-1] - days[-2]) if len(days) > 1 else USUAL_D
    hours = np.cumsum([one.hours for one in found])
    return tuple(_trend(name, found, days, hours, permitted, interval_d) for name in names)


def _trend(
    name: str, found: Sequence[Calibrated], days: Array, hours: Array, permitted: Mapping[str, tuple[float, str]],
    interval_d: float,
) -> Trend:  # fmt: skip
    values, u = columns(found, name)
    line: Drift | str
    try:
        line = drift(days / DAYS_A_YEAR, values, u)
    except ValueError as few:
        line = str(few)
    limit = permitted.get(name) or permitted.get(name.split()[0])
    proposed: tuple[IntervalProposal, ...] = ()
    if limit is not None:
        try:
            proposed = proposals(days, values, u, limit[0], interval_d, hours)
        except ValueError as fault:
            raise InputError(f"{name}: {fault}") from None
    return Trend(name, found[0].figures[name].unit, days, values, u, line, proposed)


def columns(found: Sequence[Calibrated], name: str) -> tuple[Array, Array]:
    """Values (n,) and standard uncertainties (n,) of one figure; NaN where u is not known."""
    values = np.array([one.figures[name].value for one in found])
    u = np.array([np.nan if (s := one.figures[name].u) is None else s for one in found])
    return values, u


def shortest(found: Sequence[Trend]) -> dict[str, tuple[float, str]]:
    """The shortest proposal of each method, days and the figure that asks for it: it rules the sensor's interval."""
    by: dict[str, tuple[float, str]] = {}
    for trend in found:
        for one in trend.proposals:
            if one.days is not None and one.days < by.get(one.method, (np.inf, ""))[0]:
                by[one.method] = one.days, trend.quantity
    return by


def compared(
    benches: Sequence[str], found: Sequence[Calibrated], pilot: str | None = None
) -> dict[str, tuple[str, Intercomparison]]:
    """Of each figure its unit and the comparison of `benches`, each of whom measured the calibration in its place.

    Raises InputError where they are of several sensors, or cannot be compared.
    """
    if len({one.serial for one in found}) > 1:
        raise InputError(f"these are several sensors: {', '.join(sorted({one.serial for one in found}))}")
    when = np.array([one.days for one in found]) / DAYS_A_YEAR
    made: dict[str, tuple[str, Intercomparison]] = {}
    for name, figure in found[0].figures.items():
        values, u = columns(found, name)
        try:
            made[name] = figure.unit, compare_benches(benches, values, u, when - when.min(), pilot)
        except ValueError as fault:
            raise InputError(f"{name}: {fault}") from None
    return made


def as_permitted(texts: Sequence[str]) -> dict[str, tuple[float, str]]:
    """What `--permitted 'offset=20 nT'` states, by name. Raises InputError."""
    found: dict[str, tuple[float, str]] = {}
    for text in texts:
        stated = PERMITTED.fullmatch(text)
        value = _number(stated[2]) if stated else None
        if stated is None or value is None:
            raise InputError(f"--permitted is a figure with its change and unit, as 'offset=20 nT', found {text!r}")
        found[stated[1]] = value, stated[3]
    return found


def _number(text: str) -> float | None:
    try:
        value = float(text)
    except ValueError:
        return None
    return value if isfinite(value) and value > 0 else None


def _refuse_unknown(names: Sequence[str], first: Calibrated, permitted: Mapping[str, tuple[float, str]]) -> None:
    for name, (_, unit) in permitted.items():
        of = [one for one in names if name in (one, one.split()[0])]
        if not of:
            known = ", ".join([*dict.fromkeys(one.split()[0] for one in names), *names])
            raise InputError(f"--permitted {name!r} is none of the figures {known}")
        if first.figures[of[0]].unit != unit:
            raise InputError(f"--permitted {name!r} is in {first.figures[of[0]].unit}, not in {unit}")

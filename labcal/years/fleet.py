"""A fleet: how each figure is spread over its sensors, which stand out, and what effects its batches have."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from labcal.errors import InputError
from labcal.files.patterns import LONGEST_TEXT, bounded
from labcal.quality.batches import Pooled, pool
from labcal.years.history import UNDATED, Calibrated

Array = NDArray[np.float64]
USUAL_BATCH = r"(.+?)[-_ .]?\d+$"  # the serial without its last number
MAD = 1.4826  # sigma over the median absolute deviation, of normal values
OUTLIER = 3.5  # robust sigmas, beyond which a sensor stands out (Iglewicz and Hoaglin)
FEWEST = 5  # sensors, below which none can stand out


@dataclass(frozen=True, slots=True, eq=False)
class Spread:
    """One figure over the sensors of a model: values (n,), robust centre and sigma, and who stands out, worst first."""

    model: str
    quantity: str
    unit: str
    values: Array
    centre: float
    sigma: float
    outliers: tuple[tuple[str, float, float], ...]  # serial, value, distance in sigma


@dataclass(frozen=True, slots=True)
class OfBatches:
    """One parameter of an effect over the batches of a model: of `sensors` it was found in `found`."""

    model: str
    parameter: str
    unit: str
    sensors: int
    found: int
    found_in: Mapping[str, int]  # batch: sensors
    pooled: Pooled
    worst: float  # the batch that is farthest from zero, in its u


@dataclass(frozen=True, slots=True)
class Fleet:
    """All of it. `batches` {model: {batch: sensors}}; effects are those that matter most first."""

    sensors: int
    calibrations: int
    simulated: bool
    batches: Mapping[str, Mapping[str, int]]
    spreads: tuple[Spread, ...]
    effects: tuple[OfBatches, ...]

    @property
    def outliers(self) -> tuple[tuple[float, str, str, Spread, float], ...]:
        """Distance, model, serial, figure and value of all that stand out, the worst first."""
        found = [(abs(far), s.model, serial, s, value) for s in self.spreads for serial, value, far in s.outliers]
        return tuple(sorted(found, key=lambda one: -one[0]))


def fleet_of(found: Sequence[Calibrated], batch: str = USUAL_BATCH) -> Fleet:
    """The fleet of the last calibration of each sensor; its batch is the first group of `batch` in its serial.

    Raises InputError where nothing is there, simulated and real sensors are mixed, nothing tells which of a sensor's
    several is the last, or `batch` is no expression.
    """
    if not found:
        raise InputError("there is no calibration here")
    if len({one.simulated for one in found}) > 1:
        raise InputError("simulated and real sensors are no fleet: name the files that belong together")
    _refuse_undated(found)
    last = {(one.model, one.serial): one for one in sorted(found, key=lambda one: one.utc)}
    models: dict[str, dict[str, list[Calibrated]]] = {}
    pattern = _pattern(batch)
    for one in last.values():
        models.setdefault(one.model, {}).setdefault(_batch_of(one.serial, pattern), []).append(one)
    spreads = [s for model, groups in models.items() for s in _spreads(model, [c for g in groups.values() for c in g])]
    effects = [e for model, groups in models.items() for e in _effects(model, groups)]
    effects.sort(key=lambda one: -one.worst)
    counted = {model: {name: len(group) for name, group in sorted(groups.items())} for model, groups in models.items()}
    return Fleet(len(last), len(found), found[0].simulated, counted, tuple(spreads), tuple(effects))


def _refuse_undated(found: Sequence[Calibrated]) -> None:
    count = Counter((one.model, one.serial) for one in found)
    for one in found:
        if one.utc == UNDATED and count[one.model, one.serial] > 1:
            message = f"nothing tells when it was measured, and there are several of {one.serial}: which is last?"
            raise InputError(f"{message} Its run is not in this store, and it has no date of issue", file=one.where)


def _pattern(text: str) -> re.Pattern[str]:
    try:
        pattern = bounded(text)
    except ValueError as fault:
        raise InputError(f"--batch {text!r} {fault}") from None
    if pattern.groups != 1:
        raise InputError(f"--batch {text!r} needs one group in parentheses: what it holds is the batch")
    return pattern


def _batch_of(serial: str, pattern: re.Pattern[str]) -> str:
    found = pattern.match(serial[:LONGEST_TEXT])
    return (found[1] if found else "") or "no batch"


def _spreads(model: str, sensors: Sequence[Calibrated]) -> list[Spread]:
    """Of each figure that all sensors have."""
    names = [name for name in sensors[0].figures if all(name in one.figures for one in sensors)]
    return [_spread(model, name, sensors) for name in names]


def _spread(model: str, name: str, sensors: Sequence[Calibrated]) -> Spread:
    values = np.array([one.figures[name].value for one in sensors])
    centre = float(np.median(values))
    sigma = MAD * float(np.median(np.abs(values - centre)))
    far = (values - centre) / sigma if sigma > 0 and len(values) >= FEWEST else np.zeros(len(values))
    out = [(one.serial, float(v), float(f)) for one, v, f in zip(sensors, values, far, strict=True) if abs(f) > OUTLIER]
    out.sort(key=lambda one: -abs(one[2]))
    return Spread(model, name, sensors[0].figures[name].unit, values, centre, sigma, tuple(out))


def _effects(model: str, groups: Mapping[str, Sequence[Calibrated]]) -> list[OfBatches]:
    everybody = [one for group in groups.values() for one in group]
    known = {(name, figure.unit) for one in everybody for name, figure in one.effects.items()}
    return [_of_batches(model, name, unit, groups, everybody) for name, unit in sorted(known)]


def _of_batches(
    model: str, name: str, unit: str, groups: Mapping[str, Sequence[Calibrated]], everybody: Sequence[Calibrated]
) -> OfBatches:
    """The hierarchical estimate. Where the effect was not found it is taken as 0 with the median u of where it was."""
    found = [f for one in everybody if (f := one.effects.get(name)) is not None and f.unit == unit]
    typical = float(np.median([one.u for one in found if one.u is not None] or [0.0]))
    columns = {
        batch: (
            [_value(one, name, unit, typical)[0] for one in group],
            [_value(one, name, unit, typical)[1] for one in group],
        )
        for batch, group in groups.items()
    }
    found_in = {batch: sum(name in one.effects for one in group) for batch, group in groups.items()}
    unseen = {batch: 1 - count / len(groups[batch]) for batch, count in found_in.items()}
    pooled = _with_unseen(pool(columns), unseen, min(abs(one.value) for one in found))
    worst = max(abs(one.value) / one.u if one.u > 0 else 0.0 for one in pooled.batches)
    return OfBatches(model, name, unit, len(everybody), len(found), found_in, pooled, worst)


def _with_unseen(pooled: Pooled, unseen: Mapping[str, float], smallest: float) -> Pooled:
    """With u wider by what the sensors hide in which nothing was found: all may have as much as the smallest found.

    That is common to a batch, so it does not average out: rectangular, times their share.
    """
    batches = [replace(b, u=float(np.hypot(b.u, unseen[b.name] * smallest / np.sqrt(3)))) for b in pooled.batches]
    return replace(pooled, batches=tuple(batches))


def _value(one: Calibrated, name: str, unit: str, typical: float) -> tuple[float, float]:
    figure = one.effects.get(name)
    if figure is None or figure.unit != unit:
        return 0.0, typical
    return figure.value, typical if figure.u is None else figure.u

"""The way to zero: all axes together, ramped, read back, opened; what fails on one axis does not stop another.

Every axis is written zero before anything is asked of any of them, as far as its set-point is known: a supply that
hears and answers late is at zero in time.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import replace
from functools import partial
from typing import TypeVar

from labcal.bench.clock import Clock
from labcal.bench.coils.at_zero import AtZero as AtZero  # what the way to zero ends with
from labcal.bench.driver_kit.roles import CoilSupply, Unacknowledged
from labcal.errors import InstrumentError

T = TypeVar("T")
RAMP_STEP_S = 0.1
ZERO_TIMEOUT_S = 1.0
TIMES_TOLD = 2  # before anybody is asked: a supply may miss one, and its silence may take longer than there is time


def to_zero(
    supplies: Mapping[str, CoilSupply],
    rates_A_per_s: Mapping[str, float],
    clock: Clock,
    wait: Callable[[float], None] | None = None,
    known_A: Mapping[str, float] | None = None,
    doubts: Mapping[str, InstrumentError] | None = None,
) -> dict[str, AtZero]:
    """Ramp every axis to zero, see it below its `zero_current_A`, then open it where it can open.

    `known_A`: set-points that need not be asked for. `doubts`: axes that may not answer, and why: they are written
    zero at once, without a ramp, and read back after the others. An axis that fails on the way is treated likewise.
    Its `fault` is what the read-back found, where that failed, else what went wrong before.
    What is not read back at zero is written off as well: the last that can be said to it.
    """
    faults, levels = dict(doubts or {}), dict(known_A or {})
    write_zero({axis: supplies[axis] for axis in faults})
    levels |= _each({axis: s.set_point for axis, s in supplies.items() if axis not in levels | faults}, faults)
    going = {axis: level for axis, level in levels.items() if level and axis not in faults}
    levels |= _ramp_down(supplies, going, rates_A_per_s, clock, wait or clock.wait_until, faults)
    for _ in range(TIMES_TOLD):
        write_zero(supplies)
    well, ill = [axis for axis in supplies if axis not in faults], list(faults)
    ended = {end.axis: end for axes in (well, ill) for end in _read_back(axes, supplies, clock, faults)}
    return {axis: replace(ended[axis], from_A=_stepped_A(levels.get(axis, 0.0), s)) for axis, s in supplies.items()}


def _stepped_A(held_A: float, supply: CoilSupply) -> float:
    """What it held [A] when its ramp was left out, or broke off; nothing where that counts as zero."""
    return abs(held_A) if abs(held_A) >= supply.zero_current_A else 0.0


def write_zero(supplies: Mapping[str, CoilSupply]) -> None:
    """Zero on the line to each of them, its answer not waited for. Never raises InstrumentError: it is read back."""
    _each({axis: partial(s.write_current, 0.0) for axis, s in supplies.items() if isinstance(s, Unacknowledged)}, {})


def _ramp_down(
    supplies: Mapping[str, CoilSupply],
    levels: Mapping[str, float],
    rates: Mapping[str, float],
    clock: Clock,
    wait: Callable[[float], None],
    faults: dict[str, InstrumentError],
) -> dict[str, float]:
    """Bring the set-points down together; the last that is written is zero. Returns what each was written last [A]."""
    reached = dict(levels)
    duration = max((abs(level) / rates[axis] for axis, level in levels.items()), default=0.0)
    begun, lead_s, left = clock.now(), RAMP_STEP_S, float(duration > 0)
    while left > 0:  # by the clock: a slow line takes larger steps and not longer
        pass_begun = clock.now()
        left = max(0.0, 1 - (pass_begun + lead_s - begun) / duration)
        going = [axis for axis in levels if axis not in faults]
        reached |= {axis: levels[axis] * left for axis in going}
        _each({axis: partial(_write, supplies[axis], reached[axis]) for axis in going}, faults)
        lead_s = max(RAMP_STEP_S, clock.now() - pass_begun)
        wait(begun + duration * (1 - left))
    return reached


def _write(supply: CoilSupply, current_A: float) -> None:
    if isinstance(supply, Unacknowledged):
        supply.write_current(current_A)
    else:
        supply.set_current(current_A)


def _read_back(
    axes: Iterable[str], supplies: Mapping[str, CoilSupply], clock: Clock, before: Mapping[str, InstrumentError]
) -> list[AtZero]:
    """The currents of all, then the outputs."""
    faults: dict[str, InstrumentError] = {}
    currents = _currents(list(axes), supplies, clock, faults)
    _each({axis: partial(supplies[axis].output, False) for axis in currents}, faults)
    _each({axis: s.write_off for axis in faults if isinstance(s := supplies[axis], Unacknowledged)}, {})
    return [
        AtZero(axis, None, False, faults[axis])
        if axis in faults
        else AtZero(axis, currents[axis][0], supplies[axis].can_open, before.get(axis), currents[axis][1])
        for axis in axes
    ]


def _currents(
    axes: Sequence[str], supplies: Mapping[str, CoilSupply], clock: Clock, faults: dict[str, InstrumentError]
) -> dict[str, tuple[float, float]]:
    """The current of each axis and when it was read.

    While one does not answer, the others of its line wait to be asked, and may have missed their zero: whoever is not
    read back yet is written it again.
    """
    found = dict[str, tuple[float, float]]()
    for axis in axes:
        found |= _each({axis: partial(_read_zero, axis, supplies[axis], clock)}, faults)
        if axis in faults:
            write_zero({axis: supplies[axis] for axis in axes if axis not in found})
    return found


def _read_zero(axis: str, supply: CoilSupply, clock: Clock) -> tuple[float, float]:
    """The current at zero and when it was read. An output that cannot open is held there by its set-point alone."""
    if not supply.can_open and supply.set_point() != 0:
        supply.set_current(0.0)
    return wait_for_zero(axis, supply, clock), time.monotonic()


def wait_for_zero(axis: str, supply: CoilSupply, clock: Clock) -> float:
    """The measured current once it is below `zero_current_A`. Raises InstrumentError (not zero) where it stays.

    Zero is set once more, acknowledged, where it still flows: what was written may have been lost. What was measured
    last was measured after the time was up, however slow the line is.
    """
    begun = clock.now()
    left = abs(supply.measure_current())
    if left >= supply.zero_current_A:
        supply.set_current(0.0)
    while left >= supply.zero_current_A:
        clock.wait_until(clock.now() + 0.02)
        late = clock.now() >= begun + ZERO_TIMEOUT_S
        left = abs(supply.measure_current())
        if left >= supply.zero_current_A and late:
            raise InstrumentError(
                f"coil {axis}: {left:.4g} A still flows {ZERO_TIMEOUT_S:g} s after zero was set "
                f"(zero is below {supply.zero_current_A:g} A).",
                fault="not zero",
                remedy=f"Switch {supply.name} off by hand, then look at its panel.",
            )
    return left


def _each(acts: Mapping[str, Callable[[], T]], faults: dict[str, InstrumentError]) -> dict[str, T]:
    """What each axis' act gives; what fails on one is kept in `faults` and stops no other."""
    done: dict[str, T] = {}
    for axis, act in acts.items():
        try:
            done[axis] = act()
        except InstrumentError as error:
            faults[axis] = error
    return done

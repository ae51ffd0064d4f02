"""The way to zero: all axes together, ramped, read back, opened; what fails on one axis does not stop another."""

from __future__ import annotations

import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from typing import TypeVar

from labcal.bench.clock import Clock
from labcal.bench.roles import CoilSupply
from labcal.errors import InstrumentError

T = TypeVar("T")
RAMP_STEP_S = 0.1
ZERO_TIMEOUT_S = 1.0


@dataclass(frozen=True, slots=True)
class AtZero:
    """How one axis ended. `fault` is what went wrong on the way; then `current_A` may be unknown (None).

    `read_s` is when it was read back, on the computer's monotonic clock.
    """

    axis: str
    current_A: float | None
    opened: bool
    fault: InstrumentError | None = None
    read_s: float | None = None

    @property
    def abrupt(self) -> bool:
        """Whether it came to zero without its ramp: that changes the magnetic history of what is near."""
        return self.fault is not None and self.current_A is not None

    @property
    def words(self) -> str:
        """The end state in words: "zero, open", "zero, not open", or the fault."""
        if self.fault is not None:
            return str(self.fault)
        return "zero, open" if self.opened else "zero, not open"


def to_zero(
    supplies: Mapping[str, CoilSupply],
    rates_A_per_s: Mapping[str, float],
    clock: Clock,
    wait: Callable[[float], None] | None = None,
    known_A: Mapping[str, float] | None = None,
) -> dict[str, AtZero]:
    """Ramp every axis to zero, see it below its `zero_current_A`, then open it where it can open.

    Every axis is set to zero before the first is read back, and read back before the first is opened. One that fails
    on the ramp is set to zero without a ramp, as far as it answers, after all others: its silence keeps no line busy
    that they need. `known_A`: set-points that need not be asked for.
    """
    faults: dict[str, InstrumentError] = {}
    levels = dict(known_A or {})
    levels |= _each({axis: supply.set_point for axis, supply in supplies.items() if axis not in levels}, faults)
    arrived = _ramp_down(supplies, levels, rates_A_per_s, clock, wait or clock.wait_until, faults)
    well, ill = [axis for axis in supplies if axis not in faults], list(faults)
    ended = {end.axis: end for axes in (well, ill) for end in _released(axes, supplies, clock, arrived, faults)}
    return {axis: ended[axis] for axis in supplies}


def _ramp_down(
    supplies: Mapping[str, CoilSupply],
    levels: Mapping[str, float],
    rates: Mapping[str, float],
    clock: Clock,
    wait: Callable[[float], None],
    faults: dict[str, InstrumentError],
) -> set[str]:
    """Bring the set-points down together; returns the axes that hold zero now."""
    duration = max((abs(level) / rates[axis] for axis, level in levels.items()), default=0.0)
    begun, lead_s, arrived, left = clock.now(), RAMP_STEP_S, set[str](), float(duration > 0)
    while left > 0:  # by the clock: a slow line takes larger steps and not longer
        pass_begun = clock.now()
        left = max(0.0, 1 - (pass_begun + lead_s - begun) / duration)
        going = [axis for axis, level in levels.items() if level and axis not in faults]
        arrived = set(_each({a: partial(supplies[a].set_current, levels[a] * left) for a in going}, faults))
        lead_s = max(RAMP_STEP_S, clock.now() - pass_begun)
        wait(begun + duration * (1 - left))
    return arrived


def _released(
    axes: Sequence[str],
    supplies: Mapping[str, CoilSupply],
    clock: Clock,
    arrived: set[str],
    before: Mapping[str, InstrumentError],
) -> list[AtZero]:
    """Zero on all that are not there yet, then the read-backs of all, then the outputs."""
    faults: dict[str, InstrumentError] = {}
    _each({axis: partial(supplies[axis].set_current, 0.0) for axis in axes if axis not in arrived}, faults)
    set_to_zero = [axis for axis in axes if axis not in faults]
    currents = _each({axis: partial(wait_for_zero, axis, supplies[axis], clock) for axis in set_to_zero}, faults)
    read_s = time.monotonic()
    _each({axis: partial(supplies[axis].output, False) for axis in currents}, faults)
    return [
        AtZero(axis, None, False, before.get(axis, faults[axis]))
        if axis in faults
        else AtZero(axis, currents[axis], supplies[axis].can_open, before.get(axis), read_s)
        for axis in axes
    ]


def wait_for_zero(axis: str, supply: CoilSupply, clock: Clock) -> float:
    """The measured current once it is below `zero_current_A`. Raises InstrumentError (not zero) where it stays.

    What was measured last was measured after the time was up, however slow the line is.
    """
    deadline, late = clock.now() + ZERO_TIMEOUT_S, False
    while abs(left := supply.measure_current()) >= supply.zero_current_A:
        if late:
            raise InstrumentError(
                f"coil {axis}: {left:.4g} A still flows {ZERO_TIMEOUT_S:g} s after zero was set "
                f"(zero is below {supply.zero_current_A:g} A).",
                fault="not zero",
                remedy="Switch the supply off by hand, then look at its panel.",
            )
        late = clock.now() >= deadline
        clock.wait_until(clock.now() + 0.02)
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

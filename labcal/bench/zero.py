"""The way to zero: all axes together, ramped, read back, opened; what fails on one axis does not stop another."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import partial

from labcal.bench.clock import Clock
from labcal.bench.roles import CoilSupply
from labcal.errors import InstrumentError

RAMP_STEP_S = 0.1
ZERO_TIMEOUT_S = 1.0


@dataclass(frozen=True, slots=True)
class AtZero:
    """How one axis ended. `fault` is what went wrong on the way; then `current_A` may be unknown (None)."""

    axis: str
    current_A: float | None
    opened: bool
    fault: InstrumentError | None = None

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
) -> dict[str, AtZero]:
    """Ramp every axis to zero, see it below its `zero_current_A`, then open it where it can open.

    An axis that fails on the ramp is set to zero at once and opened without a ramp, as far as it answers.
    """
    faults: dict[str, InstrumentError] = {}
    _ramp_down(supplies, rates_A_per_s, clock, wait or clock.wait_until, faults)
    return {axis: _release(axis, supply, clock, faults.get(axis)) for axis, supply in supplies.items()}


def _ramp_down(
    supplies: Mapping[str, CoilSupply],
    rates: Mapping[str, float],
    clock: Clock,
    wait: Callable[[float], None],
    faults: dict[str, InstrumentError],
) -> None:
    start = {axis: level for axis, s in supplies.items() if (level := _tried(axis, s.set_point, faults)) is not None}
    begun = clock.now()
    duration = max((abs(level) / rates[axis] for axis, level in start.items()), default=0.0)
    left = float(duration > 0)
    while left > 0:  # by the clock, so that a slow supply takes larger steps and not longer
        left = max(0.0, 1 - (clock.now() + RAMP_STEP_S - begun) / duration)
        for axis, level in start.items():
            if axis not in faults and level:
                _tried(axis, partial(supplies[axis].set_current, level * left), faults)
        wait(begun + duration * (1 - left))


def _release(axis: str, supply: CoilSupply, clock: Clock, fault: InstrumentError | None) -> AtZero:
    try:
        supply.set_current(0.0)
        current = wait_for_zero(axis, supply, clock)
        supply.output(False)
        return AtZero(axis, current, supply.can_open, fault)
    except InstrumentError as error:
        return AtZero(axis, None, False, fault or error)


def wait_for_zero(axis: str, supply: CoilSupply, clock: Clock) -> float:
    """The measured current once it is below `zero_current_A`. Raises InstrumentError (not zero) where it stays."""
    deadline = clock.now() + ZERO_TIMEOUT_S
    while abs(left := supply.measure_current()) >= supply.zero_current_A:
        if clock.now() >= deadline:
            raise InstrumentError(
                f"coil {axis}: {left:.4g} A still flows {ZERO_TIMEOUT_S:g} s after zero was set "
                f"(zero is below {supply.zero_current_A:g} A).",
                fault="not zero",
                remedy="Its output stays closed: switch the supply off by hand, then look at its panel.",
            )
        clock.wait_until(clock.now() + 0.02)
    return left


def _tried(axis: str, act: Callable[[], float | None], faults: dict[str, InstrumentError]) -> float | None:
    try:
        return act()
    except InstrumentError as error:
        faults[axis] = error
        return None

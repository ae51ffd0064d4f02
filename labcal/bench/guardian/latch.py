"""The latch of a coil that was ordered to zero: from then on it hears zero, off, or less than it has heard since."""

from __future__ import annotations

import math

from labcal.bench.driver_kit.roles import CoilSupply, Identity, Unacknowledged
from labcal.errors import InstrumentError


class Latch:
    """`most_A`: the largest magnitude that may still be sent; None where the coil is free, inf until it is known."""

    def __init__(self) -> None:
        self.most_A: float | None = None

    def engage(self, level_A: float | None) -> None:
        """Zero was ordered, with this set-point held (None: not known). The most that may be sent never goes up."""
        level = math.inf if level_A is None else abs(level_A)
        self.most_A = level if self.most_A is None else min(level, self.most_A)

    def lift(self) -> None:
        """Zero was read back, and a session that knows has given a new order."""
        self.most_A = None

    def take(self, current_A: float) -> None:
        """Note that this is about to be sent. Raises InstrumentError (taken to zero) where it may not be."""
        if self.most_A is None:
            return
        if not abs(current_A) <= self.most_A:
            raise InstrumentError(
                f"{current_A:.4g} A was not sent: this coil was ordered to zero, and {self.most_A:.4g} A is the most "
                "that it may still hear.",
                fault="taken to zero",
            )
        self.most_A = abs(current_A)


class LatchedSupply:
    """A CoilSupply behind a latch: the only way from the guardian to the driver."""

    def __init__(self, supply: CoilSupply, latch: Latch) -> None:
        self._supply, self._latch, self.name = supply, latch, supply.name
        self.bipolar, self.can_open = supply.bipolar, supply.can_open
        self.zero_current_A, self.ramp_A_per_s = supply.zero_current_A, supply.ramp_A_per_s

    def set_current(self, current_A: float) -> None:
        """Set and read back."""
        self._latch.take(current_A)
        self._supply.set_current(current_A)

    def write_current(self, current_A: float) -> None:
        """Send the set-point; a driver that cannot do so without waiting waits."""
        self._latch.take(current_A)
        if isinstance(self._supply, Unacknowledged):
            self._supply.write_current(current_A)
        else:
            self._supply.set_current(current_A)

    def write_off(self) -> None:
        """Send "output off"."""
        if isinstance(self._supply, Unacknowledged):
            self._supply.write_off()
        else:
            self._supply.output(False)

    def set_point(self) -> float:
        """The set-point, read back [A]."""
        return self._supply.set_point()

    def measure_current(self) -> float:
        """The delivered current [A]."""
        return self._supply.measure_current()

    def output(self, on: bool) -> None:
        """Close or open the output; it is not closed while the latch holds."""
        if on and self._latch.most_A is not None:
            raise InstrumentError(
                f"{self.name}: its output was not closed: this coil was ordered to zero.", fault="taken to zero"
            )
        self._supply.output(on)

    def identify(self) -> Identity:
        """Who answers."""
        return self._supply.identify()

    def make_safe(self) -> None:
        """Zero, open, and back to its panel."""
        self._supply.make_safe()

    def close(self) -> None:
        """Let go of its link."""
        self._supply.close()

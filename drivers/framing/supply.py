"""What supplies in constant current do alike, once their numbers are declared."""

from __future__ import annotations

from contextlib import ExitStack
from typing import Any

from labcal.bench.instrument import quantity


class CurrentSource:
    """The methods of a CoilSupply on the declared numbers `current`, `sensed`, `compliance` and `enabled`."""

    settings: Any
    current: quantity
    sensed: quantity
    compliance: quantity
    enabled: quantity

    def set_current(self, current_A: float) -> None:
        """Set the current and read the set-point back."""
        self.current = current_A

    def set_point(self) -> float:
        """The set-point that it holds [A]."""
        return self.current

    def measure_current(self) -> float:
        """The delivered current [A]."""
        return self.sensed

    def output(self, on: bool) -> None:
        """Switch the output, confirmed; before it goes on, the compliance voltage is set."""
        if on:
            self.compliance = self.settings.compliance_V
        self.enabled = on

    def write_current(self, current_A: float) -> None:
        """Send the set-point and wait for nothing."""
        type(self).current.write(self, current_A)

    def write_off(self) -> None:
        """Send "output off" and wait for nothing."""
        type(self).enabled.write(self, 0)

    def make_safe(self) -> None:
        """Current to zero, then output off, a failure of one not skipping the other; after both, back to its panel."""
        with ExitStack() as steps:
            steps.callback(self.output, False)
            steps.callback(self.set_current, 0.0)
        self.release()

    def release(self) -> None:
        """Give it back to its panel; most need no word for it."""

"""What supplies in constant current do alike, once their numbers are declared."""

from __future__ import annotations

from contextlib import ExitStack, suppress
from typing import Any

from labcal.bench.instrument import quantity
from labcal.errors import InstrumentError

MISSING = 2.0  # times what counts as zero: a current so much asked for, and not there, is missing
CLEAR_IT = "Find out why, then clear it on its panel."


class CurrentSource:
    """The methods of a CoilSupply on the declared numbers `current`, `sensed`, `compliance` and `enabled`."""

    name: str
    settings: Any
    zero_current_A: float
    current: quantity
    sensed: quantity
    compliance: quantity
    enabled: quantity
    _asked_A = 0.0

    def set_current(self, current_A: float) -> None:
        """Set the current and read the set-point back."""
        if not current_A:
            self._asked_A = 0.0  # whatever comes of it: the way to rest must not be barred
        self.current = current_A
        self._asked_A = current_A

    def set_point(self) -> float:
        """The set-point that it holds [A]."""
        return self.current

    def measure_current(self) -> float:
        """The delivered current [A]. Raises InstrumentError (tripped) where a protection has ended it."""
        sensed = self.sensed
        missing = abs(self._asked_A) > MISSING * self.zero_current_A and abs(sensed) < self.zero_current_A
        if missing and (kind := self._tripped()):
            raise InstrumentError(f"{self.name}: its {kind} protection tripped.", fault="tripped", remedy=CLEAR_IT)
        return sensed

    def trip(self) -> str:
        """Which protection has switched the output off: over-voltage, over-current …; "" where none has."""
        return ""

    def _tripped(self) -> str:
        with suppress(InstrumentError):  # a model that does not know the question has not said that it tripped
            return self.trip()
        return ""

    def output(self, on: bool) -> None:
        """Switch the output, confirmed; before it goes on, the compliance voltage is set."""
        if on:
            self.compliance = self.settings.compliance_V
        self.enabled = on

    def write_current(self, current_A: float) -> None:
        """Send the set-point and wait for nothing."""
        self._asked_A = current_A
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

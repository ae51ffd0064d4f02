"""The supplies and contacts as a session sees them: the same roles, spoken through the guardian."""

from __future__ import annotations

from labcal.bench.guardian.client import GuardianClient
from labcal.bench.roles import Identity


class GuardedInstrument:
    """An instrument that the guardian owns."""

    def __init__(self, name: str, guardian: GuardianClient) -> None:
        self.name, self._guardian = name, guardian

    def identify(self) -> Identity:
        """Who answers. Raises InstrumentError where it is another one than before."""
        return Identity(**self._guardian.ask("identify", name=self.name))

    def reopen(self) -> None:
        """Open its lost link again."""
        self._guardian.ask("reopen", name=self.name)

    def make_safe(self) -> None:
        """Nothing to do alone: coils come to zero together, and contacts do not move under current."""

    def close(self) -> None:
        """The guardian lets go of the link when the session has ended."""


class GuardedSupply(GuardedInstrument):
    """A CoilSupply, signed, whose limits and ramp the guardian enforces."""

    def __init__(self, axis: str, guardian: GuardianClient) -> None:
        facts = guardian.facts[axis]
        super().__init__(str(facts["name"]), guardian)
        self._axis = axis
        self.has_contacts = bool(facts["has_contacts"])
        self.bipolar, self.can_open = bool(facts["bipolar"]), bool(facts["can_open"])
        self.zero_current_A, self.ramp_A_per_s = float(facts["zero_current_A"]), float(facts["ramp_A_per_s"])

    def make_safe(self) -> None:
        """All coils to zero, where any may carry current that was not ordered there: they come down together."""
        if self._guardian.ask("status")["in_hand"]:
            self._guardian.zero(f"{self.name} was to be made safe")

    def set_current(self, current_A: float) -> None:
        """Set the signed current and read it back."""
        self._guardian.ask("set_current", axis=self._axis, current_A=current_A)

    def set_point(self) -> float:
        """The signed set-point, read back [A]."""
        return float(self._guardian.ask("set_point", axis=self._axis))

    def measure_current(self) -> float:
        """The signed delivered current [A]."""
        return float(self._guardian.ask("measure_current", axis=self._axis))

    def output(self, on: bool) -> None:
        """Close or open the output, confirmed by read-back."""
        self._guardian.ask("output", axis=self._axis, on=on)

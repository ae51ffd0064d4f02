"""How a coil axis ended. By itself, so that who only says off loads nothing else."""

from __future__ import annotations

from dataclasses import dataclass

from labcal.errors import InstrumentError


@dataclass(frozen=True, slots=True)
class AtZero:
    """How one axis ended. `fault` is what went wrong on the way; then `current_A` may be unknown (None).

    `read_s`: when the current was read back, on `time.monotonic`.
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

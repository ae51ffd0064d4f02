"""What the axes of Newport's controllers do alike: velocity and absolute position, in degrees, read back."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field

from labcal.bench.driver_kit.arrival import refuse_elsewhere
from labcal.bench.driver_kit.quantity import decimal
from labcal.bench.links import quoted
from labcal.errors import InstrumentError


@dataclass
class NewportAxis:
    """`command` and `ask` are how its controller is spoken to; `command` raises where it did not take the words."""

    name: str
    command: Callable[[str], None]
    ask: Callable[[str], str]
    tolerance_deg: float
    target_deg: float | None = field(default=None, init=False)  # None where it is nowhere to arrive at

    def move_to(self, angle_deg: float, rate_deg_per_s: float) -> None:
        """Begin an absolute move in the stage's own sense; sent once, never repeated."""
        self.command(f"VA{rate_deg_per_s:.4f}")
        held = self.number("VA?")
        if abs(held - rate_deg_per_s) > 1e-3:
            raise InstrumentError(f"{self.name}: its velocity reads back {held:g} deg/s.", fault="read-back")
        self.target_deg = angle_deg
        self.command(f"PA{angle_deg:.4f}")

    def angle_deg(self) -> float:
        """The position [deg] in the stage's own sense."""
        return self.number("TP")

    def refuse_elsewhere(self) -> None:
        """Raise InstrumentError (not arrived) where it rests elsewhere than it was sent."""
        refuse_elsewhere(self.name, self.angle_deg(), self.target_deg, self.tolerance_deg)

    def stop(self) -> None:
        """Stop with its brake ramp."""
        self.target_deg = None
        self.command("ST")

    def at_most(self, speed: str, limit_deg_per_s: float) -> None:
        """See that the speed that these letters set is no faster, and lower it where it is; confirmed."""
        if self.number(f"{speed}?") <= limit_deg_per_s:
            return
        self.command(f"{speed}{limit_deg_per_s:.4f}")
        if (held := self.number(f"{speed}?")) > limit_deg_per_s + 1e-3:
            raise InstrumentError(f"{self.name}: {speed} reads back {held:g} deg/s.", fault="read-back")

    def number(self, words: str) -> float:
        """The number that is asked for with these letters. Raises InstrumentError (wrong reply) for all else."""
        reply = self.ask(words)
        try:
            return decimal(reply)
        except ValueError as error:
            raise self.wrong(words, reply) from error

    def wrong(self, words: str, reply: str) -> InstrumentError:
        """The error for a reply that is none to `words`."""
        return InstrumentError(f"{self.name}: {words} was answered {quoted(reply)}.", fault="wrong reply")

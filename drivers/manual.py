"""A platform turned by hand: a move is a question to the technician, and what the dial then reads is its answer."""

from __future__ import annotations

import math
import re
from dataclasses import dataclass

from labcal.bench.clock import Clock
from labcal.bench.driver_kit.arrival import refuse_elsewhere
from labcal.bench.driver_kit.roles import Identity
from labcal.bench.driver_kit.settings import Positive
from labcal.bench.links import Link, quoted
from labcal.errors import InstrumentError

ABORT = ("abort", "stop", "no")
AS_ASKED = ("", "done", "yes")


@dataclass(frozen=True, slots=True)
class Settings:
    """`dial_deg`: half the width within which the dial can be read. `tolerance_deg`: how far from the angle asked for
    the reading may lie. `max_rate_deg_per_s`: how fast hands turn it, at most.
    """

    serial: str = ""
    dial_deg: Positive = 0.1
    tolerance_deg: Positive = 2.0
    max_rate_deg_per_s: Positive = 10.0


class ManualPlatform:
    """No motor and no wire. Its angle is not known before a reading was entered, nor from a move to its answer."""

    roles = ("platform",)
    never = (rb"",)  # there is nobody to send to
    motorised = False

    def __init__(self, name: str, link: Link, clock: Clock, settings: Settings) -> None:
        self.name, self.settings, self._link = name, settings, link
        self.max_rate_deg_per_s = settings.max_rate_deg_per_s
        self.u_reading_deg = settings.dial_deg / math.sqrt(3)  # rectangular (GUM 4.3.7)
        self._angle_deg, self._target_deg = 0.0, 0.0
        self._known = False

    def identify(self) -> Identity:
        """What bench.toml says of it."""
        return Identity("", "manual platform", self.settings.serial)

    def home(self, limit_deg_per_s: float = math.inf) -> None:
        """Where its angle is not known, zero is asked for."""
        if not self._known:
            self._target_deg = 0.0

    def move_to(self, angle_deg: float, rate_deg_per_s: float) -> None:
        """Begin an absolute move in the dial's own sense: from here on `question` stands and waits for `confirm`."""
        self._target_deg, self._known = angle_deg, False

    def question(self) -> str:
        """What the technician is asked to do."""
        return (
            f"Turn the platform to {self._target_deg % 360:.1f}° on its dial, take your hands off, and enter what it "
            "reads (or: abort)."
        )

    def confirm(self, answer: str) -> None:
        """The technician's answer: the dial's reading [deg], nothing for the angle asked for, or "abort".

        Raises InstrumentError where it is none of these, an abort, or an angle other than the one asked for.
        """
        said = answer.strip().rstrip("°").lower().replace(",", ".")
        if said in ABORT:
            raise InstrumentError(f"{self.name}: the technician did not turn it.", fault="aborted")
        if said not in AS_ASKED and not re.fullmatch(r"[+-]?\d{1,4}(\.\d+)?", said):
            raise InstrumentError(f"{self.name}: {quoted(answer)} is no reading of a dial.", fault="wrong reply")
        angle = self._target_deg if said in AS_ASKED else self._nearest(float(said))
        refuse_elsewhere(self.name, angle, self._target_deg, self.settings.tolerance_deg)
        self._angle_deg, self._known = angle, True

    def moving(self) -> bool:
        """Whether the question still stands."""
        return not self._known

    def angle_deg(self) -> float:
        """The last reading [deg] in the dial's own sense."""
        return self._angle_deg

    def state(self) -> tuple[float, bool]:
        """The last reading [deg], and whether it may have been turned since."""
        return self._angle_deg, not self._known

    def make_safe(self) -> None:
        """Nothing moves by itself."""

    def close(self) -> None:
        """Let go of the link."""
        self._link.close()

    def _nearest(self, reading_deg: float) -> float:
        """The reading on the turn of the target: a dial shows 350° for -10°."""
        return self._target_deg + math.remainder(reading_deg - self._target_deg, 360.0)

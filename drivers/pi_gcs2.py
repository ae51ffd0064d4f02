"""PI controllers of GCS 2 (C-863, C-867, C-884, E-873 …) with a rotation stage, ASCII over serial or TCP."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Annotated

from pydantic import Field

from drivers.framing.gcs2 import Conversation
from labcal.bench.clock import Clock
from labcal.bench.driver_kit.arrival import refuse_elsewhere
from labcal.bench.driver_kit.roles import Identity
from labcal.bench.driver_kit.settings import NotNegative, Positive
from labcal.bench.links import Link, quoted
from labcal.errors import InstrumentError

UNIT, REFERENCE_VELOCITY = "0x7000601", "0x50"  # parameters of an axis
MOTION, STOPPED = "\x05", 10  # asks for the axes that move; the error that a stop leaves


@dataclass(frozen=True, slots=True)
class Settings:
    """`axis`: its name there. `degrees`: whether it can be asked that the axis counts degrees.

    `settle_s`: how long it may take at rest to say that it is on target. `tolerance_deg`: how far off it may end.
    """

    axis: Annotated[str, Field(pattern=r"^[A-Za-z0-9_-]{1,16}$")] = "1"
    degrees: bool = True
    settle_s: NotNegative = 1.0
    tolerance_deg: Positive = 0.02
    max_rate_deg_per_s: Positive = 20.0
    timeout_s: Positive = 0.5


class PiStage:
    """Absolute moves only. Standing still is not arrived: errors and position are looked at after every move."""

    roles = ("platform",)
    never = (  # all but questions, servo on, reference, velocity, one absolute move, stop: no memory, no new zero
        rb"^(?!(\*IDN\?|ERR\?|(SVO|FRF|VEL|POS|ONT)\? \S+|SPA\? \S+ 0x(50|7000601)|SVO \S+ 1|FRF \S+|HLT \S+"
        rb"|(VEL|MOV) \S+ -?[\d.]+|SPA \S+ 0x50 [\d.]+)\n\Z|\x05\Z)",
    )
    motorised = True

    def __init__(self, name: str, link: Link, clock: Clock, settings: Settings) -> None:
        self.name, self.settings, self._link, self._clock = name, settings, link, clock
        self.max_rate_deg_per_s = settings.max_rate_deg_per_s
        self._target_deg: float | None = None
        self._moved_s = -math.inf  # when it was last seen to move
        self._axis = Conversation(name, link, settings.axis, settings.timeout_s)

    def identify(self) -> Identity:
        """Ask who it is. Raises InstrumentError for another maker, and where the axis does not count degrees."""
        said = self._axis.ask("*IDN?\n")
        maker, model, serial, version = (part.strip() for part in (said + ",,,").split(",")[:4])
        if "Physik Instrumente" not in maker:
            message = f"{self.name}: {quoted(said)} answered, no controller of PI."
            raise InstrumentError(message, fault="another instrument")
        self._axis.error()  # of what was said before
        if self.settings.degrees:
            unit = self._axis.value("SPA?", f" {UNIT}")
            self._axis.refuse_errors(f"SPA? {UNIT}")
            if not unit.upper().startswith("DEG"):
                message = f"{self.name}: axis {self.settings.axis} counts in {quoted(unit)}, not in degrees."
                raise InstrumentError(message, fault="wrong set-up", remedy="Is the rotation stage on this axis?")
        return Identity("Physik Instrumente", model, serial, version)

    def home(self, limit_deg_per_s: float = math.inf) -> None:
        """Search the reference where it is not known; its velocity above the limit is lowered and read back."""
        if self._axis.value("FRF?") == "1":
            return
        if self._axis.number("SPA?", f" {REFERENCE_VELOCITY}") > limit_deg_per_s:
            self._axis.set("SPA", limit_deg_per_s, f" {REFERENCE_VELOCITY}")
        self._axis.command("SVO", " 1")
        self._target_deg = None
        self._axis.command("FRF")

    def move_to(self, angle_deg: float, rate_deg_per_s: float) -> None:
        """Begin an absolute move in the stage's own sense; sent once, never repeated."""
        self._axis.set("VEL", rate_deg_per_s)
        self._target_deg, self._moved_s = angle_deg, self._clock.now()
        self._axis.command("MOV", f" {angle_deg:.5f}")

    def moving(self) -> bool:
        """Whether it moves. Raises InstrumentError where it has stopped elsewhere than it should have."""
        if self._moves():
            self._moved_s = self._clock.now()
            return True
        self._axis.refuse_errors("the move")
        settling = self._target_deg is not None and self._axis.value("ONT?") != "1"
        if settling and self._clock.now() < self._moved_s + self.settings.settle_s:
            return True
        if self._target_deg is None and self._axis.value("FRF?") != "1":
            message, remedy = f"{self.name}: it stands, and does not know where.", "Home it again."
            raise InstrumentError(message, fault="stage fault", remedy=remedy)
        refuse_elsewhere(self.name, self.angle_deg(), self._target_deg, self.settings.tolerance_deg)
        return False

    def angle_deg(self) -> float:
        """The position [deg] in the stage's own sense."""
        return self._axis.number("POS?")

    def state(self) -> tuple[float, bool]:
        """Position [deg] and whether it moves; first the motion, so that a position said to be final is."""
        moving = self._moves()
        return self.angle_deg(), moving

    def make_safe(self) -> None:
        """Stop with its brake ramp; it holds that for an error, which is taken off."""
        self._target_deg = None
        self._link.send(f"HLT {self.settings.axis}\n".encode())
        self._axis.refuse_errors("HLT", forgive=STOPPED)

    def close(self) -> None:
        """Let go of the link."""
        self._link.close()

    def _moves(self) -> bool:
        """Whether any axis of its controller moves."""
        reply = self._axis.ask(MOTION)
        try:
            return int(reply, 16) != 0
        except ValueError:
            raise self._axis.wrong("#5", reply) from None

"""Newport ESP300/ESP301 with a rotary stage, ASCII over RS-232 (19200 8N1, RTS/CTS) or USB (921600)."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Annotated

from pydantic import Field

from drivers.framing.newport import NewportAxis
from labcal.bench.clock import Clock
from labcal.bench.driver_kit.roles import Identity
from labcal.bench.driver_kit.settings import Positive
from labcal.bench.links import Link, quoted
from labcal.errors import InstrumentError

DEGREES = "7"
NO_ERROR = "0"
HOME_SPEEDS = ("OL", "OH")  # the low one first, which must not be above the high one
AXIS_ERRORS = {  # of axis · 100 + code
    1: "beyond its range", 2: "amplifier fault", 3: "following error", 4: "hard limit +", 5: "hard limit -",
    6: "soft limit +", 7: "soft limit -", 8: "no stage connected", 9: "feedback fault",
    10: "faster than its greatest velocity", 11: "beyond its greatest acceleration", 13: "motor is off",
    20: "homing was aborted", 29: "interlock", 30: "not while it homes",
}  # fmt: skip


@dataclass(frozen=True, slots=True)
class Settings:
    """`home_type`: how it homes, 0 to 6 (1: switch, then index). `tolerance_deg`: how far off a move may end."""

    axis: Annotated[int, Field(ge=1, le=3)] = 1
    home_type: Annotated[int, Field(ge=0, le=6)] = 1
    tolerance_deg: Positive = 0.02
    max_rate_deg_per_s: Positive = 20.0
    timeout_s: Positive = 0.5


class Esp301Stage:
    """Absolute moves only, in degrees. Done is not arrived: errors and position are looked at after every move."""

    roles = ("platform",)
    never = (  # relative and endless moves, new zeros, flash, programs, resets, the axis' own configuration
        rb"\d(PR|MV|MT|MZ|DH|SN|SU|QM|QI|QV|SL|SR|ZA|ZB|ZE|ZF|ZH|ZS|SA|UF|HA|HB|PE|PH)[^?]",
        rb"SM\W|(^|;)\d*(RS|EX|EP|XX|QP|BG|BM|BO|SB|DO|ES)",
    )
    motorised = True

    def __init__(self, name: str, link: Link, clock: Clock, settings: Settings) -> None:
        self.name, self.settings, self._link = name, settings, link
        self.max_rate_deg_per_s = settings.max_rate_deg_per_s
        self._axis, self._homed = NewportAxis(name, self._command, self._ask_axis, settings.tolerance_deg), False

    def identify(self) -> Identity:
        """Ask controller and stage who they are. Raises InstrumentError where the axis does not count degrees."""
        version, stage, unit = self._ask("VE?"), self._ask(f"{self.settings.axis}ID?"), self._ask_axis("SN?")
        if not version.startswith("ESP30"):
            raise InstrumentError(
                f"{self.name}: {quoted(version)} answered, not an ESP300.", fault="another instrument"
            )
        if unit != DEGREES:
            raise InstrumentError(
                f"{self.name}: axis {self.settings.axis} counts in unit {unit}, not in degrees ({DEGREES}).",
                fault="wrong set-up",
                remedy="Is the rotary stage on this axis?",
            )
        self._homed = False
        model, _, serial = stage.partition(",")
        return Identity("Newport", model.strip(), serial.replace("SN", "").strip(" :"), version)

    def home(self, limit_deg_per_s: float = math.inf) -> None:
        """Search the reference once per connection: the controller does not tell whether it knows it."""
        if not self._homed:
            if limit_deg_per_s < math.inf:
                for speed in HOME_SPEEDS:
                    self._axis.at_most(speed, limit_deg_per_s)
            self._command("MO")
            self._axis.target_deg = 0.0
            self._command(f"OR{self.settings.home_type}")
            self._homed = True

    def move_to(self, angle_deg: float, rate_deg_per_s: float) -> None:
        """Begin an absolute move in the stage's own sense; sent once, never repeated."""
        self._axis.move_to(angle_deg, rate_deg_per_s)

    def moving(self) -> bool:
        """Whether it moves. Raises InstrumentError where it has stopped elsewhere than it should have."""
        moving = self._moves()
        self._refuse_errors("the move")
        if not moving:
            self._axis.refuse_elsewhere()
        return moving

    def angle_deg(self) -> float:
        """The position [deg] in the stage's own sense."""
        return self._axis.angle_deg()

    def state(self) -> tuple[float, bool]:
        """Position [deg] and whether it moves; first the motion, so that a position said to be final is."""
        moving = self._moves()
        return self.angle_deg(), moving

    def make_safe(self) -> None:
        """Stop with its brake ramp."""
        self._axis.stop()

    def close(self) -> None:
        """Let go of the link."""
        self._link.close()

    def _command(self, words: str) -> None:
        self._link.send(f"{self.settings.axis}{words}\r".encode())
        self._refuse_errors(words)

    def _refuse_errors(self, words: str) -> None:
        code, _, text = (part.strip(" ") for part in (*self._ask("TB?").split(",", 2), "", "")[:3])
        if code != NO_ERROR:
            number = int(code) if code.isdigit() else 0
            said = AXIS_ERRORS.get(number % 100, text) if number >= 100 else text
            self._homed = self._homed and number % 100 not in (8, 9, 20)
            raise InstrumentError(
                f"{self.name}: {words} failed: error {code}, {said or text}.",
                fault="stage fault",
                remedy="Look at the stage, home it and try again.",
            )

    def _moves(self) -> bool:
        done = self._ask_axis("MD?")
        if done not in ("0", "1"):
            raise self._axis.wrong("MD?", done)
        return done == "0"

    def _ask_axis(self, words: str) -> str:
        return self._ask(f"{self.settings.axis}{words}")

    def _ask(self, text: str) -> str:
        self._link.flush()
        reply = self._link.ask(text.encode() + b"\r", end=b"\r\n", timeout_s=self.settings.timeout_s)
        return reply.strip(b" \r\n").decode("ascii", "replace")

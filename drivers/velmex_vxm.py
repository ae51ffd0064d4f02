"""Velmex VXM with a rotary table (B48 and like), ASCII over RS-232 or USB (9600 8N1)."""

from __future__ import annotations

import math
import re
from dataclasses import dataclass
from typing import Annotated, Literal

from pydantic import Field

from labcal.bench.clock import Clock
from labcal.bench.driver_kit.arrival import refuse_elsewhere
from labcal.bench.driver_kit.roles import Identity
from labcal.bench.driver_kit.settings import Count, Positive
from labcal.bench.links import Link, quoted
from labcal.errors import InstrumentError, LimitError

READY, BUSY, JOGS = b"R", b"B", b"Jb"  # answers to V; the last two while somebody turns it from its panel
POSITION = re.compile(rb"[XYZT]?([+-]\d{7})\r")  # some clients have met the letter that asked before it
PASSED_OVER, MOST_PASSED_OVER = (
    b"^O\r\n",
    20,
)  # what it says of a program that has ended, and line ends of what was said before
COUNTERS = "XYZT"  # of motors 1 to 4
FASTEST = 6000  # steps a second
SWITCHES = {"negative": "-0", "positive": "0"}
START_S = 0.1  # until it shows that it moves


@dataclass(frozen=True, slots=True)
class Settings:
    """`steps_per_turn` of the table: 400 a motor turn times its gear, 14 400 for 36:1; a wrong one turns too far, so
    the first turn is made with a look at the table's scale.

    `home`: the switch at which its count is set to zero; "none" takes the count that it keeps while it is on: a table
    without a switch would turn for ever. `home_deg_per_s`: how fast it goes there.
    """

    motor: Annotated[int, Field(ge=1, le=4)] = 1
    steps_per_turn: Count = 14_400
    home: Literal["none", "negative", "positive"] = "none"
    home_deg_per_s: Positive = 4.0
    tolerance_deg: Positive = 0.05
    max_rate_deg_per_s: Positive = 20.0
    timeout_s: Positive = 0.5


class VelmexStage:
    """Absolute moves only, each a program of one line that is run at once. Ready is not arrived."""

    roles = ("platform",)
    never = (  # all but questions, online, one absolute index, its way to the switch and zero there, stop
        rb"^(?!(?-i:F|V|[XYZT]|D|C,S\dM\d+,IA?\dM-?\d+,R|C,IA\dM-0,R)\r?\Z)",
        rb"(?-i:I\dM(?!-?0,R\r))",
    )
    motorised = True

    def __init__(self, name: str, link: Link, clock: Clock, settings: Settings) -> None:
        self.name, self.settings, self._link, self._clock = name, settings, link, clock
        self.max_rate_deg_per_s = settings.max_rate_deg_per_s
        self._target_deg: float | None = None
        self._homed, self._homing, self._begun_s = False, False, -math.inf

    def identify(self) -> Identity:
        """It has no name to ask for: taken online, it must say its state and a position as a VXM does."""
        self._homed, self._homing = False, False
        self._link.send(b"F\r")
        self._moves()
        self.angle_deg()
        return Identity("Velmex", "VXM", f"motor {self.settings.motor}")

    def home(self, limit_deg_per_s: float = math.inf) -> None:
        """Go to its switch, once per connection, no faster than this; nothing where no switch is stated."""
        if self._homed or self.settings.home == "none":
            return
        rate = min(self.settings.home_deg_per_s, limit_deg_per_s)
        self._target_deg, self._homing = None, True
        self._run(f"S{self.settings.motor}M{self._speed(rate)},I{self.settings.motor}M{SWITCHES[self.settings.home]}")

    def move_to(self, angle_deg: float, rate_deg_per_s: float) -> None:
        """Begin an absolute move in the stage's own sense; sent once, never repeated."""
        motor, self._target_deg, self._homing = self.settings.motor, angle_deg, False
        self._run(f"S{motor}M{self._speed(rate_deg_per_s)},IA{motor}M{self._steps(angle_deg)}")

    def moving(self) -> bool:
        """Whether it moves. Raises InstrumentError where it has stopped elsewhere than it should have."""
        if self._moves():
            return True
        if self._homing:
            self._homed, self._homing, self._target_deg = True, False, 0.0
            self._run(f"IA{self.settings.motor}M-0")
            return True
        refuse_elsewhere(self.name, self.angle_deg(), self._target_deg, self.settings.tolerance_deg)
        return False

    def angle_deg(self) -> float:
        """The position [deg] in the stage's own sense: what it has counted, for it sees nothing of the table."""
        reply = self._ask(COUNTERS[self.settings.motor - 1], end=b"\r")
        if not (found := POSITION.fullmatch(reply.lstrip(PASSED_OVER))):
            raise self._wrong("a position", reply)
        return int(found[1]) * 360 / self.settings.steps_per_turn

    def state(self) -> tuple[float, bool]:
        """Position [deg] and whether it moves; first the motion, so that a position said to be final is."""
        moving = self._moves()
        return self.angle_deg(), moving

    def make_safe(self) -> None:
        """Stop with its brake ramp; nothing answers."""
        self._target_deg, self._homing, self._begun_s = None, False, -math.inf
        self._link.send(b"D\r")

    def close(self) -> None:
        """Let go of the link."""
        self._link.close()

    def _moves(self) -> bool:
        if (reply := self._ask("V", end=1)) in JOGS:
            remedy = "Let go of it, home it and try again."
            raise InstrumentError(f"{self.name}: it is turned from its own panel.", fault="touched", remedy=remedy)
        if reply not in (READY, BUSY):
            raise self._wrong("its state", reply)
        return reply == BUSY or self._clock.now() < self._begun_s + START_S

    def _run(self, program: str) -> None:
        self._begun_s = self._clock.now()
        self._link.flush()
        self._link.send(f"C,{program},R\r".encode())

    def _ask(self, words: str, *, end: bytes | int) -> bytes:
        self._link.flush()
        reply = self._link.ask(f"{words}\r".encode(), end=end, timeout_s=self.settings.timeout_s)
        for _ in range(MOST_PASSED_OVER):
            if not reply.strip(PASSED_OVER):  # it has just come to rest
                reply = self._link.ask(b"", end=end, timeout_s=self.settings.timeout_s)
        return reply

    def _speed(self, rate_deg_per_s: float) -> int:
        if not 1 <= (speed := int(rate_deg_per_s * self.settings.steps_per_turn / 360)) <= FASTEST:
            message = f"{self.name}: {rate_deg_per_s:g} deg/s is {speed} steps/s, not 1 to {FASTEST}; nothing was sent."
            raise LimitError(message)
        return speed

    def _steps(self, deg: float) -> int:
        return round(deg * self.settings.steps_per_turn / 360)

    def _wrong(self, what: str, reply: bytes) -> InstrumentError:
        self._link.flush()
        return InstrumentError(f"{self.name}: {what} was answered {quoted(reply)}.", fault="wrong reply")

"""Trinamic modules (TMCM-…, PD-…) with a stepper that turns the platform: TMCL in its binary form."""

from __future__ import annotations

import math
from contextlib import suppress
from dataclasses import dataclass
from typing import Annotated

from pydantic import Field

from drivers.framing.tmcl import GET, WHY_IT_STANDS, Conversation, Refused
from labcal.bench.clock import Clock
from labcal.bench.driver_kit.arrival import refuse_elsewhere, refuse_fast_homing
from labcal.bench.driver_kit.roles import Identity
from labcal.bench.driver_kit.settings import Count, Positive
from labcal.bench.links import Link
from labcal.errors import InstrumentError, LimitError

STOP, MOVE, SET, REFERENCE, VERSION = 3, 4, 5, 13, 136
ABSOLUTE, START, END, STATUS, BINARY = 0, 0, 1, 2, 1  # types of MOVE, REFERENCE and VERSION
POSITION, SPEED, MOST_SPEED, PULSE_DIVISOR = 1, 3, 4, 154  # parameters of an axis
SEARCH_SPEEDS = (194, 195)
LARGEST_SHIFT = 8  # as a search speed older modules take how often MOST_SPEED is halved
START_S = 0.1  # until it shows that it moves


@dataclass(frozen=True, slots=True)
class Settings:
    """`microsteps_per_turn` of the platform: 200 full steps, times their microsteps, times the gear; a wrong one turns
    too far, so the first turn is made with a look at the table's scale.

    `host`: the address that it answers to. `tolerance_deg`: how far off a move may end.
    """

    address: Annotated[int, Field(ge=1, le=255)] = 1
    host: Annotated[int, Field(ge=0, le=255)] = 2
    axis: Annotated[int, Field(ge=0, le=5)] = 0
    microsteps_per_turn: Count = 4_608_000
    tolerance_deg: Positive = 0.05
    max_rate_deg_per_s: Positive = 20.0
    timeout_s: Positive = 0.5


class TmclStage:
    """Absolute moves only. Standing still is not arrived: the position is looked at after every move."""

    roles = ("platform",)
    never = (  # all but stop, an absolute move, the greatest speed, questions, a reference search
        rb"^(?!(?-i:.(\x03\0|\x04\0|\x05\x04|\x06.|\x0d[\0-\x02]|\x88\x01).{6})\Z)",
    )
    motorised = True

    def __init__(self, name: str, link: Link, clock: Clock, settings: Settings) -> None:
        self.name, self.settings, self._link, self._clock = name, settings, link, clock
        self.max_rate_deg_per_s = settings.max_rate_deg_per_s
        self._module = Conversation(name, link, settings.address, settings.host, settings.axis, settings.timeout_s)
        self._target_deg: float | None = None
        self._divisor: int | None = None  # of its pulses; None where it counts microsteps a second
        self._homed, self._begun_s = False, -math.inf

    def identify(self) -> Identity:
        """Ask for module and firmware, and how it counts speed."""
        version = self._module.ask(VERSION, BINARY) & 0xFFFFFFFF
        self._homed, self._divisor = False, self._module.parameter(PULSE_DIVISOR)
        firmware = f"{version >> 8 & 0xFF}.{version & 0xFF:02d}"
        return Identity("Trinamic", f"TMCM-{version >> 16}", f"address {self.settings.address}", firmware)

    def home(self, limit_deg_per_s: float = math.inf) -> None:
        """Search the reference once per connection: the module does not tell whether it knows it."""
        if self._homed:
            return
        if limit_deg_per_s < math.inf:
            refuse_fast_homing(self.name, max(map(self._search_rate, SEARCH_SPEEDS)), limit_deg_per_s)
        self._target_deg, self._begun_s = 0.0, self._clock.now()
        self._module.ask(REFERENCE, START)
        self._homed = True

    def move_to(self, angle_deg: float, rate_deg_per_s: float) -> None:
        """Begin an absolute move in the stage's own sense; sent once, never repeated."""
        if (speed := int(rate_deg_per_s / self._rate(1))) < 1:
            raise LimitError(f"{self.name}: {rate_deg_per_s:g} deg/s is below its least speed; nothing was sent.")
        self._module.ask(SET, MOST_SPEED, speed)
        if (held := self._get(MOST_SPEED)) != speed:
            raise InstrumentError(f"{self.name}: a speed of {speed} reads back {held}.", fault="read-back")
        self._target_deg, self._begun_s = angle_deg, self._clock.now()
        self._module.ask(MOVE, ABSOLUTE, round(angle_deg * self.settings.microsteps_per_turn / 360))

    def moving(self) -> bool:
        """Whether it moves. Raises InstrumentError where it has stopped elsewhere than it should have."""
        if self._moves():
            return True
        try:
            refuse_elsewhere(self.name, self.angle_deg(), self._target_deg, self.settings.tolerance_deg)
        except InstrumentError as fault:
            if why := self._why():
                raise InstrumentError(f"{fault.args[0]} {why}", fault="not arrived") from fault
            raise
        return False

    def angle_deg(self) -> float:
        """The position [deg] in the stage's own sense."""
        return self._get(POSITION) * 360 / self.settings.microsteps_per_turn

    def state(self) -> tuple[float, bool]:
        """Position [deg] and whether it moves; first the motion, so that a position said to be final is."""
        moving = self._moves()
        return self.angle_deg(), moving

    def make_safe(self) -> None:
        """Stop with its brake ramp, and end a reference search, which would go on."""
        self._target_deg, self._begun_s = None, -math.inf
        try:
            self._module.ask(STOP, 0)
        finally:
            with suppress(Refused):
                self._module.ask(REFERENCE, END)

    def close(self) -> None:
        """Let go of the link."""
        self._link.close()

    def _moves(self) -> bool:
        early = self._clock.now() < self._begun_s + START_S
        return early or self._get(SPEED) != 0 or self._module.ask(REFERENCE, STATUS) != 0

    def _get(self, parameter: int) -> int:
        return self._module.ask(GET, parameter)

    def _rate(self, speed: int) -> float:
        """As deg/s: microsteps a second, or of a TMC429 as its data sheet has it."""
        per_s = float(speed) if self._divisor is None else speed * 16e6 / (2048 * 32 << self._divisor)
        return per_s * 360 / self.settings.microsteps_per_turn

    def _search_rate(self, parameter: int) -> float:
        speed = self._get(parameter)
        if self._divisor is not None and speed <= LARGEST_SHIFT:
            speed = self._get(MOST_SPEED) >> speed
        return self._rate(speed)

    def _why(self) -> str:
        """What it says itself of why it stands, as far as this module can."""
        said = [(words, self._module.parameter(number)) for number, words in WHY_IT_STANDS.items()]
        flags = [text for words, held in said for bit, text in words.items() if (held or 0) >> bit & 1]
        return f"It says: {' and '.join(flags)}." if flags else ""

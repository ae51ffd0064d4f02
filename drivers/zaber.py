"""Zaber rotary stages (X-RSW, X-RSB, X-RST …), ASCII protocol."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Annotated

from pydantic import Field

from drivers.framing.zaber import INTERRUPTED, NOT_HOMED, SPEED_DATA, TURNED, Conversation, Reply
from labcal.bench.clock import Clock
from labcal.bench.driver_kit.arrival import refuse_elsewhere
from labcal.bench.driver_kit.roles import Identity
from labcal.bench.driver_kit.settings import Positive
from labcal.bench.links import Link
from labcal.errors import InstrumentError

MOVES_AT_A_SPEED = (7, 25)  # firmware whose moves state their own; before it, each new one wears its memory


@dataclass(frozen=True, slots=True)
class Settings:
    """`tolerance_deg`: how far from its target a finished move may end."""

    address: Annotated[int, Field(ge=1, le=99)] = 1
    axis: Annotated[int, Field(ge=1, le=9)] = 1
    tolerance_deg: Positive = 0.02
    max_rate_deg_per_s: Positive = 24.0
    timeout_s: Positive = 0.5


class ZaberStage:
    """Absolute moves only. Idle is not arrived: warnings and position are looked at after every move.

    That it stalled is said until it is acknowledged, that its knob was turned until it moves: `home` does both.
    """

    roles = ("platform",)
    never = (rb"system re", rb"renumber", rb"move (rel|vel|min|max|index|sin)", rb"set comm", rb"tools")
    motorised = True

    def __init__(self, name: str, link: Link, clock: Clock, settings: Settings) -> None:
        self.name, self.settings, self._link = name, settings, link
        self.max_rate_deg_per_s = settings.max_rate_deg_per_s
        self._steps_per_turn: int | None = None
        self._version: tuple[int, ...] = ()
        self._target_deg: float | None = None
        self._stage = Conversation(name, link, settings.address, settings.axis, settings.timeout_s)

    def identify(self) -> Identity:
        """Ask for device id, serial number and firmware, and how many microsteps make a turn."""
        device, serial = (self._stage.ask(f"get {what}").data for what in ("deviceid", "system.serial"))
        version = self._ask_version()
        self._steps_per_turn = self._stage.number("get limit.cycle.dist")[0]
        return Identity("Zaber", f"device {device}", serial, version)

    def home(self, limit_deg_per_s: float = math.inf) -> None:
        """Find the reference position, where it is not known or may have been lost; it goes on while time passes.

        What it reports is acknowledged first. A stage homes at the lesser of its `maxspeed` and of its own
        limit.approach.maxspeed (Zaber's EPICS driver).
        """
        flags = self._stage.flags()
        if any(flag.startswith("F") for flag in flags):
            self._stage.ask("warnings clear")
        elif flags.isdisjoint((*NOT_HOMED, TURNED, INTERRUPTED)):
            return
        if limit_deg_per_s < math.inf:
            speed = self._speed(min(limit_deg_per_s, self.max_rate_deg_per_s))
            if self._stage.number("get maxspeed")[0] > speed:
                self._stage.ask(f"set maxspeed {speed}")
        self._target_deg = 0.0
        self._stage.ask("home")

    def move_to(self, angle_deg: float, rate_deg_per_s: float) -> None:
        """Begin an absolute move in the stage's own sense; sent once, never repeated."""
        move, speed = f"move abs {round(angle_deg * self._steps_per_deg)}", self._speed(rate_deg_per_s)
        if not self._version:
            self._ask_version()
        if self._version >= MOVES_AT_A_SPEED:
            move += f" {speed}"
        elif self._stage.number("get maxspeed")[0] != speed:
            self._stage.ask(f"set maxspeed {speed}")
        self._target_deg = angle_deg
        self._stage.ask(move)

    def moving(self) -> bool:
        """Whether it moves. Raises InstrumentError where it has stopped elsewhere than it should have."""
        position, reply = self._stage.number("get pos")
        self._refuse_faults(reply)
        if not reply.busy:
            angle = position / self._steps_per_deg
            refuse_elsewhere(self.name, angle, self._target_deg, self.settings.tolerance_deg)
        return reply.busy

    def angle_deg(self) -> float:
        """The position [deg] in the stage's own sense."""
        return self.state()[0]

    def state(self) -> tuple[float, bool]:
        """Position [deg] and whether it is busy, in one reply."""
        position, reply = self._stage.number("get pos")
        return position / self._steps_per_deg, reply.busy

    def make_safe(self) -> None:
        """Stop with a brake ramp."""
        self._target_deg = None
        self._stage.ask("stop")

    def close(self) -> None:
        """Let go of the link."""
        self._link.close()

    @property
    def _steps_per_deg(self) -> float:
        if self._steps_per_turn is None:
            self._steps_per_turn = self._stage.number("get limit.cycle.dist")[0]
        return self._steps_per_turn / 360

    def _speed(self, rate_deg_per_s: float) -> int:
        return round(rate_deg_per_s * self._steps_per_deg * SPEED_DATA)

    def _ask_version(self) -> str:
        reply = self._stage.ask("get version")
        try:
            self._version = tuple(int(part) for part in reply.data.split("."))
        except ValueError:
            raise self._stage.wrong("get version", reply) from None
        return reply.data

    def _refuse_faults(self, reply: Reply) -> None:
        """NI is none: where a move was cut short, its place tells. WR at rest is one, for homing ends it."""
        flag = reply.warning
        if flag == TURNED:
            said, fault = "somebody turned its knob", "touched"
        elif flag.startswith("F") or (flag in NOT_HOMED and not reply.busy):
            said, fault = "the stage reports a fault", "stage fault"
        else:
            return
        raise InstrumentError(f"{self.name}: warning {flag}: {said}.", fault=fault, remedy="Home it and try again.")

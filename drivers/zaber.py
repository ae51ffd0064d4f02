"""Zaber rotary stages (X-RSW, X-RSB, X-RST …), ASCII protocol."""

from __future__ import annotations

import math
import re
from dataclasses import dataclass
from typing import Annotated

from pydantic import Field

from drivers.framing.zaber import NOT_HOMED, REPLY, SPEED_DATA, TOUCHED, UNASKED, Reply, checksum
from labcal.bench.clock import Clock
from labcal.bench.driver_kit.arrival import refuse_elsewhere
from labcal.bench.driver_kit.roles import Identity
from labcal.bench.driver_kit.settings import Positive
from labcal.bench.links import Link, quoted
from labcal.errors import InstrumentError

WHOLE = re.compile(r"-?\d+", re.ASCII)
MOST_OLD = 20  # older replies and what nobody asked for, before the reply to a request


@dataclass(frozen=True, slots=True)
class Settings:
    """`tolerance_deg`: how far from its target a finished move may end."""

    address: Annotated[int, Field(ge=1, le=99)] = 1
    axis: Annotated[int, Field(ge=1, le=9)] = 1
    tolerance_deg: Positive = 0.02
    max_rate_deg_per_s: Positive = 24.0
    timeout_s: Positive = 0.5


class ZaberStage:
    """Absolute moves only. Idle is not arrived: warnings and position are looked at after every move."""

    roles = ("platform",)
    never = (rb"system re", rb"renumber", rb"move (rel|vel|min|max|index|sin)", rb"set comm", rb"tools")
    motorised = True

    def __init__(self, name: str, link: Link, clock: Clock, settings: Settings) -> None:
        self.name, self.settings, self._link = name, settings, link
        self.max_rate_deg_per_s = settings.max_rate_deg_per_s
        self._steps_per_turn: int | None = None
        self._target_deg: float | None = None
        self._id, self._summed = 0, False  # summed: it has sent a checksum, so every reply must have one

    def identify(self) -> Identity:
        """Ask for device id, serial number and firmware, and how many microsteps make a turn."""
        device, serial, version = (self._ask(f"get {what}").data for what in ("deviceid", "system.serial", "version"))
        self._steps_per_turn = self._number("get limit.cycle.dist")[0]
        return Identity("Zaber", f"device {device}", serial, version)

    def home(self, limit_deg_per_s: float = math.inf) -> None:
        """Find the reference position, where the device says that it does not know it; it goes on while time passes.

        A stage homes at the lesser of its `maxspeed` and of its own limit.approach.maxspeed (Zaber's EPICS driver).
        """
        if self._ask("").warning in NOT_HOMED:
            if limit_deg_per_s < math.inf:
                self._set_rate(min(limit_deg_per_s, self.max_rate_deg_per_s))
            self._target_deg = 0.0
            self._ask("home")

    def move_to(self, angle_deg: float, rate_deg_per_s: float) -> None:
        """Begin an absolute move in the stage's own sense; sent once, never repeated."""
        self._set_rate(rate_deg_per_s)
        self._target_deg = angle_deg
        self._ask(f"move abs {round(angle_deg * self._steps_per_deg)}")

    def moving(self) -> bool:
        """Whether it moves. Raises InstrumentError where it has stopped elsewhere than it should have."""
        position, reply = self._number("get pos")
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
        position, reply = self._number("get pos")
        return position / self._steps_per_deg, reply.busy

    def make_safe(self) -> None:
        """Stop with a brake ramp."""
        self._target_deg = None
        self._ask("stop")

    def close(self) -> None:
        """Let go of the link."""
        self._link.close()

    def _set_rate(self, rate_deg_per_s: float) -> None:
        self._ask(f"set maxspeed {round(rate_deg_per_s * self._steps_per_deg * SPEED_DATA)}")

    @property
    def _steps_per_deg(self) -> float:
        if self._steps_per_turn is None:
            self._steps_per_turn = self._number("get limit.cycle.dist")[0]
        return self._steps_per_turn / 360

    def _number(self, words: str) -> tuple[int, Reply]:
        reply = self._ask(words)
        if not WHOLE.fullmatch(reply.data):
            raise InstrumentError(f"{self.name}: {words!r} was answered {quoted(reply.data)}.", fault="wrong reply")
        return int(reply.data), reply

    def _ask(self, words: str) -> Reply:
        self._id = (self._id + 1) % 96
        text = f"/{self.settings.address} {self.settings.axis} {self._id:02d} {words}".rstrip()
        request = text.encode() + b"\r\n"
        for _ in range(MOST_OLD):
            frame = self._link.ask(request, end=b"\r\n", timeout_s=self.settings.timeout_s).lstrip(b"\r\n")
            if (reply := self._matched(frame, words)) is not None:
                return reply
            request = b""  # an older reply, another device's, or an alert: the one to this request is still to come
        raise InstrumentError(f"{self.name}: it says much, but does not answer {words!r}.", fault="wrong reply")

    def _matched(self, frame: bytes, words: str) -> Reply | None:
        if frame.startswith(UNASKED):
            return None
        found = REPLY.fullmatch(frame)
        if found is None or not self._sound(frame, found[8]):
            raise InstrumentError(f"{self.name}: {quoted(frame)} is no valid reply.", fault="wrong reply")
        if found[3] is None or (int(found[1]), int(found[3])) != (self.settings.address, self._id):
            return None
        if found[4] == b"RJ":
            raise InstrumentError(f"{self.name}: {words!r} was rejected: {quoted(found[7])}.", fault="refused")
        return Reply(found[7].decode(), found[5] == b"BUSY", found[6].decode())

    def _sound(self, frame: bytes, sum_: bytes | None) -> bool:
        fits = sum_ is not None and checksum(frame[1:-5]) == sum_.decode()
        self._summed = self._summed or fits
        return fits or (sum_ is None and not self._summed)

    def _refuse_faults(self, reply: Reply) -> None:
        if reply.warning.startswith("F") or reply.warning in TOUCHED + NOT_HOMED:
            touched = reply.warning in TOUCHED
            raise InstrumentError(
                f"{self.name}: warning {reply.warning}"
                + (": somebody turned the knob." if touched else ": the stage reports a fault."),
                fault="touched" if touched else "stage fault",
                remedy="Home it and begin this step again.",
            )

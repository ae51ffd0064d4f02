"""Thorlabs rotation stages by the APT protocol: K10CR1, PRM1-Z8 on a KDC101 or TDC001, others with their scale."""

from __future__ import annotations

import math
from dataclasses import dataclass

from drivers.framing import apt
from labcal.bench.clock import Clock
from labcal.bench.driver_kit.arrival import refuse_elsewhere
from labcal.bench.driver_kit.roles import Identity
from labcal.bench.driver_kit.settings import NotNegative, Positive
from labcal.bench.links import Link, quoted
from labcal.errors import InstrumentError

HOMED, MOVING = 1 << 10, 0x02F0  # moves, jogs or homes, in either direction
PROFILED = 2  # the kind of stop that brakes
ENABLE_S, START_S = 1.0, 0.2  # until it hears what comes after an enable; until it shows that it moves


@dataclass(frozen=True, slots=True)
class Settings:
    """`counts_per_deg`: 0 for a K10CR1, or a PRM1-Z8 on a KDC101 or TDC001; a wrong one turns too far.

    `tolerance_deg`: how far from its target a finished move may end.
    """

    counts_per_deg: NotNegative = 0.0
    tolerance_deg: Positive = 0.03
    max_rate_deg_per_s: Positive = 10.0
    timeout_s: Positive = 0.5


class AptStage:
    """Absolute moves only. Rest is not arrival: faults and position are looked at after every move."""

    roles = ("platform",)
    never = (  # all but questions, a velocity, homing, one absolute move, enable and stop: no flash, no new zero
        rb"^(?!(?-i:(\x05\0|\x12\0|\x11\x04|\x14\x04|\x29\x04|\x41\x04|\x43\x04|\x10\x02|\x65\x04)..\x50\x01"
        rb"|\x53\x04\x06\0\xd0\x01.{6}|(\x13\x04|\x40\x04)\x0e\0\xd0\x01.{14})\Z)",
    )
    motorised = True

    def __init__(self, name: str, link: Link, clock: Clock, settings: Settings) -> None:
        self.name, self.settings, self._link, self._clock = name, settings, link, clock
        self.max_rate_deg_per_s = settings.max_rate_deg_per_s
        self._motor = apt.Conversation(name, link, settings.timeout_s)
        self._scale: tuple[float, float] | None = None
        self._target_deg: float | None = None
        self._enabled, self._begun_s = False, -math.inf

    def identify(self) -> Identity:
        """Ask the controller who it is; its model says how it counts. Raises InstrumentError for another one."""
        self._enabled = False
        self._motor.send(apt.STOP_UPDATES)
        serial, model, _, version, *_ = self._motor.exchange(apt.REQ_INFO)
        called = model.split(b"\0")[0].decode("ascii", "replace").strip()
        counts, velocity = apt.MODELS.get(called, (-1.0, 0.0))
        if counts < 0:
            text = f"{self.name}: {quoted(called)} answered, none of {', '.join(apt.MODELS)}."
            raise InstrumentError(text, fault="another instrument")
        counts = self.settings.counts_per_deg or counts
        if not counts:
            text = f"{self.name}: a {called} does not say which stage hangs on it."
            raise InstrumentError(text, fault="wrong set-up", remedy="State counts_per_deg of the stage in bench.toml.")
        self._scale = (counts, counts * velocity)
        return Identity("Thorlabs", called, str(serial), ".".join(map(str, version[2::-1])))

    def home(self, limit_deg_per_s: float = math.inf) -> None:
        """Search the reference where it is not known; a homing velocity above the limit is lowered and read back."""
        if self._bits() & HOMED:
            return
        direction, switch, velocity, offset = self._motor.ask(apt.REQ_HOMING)
        if velocity > (most := limit_deg_per_s * self._counts()[1]):
            self._motor.set(apt.SET_HOMING, direction, switch, int(most), offset)
            self._read_back(self._motor.ask(apt.REQ_HOMING)[2], int(most))
        self._enable()
        self._target_deg, self._begun_s = None, self._clock.now()
        self._motor.send(apt.HOME)

    def move_to(self, angle_deg: float, rate_deg_per_s: float) -> None:
        """Begin an absolute move in the stage's own sense; sent once, never repeated."""
        _, acceleration, held = self._motor.ask(apt.REQ_VELOCITY)
        if held != (velocity := round(rate_deg_per_s * self._counts()[1])):
            self._motor.set(apt.SET_VELOCITY, 0, acceleration, velocity)
            self._read_back(self._motor.ask(apt.REQ_VELOCITY)[2], velocity)
        self._enable()
        self._target_deg, self._begun_s = angle_deg, self._clock.now()
        self._motor.set(apt.MOVE_ABSOLUTE, round(angle_deg * self._counts()[0]))

    def moving(self) -> bool:
        """Whether it moves. Raises InstrumentError where it has stopped elsewhere than it should have."""
        bits = self._bits()
        if self._moves(bits):
            return True
        if not bits & HOMED:
            raise InstrumentError(
                f"{self.name}: it stands, and does not know where.", fault="stage fault", remedy="Home it again."
            )
        refuse_elsewhere(self.name, self.angle_deg(), self._target_deg, self.settings.tolerance_deg)
        return False

    def angle_deg(self) -> float:
        """The position [deg] in the stage's own sense."""
        return self._motor.ask(apt.REQ_POSITION)[0] / self._counts()[0]

    def state(self) -> tuple[float, bool]:
        """Position [deg] and whether it moves; first the motion, so that a position said to be final is."""
        moving = self._moves(self._motor.ask(apt.REQ_BITS)[0])
        return self.angle_deg(), moving

    def make_safe(self) -> None:
        """Stop with its brake ramp."""
        self._target_deg, self._begun_s = None, -math.inf
        self._motor.send(apt.STOP, PROFILED)

    def close(self) -> None:
        """Let go of the link."""
        self._link.close()

    def _counts(self) -> tuple[float, float]:
        """Counts of a degree, and of a degree a second."""
        if self._scale is None:
            self.identify()
        assert self._scale is not None
        return self._scale

    def _bits(self) -> int:
        bits = self._motor.ask(apt.REQ_BITS)[0]
        if said := [words for bit, words in apt.FAULTS.items() if bits >> bit & 1]:
            text, remedy = (
                f"{self.name}: it says {' and '.join(said)}.",
                "Look at the stage, home it and try again.",
            )
            raise InstrumentError(text, fault="stage fault", remedy=remedy)
        return bits

    def _moves(self, bits: int) -> bool:
        return bool(bits & MOVING) or self._clock.now() < self._begun_s + START_S

    def _enable(self) -> None:
        """Once per connection, and a second before what follows: sooner some controllers lock up."""
        if not self._enabled:
            self._motor.send(apt.SET_ENABLED, 1)
            self._clock.wait_until(self._clock.now() + ENABLE_S)
            self._enabled = True

    def _read_back(self, held: int, sent: int) -> None:
        if held != sent:
            raise InstrumentError(f"{self.name}: a velocity of {sent} counts reads back {held}.", fault="read-back")

"""Standa 8SMC4 and 8SMC5 controllers with a rotation stage, over their USB port (115200 baud, 8N2)."""

from __future__ import annotations

import math
from dataclasses import dataclass

from drivers.framing.ximc import Conversation
from labcal.bench.clock import Clock
from labcal.bench.driver_kit.arrival import refuse_elsewhere, refuse_fast_homing
from labcal.bench.driver_kit.roles import Identity
from labcal.bench.driver_kit.settings import Count, Positive
from labcal.bench.links import Link, quoted
from labcal.errors import InstrumentError, LimitError

MOVES, RUNNING, FAILED = 0x01, 0x80, 0x40  # of the motion; of the last command
HOMED = 1 << 5
FAULTS = {
    6: "alarm", 8: "its driver is too hot", 9: "it is too hot", 10: "its supply is too high", 11: "too much current",
    16: "its supply is too low", 17: "its bridge failed", 20: "a winding is not what it should be",
    21: "its encoder failed", 23: "its motor does not answer",
}  # fmt: skip


@dataclass(frozen=True, slots=True)
class Settings:
    """`steps_per_turn`: full steps of the motor for a turn of the platform, 28 800 for 8MR190-2-28; a wrong one turns
    too far, so the first turn is made with a look at the table's scale. `tolerance_deg`: how far off a move may end.
    """

    steps_per_turn: Count = 28_800
    tolerance_deg: Positive = 0.03
    max_rate_deg_per_s: Positive = 20.0
    timeout_s: Positive = 0.5


class StandaStage:
    """Absolute moves only. Standing still is not arrived: flags and position are looked at after every move.

    Homing ends at the switch with whatever count stands there: there its zero is set, as the maker's `homezero` does.
    """

    roles = ("platform",)
    never = (  # all but questions, home and its zero, an absolute move, its speed and a stop: no memory, no firmware
        rb"^(?!(?-i:get[is]|g(ser|pos|mov|hom|eng)|home|zero|sstp|move.{14}|smov.{26})\Z)",
    )
    motorised = True

    def __init__(self, name: str, link: Link, clock: Clock, settings: Settings) -> None:
        self.name, self.settings, self._link = name, settings, link
        self.max_rate_deg_per_s = settings.max_rate_deg_per_s
        self._controller = Conversation(name, link, settings.timeout_s)
        self._target_deg: float | None = None
        self._homed, self._homing, self._division = False, False, 0

    def identify(self) -> Identity:
        """Ask who it is, and how it divides a step. Raises InstrumentError for another instrument."""
        self._homed, self._homing, self._division = False, False, 0
        maker, _, product, major, minor, release = self._controller.ask("geti")
        if maker != b"XIMC":
            message = f"{self.name}: {quoted(maker)} answered, no 8SMC."
            raise InstrumentError(message, fault="another instrument")
        model = product.split(b"\0")[0].decode("ascii", "replace").strip()
        return Identity("Standa", model or "8SMC", str(*self._controller.ask("gser")), f"{major}.{minor}.{release}")

    def home(self, limit_deg_per_s: float = math.inf) -> None:
        """Search the reference once per connection: a count that is kept through power-off is not relied on."""
        if self._homed:
            return
        if limit_deg_per_s < math.inf:
            fast, fast_part, slow, slow_part, *_ = self._controller.ask("ghom")
            fastest = max(self._deg(fast, fast_part), self._deg(slow, slow_part))
            refuse_fast_homing(self.name, fastest, limit_deg_per_s)
        self._target_deg, self._homing = None, True
        self._controller.command("home")

    def move_to(self, angle_deg: float, rate_deg_per_s: float) -> None:
        """Begin an absolute move in the stage's own sense; sent once, never repeated."""
        _, _, *others = self._controller.ask("gmov")
        speed = self._steps(rate_deg_per_s)
        if speed == (0, 0):
            raise LimitError(f"{self.name}: {rate_deg_per_s:g} deg/s is below its least speed; nothing was moved.")
        self._controller.command("smov", *speed, *others)
        if (held := self._controller.ask("gmov")[:2]) != speed:
            message = f"{self.name}: a speed of {speed} steps and parts reads back {held}."
            raise InstrumentError(message, fault="read-back")
        self._target_deg, self._homing = angle_deg, False
        self._controller.command("move", *self._steps(angle_deg))

    def moving(self) -> bool:
        """Whether it moves. Raises InstrumentError where it has stopped elsewhere than it should have."""
        moves, command, flags, angle = self._status()
        if said := [words for bit, words in FAULTS.items() if flags >> bit & 1]:
            self._refuse(f"it says: {', '.join(said)}")
        if moves:
            return True
        if self._homing:
            if command & FAILED or not flags & HOMED:
                self._refuse("it did not find its reference")
            self._controller.command("zero")
            self._homed, self._homing = True, False
            return False
        refuse_elsewhere(self.name, angle, self._target_deg, self.settings.tolerance_deg)
        return False

    def angle_deg(self) -> float:
        """The position [deg] in the stage's own sense."""
        return self._status()[3]

    def state(self) -> tuple[float, bool]:
        """Position [deg] and whether it moves, in one answer."""
        moves, _, _, angle = self._status()
        return angle, moves

    def make_safe(self) -> None:
        """Stop with its brake ramp."""
        self._target_deg, self._homing = None, False
        self._controller.command("sstp")

    def close(self) -> None:
        """Let go of the link."""
        self._link.close()

    def _status(self) -> tuple[bool, int, int, float]:
        """Whether it moves, state of the last command, flags, and position [deg]."""
        motion, command, _, _, _, steps, parts, *others = self._controller.ask("gets")
        moves = bool(motion & MOVES or command & RUNNING)
        return moves, command, others[-3], self._deg(steps, parts)

    def _parts(self) -> int:
        """Into how many parts it divides a step: 1 to 256."""
        if not self._division:
            mode = self._controller.ask("geng")[6]
            if not 1 <= mode <= 9:
                raise InstrumentError(f"{self.name}: its microstep mode is {mode}.", fault="wrong reply")
            self._division = 1 << mode - 1
        return self._division

    def _deg(self, steps: int, parts: int) -> float:
        return (steps + parts / self._parts()) * 360 / self.settings.steps_per_turn

    def _steps(self, deg: float) -> tuple[int, int]:
        """Whole steps and parts of one, both of the sign of the angle."""
        parts = round(deg * self.settings.steps_per_turn / 360 * self._parts())
        steps, rest = divmod(abs(parts), self._parts())
        return (steps, rest) if parts >= 0 else (-steps, -rest)

    def _refuse(self, what: str) -> None:
        remedy = "Look at the stage, home it and try again."
        raise InstrumentError(f"{self.name}: {what}.", fault="stage fault", remedy=remedy)

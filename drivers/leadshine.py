"""Leadshine iEM-RS, EM2RS, DM556RS, CS2RS, EL7-RS drives on RS-485, Modbus RTU with "PR" paths."""

from __future__ import annotations

import math
from dataclasses import dataclass

from labcal.bench.clock import Clock
from labcal.bench.driver_kit.arrival import refuse_elsewhere, refuse_fast_homing
from labcal.bench.driver_kit.registers import Registers, signed, words
from labcal.bench.driver_kit.roles import Identity
from labcal.bench.driver_kit.settings import Address, Count, NotNegative, Positive
from labcal.bench.links.modbus import ModbusLink
from labcal.errors import InstrumentError, LimitError

PULSES, STATUS, ALARM, TRIGGER = 0x0001, 0x1003, 0x2203, 0x6002
HOME_RPM = 0x600F  # to the switch, and at it
PATH_0 = 0x6200  # control, position (2), rpm, acceleration, deceleration
ABSOLUTE = 0x0001  # of the path's control word, in every model's header
RUN_PATH_0, HOME, QUICK_STOP = 0x0010, 0x0020, 0x0040
FAULT, RUNNING, PATH_DONE, HOMED = 1 << 0, 1 << 2, 1 << 5, 1 << 6
START_S = 0.1  # until the drive shows that it moves


@dataclass(frozen=True, slots=True)
class Settings:
    """`pulses_per_turn` of the motor, `gear` to the platform; register 1 must hold the first, unless `pulses_code`
    says that this model keeps a code there (DM556RS). `position_register` holds the motor's position, two before it
    the commanded one. `ramp_ms`: time from rest to 1000 rpm.
    """

    address: Address = 1
    pulses_per_turn: Count = 10_000
    pulses_code: bool = False
    gear: Positive = 90.0
    position_register: int = 0x602C
    ramp_ms: Count = 2000
    tolerance_deg: Positive = 0.05
    max_rate_deg_per_s: Positive = 30.0
    gap_s: NotNegative = 0.02


class LeadshineStage:
    """Absolute moves by path 0: written, read back, then started. Stopped is not arrived."""

    roles = ("platform",)
    never = (  # all but reading, one absolute path, and its triggers: no other motion, no soft limits, no memory
        rb"^.[^\x03\x06\x10]",
        rb"^.\x06(?!\x60\x02\0[\x10\x20\x40])",
        rb"^.\x10(?!\x62\0\0\x06\x0C\0\x01)",
    )
    motorised = True

    def __init__(self, name: str, link: ModbusLink, clock: Clock, settings: Settings) -> None:
        self.name, self.settings, self._clock = name, settings, clock
        self.max_rate_deg_per_s = settings.max_rate_deg_per_s
        self.registers = Registers(link, clock, settings.address, settings.gap_s)
        self._target_deg: float | None = None
        self._begun_s, self._done = float("-inf"), PATH_DONE

    def identify(self) -> Identity:
        """It has no name to ask for: its pulses a turn must be those stated, its two positions must agree at rest."""
        pulses, status = self.registers.read(PULSES, 1)[0], self._status()
        commanded, motor = self._positions()
        if not self.settings.pulses_code and pulses != self.settings.pulses_per_turn:
            self._refuse_setup(f"a motor turn is {pulses} pulses and not the {self.settings.pulses_per_turn} stated")
        if not status & RUNNING and abs(commanded - motor) > self._pulses(self.settings.tolerance_deg):
            self._refuse_setup(f"its positions do not agree at rest: {commanded} commanded, {motor} of the motor")
        return Identity("Leadshine", "PR drive", f"address {self.settings.address}")

    def home(self, limit_deg_per_s: float = math.inf) -> None:
        """Search the reference where the drive says that it does not know it. Raises LimitError where that is fast."""
        if not self._status() & HOMED:
            if limit_deg_per_s < math.inf:
                fastest_rpm = max(self.registers.read(HOME_RPM, 2))
                refuse_fast_homing(self.name, fastest_rpm * 6 / self.settings.gear, limit_deg_per_s)
            self._target_deg, self._begun_s, self._done = 0.0, self._clock.now(), HOMED
            self.registers.write(TRIGGER, HOME)

    def move_to(self, angle_deg: float, rate_deg_per_s: float) -> None:
        """Begin an absolute move in the stage's own sense; started once, never again."""
        rpm = int(rate_deg_per_s / 6 * self.settings.gear)
        if rpm < 1:
            raise LimitError(f"{self.name}: {rate_deg_per_s:g} deg/s is below 1 rpm of its motor; nothing was sent.")
        path = [ABSOLUTE, *words(self._pulses(angle_deg)), rpm, self.settings.ramp_ms, self.settings.ramp_ms]
        self.registers.write_block(PATH_0, path)
        if (held := self.registers.read(PATH_0, len(path))) != path:
            raise InstrumentError(f"{self.name}: path 0 was set to {path} and reads back {held}.", fault="read-back")
        self._target_deg, self._begun_s, self._done = angle_deg, self._clock.now(), PATH_DONE
        self.registers.write(TRIGGER, RUN_PATH_0)

    def moving(self) -> bool:
        """Whether it moves. Raises InstrumentError where it has stopped elsewhere than it should have."""
        status = self._status()
        if self._moves(status):
            return True
        if self._target_deg is not None and not status & self._done:
            raise InstrumentError(f"{self.name}: it stands, its path is not complete.", fault="not arrived")
        refuse_elsewhere(self.name, self.angle_deg(), self._target_deg, self.settings.tolerance_deg)
        return False

    def angle_deg(self) -> float:
        """The motor's position as an angle of the platform [deg] in the stage's own sense."""
        return self._positions()[1] * 360 / (self.settings.pulses_per_turn * self.settings.gear)

    def state(self) -> tuple[float, bool]:
        """Position [deg] and whether it moves; first the motion, so that a position said to be final is."""
        moving = self._moves(self.registers.read(STATUS, 1)[0])
        return self.angle_deg(), moving

    def make_safe(self) -> None:
        """Stop."""
        self._target_deg, self._begun_s = None, float("-inf")
        self.registers.write(TRIGGER, QUICK_STOP)

    def close(self) -> None:
        """Let go of the link."""
        self.registers.close()

    def _status(self) -> int:
        status = self.registers.read(STATUS, 1)[0]
        if status & FAULT:
            raise InstrumentError(
                f"{self.name}: alarm {self.registers.read(ALARM, 1)[0]:04X}h.",
                fault="stage fault",
                remedy="Look the alarm up in its manual, remove the cause and try again.",
            )
        return status

    def _moves(self, status: int) -> bool:
        return bool(status & RUNNING) or self._clock.now() < self._begun_s + START_S

    def _positions(self) -> tuple[int, int]:
        four = self.registers.read(self.settings.position_register - 2, 4)
        return signed(four[:2]), signed(four[2:])

    def _pulses(self, deg: float) -> int:
        return round(deg * self.settings.pulses_per_turn * self.settings.gear / 360)

    def _refuse_setup(self, what: str) -> None:
        raise InstrumentError(f"{self.name}: {what}.", fault="wrong set-up", remedy="Correct the drive or bench.toml.")

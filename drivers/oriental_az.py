"""Oriental Motor AZ drivers (AZD-CD, -KD, -KX) with a DG hollow rotary table, Modbus RTU on RS-485, usually 8E1."""

from __future__ import annotations

import math
from dataclasses import dataclass

from labcal.bench.clock import Clock
from labcal.bench.driver_kit.arrival import refuse_elsewhere
from labcal.bench.driver_kit.registers import Registers, signed, words
from labcal.bench.driver_kit.roles import Identity
from labcal.bench.driver_kit.settings import Address, Count, NotNegative, Positive
from labcal.bench.links.modbus import ModbusLink
from labcal.errors import InstrumentError, LimitError

DIRECT_DATA = 0x0058  # sixteen registers, which start the move as they arrive
INPUTS, OUTPUTS = 0x007C, 0x007F
ALARM, FEEDBACK, FEEDBACK_COUNTER = 0x0080, 0x00CC, 0x0120
STOP = 1 << 5
ALM, MOVE, IN_POS = 1 << 7, 1 << 13, 1 << 14
ABSOLUTE, ALL_DATA, FULL_CURRENT = 1, 1, 1000
ALARMS = {
    0x10: "position deviation", 0x20: "over-current", 0x21: "overheating", 0x22: "over-voltage",
    0x23: "main power off", 0x25: "under-voltage", 0x26: "motor overheating", 0x28: "sensor error",
    0x30: "overload", 0x31: "overspeed", 0x33: "absolute position error", 0x66: "hardware overtravel",
    0x67: "software overtravel", 0x68: "hard-wired torque off",
}  # fmt: skip
START_S = 0.1  # until the drive shows that it moves
PULSE_S = 0.02  # how long an input is held


@dataclass(frozen=True, slots=True)
class Settings:
    """`steps_per_turn` of the table: 1000 a motor turn times its gear, 18 for DG130; a wrong one turns too far, so
    the first turn is made with a look at the table's scale.
    """

    address: Address = 1
    steps_per_turn: Count = 18_000
    acceleration_deg_per_s2: Positive = 10.0
    tolerance_deg: Positive = 0.05
    max_rate_deg_per_s: Positive = 30.0
    gap_s: NotNegative = 0.005


class OrientalStage:
    """Absolute moves by direct data; its encoder knows its place without homing. Standing still is not arrived."""

    roles = ("platform",)
    never = (  # all but reading, absolute moves and the input STOP: no relative moves, no free motor, no new zero
        rb"^.[^\x03\x10]",
        rb"^.\x10(?!\0\x58\0\x10\x20.{4}\0\0\0\x01|\0\x7C\0\x02\x04\0\0\0[\0\x20])",
    )
    motorised = True

    def __init__(self, name: str, link: ModbusLink, clock: Clock, settings: Settings) -> None:
        self.name, self.settings, self._clock = name, settings, clock
        self.max_rate_deg_per_s = settings.max_rate_deg_per_s
        self.registers = Registers(link, clock, settings.address, settings.gap_s)
        self._target_deg: float | None = None
        self._begun_s = float("-inf")

    def identify(self) -> Identity:
        """It has no name to ask for: its position is read in both places that hold it, and they must agree."""
        here, there = (signed(self.registers.read(at, 2)) for at in (FEEDBACK, FEEDBACK_COUNTER))
        if not self._moves(self._outputs()) and abs(here - there) > self._steps(self.settings.tolerance_deg):
            raise InstrumentError(
                f"{self.name}: its position reads {here} in {FEEDBACK:#06x} and {there} in {FEEDBACK_COUNTER:#06x}.",
                fault="another instrument",
                remedy="Is an AZ drive at this address?",
            )
        return Identity("Oriental Motor", "AZ", f"address {self.settings.address}")

    def home(self, limit_deg_per_s: float = math.inf) -> None:
        """Nothing to find: the encoder is absolute. Raises InstrumentError where an alarm is active."""
        self._refuse_alarm(self._outputs())

    def move_to(self, angle_deg: float, rate_deg_per_s: float) -> None:
        """Begin an absolute move in the stage's own sense; sent once, never repeated."""
        rate, ramp = self._steps(rate_deg_per_s), self._steps(self.settings.acceleration_deg_per_s2)
        if rate < 1:
            raise LimitError(f"{self.name}: {rate_deg_per_s:g} deg/s is less than 1 step/s; nothing was sent.")
        values = (0, ABSOLUTE, self._steps(angle_deg), rate, ramp, ramp, FULL_CURRENT, ALL_DATA)
        block = [word for value in values for word in words(value)]
        self._refuse_alarm(self._outputs())
        self._target_deg, self._begun_s = angle_deg, self._clock.now()
        self.registers.write_block(DIRECT_DATA, block)

    def moving(self) -> bool:
        """Whether it moves. Raises InstrumentError where it has stopped elsewhere than it should have."""
        outputs = self._outputs()
        self._refuse_alarm(outputs)
        if self._moves(outputs):
            return True
        if self._target_deg is not None and not outputs & IN_POS:
            raise InstrumentError(f"{self.name}: it stands, but not in position.", fault="not arrived")
        refuse_elsewhere(self.name, self.angle_deg(), self._target_deg, self.settings.tolerance_deg)
        return False

    def angle_deg(self) -> float:
        """The position [deg] in the stage's own sense, from its encoder."""
        return signed(self.registers.read(FEEDBACK, 2)) * 360 / self.settings.steps_per_turn

    def state(self) -> tuple[float, bool]:
        """Position [deg] and whether it moves; first the motion, so that a position said to be final is."""
        moving = self._moves(self._outputs())
        return self.angle_deg(), moving

    def make_safe(self) -> None:
        """Stop: the input is raised and let go of, for it is a level and would bar the next move."""
        self._target_deg, self._begun_s = None, float("-inf")
        self.registers.write_block(INPUTS, words(STOP))
        self._clock.wait_until(self._clock.now() + PULSE_S)
        self.registers.write_block(INPUTS, words(0))

    def close(self) -> None:
        """Let go of the link."""
        self.registers.close()

    def _outputs(self) -> int:
        return self.registers.read(OUTPUTS, 1)[0]

    def _moves(self, outputs: int) -> bool:
        return bool(outputs & MOVE) or self._clock.now() < self._begun_s + START_S

    def _refuse_alarm(self, outputs: int) -> None:
        if outputs & ALM:
            code = signed(self.registers.read(ALARM, 2))
            raise InstrumentError(
                f"{self.name}: alarm {code:02X}h, {ALARMS.get(code, 'see its manual')}.",
                fault="stage fault",
                remedy="Remove the cause, reset the alarm at the drive and try again.",
            )

    def _steps(self, deg: float) -> int:
        return round(deg * self.settings.steps_per_turn / 360)

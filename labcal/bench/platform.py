"""The platform as the contract counts angles, within the limits of its cables and of the DUT."""

from __future__ import annotations

import math
from collections.abc import Callable
from contextlib import suppress
from typing import TypeVar

from labcal.bench.clock import Clock
from labcal.bench.coils.state import PlatformReading
from labcal.bench.config import DutLimits, PlatformConfig
from labcal.bench.driver_kit.roles import Identity, RotationPlatform
from labcal.errors import InstrumentError, LimitError

T = TypeVar("T")
LONGEST_S, ASK_S = 5.0, 0.1  # that a stage takes to come to rest from its fastest turn; how often it is asked


class BenchPlatform:
    """A RotationPlatform whose angles are right-handed about the platform axis: the stage's own sense times its sign.

    Moves beyond the wrap limit, or faster than stage or DUT may turn, raise LimitError and nothing is sent. Where its
    line is lost, what is read is asked again once `bring_back` returns; a move never is.
    """

    bring_back: Callable[[InstrumentError], None] | None = None

    def __init__(self, stage: RotationPlatform, config: PlatformConfig, dut_limits: DutLimits) -> None:
        self.name, self.motorised = stage.name, stage.motorised
        self._stage, self._sign, self._wrap_deg = stage, config.angle_sign, config.wrap_deg
        self._dut_limit_deg_per_s = dut_limits.rate_deg_per_s or math.inf
        self._may_turn = False  # it was sent somewhere, and has not said since that it stands
        self.max_rate_deg_per_s = min(stage.max_rate_deg_per_s, self._dut_limit_deg_per_s)
        self.limited_by_dut = self._dut_limit_deg_per_s <= stage.max_rate_deg_per_s
        self.asked_deg_per_s = math.inf  # of the last move
        self.away = ""  # the fault with which its line is lost, from then until it is read again

    def identify(self) -> Identity:
        """The stage's identity."""
        return self._stage.identify()

    def home(self, limit_deg_per_s: float = math.inf) -> None:
        """Find the reference position if it is not known, no faster than the DUT may turn."""
        self._may_turn = True
        self._stage.home(min(limit_deg_per_s, self._dut_limit_deg_per_s))

    def move_to(self, angle_deg: float, rate_deg_per_s: float) -> None:
        """Begin an absolute move."""
        if not abs(angle_deg) <= self._wrap_deg:
            raise LimitError(
                f"{self.name}: {angle_deg:g}° is beyond the ±{self._wrap_deg:g}° of the cables; nothing was sent."
            )
        if not 0 < rate_deg_per_s <= self.max_rate_deg_per_s:
            raise LimitError(
                f"{self.name}: {rate_deg_per_s:g} deg/s is beyond its limit of {self.max_rate_deg_per_s:g} deg/s; "
                "nothing was sent."
            )
        self._may_turn = True
        self.asked_deg_per_s = rate_deg_per_s
        self._stage.move_to(self._sign * angle_deg, rate_deg_per_s)

    def moving(self) -> bool:
        """Whether it moves; False means arrived and confirmed."""
        self._may_turn = self._read(self._stage.moving)
        return self._may_turn

    def angle_deg(self) -> float:
        """The angle now."""
        return self._sign * self._read(self._stage.angle_deg)

    def state(self) -> tuple[float, bool]:
        """The angle now and whether it moves."""
        angle, moving = self._read(self._stage.state)
        self._may_turn = moving
        return self._sign * angle, moving

    @property
    def may_turn(self) -> bool:
        """Whether it was sent somewhere, and has not said since that it stands."""
        return self._may_turn

    def make_safe(self) -> None:
        """Stop."""
        self._stage.make_safe()

    def told_to_stop(self) -> None:
        """Stop, where it may turn, without waiting until it stands; whatever fails is found by who sees it stand."""
        if self._may_turn:
            with suppress(Exception):
                self._stage.make_safe()

    def brought_to_rest(self, clock: Clock) -> PlatformReading:
        """Stop and see that it stands, within some seconds; a lost line is not waited for, nor a turn that goes on."""
        with suppress(Exception):  # whether it stands is asked all the same
            self._stage.make_safe()
        until_s = clock.now() + LONGEST_S
        try:
            while (state := self._stage.state())[1] and clock.now() < until_s:
                clock.wait_until(clock.now() + ASK_S)
        except Exception as fault:  # of a driver of one's own too: the coils' last word is not lost over it
            return PlatformReading(fault=str(fault))
        self._may_turn, self.away = state[1], ""
        return PlatformReading(self._sign * state[0], state[1], clock.now())

    def close(self) -> None:
        """Let go of the link."""
        self._stage.close()

    def _read(self, ask: Callable[[], T]) -> T:
        try:
            answer = ask()
        except InstrumentError as fault:
            if fault.fault != "link lost" or self.bring_back is None:
                raise
            self.away = fault.fault
            self.bring_back(fault)
            answer = ask()
        self.away = ""
        return answer

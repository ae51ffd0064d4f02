"""The coils as one thing: limits, ramps, read-back, and the way to zero. Refuses, never clips."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from contextlib import ExitStack

import numpy as np
from numpy.typing import ArrayLike, NDArray

from labcal.bench.clock import Clock
from labcal.bench.config import AXES, CageConfig, CageLimits, DutLimits
from labcal.bench.roles import CoilSupply
from labcal.errors import InstrumentError, LimitError

Array = NDArray[np.float64]
RAMP_STEP_S = 0.1
ZERO_TIMEOUT_S = 1.0
LONGEST_RAMP_DOWN_S = 1.5
FOLLOWS = 0.01  # of the set-point, between what was set and what flows


class Cage:
    """Three coil axes with a measured current-to-field matrix.

    `ambient_nT` (3,) is the field in C with the coils at zero, as last measured by whoever measured it; `set_field`
    aims at the total field. `wait` is how time passes during ramps: the bench keeps its streams read meanwhile.
    """

    def __init__(
        self,
        config: CageConfig,
        supplies: Mapping[str, CoilSupply],
        clock: Clock,
        *,
        dut_limits: DutLimits | None = None,
        wait: Callable[[float], None] | None = None,
    ) -> None:
        self.limits: CageLimits = config.limits
        self.matrix_nT_per_A: Array = config.matrix
        self.ambient_nT: Array = np.zeros(3)
        self._settle_s = config.settle_s
        self._dut_field_nT = dut_limits.field_nT if dut_limits else None
        self._supplies = [supplies[axis] for axis in AXES]
        self._clock = clock
        self._wait = wait or clock.wait_until
        self._closed = False
        self._refuse_slow_supplies()

    def set_field(self, b_nT: ArrayLike) -> None:
        """Bring the total field at the centre to `b_nT` (3,) in C. Raises LimitError with both numbers."""
        b = np.asarray(b_nT, dtype=float)
        self.set_currents(np.linalg.solve(self.matrix_nT_per_A, b - self.ambient_nT))

    def set_currents(self, i_A: ArrayLike) -> None:
        """Ramp the coils to `i_A` (3,), read every step back, then wait until they are settled.

        Raises LimitError (nothing was sent), or InstrumentError where a supply does not follow.
        """
        target = np.asarray(i_A, dtype=float)
        self._refuse_beyond_limits(target)
        self._close_outputs()
        self._ramp(target)
        self._wait(self._clock.now() + self._settle_s)
        self._confirm(target)

    def field_nT(self) -> Array:
        """The field (3,) in C that the measured currents make, ambient included."""
        return np.asarray(self.matrix_nT_per_A @ self.currents_A() + self.ambient_nT)

    def currents_A(self) -> Array:
        """Measured signed currents (3,)."""
        return np.array([supply.measure_current() for supply in self._supplies])

    def set_points_A(self) -> Array:
        """Signed set-points (3,), read back."""
        return np.array([supply.set_point() for supply in self._supplies])

    def zero(self) -> None:
        """Ramp every coil to zero, see it below its `zero_current_A`, open its output where it can open.

        A failure of one axis does not skip the others; the first failure is raised at the end.
        """
        self._closed = False
        with ExitStack() as steps:
            for axis, supply in zip(reversed(AXES), reversed(self._supplies), strict=True):
                steps.callback(self._release, axis, supply)
            steps.callback(self._ramp, np.zeros(3))

    def _close_outputs(self) -> None:
        for supply in self._supplies if not self._closed else ():
            supply.set_current(0.0)
            supply.output(True)
        self._closed = True

    def _confirm(self, target: Array) -> None:
        for axis, supply, wanted, flows in zip(AXES, self._supplies, target, self.currents_A(), strict=True):
            if not abs(flows - wanted) <= max(supply.zero_current_A, FOLLOWS * abs(wanted)):
                raise InstrumentError(
                    f"coil {axis}: {wanted:.4g} A was set and {flows:.4g} A flows.",
                    fault="wrong mode",
                    remedy="Is the winding whole, does the voltage suffice, has the supply tripped? Set the coils off.",
                )

    def _ramp(self, target: Array) -> None:
        start, begun = self.set_points_A(), self._clock.now()
        rates = np.minimum(self.limits.ramp_A_per_s, [s.ramp_A_per_s for s in self._supplies])
        duration = float(np.max(np.abs(target - start) / rates))
        steps = max(1, math.ceil(duration / RAMP_STEP_S))
        for step in range(1, steps + 1):
            for supply, value in zip(self._supplies, start + (target - start) * step / steps, strict=True):
                supply.set_current(float(value))
            self._wait(begun + duration * step / steps)

    def _release(self, axis: str, supply: CoilSupply) -> None:
        supply.set_current(0.0)
        deadline = self._clock.now() + ZERO_TIMEOUT_S
        while abs(left := supply.measure_current()) >= supply.zero_current_A:
            if self._clock.now() >= deadline:
                raise InstrumentError(
                    f"coil {axis}: {left:.4g} A still flows {ZERO_TIMEOUT_S:g} s after zero was set "
                    f"(zero is below {supply.zero_current_A:g} A).",
                    fault="not zero",
                    remedy="Its output stays closed: switch the supply off by hand, then look at its panel.",
                )
            self._wait(self._clock.now() + 0.02)
        supply.output(False)

    def _refuse_beyond_limits(self, target: Array) -> None:
        for axis, value, limit in zip(AXES, target, self.limits.current_A, strict=True):
            if not abs(value) <= limit:
                raise LimitError(f"coil {axis}: {value:.4g} A is beyond its limit of {limit:g} A; nothing was set.")
        field = float(np.linalg.norm(self.matrix_nT_per_A @ target + self.ambient_nT))
        for owner, limit_nT in (("the cage", self.limits.field_nT), ("the DUT", self._dut_field_nT)):
            if limit_nT is not None and field > limit_nT:
                raise LimitError(
                    f"a field of {field:.0f} nT is beyond the limit of {owner}, {limit_nT:.0f} nT; nothing was set."
                )

    def _refuse_slow_supplies(self) -> None:
        for axis, supply, limit, rate in zip(
            AXES, self._supplies, self.limits.current_A, self.limits.ramp_A_per_s, strict=True
        ):
            needed = limit / min(rate, supply.ramp_A_per_s)
            if needed > LONGEST_RAMP_DOWN_S:
                raise LimitError(
                    f"coil {axis}: {limit:g} A would take {needed:.2f} s to ramp down, more than "
                    f"{LONGEST_RAMP_DOWN_S:g} s; lower current_A or raise ramp_A_per_s."
                )

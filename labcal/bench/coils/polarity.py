"""A unipolar supply and reversing contacts make one signed coil axis. The contacts never move under current."""

from __future__ import annotations

import math

from labcal.bench.clock import Clock
from labcal.bench.driver_kit.roles import CoilSupply, Identity, PolarityRelay, Unacknowledged
from labcal.errors import InstrumentError

SETTLE_S = 0.05  # contact bounce is of the order of 10 ms
QUIET_READS = 3
TIMEOUT_S = 1.0


class ReversedSupply:
    """A CoilSupply with a sign. To change it: zero, confirmed; open; switch; read back; settle; close again."""

    bipolar = has_contacts = True

    def __init__(self, axis: str, supply: CoilSupply, relay: PolarityRelay, clock: Clock) -> None:
        self.name, self._axis, self._supply, self._relay, self._clock = supply.name, axis, supply, relay, clock
        self.zero_current_A, self.can_open = supply.zero_current_A, supply.can_open
        self.ramp_A_per_s = supply.ramp_A_per_s
        self._sign: int | None = None  # unknown until read from the contacts
        self._closed = False

    def set_current(self, current_A: float) -> None:
        """Set the signed current and read it back, reversing the contacts first where the sign changes."""
        wanted = int(math.copysign(1, current_A))
        if current_A != 0 and wanted != self._known_sign():
            self._reverse(wanted)
        self._supply.set_current(abs(current_A))

    def set_point(self) -> float:
        """The signed set-point, read back [A]."""
        return self._known_sign() * self._supply.set_point()

    def measure_current(self) -> float:
        """The signed delivered current [A]; what is below its zero needs no sign, and no contacts that answer."""
        current = self._supply.measure_current()
        return current if self._sign is None and abs(current) < self.zero_current_A else self._known_sign() * current

    def write_current(self, current_A: float) -> None:
        """Send a current of the sign that it has, smaller or zero, and wait for nothing: contacts are not moved."""
        if isinstance(self._supply, Unacknowledged):
            self._supply.write_current(abs(current_A))
        else:
            self._supply.set_current(abs(current_A))

    def write_off(self) -> None:
        """Send "output off" and wait for nothing."""
        if isinstance(self._supply, Unacknowledged):
            self._supply.write_off()
        else:
            self._supply.output(False)
        self._closed = False

    def output(self, on: bool) -> None:
        """Close or open the supply's output; the contacts are read again before they carry current."""
        self._sign = None if on else self._sign
        self._supply.output(on)
        self._closed = on

    def identify(self) -> Identity:
        """The supply's identity."""
        return self._supply.identify()

    def make_safe(self) -> None:
        """The supply to rest; the contacts stay where they are, for they must not move under current."""
        self._supply.make_safe()

    def close(self) -> None:
        """Let go of the supply's link."""
        self._supply.close()

    def _known_sign(self) -> int:
        if self._sign is None:
            self._sign = self._relay.polarity(self._axis)
        return self._sign

    def _reverse(self, sign: int) -> None:
        self._supply.set_current(0.0)
        self._wait_for_zero()
        self._supply.output(False)
        self._sign = None
        self._relay.set_polarity(self._axis, sign)
        self._clock.wait_until(self._clock.now() + SETTLE_S)
        if self._known_sign() != sign:
            raise InstrumentError(
                f"coil {self._axis}: the contacts did not switch to {sign:+d}.",
                fault="polarity not confirmed",
                remedy="Look at the relay and its supply.",
            )
        self._supply.output(self._closed)

    def _wait_for_zero(self) -> None:
        deadline, quiet = self._clock.now() + TIMEOUT_S, 0
        while quiet < QUIET_READS:
            left = abs(self._supply.measure_current())
            quiet = quiet + 1 if left < self.zero_current_A else 0
            if not quiet and self._clock.now() > deadline:  # a slow line is no current
                raise InstrumentError(
                    f"coil {self._axis}: {left:.4g} A still flows after zero was set; the contacts were not moved.",
                    fault="not zero",
                    remedy=f"Switch {self.name} off by hand before anything else.",
                )

"""One coil axis as the guardian keeps it: its supply behind a latch, its limits, and what is known of its current."""

from __future__ import annotations

import math
import time
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from functools import cached_property
from typing import cast

from labcal.bench.coils.polarity import ReversedSupply
from labcal.bench.coils.zero import AtZero
from labcal.bench.driver_kit.roles import CoilSupply
from labcal.bench.guardian.coil_limits import CoilLimit
from labcal.bench.guardian.handover import Held
from labcal.bench.guardian.latch import Latch, LatchedSupply
from labcal.bench.guardian.owned_lines import LockedRelay, OwnedLine
from labcal.errors import InstrumentError, LimitError


@dataclass
class GuardedCoil:
    """One axis. What is None where nothing is wrong: why it may not be energised."""

    axis: str
    name: str
    line: OwnedLine
    relay: LockedRelay | None
    current_limit_A: float
    ramp_limit_A_per_s: float
    energised: bool = False
    held_A: float | None = None  # the least that the bare supply may hold; None where that is not known
    tripped: InstrumentError | None = None  # raised in the session until it sets zero itself
    unresolved: InstrumentError | None = None  # why zero is not confirmed
    asked_s: float | None = None  # when zero was last asked for (monotonic clock)
    doubt: InstrumentError | None = None  # why it may not answer: it is written zero before it is asked anything
    latch: Latch = field(default_factory=Latch)
    _supply_A_per_s: float = math.inf  # its ramp, once its link was open

    @property
    def bare(self) -> LatchedSupply:
        """The supply without its contacts: zero has no sign. Raises InstrumentError where its link does not open."""
        return LatchedSupply(cast(CoilSupply, self.line.instrument(self.name)), self.latch)

    @cached_property
    def signed(self) -> CoilSupply:
        """The supply with a sign: bipolar by itself, or behind reversing contacts."""
        if self.relay is None or not self.relay.reverses(self.axis):
            return self.bare
        return ReversedSupply(self.axis, self.bare, self.relay, self.line.clock)

    @cached_property
    def limit(self) -> CoilLimit:
        """Current and ramp."""
        return CoilLimit(self.axis, self.current_limit_A, self.rate_A_per_s)

    @property
    def rate_A_per_s(self) -> float:
        """The fastest ramp that cage and supply bear."""
        self._supply_A_per_s = self.bare.ramp_A_per_s
        return min(self.ramp_limit_A_per_s, self._supply_A_per_s)

    @property
    def ramp_down_s(self) -> float:
        """How long its ramp to zero takes from here; waits for no line."""
        return abs(self.held_A or 0.0) / min(self.ramp_limit_A_per_s, self._supply_A_per_s)

    @property
    def held(self) -> Held:
        """What a successor must know."""
        return Held(self.held_A, self.energised, self.line.known(self.name), self.latch.most_A is not None)

    def inherit(self, held: Held) -> None:
        """Go on where the guardian before this one was; one that was on its way down is not ramped again."""
        self.held_A, self.energised = held.held_A, held.energised
        if held.energised and held.falling:
            self.doubt = InstrumentError(
                f"coil {self.axis}: the guardian before is gone; it had ordered zero and reported no read-back.",
                fault="guardian lost",
            )
        if held.who is not None:
            self.line.expect(self.name, held.who)

    def release(self) -> None:
        """Lift the latch for a new order of the session. Raises InstrumentError where the coil may not be energised."""
        if self.latch.most_A is None:
            return
        if self.unresolved is not None:
            raise self.unresolved
        if self.energised:
            raise InstrumentError(f"coil {self.axis}: zero has not been read back.", fault="taken to zero")
        self.latch.lift()

    @contextmanager
    def doubting(self) -> Iterator[None]:
        """An exchange within that fails leaves the supply in doubt; a refusal of ours does not."""
        try:
            yield
        except LimitError:
            raise
        except InstrumentError as fault:
            if fault.fault not in ("taken to zero", "tripped"):
                self.doubt = fault
            raise

    def set_current(self, current_A: float) -> None:
        """Set and read back, with what it holds known to a successor at every moment."""
        before, after = self.held_A, current_A if self.bare.bipolar else abs(current_A)
        self.held_A, self.energised = _least(before, after), self.energised or current_A != 0
        with self.doubting():
            self.signed.set_current(current_A)
        self.limit.was_set(current_A, self.line.clock.now())
        self.held_A = after

    def settle(self, end: AtZero) -> None:
        """Take over how the way to zero ended."""
        self.unresolved = end.fault if end.current_A is None else None
        self.doubt, self.held_A, self.asked_s = self.unresolved, 0.0, time.monotonic()
        if self.unresolved is None:
            self.energised = False
            self.limit.at_zero()


def _least(before_A: float | None, after_A: float) -> float | None:
    """What a supply holds at least while a set-point is on its way: on the other side of zero nothing."""
    if before_A is None:
        return None
    return 0.0 if before_A * after_A < 0 else min(before_A, after_A, key=abs)

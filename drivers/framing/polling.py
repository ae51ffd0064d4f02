"""Asking on a steady beat, for instruments that do not stream."""

from __future__ import annotations

import math
from collections.abc import Iterator

from drivers.framing.mishaps import Mishaps
from labcal.bench.clock import Clock
from labcal.bench.links import Link
from labcal.record.stream import Event

REPLY_S, BEATS = 0.5, 2.0


class Polls:
    """Moments to ask at, `rate` a second; a beat that was missed is left out, not made up for."""

    def __init__(self, clock: Clock, rate: float) -> None:
        self._clock, self._period_s, self._next_s = clock, 1 / rate, math.inf

    def start(self) -> None:
        """The first moment is now."""
        self._next_s = self._clock.now()

    def stop(self) -> None:
        """No more."""
        self._next_s = math.inf

    def next_s(self) -> float:
        """The next moment; inf where there is none."""
        return self._next_s

    @property
    def reply_s(self) -> float:
        """How long a reply may take of an instrument that keeps up with the rate."""
        return max(REPLY_S, BEATS * self._period_s)

    def due(self, t_s: float) -> Iterator[float]:
        """Wait for each moment up to `t_s` and give the time when it is there; then wait for `t_s`."""
        while self._next_s <= t_s:
            self._clock.wait_until(self._next_s)
            now = self._clock.now()
            yield now
            missed = math.floor((now - self._next_s) / self._period_s)
            self._next_s += self._period_s * (1 + max(missed, 0))
        self._clock.wait_until(t_s)


class Polled:
    """What sensors that are asked on a beat have in common; whoever reads one learns when it is to be asked."""

    _polls: Polls
    _mishaps: Mishaps
    _link: Link

    def due_s(self) -> float:
        """When it is to be asked next, on the bench's clock; inf where it is not."""
        return self._polls.next_s()

    def events(self) -> list[Event]:
        """Readings that were no good."""
        return self._mishaps.events()

    def stop(self) -> None:
        """Ask no more."""
        self._polls.stop()

    def make_safe(self) -> None:
        """Ask no more."""
        self.stop()

    def close(self) -> None:
        """Let go of the link."""
        self._link.close()

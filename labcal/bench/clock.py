"""The bench's clock: real, or virtual, where waiting takes no time. Handed in; nobody calls `time` alone."""

from __future__ import annotations

import math
import time
from datetime import UTC, datetime, timedelta
from typing import Protocol


class Clock(Protocol):
    """Seconds since the bench was opened; never goes back.

    `listen_s`: how often lines have to be looked at so that what arrives is stamped truly.
    """

    listen_s: float

    def now(self) -> float:
        """Seconds since the bench was opened."""
        ...

    def wait_until(self, t_s: float) -> None:
        """Return at `t_s`, or at once if that has passed."""
        ...

    def utc(self) -> datetime:
        """The wall clock's time now."""
        ...


class RealClock:
    """True time: monotonic for intervals, the system's for dates."""

    listen_s = 0.002

    def __init__(self) -> None:
        self._start = time.monotonic()

    def now(self) -> float:
        """Seconds since the bench was opened."""
        return time.monotonic() - self._start

    def wait_until(self, t_s: float) -> None:
        """Sleep until `t_s`."""
        while (left := t_s - self.now()) > 0:
            time.sleep(left)

    def utc(self) -> datetime:
        """The system's UTC time."""
        return datetime.now(UTC)


class VirtualClock:
    """Simulated time: waiting moves it. Emulated instruments put on the link what they would have sent by then,
    each piece with its own stamp: nothing is gained by looking often.
    """

    listen_s = math.inf

    def __init__(self, start: datetime) -> None:
        self._start, self._now = start, 0.0

    def now(self) -> float:
        """Seconds since the bench was opened."""
        return self._now

    def wait_until(self, t_s: float) -> None:
        """Let the time be `t_s`, unless it is later already."""
        self._now = max(self._now, t_s)

    def utc(self) -> datetime:
        """The start's date and the simulated seconds since."""
        return self._start + timedelta(seconds=self._now)

"""The bench's clock: real, or virtual, where waiting takes no time. Handed in; nobody calls `time` alone."""

from __future__ import annotations

import math
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from datetime import UTC, datetime, timedelta
from typing import Protocol

LOOK_S = 0.002


class Clock(Protocol):
    """Seconds since the bench was opened; never goes back.

    `listen_s`: how often it is worth taking in what has arrived; inf where time is simulated.
    """

    listen_s: float

    def now(self) -> float:
        """Seconds since the bench was opened."""
        ...

    def wait_until(self, t_s: float) -> None:
        """Return at `t_s`, or at once if that has passed."""
        ...

    def while_waiting(self, look: Callable[[], None]) -> None:
        """Have `look` called again and again while anybody waits: lines are looked at, so that stamps are true."""
        ...

    def utc(self) -> datetime:
        """The wall clock's time now."""
        ...


class RealClock:
    """True time: monotonic for intervals, the system's for dates."""

    listen_s = LOOK_S

    def __init__(self) -> None:
        self._start = time.monotonic()
        self._looks: list[Callable[[], None]] = []
        self._here = threading.local()

    def now(self) -> float:
        """Seconds since the bench was opened."""
        return time.monotonic() - self._start

    def wait_until(self, t_s: float) -> None:
        """Sleep until `t_s`, in slices, with a look at every line between them."""
        while (left := t_s - self.now()) > 0:
            time.sleep(min(left, LOOK_S))
            for look in () if getattr(self._here, "apart", False) else self._looks:
                look()

    @contextmanager
    def apart(self) -> Iterator[None]:
        """In this thread, waiting looks at nothing: another thread does, and looks are not made for two."""
        self._here.apart = True
        try:
            yield
        finally:
            self._here.apart = False

    def while_waiting(self, look: Callable[[], None]) -> None:
        """Call `look` every few milliseconds of waiting."""
        self._looks.append(look)

    def utc(self) -> datetime:
        """The system's UTC time."""
        return datetime.now(UTC)


class VirtualClock:
    """Simulated time: waiting moves it. Emulated instruments put on the link what they would have sent by then,
    each piece with its own stamp.
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

    def while_waiting(self, look: Callable[[], None]) -> None:
        """No need: what arrives brings its own stamp."""

    def utc(self) -> datetime:
        """The start's date and the simulated seconds since."""
        return self._start + timedelta(seconds=self._now)

"""Simulated time at a pace that eyes can follow."""

from __future__ import annotations

import time
from datetime import datetime

from labcal.bench.clock import Clock, VirtualClock

SPEEDS = {"true": 1.0, "20 times": 20.0, "100 times": 100.0, "at once": 0.0}


class SimulatedClock(VirtualClock):
    """Virtual time that passes `speed` times as fast as true time; while a person is asked it all but stands still."""

    listen_s = 0.2

    def __init__(self, start: datetime, speed: float, now_s: float = 0.0) -> None:
        super().__init__(start)
        self._speed = speed
        super().wait_until(now_s)

    def wait_until(self, t_s: float) -> None:
        """Return when as much time has passed as `t_s` is ahead, divided by the speed."""
        time.sleep(max(0.0, t_s - self.now()) / self._speed)
        super().wait_until(t_s)


def simulated_clock(pace: str, start: datetime, now_s: float = 0.0) -> Clock:
    """The clock of a simulated bench, `now_s` seconds after its `start`."""
    clock = SimulatedClock(start, SPEEDS[pace], now_s) if SPEEDS[pace] else VirtualClock(start)
    if not SPEEDS[pace]:
        clock.wait_until(now_s)
    return clock

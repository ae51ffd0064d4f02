"""A line that was lost and comes back: its instrument is identified again, and refused where it is another one."""

from __future__ import annotations

import math
from collections.abc import Callable

from labcal.bench.clock import Clock
from labcal.bench.driver_kit.roles import Magnetometer, Pollable, Steady
from labcal.errors import InstrumentError
from labcal.record.stream import Block, Event

RETRY_S, LOOK_S = 0.5, 0.05
BACK_S = 3.0  # so long is a stage waited for
AWAY = ("link lost", "silent", "in use")  # faults with which a plug that is out, or just in again, may show


def bring_back(
    reopen: Callable[[], object], clock: Clock, lost: InstrumentError, look: Callable[[], None] = lambda: None
) -> None:
    """Wait until the line is back; what `look` raises meanwhile ends that (somebody wants the coils at zero).

    Raises `lost` where it does not come in time, or that another instrument answers.
    """
    deadline = clock.now() + BACK_S
    while True:
        _wait_until(clock.now() + RETRY_S, clock, look)
        try:
            reopen()
            return
        except InstrumentError as fault:
            if fault.fault not in AWAY:
                raise
            if clock.now() + RETRY_S > deadline:  # another try would begin too late, and may itself take seconds
                raise lost from fault


def _wait_until(t_s: float, clock: Clock, look: Callable[[], None]) -> None:
    while clock.now() < t_s:
        look()
        clock.wait_until(min(t_s, clock.now() + LOOK_S))


class Reconnecting:
    """Reads a sensor; while its line is lost nothing is read and it is tried again, for `patience_s` at the most.

    `reopen` opens the line and raises InstrumentError where another instrument answers than before. `left_s`: how long
    the sensor may be missed now, with coils on; a line whose opening may itself take longer is then not `tried`. While
    a person is asked, `waited_for`, it may be away as long as it likes.
    """

    def __init__(
        self,
        sensor: Magnetometer,
        reopen: Callable[[], object],
        patience_s: float,
        left_s: Callable[[], float] = lambda: math.inf,
        tried: bool = True,
        waited_for: Callable[[], bool] = lambda: False,
    ) -> None:
        self.name, self.wrong = sensor.name, ""  # `wrong`: the fault that keeps it from sending, until it sends again
        self._sensor, self._reopen, self._patience_s = sensor, reopen, patience_s
        self._polled = sensor if isinstance(sensor, Pollable) else None  # asked once: that walks all its methods
        self._steady = sensor if isinstance(sensor, Steady) else None
        self._left_s, self._tried, self._waited_for = left_s, tried, waited_for
        self._lost: InstrumentError | None = None
        self._since_s = self._missed_s = self._next_s = 0.0  # it is missed from when nobody was asked any more
        self._events: list[Event] = []

    def read_until(self, t_s: float) -> list[Block]:
        """What has come. Raises the first fault where the line does not come back in time."""
        if self._lost is not None:
            self._try_again(t_s, self._lost)
            return []
        try:
            blocks = self._sensor.read_until(t_s)
        except InstrumentError as fault:
            self.wrong = fault.fault
            if fault.fault != "link lost":
                raise
            self._lost, self._since_s, self._missed_s, self._next_s = fault, t_s, t_s, t_s + RETRY_S
            self._note(t_s, "link lost", fault.what)
            return []
        self.wrong = "" if blocks else self.wrong
        return blocks

    def due_s(self) -> float:
        """When it is to be read next; inf where it sends by itself."""
        if self._lost is not None:
            return min(self._next_s, self._given_up_s())
        return math.inf if self._polled is None else self._polled.due_s()

    @property
    def period_s(self) -> float | None:
        """Between two of its messages, as its maker states it; None where it sends as it is set or asked."""
        return None if self._steady is None else self._steady.period_s

    @property
    def spoilt(self) -> int:
        """How many messages came that were no good, as far as it counts them."""
        return 0 if self._steady is None else self._steady.spoilt

    def events(self) -> list[Event]:
        """What the sensor lost since this was asked last: frames, samples."""
        return self._sensor.events()

    def news(self) -> list[Event]:
        """When its line went and came back, since this was asked last."""
        noted, self._events = self._events, []
        return noted

    def _try_again(self, t_s: float, lost: InstrumentError) -> None:
        if self._waited_for():
            self._missed_s = t_s
        if t_s >= self._given_up_s():
            raise lost
        if t_s < self._next_s:
            return
        self._next_s = t_s + RETRY_S
        try:
            self._reopen()
            self._sensor.start()
        except InstrumentError as fault:
            if fault.fault not in AWAY:
                raise
            return
        self._lost, self.wrong = None, ""
        self._note(t_s, "reconnected", f"it answers again, {t_s - self._since_s:.1f} s after its loss was noticed")

    def _given_up_s(self) -> float:
        left_s = self._left_s()
        if left_s < self._patience_s and not self._tried:
            return self._missed_s
        return self._missed_s + min(self._patience_s, left_s)

    def _note(self, t_s: float, fault: str, text: str) -> None:
        self._events.append(Event(t_s, "stream", f"{self._sensor.name}: {text}", {"fault": fault}))

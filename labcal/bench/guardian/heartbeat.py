"""The heartbeats that instruments wait for: where they end, the instruments switch off by themselves.

An interlock is closed while every coil is at zero, read back, and opened where one is not: it is the last means against
a supply that does not obey. Each watched instrument is fed by a thread of its own, so that no other line holds a beat
up; but only while the guardian's loop lives, for a thread goes on when the loop hangs.
"""

from __future__ import annotations

import threading
import time
from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, cast

from labcal.bench.driver_kit.roles import Interlock, Watched
from labcal.bench.guardian.owned_lines import OwnedLine
from labcal.errors import InputError, InstrumentError

if TYPE_CHECKING:
    from labcal.bench.config import BenchConfig
    from labcal.bench.essentials import Essentials

LOOP_S = 2.0  # the guardian's loop must have been seen so lately: a way to zero takes no longer
AGAIN_S = 1.0  # until a beat that went wrong is tried again
ARM_S = 15.0  # that an order to energise waits for an interlock to close, at most


class Heartbeats:
    """Feeds what is watched on `lines`. `fault` is why no coil may carry current, if there is such a thing."""

    def __init__(
        self, config: BenchConfig | Essentials, lines: Mapping[str, OwnedLine], note: Callable[[str], None]
    ) -> None:
        self._note, self._ended = note, threading.Event()
        self._seen_s, self._at_rest, self._in_doubt = time.monotonic(), False, False
        self._hearts = [
            Heart(name, line, period_s, config.instruments[name].role == "interlock")
            for name, line in lines.items()
            if (period_s := _watchdog_s(line, name) / 3)
        ]
        self._threads: list[threading.Thread] = []

    def start(self) -> None:
        """Beat from now on; an interlock is closed once the guardian's loop has said that it may be."""
        self._threads = [threading.Thread(target=self._beat, args=(heart,), daemon=True) for heart in self._hearts]
        for thread in self._threads:
            thread.start()

    def see(self, *, at_rest: bool, in_doubt: bool) -> None:
        """The guardian's loop lives. `at_rest`: all coils are at zero; `in_doubt`: one that should be is not."""
        turned = (at_rest, in_doubt) != (self._at_rest, self._in_doubt)
        self._seen_s, self._at_rest, self._in_doubt = time.monotonic(), at_rest, in_doubt
        for heart in self._hearts:
            if turned and heart.is_interlock:  # what is fed alike in either case is fed in its own time
                heart.wake.set()

    @property
    def fault(self) -> InstrumentError | None:
        """What went wrong with a beat, until one has gone well again."""
        return next((heart.fault for heart in self._hearts if heart.fault is not None), None)

    def refuse(self) -> None:
        """Raise InstrumentError where no coil may be energised; an interlock that is about to close is waited for."""
        deadline = time.monotonic() + ARM_S
        for heart in self._hearts:
            while not (heart.ready or heart.fault or self._in_doubt) and time.monotonic() < deadline:
                time.sleep(0.01)
            if not heart.ready:
                raise heart.fault or _not_closed(heart.name)

    def stop(self) -> None:
        """The coils are at zero: beat no more, and open the interlock."""
        self._ended.set()
        for heart in self._hearts:
            heart.wake.set()
        for thread in self._threads:
            thread.join(LOOP_S)

    def _beat(self, heart: Heart) -> None:
        while not self._ended.is_set():
            before = heart.fault
            heart.try_to(self._step(heart))
            if heart.fault is not None and (before is None or before.what != heart.fault.what):
                self._note(f"heartbeat of {heart.name}: {heart.fault.what}")
            heart.wake.wait(heart.period_s if heart.fault is None else AGAIN_S)
            heart.wake.clear()
        if heart.closed:
            heart.try_to(heart.open)

    def _step(self, heart: Heart) -> Callable[[], None]:
        """What is to be done now."""
        if time.monotonic() - self._seen_s > LOOP_S:
            return _nothing
        if not heart.is_interlock:
            return heart.feed
        if heart.closed:
            return heart.open if self._in_doubt else heart.feed
        return heart.close if self._at_rest and not self._in_doubt else _nothing


class Heart:
    """One watched instrument on its line. `closed`: an interlock that was closed and has been fed since."""

    def __init__(self, name: str, line: OwnedLine, period_s: float, is_interlock: bool) -> None:
        self.name, self.period_s, self.is_interlock = name, period_s, is_interlock
        self.closed, self.wake = False, threading.Event()
        self.fault: InstrumentError | None = None
        self._line = line

    @property
    def ready(self) -> bool:
        """Whether coils may be energised, as far as this one goes."""
        return self.fault is None and (self.closed or not self.is_interlock)

    def try_to(self, step: Callable[[], None]) -> None:
        """Do it; what goes wrong is the fault, until something has gone well."""
        try:
            with self._line.lock:
                step()
            if step is not _nothing:
                self.fault = None
        except InstrumentError as fault:
            if fault.fault != "taken to zero":  # given up for the way to zero, which the instrument hears as well
                self._failed(fault.what, fault.fault, fault.remedy)
        except Exception as error:  # whatever it is, it is named and the coils go to zero
            self._failed(f"its beat failed: {type(error).__name__}: {error}.", "guardian failed", "")

    def _failed(self, what: str, fault: str, remedy: str) -> None:
        named = what if self.name in what else f"{self.name}: {what}"
        self.fault, self.closed = InstrumentError(named, fault=fault, remedy=remedy), False

    def feed(self) -> None:
        """One beat."""
        cast(Watched, self._line.instrument(self.name)).feed()

    def close(self) -> None:
        """Close the interlock, whoever answers being who answered before."""
        if self.fault is not None:
            self._line.reopen()
        self._line.identify(self.name)
        cast(Interlock, self._line.instrument(self.name)).arm()
        self.closed = True

    def open(self) -> None:
        """Open the interlock."""
        self.closed = False
        cast(Interlock, self._line.instrument(self.name)).disarm()


def _nothing() -> None:
    """Without a beat all that is watched opens by itself."""


def _watchdog_s(line: OwnedLine, name: str) -> float:
    try:
        return float(getattr(line.loader.driver(name)[2], "watchdog_s", 0.0))
    except InputError:  # in the file; a session says so before it starts a guardian
        return 0.0


def _not_closed(name: str) -> InstrumentError:
    return InstrumentError(
        f"{name}: the interlock is open.",
        fault="interlock",
        remedy="It closes when every coil is read back at zero; `guardian.log` says which is not.",
    )

"""The lines that the guardian owns: one lock and one clock each, so that a silent instrument delays no other line."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from contextlib import suppress
from dataclasses import dataclass, field
from pathlib import Path
from threading import RLock
from typing import TYPE_CHECKING, Any, cast

from labcal.bench.clock import Clock, RealClock
from labcal.bench.driver_kit.identities import the_same
from labcal.bench.driver_kit.roles import Identity, Instrument, PolarityRelay
from labcal.bench.guardian.gate import Gate, GatedLoader
from labcal.bench.links.urls import is_connection
from labcal.bench.loading import speaks_modbus
from labcal.errors import InputError, InstrumentError

if TYPE_CHECKING:
    from labcal.bench.config import BenchConfig
    from labcal.bench.essentials import Essentials
    from labcal.bench.links.modbus import ModbusLink


@dataclass
class OwnedLine:
    """One line and the instruments on it. Who talks on it holds `lock`, and leaves it when its gate closes."""

    url: str
    loader: GatedLoader
    lock: RLock = field(default_factory=RLock)
    _open: dict[str, Instrument] = field(default_factory=dict)
    _known: dict[str, Identity] = field(default_factory=dict)
    _identified: set[str] = field(default_factory=set)
    _said_s: dict[str, float] = field(default_factory=dict)  # when it last was who it should be, on its clock
    _shared: dict[str, ModbusLink] = field(default_factory=dict)

    @property
    def gate(self) -> Gate:
        """Closed while the coils on this line are brought to zero."""
        return self.loader.gate

    @property
    def clock(self) -> Clock:
        """The clock of all that waits on this line."""
        return self.loader.clock

    @property
    def is_connection(self) -> bool:
        """Whether it may lead nowhere although nothing was pulled, and a new one be heard at once."""
        return is_connection(self.url)

    def instrument(self, name: str) -> Instrument:
        """The driver of `name`; its link is opened when it is asked for first. Raises InstrumentError (link lost)."""
        with self.lock:
            if name not in self._open:
                try:
                    self._open[name] = self.loader.instrument(name)
                except InputError as error:  # in the file; a session says so before it starts a guardian
                    remedy = "Correct the file and say off again, or switch this supply off by hand."
                    raise InstrumentError(f"not reached: {error}.", fault="not reached", remedy=remedy) from error
            return self._open[name]

    def identify(self, name: str, within_s: float = 0.0) -> Identity:
        """Who answers, or did within the last `within_s` on this link. Raises InstrumentError where another does."""
        with self.lock:
            if self.clock.now() - self._said_s.get(name, -math.inf) < within_s:
                return self._known[name]
            self._said_s.pop(name, None)
            who = the_same(name, self.instrument(name).identify, self._known.get(name))
            self._known[name] = who
        self._identified.add(name)
        self._said_s[name] = self.clock.now()
        return who

    def strangers(self, names: Iterable[str]) -> list[Instrument]:
        """Drivers of other instruments on this line, for when cables were swapped; those that speak as it does."""
        found = list[Instrument]()
        own = next(iter(self._open), None)
        for name in names:
            with suppress(InputError, InstrumentError):
                driver, hints, settings = self.loader.driver(name)
                if own is not None and speaks_modbus(hints) == speaks_modbus(self.loader.driver(own)[1]):
                    link = self.loader.modbus(own) if speaks_modbus(hints) else self.loader.link(own)
                    found.append(cast(Instrument, driver(name, link, self.clock, settings)))
        return found

    def expect(self, name: str, who: Identity) -> None:
        """It was `who` that answered before this process had the line."""
        self._known[name] = who

    def known(self, name: str) -> Identity | None:
        """Who answered at first; None before anybody has."""
        return self._known.get(name)

    def identified(self, name: str) -> bool:
        """Whether this process has heard from it."""
        return name in self._identified

    def modbus(self, name: str, call: str, args: list[Any]) -> Any:
        """One exchange for an instrument that shares this line but belongs to the session; with no other on it."""
        driver, _, settings = self.loader.driver(name)
        if not args or args[0] != settings.address or settings.address == 0:
            raise InstrumentError(
                f"{name}: device {args[:1]} on its line is not for the session to address.", fault="forbidden"
            )
        with self.lock:
            if name not in self._shared:
                self._shared[name] = self.loader.modbus(name)
                self.loader.links[self.url].never.add(driver.never, settings.address)
            return getattr(self._shared[name], call)(*args)

    def reopen(self) -> None:
        """Open the link again after it was lost. Raises InstrumentError (link lost)."""
        with self.lock:
            self._identified.clear()
            self._said_s.clear()
            for link in self.loader.links.values():
                link.reopen()

    def close(self) -> None:
        """Let go of the link."""
        for link in self.loader.links.values():
            link.close()


def open_lines(path: Path, config: BenchConfig | Essentials) -> dict[str, OwnedLine]:
    """One line for every owned instrument by name; those that state the same link share theirs. Opens nothing yet."""
    lines: dict[str, OwnedLine] = {}
    for name in config.guarded:
        whole = cast("BenchConfig", config)  # of real links a loader asks no more than the essentials
        url = (loader := GatedLoader(path, whole, RealClock(), 0)).line_of(name)
        lines[name] = next((line for line in lines.values() if line.url == url), OwnedLine(url, loader))
    return lines


class LockedRelay:
    """A PolarityRelay on a line that other threads use too."""

    def __init__(self, name: str, line: OwnedLine) -> None:
        self.name, self._line = name, line

    @property
    def _relay(self) -> PolarityRelay:
        return cast(PolarityRelay, self._line.instrument(self.name))

    def identify(self) -> Identity:
        """Who answers."""
        return self._line.identify(self.name)

    def reverses(self, axis: str) -> bool:
        """Whether contacts are wired into `axis`."""
        return self._relay.reverses(axis)

    def set_polarity(self, axis: str, sign: int) -> None:
        """Switch, confirmed by read-back."""
        with self._line.lock:
            self._relay.set_polarity(axis, sign)

    def polarity(self, axis: str) -> int:
        """+1 or -1, read back."""
        with self._line.lock:
            return self._relay.polarity(axis)

    def make_safe(self) -> None:
        """Leave the contacts where they are."""
        with self._line.lock:
            self._relay.make_safe()

    def close(self) -> None:
        """Let go of the line."""
        self._relay.close()


def relay_of(config: BenchConfig | Essentials, lines: Mapping[str, OwnedLine]) -> LockedRelay | None:
    """The reversing contacts of the bench, if it has any."""
    names = [name for name, entry in config.instruments.items() if entry.role == "polarity"]
    return LockedRelay(names[0], lines[names[0]]) if names else None

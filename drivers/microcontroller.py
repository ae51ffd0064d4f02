"""A board with H-bridges that speaks labcal-coil/1 (docs/microcontroller.md): signed current, or signed duty."""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import Annotated, Any

from pydantic import Field

from drivers.framing.coil_line import CoilLine
from drivers.framing.supply import CurrentSource
from labcal.bench.clock import Clock
from labcal.bench.driver_kit.quantity import quantity
from labcal.bench.driver_kit.roles import Identity
from labcal.bench.driver_kit.settings import NotNegative, Positive
from labcal.bench.links import Link, quoted
from labcal.errors import InstrumentError

PROTOCOL, MICRO = "labcal-coil/1", 1_000_000
WHO = re.compile(
    r"labcal-coil/1 (?P<maker>\S+) (?P<model>\S+) (?P<serial>\S+) (?P<firmware>\S+) channels=(?P<channels>\d) "
    r"unit=(?P<unit>uA|ppm) limit=(?P<limit>\d{1,9}) watchdog_ms=(?P<watchdog>\d{1,6}) sense=(?P<sense>[01])"
)


@dataclass(frozen=True, slots=True)
class Settings:
    """`watchdog_s`: its firmware's own, as it tells. `full_scale_A`: what flows at full duty, where it takes a duty.

    `unsensed`: it measures no current, and what is read back is what it drives. `starts_in_s`: an opened port resets
    many boards, which are then silent for so long.
    """

    channel: Annotated[int, Field(ge=1, le=6)] = 1
    max_current_A: Positive = 1.0
    full_scale_A: NotNegative = 0.0
    unsensed: bool = False
    watchdog_s: NotNegative = 0.0
    zero_current_A: float = 0.01
    ramp_A_per_s: float = 4.0
    resolution_A: Positive = 0.001
    starts_in_s: NotNegative = 3.0
    timeout_s: Positive = 0.5

    def __post_init__(self) -> None:
        if self.full_scale_A and self.max_current_A > self.full_scale_A:
            raise ValueError("max_current_A must be at most full_scale_A, which flows at full duty")


class counted(quantity):
    """A current that goes over the line as a whole number of µA, or of millionths of the duty."""

    def _message(self, device: Any, value: float) -> str:
        return super()._message(device, round(value * device.per_A))

    def _ask(self, device: Any) -> float:
        return super()._ask(device) / float(device.per_A if self.set or device.settings.unsensed else MICRO)

    def _agrees(self, device: Any, value: float, held: float) -> bool:
        return bool(abs(held - value) <= device.settings.resolution_A)


def _whole(reply: str) -> float:
    if re.fullmatch(r"-?\d{1,9}", reply) is None:
        raise ValueError(reply)
    return float(reply)


class CoilBoard(CurrentSource):
    """One channel of a board: a signed supply that falls to zero by itself where its firmware hears nothing."""

    roles = ("coil",)
    never = (  # whatever is no line of the protocol
        rb"^(?!\d{1,3} (WHO|BEAT|TRIP\? \d|(SET|MEAS|OUT)\? \d|OUT \d [01]|SET \d -?\d{1,9})\*[0-9A-F]{2}\n\Z)",
    )
    bipolar, can_open = True, True

    current = counted(
        "SET? {s.channel}", "SET {s.channel} {value:d}", unit="A", doc="Control the signed current set-point.",
        limits=lambda s: (-s.max_current_A, s.max_current_A), read=_whole,
    )  # fmt: skip
    sensed = counted("MEAS? {s.channel}", unit="A", doc="Measure the delivered current.", read=_whole)
    enabled = quantity(
        "OUT? {s.channel}", "OUT {s.channel} {value:d}", unit="1", doc="Control whether the bridge drives.",
        limits=lambda s: (0, 1), read=_whole,
    )  # fmt: skip

    def __init__(self, name: str, link: Link, clock: Clock, settings: Settings) -> None:
        self.name, self.settings, self._link, self._clock = name, settings, link, clock
        self._line = CoilLine(name, link, clock, settings.channel, settings.timeout_s)
        self.query, self.write = self._line.ask, self._line.send
        self.zero_current_A, self.ramp_A_per_s = settings.zero_current_A, settings.ramp_A_per_s
        self.watchdog_s, self.per_A = settings.watchdog_s, MICRO / (settings.full_scale_A or 1.0)
        self._watched = False

    def identify(self) -> Identity:
        """Ask who it is, for as long as it may take to start. Raises InstrumentError where its settings are others."""
        who = WHO.fullmatch(reply := self._who())
        if who is None:
            message = f"{self.name}: {quoted(reply)} answered, not a board that speaks {PROTOCOL}."
            raise InstrumentError(message, fault="another instrument")
        s, sees, watchdog_s = self.settings, who["sense"] == "1", int(who["watchdog"]) / 1000
        limit_A = int(who["limit"]) / self.per_A
        self._refuse(s.channel > int(who["channels"]), f"it has {who['channels']} channels", "channel")
        self._refuse((who["unit"] == "ppm") != (s.full_scale_A > 0), f"it counts in {who['unit']}", "full_scale_A")
        self._refuse(s.max_current_A > limit_A, f"its firmware's limit is {limit_A:g} A", "max_current_A")
        self._refuse(s.unsensed == sees, f"it {'measures' if sees else 'does not measure'} its current", "unsensed")
        self._refuse(abs(s.watchdog_s - watchdog_s) > 0.0005, f"its watchdog takes {watchdog_s:g} s", "watchdog_s")
        return Identity(who["maker"], who["model"], who["serial"], who["firmware"])

    def command(self, text: str) -> None:
        """Tell. Raises InstrumentError with why the board refused."""
        self._line.ask(text)

    def output(self, on: bool) -> None:
        """Switch the bridge, confirmed. It goes on at zero alone: the firmware holds no set-point while it is off."""
        self._watched = on and self.watchdog_s > 0
        self.enabled = on

    def trip(self) -> str:
        """Which of the firmware's own protections has taken it to zero."""
        return "" if (why := self.query(f"TRIP? {self.settings.channel}")) == "none" else why

    def feed(self) -> None:
        """Be heard, where it watches. Raises InstrumentError (tripped) where its firmware has taken it to zero."""
        if self._watched:
            self.query("BEAT")

    def close(self) -> None:
        """Let go of the link."""
        self._link.close()

    def _who(self) -> str:
        until_s = self._clock.now() + self.settings.starts_in_s
        while True:
            try:
                return self.query("WHO")
            except InstrumentError as fault:
                if fault.fault not in ("silent", "wrong reply") or self._clock.now() >= until_s:
                    raise

    def _refuse(self, wrong: bool, fact: str, key: str) -> None:
        if wrong:
            remedy = f"Correct {key} in its settings in bench.toml."
            raise InstrumentError(
                f"{self.name}: {fact}, its settings say otherwise.", fault="wrong set-up", remedy=remedy
            )

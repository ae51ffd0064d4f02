"""TDK-Lambda Genesys in its own language (RS-232/485, 9600 8N1), several on one line; unipolar. A Z+ knows it too."""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import Annotated

from pydantic import Field

from drivers.framing.genesys import Conversation
from drivers.framing.supply import CurrentSource
from labcal.bench.clock import Clock
from labcal.bench.driver_kit.quantity import quantity
from labcal.bench.driver_kit.roles import Identity
from labcal.bench.driver_kit.settings import NotNegative, Positive
from labcal.bench.links import Link, quoted
from labcal.errors import InstrumentError

IDENTITY = re.compile(r"(?:TDK-?)?LAMBDA, ?((?:GENH?|Z)(\d+(?:\.\d+)?)-(\d+(?:\.\d+)?).*)", re.IGNORECASE)
TRIPS = {1: "AC fail", 2: "over-temperature", 3: "foldback", 4: "over-voltage", 5: "Shut Off", 7: "Enable"}

STATE_LESS = "Is it this supply that drives the coil? State what it can deliver in bench.toml."


@dataclass(frozen=True, slots=True)
class Settings:
    """`address`: 6 as it leaves the factory. `gap_s`: the least pause after each message."""

    address: Annotated[int, Field(ge=0, le=30)] = 6
    max_current_A: Positive = 3.0
    compliance_V: Positive = 20.0
    zero_current_A: float = 0.02
    ramp_A_per_s: float = 4.0
    gap_s: NotNegative = 0.01
    timeout_s: Positive = 0.6


def switch(reply: str) -> float:
    """ON or OFF, or 1 or 0. Raises ValueError for all else."""
    if reply not in ("ON", "OFF", "1", "0"):
        raise ValueError(reply)
    return float(reply in ("ON", "1"))


class GenesysSupply(CurrentSource):
    """Every set is acknowledged and read back.

    Before its output goes on, what would end a constant current (foldback protection) or begin one by itself after a
    power cut (auto-restart) is switched off, and read back.
    """

    roles = ("coil",)
    never = (rb"RST", rb"SAV", rb"RCL", rb"\\", rb"AST +(1|ON)", rb"FLD +(1|ON)", rb"[\x80-\xff]", rb"LLO|RMT +2")
    bipolar, can_open = False, True

    current = quantity(
        "PC?", "PC {value:.4f}", unit="A", doc="Control the current set-point.",
        limits=lambda s: (0.0, s.max_current_A), tolerance=0.0101,  # two decimals of the largest models
    )  # fmt: skip
    compliance = quantity(
        "PV?", "PV {value:.3f}", unit="V", doc="Control the voltage that may drive the coil.",
        limits=lambda s: (0.0, 600.0), tolerance=0.0101,
    )  # fmt: skip
    enabled = quantity(
        "OUT?", "OUT {value:d}", unit="1", doc="Control whether the output is on.", limits=lambda s: (0, 1), read=switch
    )
    foldback = quantity(
        "FLD?", "FLD {value:d}", unit="1", doc="Control whether constant current is a fault.", limits=lambda s: (0, 0),
        read=switch,
    )  # fmt: skip
    restart = quantity(
        "AST?", "AST {value:d}", unit="1", doc="Control whether it goes on by itself when power comes back.",
        limits=lambda s: (0, 0), read=switch,
    )  # fmt: skip
    sensed = quantity("MC?", unit="A", doc="Measure the delivered current.")
    faults = quantity("FLT?", unit="1", doc="Tell which faults there are, a bit each.", read=lambda said: int(said, 16))

    def __init__(self, name: str, link: Link, clock: Clock, settings: Settings) -> None:
        self.name, self.settings, self._link = name, settings, link
        self.zero_current_A, self.ramp_A_per_s = settings.zero_current_A, settings.ramp_A_per_s
        self._line = Conversation(name, link, clock, settings.address, settings.gap_s, settings.timeout_s)
        self.query, self.command, self.write = self._line.ask, self._line.command, self._line.send
        self.refuse_earlier = self._line.refuse_earlier

    def identify(self) -> Identity:
        """Ask who it is at this address, and what it can deliver."""
        self._line.select()
        said = self.query("IDN?")
        if (found := IDENTITY.fullmatch(said)) is None:
            self.refuse_earlier("IDN?", said)
            raise InstrumentError(f"{self.name}: {quoted(said)} answered, not a Genesys.", fault="another instrument")
        for most, unit, asked in (
            (found[2], "V", self.settings.compliance_V),
            (found[3], "A", self.settings.max_current_A),
        ):
            if float(most) < asked:
                message = f"it delivers {most} {unit}, and {asked:g} {unit} are stated"
                raise InstrumentError(f"{self.name}: {message}.", fault="wrong set-up", remedy=STATE_LESS)
        return Identity("TDK-Lambda", found[1], self.query("SN?"), self.query("REV?").removeprefix("REV:"))

    def output(self, on: bool) -> None:
        """Switch the output, confirmed; before it goes on, compliance, foldback and auto-restart are set."""
        if on:
            self.foldback, self.restart = 0, 0
        super().output(on)

    def trip(self) -> str:
        """Which protections its fault register names."""
        faults = int(self.faults)
        return " and ".join(name for bit, name in TRIPS.items() if faults >> bit & 1)

    def close(self) -> None:
        """Let go of the link."""
        self._link.close()

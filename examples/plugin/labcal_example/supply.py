"""A made-up SCPI supply, one unipolar output; in a driver of your own this line names models and manual."""

from __future__ import annotations

from dataclasses import dataclass

from drivers.framing.scpi import Scpi
from drivers.framing.supply import CurrentSource
from labcal.bench.clock import Clock
from labcal.bench.driver_kit.quantity import quantity
from labcal.bench.driver_kit.roles import Identity
from labcal.bench.driver_kit.settings import Positive
from labcal.bench.links import Link


@dataclass(frozen=True, slots=True)
class Settings:
    """What bench.toml may state; the defaults fit most units. `compliance_V` bounds the voltage across the coil."""

    max_current_A: Positive = 3.0
    compliance_V: Positive = 20.0
    zero_current_A: float = 0.005
    ramp_A_per_s: float = 4.0
    timeout_s: Positive = 0.5


class ExampleSupply(CurrentSource):
    """A unipolar supply in constant current."""

    roles = ("coil",)
    never = (rb"\*RST", rb"\*SAV", rb"\*RCL")  # they switch the output or change its limits unseen
    bipolar, can_open = False, True

    current = quantity(
        "CURR?", "CURR {value:.4f}", unit="A", doc="Control the current set-point.",
        limits=lambda s: (0.0, s.max_current_A), tolerance=0.001,
    )  # fmt: skip
    compliance = quantity(
        "VOLT?", "VOLT {value:.3f}", unit="V", doc="Control the voltage that may drive the coil.",
        limits=lambda s: (0.0, 30.0), tolerance=0.01,
    )  # fmt: skip
    enabled = quantity(
        "OUTP?", "OUTP {value:d}", unit="1", doc="Control whether the output is on.", limits=lambda s: (0, 1),
    )  # fmt: skip
    sensed = quantity("MEAS:CURR?", unit="A", doc="Measure the delivered current.")

    def __init__(self, name: str, link: Link, clock: Clock, settings: Settings) -> None:
        self.name, self.settings, self._link = name, settings, link
        self._scpi = Scpi(name, link, clock, settings.timeout_s)
        self.query, self.command, self.write = self._scpi.query, self._scpi.command, self._scpi.send
        self.zero_current_A, self.ramp_A_per_s = settings.zero_current_A, settings.ramp_A_per_s

    def identify(self) -> Identity:
        """Ask who it is, and empty the error queue of the time before."""
        who = self._scpi.identify(lambda maker, model: maker == "EXAMPLE", "the example's supply")
        self._scpi.empty_errors()
        return who

    def close(self) -> None:
        """Let go of the link."""
        self._link.close()

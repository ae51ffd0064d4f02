"""Rigol DP800 supplies (DP811 … DP832), one channel, SCPI (DP800 programming guide)."""

from __future__ import annotations

from dataclasses import dataclass

from drivers.framing.scpi import Scpi
from drivers.framing.supply import CurrentSource
from labcal.bench.clock import Clock
from labcal.bench.driver_kit.quantity import quantity
from labcal.bench.driver_kit.roles import Identity
from labcal.bench.driver_kit.settings import NotNegative, Output, Positive
from labcal.bench.links import Link

TRIPS = {"OVP": "over-voltage", "OCP": "over-current"}


@dataclass(frozen=True, slots=True)
class Settings:
    """`gap_s`: the least pause after each message. `compliance_V` bounds the voltage that drives the coil."""

    channel: Output = 1
    max_current_A: Positive = 3.0
    compliance_V: Positive = 20.0
    zero_current_A: float = 0.005
    ramp_A_per_s: float = 4.0
    gap_s: NotNegative = 0.05
    timeout_s: Positive = 1.5


class RigolSupply(CurrentSource):
    """A unipolar supply in constant current. Its error queue is read after every set; `*RST` is never sent."""

    roles = ("coil",)
    never = (rb"\*RST", rb"\*SAV", rb"\*RCL", rb"\*TST")
    bipolar, can_open = False, True

    current = quantity(
        ":SOUR{s.channel}:CURR?", ":SOUR{s.channel}:CURR {value:.4f}", unit="A", doc="Control the current set-point.",
        limits=lambda s: (0.0, s.max_current_A), tolerance=0.00101,
    )  # fmt: skip
    compliance = quantity(
        ":SOUR{s.channel}:VOLT?", ":SOUR{s.channel}:VOLT {value:.3f}", unit="V",
        doc="Control the voltage that may drive the coil.", limits=lambda s: (0.0, 63.0), tolerance=0.0101,
    )  # fmt: skip
    sensed = quantity(":MEAS:CURR? CH{s.channel}", unit="A", doc="Measure the delivered current.")
    enabled = quantity(
        ":OUTP? CH{s.channel}", ":OUTP CH{s.channel},{on}", unit="1", doc="Control whether the output is on.",
        limits=lambda s: (0, 1), read=lambda reply: {"ON": 1.0, "OFF": 0.0, "1": 1.0, "0": 0.0}[reply],
    )  # fmt: skip

    def __init__(self, name: str, link: Link, clock: Clock, settings: Settings) -> None:
        self.name, self.settings, self._link = name, settings, link
        self._scpi = Scpi(name, link, clock, settings.timeout_s, settings.gap_s, ":SYST:ERR?")
        self.query, self.command, self.write = self._scpi.query, self._scpi.command, self._scpi.send
        self.refuse_earlier = self._scpi.refuse_earlier
        self.zero_current_A, self.ramp_A_per_s = settings.zero_current_A, settings.ramp_A_per_s

    def identify(self) -> Identity:
        """Ask who it is, and empty the error queue of the time before."""
        who = self._scpi.identify(lambda maker, model: "RIGOL" in maker and model.startswith("DP"), "a Rigol DP supply")
        self._scpi.empty_errors()
        return who

    def trip(self) -> str:
        """Which protection it says has tripped."""
        asked = ((f":OUTP:{word}:QUES? CH{self.settings.channel}", name) for word, name in TRIPS.items())
        return " and ".join(name for question, name in asked if self.query(question) == "YES")

    def release(self) -> None:
        """Give it back to its panel. Nothing is asked after it: any other message takes control again."""
        self._scpi.send(":SYST:LOC")

    def close(self) -> None:
        """Let go of the link."""
        self._link.close()

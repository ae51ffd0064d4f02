"""Keysight E36311A, E36312A, E36313A, one output, SCPI with channel lists (raw TCP 5025), unipolar."""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import Annotated

from pydantic import Field

from drivers.framing.scpi import Scpi
from drivers.framing.supply import CurrentSource
from labcal.bench.clock import Clock
from labcal.bench.driver_kit.quantity import quantity
from labcal.bench.driver_kit.roles import Identity
from labcal.bench.driver_kit.settings import Output, Positive
from labcal.bench.links import Link
from labcal.errors import InstrumentError

COUPLINGS = (("OUTP:PAIR?", "pairing"), ("OUTP:TRAC?", "tracking"))
UNCOUPLED = ("OFF", "0")
TRIPS = {"VOLT": "over-voltage", "CURR": "over-current"}


@dataclass(frozen=True, slots=True)
class Settings:
    """`couplings`: what must answer OFF before the output goes on; an empty list where a model has neither.

    `watchdog_s`: its outputs switch off after so many seconds without a message; 0: it is left alone.
    """

    output: Output = 1
    max_current_A: Positive = 3.0
    compliance_V: Positive = 6.0
    zero_current_A: float = 0.01
    ramp_A_per_s: float = 4.0
    couplings: tuple[str, ...] = ("pairing", "tracking")
    timeout_s: Positive = 1.5
    watchdog_s: Annotated[int, Field(ge=0, le=3600)] = 0


class KeysightSupply(CurrentSource):
    """A unipolar supply in constant current, no output of which may drag another along."""

    roles = ("coil",)
    never = (rb"\*(RST|SAV|RCL|TST)", rb"CAL", rb"OUTP\w*:(PAIR|TRAC)\w*\s", rb"MEM", rb"SYST\w*:(SEC|COMM)")
    bipolar, can_open = False, True

    current = quantity(
        "CURR? (@{s.output})", "CURR {value:.4f},(@{s.output})", unit="A", doc="Control the current set-point.",
        limits=lambda s: (0.0, s.max_current_A), tolerance=0.00101,
    )  # fmt: skip
    compliance = quantity(
        "VOLT? (@{s.output})", "VOLT {value:.3f},(@{s.output})", unit="V",
        doc="Control the voltage that may drive the coil.", limits=lambda s: (0.0, 25.0), tolerance=0.0101,
    )  # fmt: skip
    enabled = quantity(
        "OUTP? (@{s.output})", "OUTP {value:d},(@{s.output})", unit="1", doc="Control whether the output is on.",
        limits=lambda s: (0, 1),
    )  # fmt: skip
    watchdog_delay = quantity(
        "OUTP:PROT:WDOG:DEL?", "OUTP:PROT:WDOG:DEL {value:.0f}", unit="s",
        doc="Control the silence after which it switches off.", limits=lambda s: (1, 3600),
    )  # fmt: skip
    watching = quantity(
        "OUTP:PROT:WDOG?", "OUTP:PROT:WDOG {value:d}", unit="1", doc="Control whether it minds a silence.",
        limits=lambda s: (0, 1),
    )  # fmt: skip
    sensed = quantity("MEAS:CURR? (@{s.output})", unit="A", doc="Measure the delivered current.")

    def __init__(self, name: str, link: Link, clock: Clock, settings: Settings) -> None:
        self.name, self.settings, self._link = name, settings, link
        self._scpi = Scpi(name, link, clock, settings.timeout_s)
        self.query, self.command, self.write = self._scpi.query, self._scpi.command, self._scpi.send
        self.refuse_earlier = self._scpi.refuse_earlier
        self.zero_current_A, self.ramp_A_per_s = settings.zero_current_A, settings.ramp_A_per_s
        self.watchdog_s, self._armed = float(settings.watchdog_s), False

    def identify(self) -> Identity:
        """Ask who it is, and empty the error queue of the time before. An E3631A speaks otherwise and is refused."""
        who = self._scpi.identify(
            lambda maker, model: re.fullmatch("E3631[123]A", model) is not None,
            "a Keysight E36311A, E36312A or E36313A",
        )
        self._scpi.empty_errors()
        return who

    def output(self, on: bool) -> None:
        """Switch the output, confirmed; before it goes on, it is not coupled, watched, and its compliance is set."""
        if on:
            self._refuse_coupling()
            self._watch()
        super().output(on)

    def trip(self) -> str:
        """Which protection it says has tripped."""
        asked = ((f"{word}:PROT:TRIP? (@{self.settings.output})", name) for word, name in TRIPS.items())
        return " and ".join(name for question, name in asked if self.query(question) == "1")

    def feed(self) -> None:
        """Be heard, where it watches. Raises InstrumentError where it does so no longer: it was switched off and on."""
        if self._armed and not self.watching:
            raise InstrumentError(
                f"{self.name}: its watchdog is off.",
                fault="tripped",
                remedy="Was it switched off and on? Try again.",
            )

    def release(self) -> None:
        """Give it back to its panel. Nothing is asked after it: any other message takes control again."""
        if self._armed:
            self.watching, self._armed = 0, False
        self._scpi.send("SYST:LOC")

    def close(self) -> None:
        """Let go of the link."""
        self._link.close()

    def _watch(self) -> None:
        if not self.watchdog_s:
            return
        try:
            self.watchdog_delay, self.watching = self.watchdog_s, 1
        except InstrumentError as fault:
            remedy = "Leave watchdog_s out of its settings where this model has no watchdog."
            raise InstrumentError(fault.what, fault=fault.fault, remedy=remedy) from fault
        self._armed = True

    def _refuse_coupling(self) -> None:
        for ask, name in COUPLINGS:
            if name in self.settings.couplings and (said := self.query(ask)) not in UNCOUPLED:
                raise InstrumentError(
                    f"{self.name}: its outputs are coupled: {name} is {said}.",
                    fault="wrong mode",
                    remedy=f"Switch {name} off on its panel.",
                )

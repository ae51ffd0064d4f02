"""HP and Agilent 6030A to 6038A in their own language (GPIB, before SCPI): one output, autoranging, unipolar."""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import Any

from drivers.framing.scpi import Scpi, refused
from drivers.framing.supply import CurrentSource
from labcal.bench.clock import Clock
from labcal.bench.driver_kit.quantity import after, quantity
from labcal.bench.driver_kit.roles import Identity
from labcal.bench.driver_kit.settings import NotNegative, Positive
from labcal.bench.links import Link, abridged, quoted
from labcal.errors import InstrumentError

IDENTITY = re.compile(r"ID +HP ?(60\d\d[A-Z])")
MOST = {  # volts and amperes of each model; the product of both is more than it delivers
    "6030A": (200.0, 17.0), "6031A": (20.0, 120.0), "6032A": (60.0, 50.0), "6033A": (20.0, 30.0),
    "6035A": (500.0, 5.0), "6038A": (60.0, 10.0),
}  # fmt: skip
TRIPS = {3: "over-voltage", 4: "over-temperature", 5: "AC line", 6: "foldback", 8: "remote inhibit"}  # bits of STS?
ERRORS = {
    1: "a character is not known", 2: "a number is none", 3: "it does not know this", 4: "wrong syntax",
    5: "the number is out of range", 6: "it does not go beyond its soft limits", 7: "a soft limit below what is set",
    8: "nothing was asked", 9: "its relays do not answer",
}  # fmt: skip
STEPS = 2000  # of the range: it sets and tells in 12 bits of a little more than it, and both may round


@dataclass(frozen=True, slots=True)
class Settings:
    """`model` as its front has it, such as 6038A: it bounds what may be stated and how finely it reads back.

    `gap_s`: the least pause after each message; it works one off in some 10 ms.
    """

    model: str = "6038A"
    max_current_A: Positive = 3.0
    compliance_V: Positive = 20.0
    zero_current_A: Positive = 0.03
    ramp_A_per_s: Positive = 4.0
    gap_s: NotNegative = 0.0
    timeout_s: Positive = 1.5

    def __post_init__(self) -> None:
        if self.model not in MOST:
            raise ValueError(f"model must be one of {', '.join(MOST)}")
        for most, what, unit in zip(MOST[self.model], ("compliance_V", "max_current_A"), "VA", strict=True):
            if getattr(self, what) > most:
                raise ValueError(f"{what} must be at most {most:g} {unit}, which is all that a {self.model} delivers")


class coarse(quantity):
    """A number that comes back as the nearest of 12 bits; `place` of its range in MOST."""

    def __init__(self, get: str, set: str, *, place: int, **rest: Any) -> None:
        super().__init__(get, set, **rest)
        self.place = place

    def _agrees(self, device: Any, value: float, held: float) -> bool:
        return abs(held - value) <= MOST[device.settings.model][self.place] / STEPS


class Hp603x(CurrentSource):
    """Its error register is asked for after every set; every set is read back.

    Before the output goes on foldback, which would end a constant current, is switched off and read back.
    """

    roles = ("coil",)
    never = (  # after CLR, RST and RCL another state holds; HOLD delays a zero until it is triggered
        rb"(?<![A-Z])(CLR|RST|RCL|STO|TEST|HOLD +(1|ON)|FOLD +(1|2|CV|CC)|TRG|CMODE|RLY|OUTREL|CAL)",
    )
    bipolar, can_open = False, True

    current = coarse(
        "ISET?", "ISET {value:.4f}", unit="A", doc="Control the current set-point.", read=after("ISET"),
        limits=lambda s: (0.0, s.max_current_A), place=1,
    )  # fmt: skip
    compliance = coarse(
        "VSET?", "VSET {value:.4f}", unit="V", doc="Control the voltage that may drive the coil.",
        limits=lambda s: (0.0, s.compliance_V), read=after("VSET"), place=0,
    )  # fmt: skip
    enabled = quantity(
        "OUT?", "OUT {value:d}", unit="1", doc="Control whether the output is on.", limits=lambda s: (0, 1),
        read=after("OUT"),
    )  # fmt: skip
    foldback = quantity(
        "FOLD?", "FOLD {value:d}", unit="1", doc="Control whether a constant current is a fault.", read=after("FOLD"),
        limits=lambda s: (0, 0),
    )  # fmt: skip
    sensed = quantity("IOUT?", unit="A", doc="Measure the delivered current.", read=after("IOUT"))
    status = quantity("STS?", unit="1", doc="Tell how it is, a bit each.", read=after("STS"))

    def __init__(self, name: str, link: Link, clock: Clock, settings: Settings) -> None:
        self.name, self.settings, self._link = name, settings, link
        self.zero_current_A, self.ramp_A_per_s = settings.zero_current_A, settings.ramp_A_per_s
        line = Scpi(name, link, clock, settings.timeout_s, settings.gap_s)
        self.query, self.write, self.refuse_earlier, self._line = line.query, line.send, line.refuse_earlier, line

    def identify(self) -> Identity:
        """Ask which model it is, and read its error register away."""
        said = self._line.query("ID?")
        if (found := IDENTITY.fullmatch(said)) is None:
            self._line.refuse_earlier("ID?", said)
            told = f"{abridged(said)!r} answered, not an HP {self.settings.model}"
            raise InstrumentError(f"{self.name}: {told}.", fault="another instrument")
        if found[1] != self.settings.model:
            told = f"an HP {found[1]} answered, not an HP {self.settings.model}"
            raise InstrumentError(
                f"{self.name}: {told}.", fault="wrong set-up", remedy="State its model in bench.toml."
            )
        self._line.query("ERR?")
        return Identity("HP", found[1], "", "")

    def output(self, on: bool) -> None:
        """Switch the output, confirmed; before it goes on, compliance and foldback are set."""
        if on:
            self.foldback = 0
        super().output(on)

    def trip(self) -> str:
        """Which protections its status register names."""
        status = int(self.status)
        return " and ".join(name for bit, name in TRIPS.items() if status >> bit & 1)

    def command(self, text: str) -> None:
        """Tell. Raises InstrumentError with what its error register says."""
        self._line.send(text)
        said = self._line.query("ERR?")
        try:
            error = int(after("ERR")(said))
        except ValueError:
            self._line.refuse_earlier("ERR?", said)
            raise refused(self.name, text, f"asked for errors it answered {quoted(said)}") from None
        if error:
            raise refused(self.name, text, f"error {error}: {ERRORS.get(error, 'not known')}")

    def close(self) -> None:
        """Let go of the link."""
        self._link.close()

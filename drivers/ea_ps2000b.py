"""EA PS 2000 B, single and triple, over their USB port (115200 baud, odd parity): binary telegrams, unipolar."""

from __future__ import annotations

import re
import struct
from dataclasses import dataclass
from typing import Literal

from drivers.framing import ea_telegram as ea
from drivers.framing.supply import CurrentSource
from labcal.bench.clock import Clock
from labcal.bench.driver_kit.quantity import quantity
from labcal.bench.driver_kit.roles import Identity
from labcal.bench.driver_kit.settings import NotNegative, Positive
from labcal.bench.links import Link, quoted
from labcal.errors import InstrumentError

MODEL = re.compile(r"PS ?2\d{3}-\d+ ?B.*")
TRIPS = {4: "over-voltage", 5: "over-current", 6: "over-power", 7: "over-temperature"}  # bits of its second byte
REMOTE, OUTPUT = 0x10, 0x01  # bits of its control, each told with itself as mask


@dataclass(frozen=True, slots=True)
class Settings:
    """`channel`: 1 is the output of a single and the first of a triple, 2 the second (the third is not distinguished).

    `gap_s`: the least pause between telegrams.
    """

    channel: Literal[1, 2] = 1
    max_current_A: Positive = 3.0
    compliance_V: Positive = 20.0
    zero_current_A: float = 0.02
    ramp_A_per_s: float = 4.0
    gap_s: NotNegative = 0.05
    timeout_s: Positive = 0.5

    @property
    def node(self) -> int:
        """The channel as telegrams have it."""
        return self.channel - 1


class EaPs2000B(CurrentSource):
    """A unipolar supply that takes set-points under remote control alone, in counts of its own nominal values."""

    roles = ("coil",)
    never = (rb"^[\xf0-\xff].[^\x32\x33\x36]", rb"^[\xf0-\xff].\x36[^\x01\x10]")  # thresholds, tracking, alarms
    bipolar, can_open = False, True

    current = quantity(
        "51 0 A", "51 {value:.6f}", unit="A", doc="Control the current set-point.",
        limits=lambda s: (0.0, s.max_current_A), tolerance=0.0005,
    )  # fmt: skip
    compliance = quantity(
        "50 0 V", "50 {value:.6f}", unit="V", doc="Control the voltage that may drive the coil.",
        limits=lambda s: (0.0, 84.0), tolerance=0.002,
    )  # fmt: skip
    enabled = quantity(
        "71 1 bit", "54 {value:d}", unit="1", doc="Control whether the output is on.", limits=lambda s: (0, 1)
    )
    sensed = quantity("71 4 A", unit="A", doc="Measure the delivered current.")

    def __init__(self, name: str, link: Link, clock: Clock, settings: Settings) -> None:
        self.name, self.settings, self._link = name, settings, link
        self.zero_current_A, self.ramp_A_per_s = settings.zero_current_A, settings.ramp_A_per_s
        self._nominal, self._remote = dict[str, float](), False
        self._line = ea.Conversation(name, link, clock, settings.node, settings.gap_s, settings.timeout_s)

    def identify(self) -> Identity:
        """Ask who it is, and its nominal values."""
        self._remote = False
        self._nominal.clear()
        model, serial, maker, version = map(self._line.text, (ea.TYPE, ea.SERIAL, ea.MAKER, ea.VERSION))
        if not MODEL.fullmatch(model):
            raise InstrumentError(
                f"{self.name}: {quoted(model)} answered, not a PS 2000 B.", fault="another instrument"
            )
        if (most_A := self._full("A")) < self.settings.max_current_A:
            message = f"it delivers {most_A:g} A, and max_current_A is {self.settings.max_current_A:g}"
            remedy = "Is it this supply that drives the coil? State what it can deliver in bench.toml."
            raise InstrumentError(f"{self.name}: {message}.", fault="wrong set-up", remedy=remedy)
        return Identity(maker, model, serial, version)

    def query(self, text: str) -> str:
        """Ask for an object: two bytes from a place on as a share of the nominal value, or the lowest bit there."""
        number, place, unit = text.split()
        data, at = self._line.ask(int(number)), int(place)
        if unit == "bit":
            return f"{data[at] & 1}"
        return f"{int.from_bytes(data[at : at + 2], 'big') * self._full(unit) / ea.FULL:.6f}"

    def command(self, text: str) -> None:
        """Tell, under remote control, and see that it acknowledges."""
        held, self._remote = self._remote, False
        if not held:
            self._line.exchange(self._control(REMOTE, True))
        self._line.exchange(self._set_telegram(text))
        self._remote = True

    def write(self, text: str) -> None:
        """Tell, under remote control, and wait for nothing."""
        for one in (self._control(REMOTE, True), self._set_telegram(text)):
            self._line.send(one)

    def trip(self) -> str:
        """Which protection it says is active."""
        state = self._line.ask(ea.STATE)[1]
        return " and ".join(name for bit, name in TRIPS.items() if state >> bit & 1)

    def release(self) -> None:
        """Give it back to its panel. Nothing is asked after it."""
        self._line.send(self._control(REMOTE, False))
        self._remote = False

    def close(self) -> None:
        """Let go of the link."""
        self._link.close()

    def _set_telegram(self, text: str) -> bytes:
        number, value = text.split()
        if int(number) == ea.CONTROL:
            return self._control(OUTPUT, value == "1")
        full = self._full("V" if int(number) == ea.SET_VOLTAGE else "A") if float(value) else 1.0  # zero needs none
        counts = round(float(value) / full * ea.FULL)
        return ea.telegram(ea.SEND, self.settings.node, int(number), counts.to_bytes(2, "big"))

    def _control(self, bit: int, on: bool) -> bytes:
        return ea.telegram(ea.SEND, self.settings.node, ea.CONTROL, bytes([bit, bit if on else 0]))

    def _full(self, unit: str) -> float:
        """The nominal voltage or current."""
        if unit not in self._nominal:
            (found,) = struct.unpack(">f", self._line.ask(ea.VOLTS if unit == "V" else ea.AMPS))
            if not 1.0 <= found <= 1000.0:
                raise InstrumentError(f"{self.name}: its nominal value is {found:g} {unit}.", fault="wrong reply")
            self._nominal[unit] = found
        return self._nominal[unit]

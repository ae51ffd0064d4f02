"""An analogue three-axis fluxgate on three inputs of a LabJack T7 (Modbus TCP 502), polled."""

from __future__ import annotations

import math
import struct
from dataclasses import dataclass
from typing import Annotated

import numpy as np
from pydantic import Field

from drivers.framing.mishaps import Mishaps, overloaded
from drivers.framing.polling import Polls
from labcal.bench.clock import Clock
from labcal.bench.driver_kit.registers import Registers
from labcal.bench.driver_kit.roles import Identity
from labcal.bench.driver_kit.settings import Address, NotNegative, Positive
from labcal.bench.links.modbus import ModbusLink
from labcal.errors import InstrumentError
from labcal.record.stream import Block, Event

RANGE, NEGATIVE, RESOLUTION = 40000, 41000, 41500  # of input 0; two, one, one register an input
PRODUCT, FIRMWARE, SERIAL = 60000, 60004, 60028
T7, GROUND, RANGES_V = 7.0, 199, (10.0, 1.0, 0.1, 0.01)
NONE_V = -9999.0  # what an input reads that does not exist
Input = Annotated[int, Field(ge=0, le=13)]


@dataclass(frozen=True, slots=True)
class Settings:
    """`uT_per_V`, `zero_V`: by the sensor's certificate, an axis each; 10 where 100 µT are 10 V. `inputs`: AIN numbers.

    `differential`: each input against the next one, so that they are even. `range_V`: of the converter. The sensor is
    overloaded at `full_scale_V`. `filter_Hz`: corner of the first-order filter before the input, whose delay is taken
    off the stamps; 0: there is none. `average`: readings to one sample.
    """

    uT_per_V: tuple[float, float, float]
    zero_V: tuple[float, float, float] = (0.0, 0.0, 0.0)
    inputs: tuple[Input, Input, Input] = (0, 1, 2)
    differential: bool = False
    range_V: float = 10.0
    full_scale_V: Positive = 9.9
    resolution_index: Annotated[int, Field(ge=0, le=12)] = 0
    filter_Hz: NotNegative = 0.0
    rate: Annotated[float, Field(gt=0, le=100)] = 10.0
    average: Annotated[int, Field(ge=1, le=100)] = 1
    serial: str = ""
    address: Address = 1

    def __post_init__(self) -> None:
        if self.range_V not in RANGES_V:
            raise ValueError(f"range_V must be one of {', '.join(f'{one:g}' for one in RANGES_V)}")
        if len(set(self.inputs)) != 3 or (self.differential and any(n % 2 for n in self.inputs)):
            raise ValueError("inputs must be three, and even where they are differential")
        if not all(map(math.isfinite, (*self.uT_per_V, *self.zero_V))) or not all(self.uT_per_V):
            raise ValueError("uT_per_V and zero_V must be finite numbers, and uT_per_V other than zero")


class LabJackT7:
    """Volts become nT by the sensor's scale. The sensor says nothing of itself: `serial` is what bench.toml states."""

    roles = ("reference",)
    never = (  # all but reading, and writing range, negative input and resolution: no outputs, nothing that is kept
        rb"^.[^\x03\x10]",
        rb"^.\x10(?!\x9C[\x40-\x5B]|\xA0[\x28-\x35]|\xA2[\x1C-\x29])",
    )

    def __init__(self, name: str, link: ModbusLink, clock: Clock, settings: Settings) -> None:
        self.name, self.settings, self._link = name, settings, link
        self._registers = Registers(link, clock, settings.address, 0.0)
        self._polls, self._mishaps = Polls(clock, settings.rate), Mishaps(name)
        self._delay_s = 1 / (2 * math.pi * settings.filter_Hz) if settings.filter_Hz else 0.0

    def identify(self) -> Identity:
        """Ask which LabJack it is, and its own serial number."""
        product, version = self._float(PRODUCT), self._float(FIRMWARE)
        if product != T7:
            raise InstrumentError(f"{self.name}: its product is {product:g}, not a T7.", fault="another instrument")
        high, low = self._registers.read(SERIAL, 2)
        return Identity("LabJack", "T7", f"{high << 16 | low} {self.settings.serial}".strip(), f"{version:.4f}")

    def start(self) -> None:
        """Set range, negative input and resolution of each input, see that it took them, and begin."""
        s = self.settings
        for n in s.inputs:
            self._set(RANGE + 2 * n, struct.unpack(">2H", struct.pack(">f", s.range_V)))
            self._set(NEGATIVE + n, (n + 1 if s.differential else GROUND,))
            self._set(RESOLUTION + n, (s.resolution_index,))
        self._polls.start()

    def read_until(self, t_s: float) -> list[Block]:
        """Samples taken up to `t_s` [nT, the sensor's own axes]."""
        taken = [(stamp, row) for stamp in self._polls.due(t_s) if (row := self._volts(stamp)) is not None]
        if not taken:
            return []
        volts = np.array([three for _, three in taken])
        if np.abs(volts).max() >= self.settings.full_scale_V:
            raise overloaded(self.name)
        values = 1000.0 * (volts - self.settings.zero_V) * np.array(self.settings.uT_per_V)
        stamps, raw = np.array([stamp for stamp, _ in taken]) - self._delay_s, volts.astype(">f4").tobytes()
        return [Block("reference", self.name, ("ref_x", "ref_y", "ref_z"), stamps, values, raw)]

    def events(self) -> list[Event]:
        """Readings that were no numbers."""
        return self._mishaps.events()

    def stop(self) -> None:
        """Ask no more."""
        self._polls.stop()

    def make_safe(self) -> None:
        """Ask no more."""
        self.stop()

    def close(self) -> None:
        """Let go of the link."""
        self._registers.close()

    def _volts(self, stamp: float) -> list[float] | None:
        """One sample of the three inputs; None, noted, where one is no number, or no input."""
        first, last = min(self.settings.inputs), max(self.settings.inputs)
        total = np.zeros(3)
        for _ in range(self.settings.average):
            words = self._registers.read(2 * first, 2 * (last - first + 1))
            volts = struct.unpack(f">{len(words) // 2}f", struct.pack(f">{len(words)}H", *words))
            total += [volts[n - first] for n in self.settings.inputs]
        if not np.isfinite(total).all() or (total <= NONE_V).any():
            self._mishaps.note("bad frame", stamp)
            return None
        return [float(v) for v in total / self.settings.average]

    def _float(self, address: int) -> float:
        return float(struct.unpack(">f", struct.pack(">2H", *self._registers.read(address, 2)))[0])

    def _set(self, address: int, words: tuple[int, ...]) -> None:
        self._registers.write_block(address, words)
        if tuple(self._registers.read(address, len(words))) != words:
            raise InstrumentError(f"{self.name}: register {address} did not take its value.", fault="read-back")

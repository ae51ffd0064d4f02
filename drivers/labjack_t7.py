"""An analogue three-axis fluxgate on three inputs of a LabJack T7 (Modbus TCP 502), polled."""

from __future__ import annotations

import struct
from dataclasses import dataclass
from typing import Annotated

import numpy as np
from pydantic import Field

from drivers.framing.analogue import Analogue, Fluxgate
from labcal.bench.clock import Clock
from labcal.bench.driver_kit.registers import Registers
from labcal.bench.driver_kit.roles import Identity
from labcal.bench.driver_kit.settings import Address
from labcal.bench.links.modbus import ModbusLink
from labcal.errors import InstrumentError

RANGE, NEGATIVE, RESOLUTION = 40000, 41000, 41500  # of input 0; two, one, one register an input
PRODUCT, FIRMWARE, SERIAL = 60000, 60004, 60028
T7, GROUND, RANGES_V = 7.0, 199, (10.0, 1.0, 0.1, 0.01)
Input = Annotated[int, Field(ge=0, le=13)]


@dataclass(frozen=True)
class Settings(Analogue):
    """`inputs`: AIN numbers, differential ones even; `range_V` 10, 1, 0.1 or 0.01. `resolution_index`: 0 is its own."""

    inputs: tuple[Input, Input, Input] = (0, 1, 2)
    resolution_index: Annotated[int, Field(ge=0, le=12)] = 0
    address: Address = 1

    def __post_init__(self) -> None:
        Analogue.__post_init__(self)
        if self.range_V not in RANGES_V:
            raise ValueError(f"range_V must be one of {', '.join(f'{one:g}' for one in RANGES_V)}")
        if self.differential and any(n % 2 for n in self.inputs):
            raise ValueError("inputs must be even where they are differential")


class LabJackT7(Fluxgate):
    """Volts become nT by the sensor's scale. The sensor says nothing of itself: `serial` is what bench.toml states."""

    roles = ("reference",)
    never = (  # all but reading, and writing range, negative input and resolution: no outputs, nothing that is kept
        rb"^.[^\x03\x10]",
        rb"^.\x10(?!\x9C[\x40-\x5B]|\xA0[\x28-\x35]|\xA2[\x1C-\x29])",
    )

    def __init__(self, name: str, link: ModbusLink, clock: Clock, settings: Settings) -> None:
        self.name, self.settings = name, settings
        self._registers = Registers(link, clock, settings.address, 0.0)
        self.begin(clock)

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

    def close(self) -> None:
        """Let go of the link."""
        self._registers.close()

    def volts(self) -> list[float]:
        """One sample of the three inputs."""
        first, last = min(self.settings.inputs), max(self.settings.inputs)
        total = np.zeros(3)
        for _ in range(self.settings.average):
            words = self._registers.read(2 * first, 2 * (last - first + 1))
            volts = struct.unpack(f">{len(words) // 2}f", struct.pack(f">{len(words)}H", *words))
            total += [volts[n - first] for n in self.settings.inputs]
        return [float(v) for v in total / self.settings.average]

    def _float(self, address: int) -> float:
        return float(struct.unpack(">f", struct.pack(">2H", *self._registers.read(address, 2)))[0])

    def _set(self, address: int, words: tuple[int, ...]) -> None:
        self._registers.write_block(address, words)
        if tuple(self._registers.read(address, len(words))) != words:
            raise InstrumentError(f"{self.name}: register {address} did not take its value.", fault="read-back")

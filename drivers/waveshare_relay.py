"""Waveshare Modbus RTU relay boards (8/16/32 channels, firmware V2 and later) as the coils' reversing contacts."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

from pydantic import Field

from labcal.bench.clock import Clock
from labcal.bench.links.modbus import ModbusLink
from labcal.bench.roles import Identity
from labcal.bench.settings import Address
from labcal.errors import InstrumentError

VERSION, CONTROL_MODE = 0x8000, 0x1000  # control mode: of relay 0; 0 obeys this line alone
GAP_S = 0.2  # between commands


Contact = Annotated[int, Field(ge=0, le=31)]


@dataclass(frozen=True, slots=True)
class Settings:
    """Which relay (0…31) reverses which axis; an axis without one is not reversed. Relay off is polarity +1.

    `inputs`: a (D) board, whose digital inputs could move its relays: each must be set to obey this line alone.
    """

    x: Contact | None = None
    y: Contact | None = None
    z: Contact | None = None
    address: Address = 1
    inputs: bool = False

    def __post_init__(self) -> None:
        wired = [relay for relay in (self.x, self.y, self.z) if relay is not None]
        if len(set(wired)) < len(wired):
            raise ValueError("each axis has a relay of its own")


class WaveshareRelay:
    """Two-pole relays, one an axis. They are set and read back, never toggled, and a write is never repeated."""

    roles = ("polarity",)
    never = (
        rb"^.[\x06\x0F\x10]",
        rb"^.\x05[^\0]",
        rb"^.\x05\0\xFF",
        rb"^.\x05..[^\0\xFF]",
    )  # settings, all, toggle, flash

    def __init__(self, name: str, link: ModbusLink, clock: Clock, settings: Settings) -> None:
        self.name, self.settings, self._link, self._clock = name, settings, link, clock
        self._free_s = 0.0

    def identify(self) -> Identity:
        """Read the firmware version. Raises InstrumentError for V1, which speaks another protocol."""
        version = self._link.read_holding(self.settings.address, VERSION, 1)[0]
        if not 200 <= version < 1000:
            raise InstrumentError(
                f"{self.name}: firmware version register reads {version}, not 200 or more.", fault="another instrument"
            )
        if self.settings.inputs:
            self._refuse_inputs()
        return Identity("Waveshare", "Modbus RTU Relay", f"address {self.settings.address}", f"V{version / 100:.2f}")

    def reverses(self, axis: str) -> bool:
        """Whether a relay is wired into this axis."""
        return getattr(self.settings, axis) is not None

    def set_polarity(self, axis: str, sign: int) -> None:
        """Switch to +1 or -1 and read the coil back."""
        self._wait()
        self._link.write_coil(self.settings.address, getattr(self.settings, axis), sign < 0)
        if self.polarity(axis) != sign:
            raise InstrumentError(
                f"{self.name}: the relay of coil {axis} did not take polarity {sign:+d}.",
                fault="polarity not confirmed",
                remedy="Look at the relay board.",
            )

    def polarity(self, axis: str) -> int:
        """+1 or -1, read back from the board."""
        self._wait()
        return -1 if self._link.read_coils(self.settings.address, getattr(self.settings, axis), 1)[0] else 1

    def make_safe(self) -> None:
        """Leave the contacts where they are: they must not move under current, and off needs no polarity."""

    def close(self) -> None:
        """Let go of the link."""
        self._link.close()

    def _refuse_inputs(self) -> None:
        for axis in filter(self.reverses, "xyz"):
            self._wait()
            relay = getattr(self.settings, axis)
            if mode := self._link.read_holding(self.settings.address, CONTROL_MODE + relay, 1)[0]:
                raise InstrumentError(
                    f"{self.name}: an input of the board can move relay {relay}: its control mode is {mode}.",
                    fault="wrong set-up",
                    remedy="Set its control mode to normal (0) with the maker's program.",
                )

    def _wait(self) -> None:
        self._clock.wait_until(self._free_s)
        self._free_s = self._clock.now() + GAP_S

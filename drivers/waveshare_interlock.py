"""A relay of a Waveshare Modbus board (firmware V2 and later) as interlock: it is closed by pulses, never for good."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

from pydantic import Field

from drivers.waveshare_relay import GAP_S, VERSION, Contact
from labcal.bench.clock import Clock
from labcal.bench.driver_kit.roles import Identity
from labcal.bench.driver_kit.settings import Address
from labcal.bench.links.modbus import ModbusLink
from labcal.errors import InstrumentError

FLASH_ON, TICK_S = 0x0200, 0.1  # closes relay n for so many ticks
ON_THE_WAY_S = 0.1  # a beat, to the board
PROOF_S = 1.0  # pulses with which it is proved before it is closed


@dataclass(frozen=True, slots=True)
class Settings:
    """`relay` (0…31) falls open `watchdog_s` after the last beat."""

    relay: Contact = 0
    watchdog_s: Annotated[float, Field(ge=2.0, le=60.0)] = 3.0
    address: Address = 1


class WaveshareInterlock:
    """One relay, closed for a time that the board itself counts; each beat begins that time again.

    No source says that a second pulse prolongs the first: the board is asked, with the coils at zero, each time before
    it is closed.
    """

    roles = ("interlock",)
    never = (
        rb"^.[\x06\x0F\x10]",
        rb"^.\x05[^\0\x02]",
        rb"^.\x05\0\xFF",
        rb"^.\x05\0.(?!\0\0)",
        rb"^.\x05\x02.([\x03-\xFF]|\0\0)",
    )  # settings, flash-off and toggles, all, on for good, pulses of more than 76.7 s and of none

    def __init__(self, name: str, link: ModbusLink, clock: Clock, settings: Settings) -> None:
        self.name, self.settings, self._link, self._clock = name, settings, link, clock
        self.watchdog_s, self._free_s = settings.watchdog_s, 0.0
        self._ends_s: float | None = None  # when it falls open, at the earliest; None where it is not armed

    def identify(self) -> Identity:
        """Read the firmware version. Raises InstrumentError for V1, which speaks another protocol."""
        version = self._in_turn().read_holding(self.settings.address, VERSION, 1)[0]
        if not 200 <= version < 1000:
            raise InstrumentError(
                f"{self.name}: firmware version register reads {version}, not 200 or more.", fault="another instrument"
            )
        return Identity("Waveshare", "Modbus RTU Relay", f"address {self.settings.address}", f"V{version / 100:.2f}")

    def arm(self) -> None:
        """Prove it, then close it. Raises InstrumentError where a pulse is not prolonged by the next, or has no end."""
        self.disarm()
        self._prove()
        ends_s = self._pulse(self.watchdog_s) + self.watchdog_s
        if not self.contact_closed():
            raise self._open("does not close")
        self._ends_s = ends_s

    def feed(self) -> None:
        """Prolong it. Raises InstrumentError where it has fallen open: `arm` alone closes it again, at zero."""
        self._refuse_late()
        if not self.contact_closed():
            self._ends_s = None
            raise self._open("has opened by itself")
        self._clock.wait_until(self._free_s)
        self._refuse_late()
        self._ends_s = self._pulse(self.watchdog_s) + self.watchdog_s

    def disarm(self) -> None:
        """Open it now, confirmed."""
        self._ends_s = None
        self._in_turn().write_coil(self.settings.address, self.settings.relay, False)
        if self.contact_closed():
            raise self._open("does not open")

    def make_safe(self) -> None:
        """Open it, where it was armed."""
        if self._ends_s is not None:
            self.disarm()

    def close(self) -> None:
        """Let go of the link."""
        self._link.close()

    def _prove(self) -> None:
        """See that a second pulse prolongs the first, and that the contact then falls open by itself."""
        begun = self._pulse(PROOF_S)
        self._clock.wait_until(begun + 0.5 * PROOF_S)
        again = self._pulse(PROOF_S)
        self._clock.wait_until(begun + 1.2 * PROOF_S)
        prolonged = self.contact_closed()
        self._clock.wait_until(again + 1.3 * PROOF_S)
        if self.contact_closed():
            raise self._open("does not fall open by itself")
        if not prolonged:
            raise self._open("falls open although it is heard in time")

    def _pulse(self, seconds: float) -> float:
        """Close it for so long; returns when that was asked."""
        link = self._in_turn()
        asked = self._clock.now()
        link.pulse(self.settings.address, FLASH_ON + self.settings.relay, round(seconds / TICK_S))
        return asked

    def _refuse_late(self) -> None:
        if self._ends_s is None or self._clock.now() > self._ends_s - ON_THE_WAY_S:
            self._ends_s = None
            raise self._open("was not heard in time and falls open")

    def contact_closed(self) -> bool:
        """Whether it is closed, asked now."""
        return self._in_turn().read_coils(self.settings.address, self.settings.relay, 1)[0]

    def _open(self, what: str) -> InstrumentError:
        return InstrumentError(
            f"{self.name}: the interlock {what}.",
            fault="interlock",
            remedy="Look at the relay board, its supply and its cable.",
        )

    def _in_turn(self) -> ModbusLink:
        self._clock.wait_until(self._free_s)
        self._free_s = self._clock.now() + GAP_S
        return self._link

"""Elektro-Automatik PS/PSI 9000 and PSB 9000/10000, Modbus RTU over USB or raw TCP 5025, unipolar."""

from __future__ import annotations

import re
import struct
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass
from typing import Annotated

from pydantic import Field

from labcal.bench.clock import Clock
from labcal.bench.driver_kit.registers import Registers, register
from labcal.bench.driver_kit.roles import Identity
from labcal.bench.driver_kit.settings import NotNegative, Positive
from labcal.bench.links import quoted
from labcal.bench.links.modbus import ModbusLink
from labcal.errors import InstrumentError

FULL, TOP = 52428, 53477  # 100 % and the 102 % that a set-point may have
TRIP_TOP = 57671  # 110 %
TYPE, MAKER, NOMINAL, SERIAL = 1, 21, 121, 151
REMOTE, OUTPUT, STATE = 402, 405, 505
ON, REMOTE_ON, ALARM, LOCATION = 1 << 7, 1 << 11, 1 << 15, 0x1F  # of its state's lower word


@dataclass(frozen=True, slots=True)
class Settings:
    """`address` is 0 for the classic series (it answers), 1 for PSB 10000. `location` is how it calls this line:
    3 USB, 6 Ethernet. `trips`: whether its trips lie in 550 and 553, to be set and read back before it energises.
    `watchdog_s`: what its interface monitoring is set to in its menu, 0 where it is off: it is fed, and never set.
    """

    address: Annotated[int, Field(ge=0, le=247)] = 0
    location: Annotated[int, Field(ge=1, le=31)] = 3
    max_current_A: Positive = 3.0
    compliance_V: Positive = 20.0
    zero_current_A: float = 0.06
    ramp_A_per_s: float = 4.0
    trips: bool = True
    gap_s: NotNegative = 0.05
    watchdog_s: NotNegative = 0.0


class EaSupply:
    """A unipolar supply in constant current under remote control; every value is a fraction of its nominal one."""

    roles = ("coil",)
    never = (  # all but reading, remote and output, set-points, trips and the power limit
        rb"^.[^\x01\x03\x05\x06]",
        rb"^.\x05(?!\x01[\x92\x95](\xFF\0|\0\0))",
        rb"^.\x06(?!\x01[\xF4-\xF6]|\x02[\x26\x29])",
    )
    bipolar, can_open = False, True

    compliance = register(
        500, unit="V", doc="Control the voltage that may drive the coil.",
        counts=lambda d: d.counts[0], limits=lambda s: (0.0, s.compliance_V), top=TOP,
    )  # fmt: skip
    current = register(
        501, unit="A", doc="Control the current set-point.",
        counts=lambda d: d.counts[1], limits=lambda s: (0.0, s.max_current_A), top=TOP,
    )  # fmt: skip
    power = register(
        502, unit="1", doc="Control the power limit.",
        counts=lambda d: FULL, limits=lambda s: (0.0, 1.0), top=TOP,
    )  # fmt: skip
    ovp = register(
        550, unit="V", doc="Control the over-voltage trip.",
        counts=lambda d: d.counts[0], limits=lambda s: (0.0, 1.1 * s.compliance_V), top=TRIP_TOP,
    )  # fmt: skip
    ocp = register(
        553, unit="A", doc="Control the over-current trip.",
        counts=lambda d: d.counts[1], limits=lambda s: (0.0, 1.1 * s.max_current_A), top=TRIP_TOP,
    )  # fmt: skip

    def __init__(self, name: str, link: ModbusLink, clock: Clock, settings: Settings) -> None:
        self.name, self.settings, self.registers = name, settings, RemoteRegisters(link, clock, settings)
        self.zero_current_A, self.ramp_A_per_s = settings.zero_current_A, settings.ramp_A_per_s
        self.watchdog_s = settings.watchdog_s
        self._counts: tuple[float, float] | None = None
        self._asked_A = 0.0

    @property
    def counts(self) -> tuple[float, float]:
        """Counts per volt and per ampere: its registers hold fractions of its nominal values."""
        if self._counts is None:
            self.identify()
        assert self._counts is not None
        return self._counts

    def identify(self) -> Identity:
        """Read type, serial number and nominal values. Raises InstrumentError where they contradict each other."""
        model, maker, serial = (_text(self.registers.read(at, 20)) for at in (TYPE, MAKER, SERIAL))
        volts, amps = struct.unpack(">2f", struct.pack(">4H", *self.registers.read(NOMINAL, 4)))
        rated = re.search(r"(\d+)-(\d+)", model)
        agree = rated is not None and abs(float(rated[2]) - amps) <= 0.05 * amps
        if not model.startswith("PS") or not agree or not 0 < volts < 1e5:
            raise InstrumentError(
                f"{self.name}: it calls itself {quoted(model)} with {volts:g} V and {amps:g} A nominal.",
                fault="another instrument",
                remedy="Is it an EA PS/PSI/PSB, and is the address in bench.toml the right one?",
            )
        self._counts = FULL / volts, FULL / amps
        return Identity(maker or "Elektro-Automatik", model, serial)

    def set_current(self, current_A: float) -> None:
        """Set the current and read the set-point back."""
        self.current = self._asked_A = current_A

    def set_point(self) -> float:
        """The set-point that it holds [A]."""
        return self.current

    def measure_current(self) -> float:
        """The delivered current [A]. Raises InstrumentError (tripped) where an alarm has ended what was asked for."""
        _, state, _, amps = self.registers.read(STATE, 4)
        if self._asked_A:  # at zero the way to rest must not be barred
            self._refuse_alarm(state)
        return amps / self.counts[1]

    def output(self, on: bool) -> None:
        """Switch the output, confirmed; before it goes on, alarms are looked for, voltage and trips are set."""
        if on:
            self._refuse_alarm(self.registers.read(STATE, 2)[1])
            self.compliance, self.power = self.settings.compliance_V, 1.0
            if self.settings.trips:
                self.ovp, self.ocp = 1.1 * self.settings.compliance_V, 1.1 * self.settings.max_current_A
        self.registers.switch(OUTPUT, on)
        if bool(self.registers.read(STATE, 2)[1] & ON) != on:
            words = f"{self.name}: its output did not go {'on' if on else 'off'}."
            raise InstrumentError(words, fault="read-back", remedy="Look at its panel.")

    def write_current(self, current_A: float) -> None:
        """Send the set-point and wait for nothing; before it, that this line has control."""
        self._asked_A = current_A
        self.registers.switch_unacknowledged(REMOTE, True)
        type(self).current.write(self, current_A)

    def write_off(self) -> None:
        """Send "output off" and wait for nothing."""
        self.registers.switch_unacknowledged(REMOTE, True)
        self.registers.switch_unacknowledged(OUTPUT, False)

    def feed(self) -> None:
        """Be heard, where it is under remote control. Raises InstrumentError where it has left that by itself."""
        if self.watchdog_s and not self.registers.still_held():
            raise InstrumentError(
                f"{self.name}: it has left remote control, as it does after a silence of {self.watchdog_s:g} s.",
                fault="tripped",
                remedy="What its output does then is set in its menu. See its panel, then try again.",
            )

    def make_safe(self) -> None:
        """Current to zero, then output off, a failure of one not skipping the other; after both, back to its panel."""
        with ExitStack() as steps:
            steps.callback(self.output, False)
            steps.callback(self.set_current, 0.0)
        self.registers.release()

    def close(self) -> None:
        """Let go of the link."""
        self.registers.close()

    def _refuse_alarm(self, state: int) -> None:
        if state & ALARM:
            words = f"{self.name}: it tripped: an alarm is active."
            raise InstrumentError(words, fault="tripped", remedy="Acknowledge the alarm on its panel.")


class RemoteRegisters(Registers):
    """Registers that take writes under remote control only; it must be this line's, and is lost by a refusal."""

    def __init__(self, link: ModbusLink, clock: Clock, settings: Settings) -> None:
        super().__init__(link, clock, settings.address, settings.gap_s)
        self._url, self._location, self._held = link.url, settings.location, False

    def write(self, address: int, value: int) -> None:
        """One register."""
        with self._control():
            super().write(address, value)

    def switch(self, address: int, on: bool) -> None:
        """One coil."""
        with self._control():
            super().switch(address, on)

    def still_held(self) -> bool:
        """Whether it is under control, as it was when this asked or wrote last; True where it was not taken."""
        if not self._held:
            return True
        self._held = bool(self.read(STATE, 2)[1] & REMOTE_ON)
        return self._held

    def release(self) -> None:
        """Give control back to the panel."""
        self._held = False
        super().switch(REMOTE, False)

    @contextmanager
    def _control(self) -> Iterator[None]:
        if not self._held:
            super().switch(REMOTE, True)
            state = self.read(STATE, 2)[1]
            if not state & REMOTE_ON or state & LOCATION != self._location:
                raise InstrumentError(
                    f"{self._url}: it is controlled from {state & LOCATION} (3 USB, 4 analogue, 6 Ethernet), "
                    "not from here.",
                    fault="wrong mode",
                    remedy="Free it on its panel, or correct `location` in bench.toml.",
                )
        self._held = False
        yield
        self._held = True


def _text(registers: list[int]) -> str:
    """Characters up to the first NUL."""
    return b"".join(word.to_bytes(2) for word in registers).split(b"\0")[0].decode("ascii", "replace").strip()

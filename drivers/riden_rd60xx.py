"""Riden RD6006 … RD6030 supplies, Modbus RTU (115200 8N1; 19200 or less through the USB dongle), unipolar."""

from __future__ import annotations

from dataclasses import dataclass

from drivers.framing.supply import CLEAR_IT, CurrentSource
from labcal.bench.clock import Clock
from labcal.bench.links.modbus import ModbusLink
from labcal.bench.registers import Registers, register
from labcal.bench.roles import Identity
from labcal.bench.settings import Address, NotNegative, Positive
from labcal.errors import InstrumentError

IDENTITY, CURRENT_RANGE, POWER_ON_OUTPUT = 0, 20, 68
MODELS = (  # first and last identity, name, counts per V, counts per A
    (60060, 60064, "RD6006", 100, 1000),
    (60065, 60065, "RD6006P", 1000, 10000),
    (60120, 60124, "RD6012", 100, 100),
    (60125, 60129, "RD6012P", 1000, 10000),
    (60180, 60189, "RD6018", 100, 100),
    (60241, 60300, "RD6024", 100, 100),
    (60301, 60301, "RD6030", 100, 100),
)
STATE, SET, MEASURED, TRIPPED = 8, 1, 3, 8  # eleven registers from 8, and which of them are what
TRIPS = {1: "over-voltage", 2: "over-current"}


@dataclass(frozen=True, slots=True)
class Settings:
    """`ovp_V`, `ocp_A`: where the supply's own protection trips; they are written before every switching on."""

    address: Address = 1
    max_current_A: Positive = 3.0
    compliance_V: Positive = 20.0
    ovp_V: Positive = 22.0
    ocp_A: Positive = 3.3
    zero_current_A: float = 0.02
    ramp_A_per_s: float = 4.0
    gap_s: NotNegative = 0.11  # stock firmware bears fewer than ten requests a second


class RidenSupply(CurrentSource):
    """A unipolar supply in constant current. How it counts follows from the model that answers."""

    roles = ("coil",)
    never = (  # all but reading, and writing V, I, output, OVP, OCP: no calibration, no presets, no boot loader
        rb"^.[^\x03\x06]",
        rb"^.\x06(?!\0[\x08\x09\x12\x52\x53])",
    )
    bipolar, can_open = False, True

    compliance = register(
        8, unit="V", doc="Control the voltage that may drive the coil.",
        counts=lambda d: d.scale[0], limits=lambda s: (0.0, s.ovp_V),
    )  # fmt: skip
    current = register(
        9, unit="A", doc="Control the current set-point.",
        counts=lambda d: d.scale[1], limits=lambda s: (0.0, s.max_current_A),
    )  # fmt: skip
    enabled = register(18, unit="1", doc="Control whether the output is on.", limits=lambda s: (0, 1))
    ovp = register(
        82, unit="V", doc="Control the over-voltage trip.", counts=lambda d: d.scale[0], limits=lambda s: (0.0, 62.0)
    )
    ocp = register(
        83, unit="A", doc="Control the over-current trip.", counts=lambda d: d.scale[1], limits=lambda s: (0.0, 31.0)
    )

    def __init__(self, name: str, link: ModbusLink, clock: Clock, settings: Settings) -> None:
        self.name, self.settings = name, settings
        self.registers = Registers(link, clock, settings.address, settings.gap_s)
        self.zero_current_A, self.ramp_A_per_s = settings.zero_current_A, settings.ramp_A_per_s
        self._scale: tuple[int, int] | None = None

    @property
    def scale(self) -> tuple[int, int]:
        """Counts per volt and per ampere, from the identity of the model."""
        if self._scale is None:
            self.identify()
        assert self._scale is not None
        return self._scale

    def identify(self) -> Identity:
        """Read model, serial number and firmware. Raises InstrumentError for a model that is not known."""
        number, high, low, firmware = self.registers.read(IDENTITY, 4)
        known = next((m for m in MODELS if m[0] <= number <= m[1]), None)
        if known is None:
            raise InstrumentError(
                f"{self.name}: identity register reads {number}, no Riden that is known.", fault="another instrument"
            )
        _, _, model, per_V, per_A = known
        if model == "RD6012P" and self.registers.read(CURRENT_RANGE, 1)[0]:
            per_A = 1000
        self._scale = per_V, per_A
        return Identity("Riden", model, f"{high << 16 | low:08d}", f"{firmware / 100:.2f}")

    def measure_current(self) -> float:
        """The delivered current [A]. Raises InstrumentError (tripped) where a protection has ended it."""
        state = self.registers.read(STATE, 11)
        if state[TRIPPED] and state[SET]:  # at set-point zero the way to rest must not be barred
            why = TRIPS.get(state[TRIPPED], f"protection {state[TRIPPED]}")
            raise InstrumentError(f"{self.name}: its {why} protection tripped.", fault="tripped", remedy=CLEAR_IT)
        return state[MEASURED] / self.scale[1]

    def output(self, on: bool) -> None:
        """Switch the output, confirmed; before it goes on, voltage and trips are set and its set-up is looked at."""
        if on:
            if self.registers.read(POWER_ON_OUTPUT, 1)[0]:
                raise InstrumentError(
                    f"{self.name}: it would switch its output on by itself when it gets power.",
                    fault="wrong set-up",
                    remedy="Switch the option 'power-on output' off in its menu.",
                )
            self.compliance = self.settings.compliance_V
            self.ovp, self.ocp = self.settings.ovp_V, self.settings.ocp_A
        self.enabled = on

    def close(self) -> None:
        """Let go of the link."""
        self.registers.close()

"""Kepco BOP four-quadrant supplies with a BIT 4886 card (RS-232) or BIT 802E (TCP 5025), SCPI, in current mode."""

from __future__ import annotations

from dataclasses import dataclass

from drivers.framing.scpi import Scpi
from drivers.framing.supply import CurrentSource
from labcal.bench.clock import Clock
from labcal.bench.driver_kit.quantity import quantity
from labcal.bench.driver_kit.roles import Identity
from labcal.bench.driver_kit.settings import NotNegative, Positive
from labcal.bench.links import Link
from labcal.errors import InstrumentError

CURRENT_MODE, REMOTE = 1, "SYST:REM ON"


@dataclass(frozen=True, slots=True)
class Settings:
    """`gap_s`: the least pause after each message. Where its RS-232 echo mode is on, the link states `echo=1`.

    `remote`: it is told SYST:REM ON before it is told to act; without that its serial line does nothing.
    """

    max_current_A: Positive = 3.0
    compliance_V: Positive = 20.0
    zero_current_A: float = 0.01
    ramp_A_per_s: float = 4.0
    gap_s: NotNegative = 0.01
    timeout_s: Positive = 1.5
    remote: bool = True


class KepcoBop(CurrentSource):
    """A signed supply that needs no relay. Its off is a low impedance at zero: it cannot open the circuit."""

    roles = ("coil",)
    never = (rb"DIAG", rb"\*(RST|TST|SAV|RCL)", rb"CAL", rb"SYST\w*:(SEC|PASS|SET)", rb"MEM")
    bipolar, can_open = True, False

    current = quantity(
        "CURR?", "CURR {value:.4f}", unit="A", doc="Control the signed current set-point.",
        limits=lambda s: (-s.max_current_A, s.max_current_A), tolerance=0.00401,  # 16 bits of ±72 A, and its rounding
    )  # fmt: skip
    compliance = quantity(
        "VOLT?", "VOLT {value:.3f}", unit="V", doc="Control the voltage that may drive the coil, either sign.",
        limits=lambda s: (0.0, 200.0), tolerance=0.0201,
    )  # fmt: skip
    mode = quantity(
        "FUNC:MODE?", "FUNC:MODE CURR", unit="1", doc="Control the regulation: 1 is current.",
        limits=lambda s: (CURRENT_MODE, CURRENT_MODE),
    )  # fmt: skip
    enabled = quantity(
        "OUTP?", "OUTP {value:d}", unit="1", doc="Control whether the output is on.", limits=lambda s: (0, 1)
    )
    sensed = quantity("MEAS:CURR?", unit="A", doc="Measure the delivered current.")

    def __init__(self, name: str, link: Link, clock: Clock, settings: Settings) -> None:
        self.name, self.settings, self._link = name, settings, link
        self._scpi = Scpi(name, link, clock, settings.timeout_s, settings.gap_s, may_echo=True)
        self.query, self._remote = self._scpi.query, not settings.remote
        self.refuse_earlier = self._scpi.refuse_earlier
        self.zero_current_A, self.ramp_A_per_s = settings.zero_current_A, settings.ramp_A_per_s

    def identify(self) -> Identity:
        """Ask who it is, and empty the error queue of the time before."""
        self._remote = not self.settings.remote
        who = self._scpi.identify(lambda maker, model: "KEPCO" in maker, "a Kepco")
        self._scpi.empty_errors()
        return who

    def command(self, text: str) -> None:
        """Tell, under remote control. Raises InstrumentError with what the supply says."""
        held, self._remote = self._remote, not self.settings.remote  # a fault may mean that it was switched off and on
        if not held:
            self._scpi.command(REMOTE)
        self._scpi.command(text)
        self._remote = True

    def write(self, text: str) -> None:
        """Tell, under remote control, and wait for nothing."""
        if self.settings.remote:
            self._scpi.send(REMOTE)
        self._scpi.send(text)

    def output(self, on: bool) -> None:
        """Switch the output, confirmed. It goes on only in current mode, at zero, with its compliance set."""
        if on and not self.enabled:
            self.mode, self.compliance, self.current = CURRENT_MODE, self.settings.compliance_V, 0.0
        self.enabled = on
        if on and self.mode != CURRENT_MODE:
            raise InstrumentError(f"{self.name}: it is in voltage mode.", fault="wrong mode", remedy="Set coils off.")

    def close(self) -> None:
        """Let go of the link."""
        self._link.close()

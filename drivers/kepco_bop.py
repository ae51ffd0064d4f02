"""Kepco BOP four-quadrant supplies with a BIT 4886 card (RS-232) or BIT 802E (TCP 5025), SCPI, in current mode."""

from __future__ import annotations

from contextlib import ExitStack
from dataclasses import dataclass

from labcal.bench.clock import Clock
from labcal.bench.instrument import quantity
from labcal.bench.links import Link
from labcal.bench.roles import Identity
from labcal.errors import InstrumentError

CURRENT_MODE = 1
NAK = b"\x15"  # its input queue overran
FLOW = b"\x11\x13"  # XON, XOFF that an adapter let through


@dataclass(frozen=True, slots=True)
class Settings:
    """`echo`: whether its RS-232 echo mode is on; every echoed command is then compared with what was sent."""

    max_current_A: float = 3.0
    compliance_V: float = 20.0
    zero_current_A: float = 0.01
    ramp_A_per_s: float = 4.0
    echo: bool = False
    gap_s: float = 0.01
    timeout_s: float = 1.5


class KepcoBop:
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
        self.name, self.settings, self._link, self._clock = name, settings, link, clock
        self.zero_current_A, self.ramp_A_per_s = settings.zero_current_A, settings.ramp_A_per_s

    def identify(self) -> Identity:
        """Ask who it is, and empty the error queue of the time before."""
        maker, model, serial, firmware = (*self.query("*IDN?").split(","), "", "", "")[:4]
        if "KEPCO" not in maker.upper():
            raise InstrumentError(f"{self.name}: {maker!r} answered, not a Kepco.", fault="another instrument")
        while not self.query("SYST:ERR?").startswith(("0,", "+0,")):
            pass
        return Identity(maker.strip(), model.strip(), serial.strip(), firmware.strip())

    def set_current(self, current_A: float) -> None:
        """Set the signed current and read the set-point back."""
        self.current = current_A

    def set_point(self) -> float:
        """The signed set-point that it holds [A]."""
        return self.current

    def measure_current(self) -> float:
        """The delivered current with its sign [A]."""
        return self.sensed

    def output(self, on: bool) -> None:
        """Switch the output, confirmed. It goes on only in current mode, at zero, with its compliance set."""
        if on and not self.enabled:
            self.mode, self.compliance, self.current = CURRENT_MODE, self.settings.compliance_V, 0.0
        self.enabled = on
        if on and self.mode != CURRENT_MODE:
            raise InstrumentError(f"{self.name}: it is in voltage mode.", fault="wrong mode", remedy="Set coils off.")

    def make_safe(self) -> None:
        """Current to zero, then output off; a failure of one does not skip the other."""
        with ExitStack() as steps:
            steps.callback(self.output, False)
            steps.callback(self.set_current, 0.0)

    def close(self) -> None:
        """Let go of the link."""
        self._link.close()

    def query(self, text: str) -> str:
        """Ask and return the reply."""
        self._send(text)
        reply = self._link.ask(b"", end=b"\n", timeout_s=self.settings.timeout_s).strip(FLOW + b"\r\n ")
        if NAK in reply:
            raise InstrumentError(f"{self.name}: it lost {text!r}: its input queue overran.", fault="refused")
        return reply.decode("ascii", "replace")

    def command(self, text: str) -> None:
        """Tell, then ask for errors. Raises InstrumentError with what the supply says."""
        self._send(text)
        error = self.query("SYST:ERR?")
        if not error.startswith(("0,", "+0,")):
            raise InstrumentError(
                f"{self.name}: {text!r} failed: {error}.",
                fault="refused",
                remedy="Coils go to zero; look at the supply's panel.",
            )

    def _send(self, text: str) -> None:
        self._clock.wait_until(self._clock.now() + self.settings.gap_s)
        self._link.flush()
        request = text.encode() + b"\n"
        self._link.send(request)
        if not self.settings.echo:
            return
        echoed = self._link.ask(b"", end=len(request), timeout_s=self.settings.timeout_s)
        if echoed != request:
            raise InstrumentError(f"{self.name}: {request!r} was echoed as {echoed!r}.", fault="wrong reply")

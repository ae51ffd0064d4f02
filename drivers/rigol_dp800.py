"""Rigol DP800 supplies (DP811 … DP832), one channel, SCPI (DP800 programming guide)."""

from __future__ import annotations

from contextlib import ExitStack
from dataclasses import dataclass

from labcal.bench.clock import Clock
from labcal.bench.instrument import quantity
from labcal.bench.links import Link
from labcal.bench.roles import Identity
from labcal.errors import InstrumentError


@dataclass(frozen=True, slots=True)
class Settings:
    """`gap_s`: the least pause after each message. `compliance_V` bounds the voltage that drives the coil."""

    channel: int = 1
    max_current_A: float = 3.0
    compliance_V: float = 20.0
    zero_current_A: float = 0.005
    ramp_A_per_s: float = 4.0
    gap_s: float = 0.02
    timeout_s: float = 1.5


class RigolSupply:
    """A unipolar supply in constant current. Its error queue is read after every set; `*RST` is never sent."""

    roles = ("coil",)
    never = (rb"\*RST", rb"\*SAV", rb"\*RCL", rb"\*TST")
    bipolar, can_open = False, True

    current = quantity(
        ":SOUR{s.channel}:CURR?", ":SOUR{s.channel}:CURR {value:.4f}", unit="A", doc="Control the current set-point.",
        limits=lambda s: (0.0, s.max_current_A), tolerance=0.00101,
    )  # fmt: skip
    compliance = quantity(
        ":SOUR{s.channel}:VOLT?", ":SOUR{s.channel}:VOLT {value:.3f}", unit="V",
        doc="Control the voltage that may drive the coil.", limits=lambda s: (0.0, 63.0), tolerance=0.0101,
    )  # fmt: skip
    sensed = quantity(":MEAS:CURR? CH{s.channel}", unit="A", doc="Measure the delivered current.")
    enabled = quantity(
        ":OUTP? CH{s.channel}", ":OUTP CH{s.channel},{on}", unit="1", doc="Control whether the output is on.",
        limits=lambda s: (0, 1), read=lambda reply: {"ON": 1.0, "OFF": 0.0, "1": 1.0, "0": 0.0}[reply],
    )  # fmt: skip

    def __init__(self, name: str, link: Link, clock: Clock, settings: Settings) -> None:
        self.name, self.settings, self._link, self._clock = name, settings, link, clock
        self.zero_current_A, self.ramp_A_per_s = settings.zero_current_A, settings.ramp_A_per_s

    def identify(self) -> Identity:
        """Ask who it is, and empty the error queue of the time before."""
        maker, model, serial, firmware = (*self.query("*IDN?").split(","), "", "", "")[:4]
        if "RIGOL" not in maker.upper() or not model.startswith("DP"):
            raise InstrumentError(
                f"{self.name}: {maker} {model} answered, not a Rigol DP supply.", fault="another instrument"
            )
        while not self.query(":SYST:ERR?").startswith(("0,", "+0,")):
            pass
        return Identity(maker, model, serial, firmware)

    def set_current(self, current_A: float) -> None:
        """Set the current and read the set-point back."""
        self.current = current_A

    def set_point(self) -> float:
        """The set-point that it holds [A]."""
        return self.current

    def measure_current(self) -> float:
        """The delivered current [A]."""
        return self.sensed

    def output(self, on: bool) -> None:
        """Switch the output, confirmed; before it goes on, the compliance voltage is set."""
        if on:
            self.compliance = self.settings.compliance_V
        self.enabled = on

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
        reply = self._link.ask(text.encode() + b"\n", end=b"\n", timeout_s=self.settings.timeout_s)
        self._clock.wait_until(self._clock.now() + self.settings.gap_s)
        return reply.decode("ascii", "replace").strip()

    def command(self, text: str) -> None:
        """Tell, then ask for errors. Raises InstrumentError with what the supply says."""
        self._link.send(text.encode() + b"\n")
        self._clock.wait_until(self._clock.now() + self.settings.gap_s)
        error = self.query(":SYST:ERR?")
        if not error.startswith(("0,", "+0,")):
            raise InstrumentError(
                f"{self.name}: {text!r} failed: {error}.",
                fault="refused",
                remedy="Coils go to zero; look at the supply's panel.",
            )

"""Keysight E36311A, E36312A, E36313A, one output, SCPI with channel lists (raw TCP 5025), unipolar."""

from __future__ import annotations

import re
from contextlib import ExitStack
from dataclasses import dataclass

from labcal.bench.clock import Clock
from labcal.bench.instrument import quantity
from labcal.bench.links import Link
from labcal.bench.roles import Identity
from labcal.errors import InstrumentError

COUPLINGS = (("OUTP:PAIR?", "pairing"), ("OUTP:TRAC?", "tracking"))
UNCOUPLED = ("OFF", "0")


@dataclass(frozen=True, slots=True)
class Settings:
    """`couplings`: what must answer OFF before the output goes on; an empty list where a model has neither."""

    output: int = 1
    max_current_A: float = 3.0
    compliance_V: float = 6.0
    zero_current_A: float = 0.01
    ramp_A_per_s: float = 4.0
    couplings: tuple[str, ...] = ("pairing", "tracking")
    timeout_s: float = 1.5


class KeysightSupply:
    """A unipolar supply in constant current, no output of which may drag another along."""

    roles = ("coil",)
    never = (rb"\*(RST|SAV|RCL|TST)", rb"CAL", rb"OUTP\w*:(PAIR|TRAC)\w*\s", rb"MEM", rb"SYST\w*:(SEC|COMM)")
    bipolar, can_open = False, True

    current = quantity(
        "CURR? (@{s.output})", "CURR {value:.4f},(@{s.output})", unit="A", doc="Control the current set-point.",
        limits=lambda s: (0.0, s.max_current_A), tolerance=0.00101,
    )  # fmt: skip
    compliance = quantity(
        "VOLT? (@{s.output})", "VOLT {value:.3f},(@{s.output})", unit="V",
        doc="Control the voltage that may drive the coil.", limits=lambda s: (0.0, 25.0), tolerance=0.0101,
    )  # fmt: skip
    enabled = quantity(
        "OUTP? (@{s.output})", "OUTP {value:d},(@{s.output})", unit="1", doc="Control whether the output is on.",
        limits=lambda s: (0, 1),
    )  # fmt: skip
    sensed = quantity("MEAS:CURR? (@{s.output})", unit="A", doc="Measure the delivered current.")

    def __init__(self, name: str, link: Link, clock: Clock, settings: Settings) -> None:
        self.name, self.settings, self._link = name, settings, link
        self.zero_current_A, self.ramp_A_per_s = settings.zero_current_A, settings.ramp_A_per_s

    def identify(self) -> Identity:
        """Ask who it is, and empty the error queue of the time before. An E3631A speaks otherwise and is refused."""
        maker, model, serial, firmware = (*self.query("*IDN?").split(","), "", "", "")[:4]
        if not re.fullmatch(r"E3631[123]A", model.strip()):
            raise InstrumentError(
                f"{self.name}: {maker} {model} answered, not a Keysight E36311A, E36312A or E36313A.",
                fault="another instrument",
            )
        while not self.query("SYST:ERR?").startswith(("0,", "+0,")):
            pass
        return Identity(maker.strip(), model.strip(), serial.strip(), firmware.strip())

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
        """Switch the output, confirmed; before it goes on, it is not coupled and its compliance voltage is set."""
        if on:
            self._refuse_coupling()
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
        self._link.flush()
        reply = self._link.ask(text.encode() + b"\n", end=b"\n", timeout_s=self.settings.timeout_s)
        return reply.decode("ascii", "replace").strip()

    def command(self, text: str) -> None:
        """Tell, then ask for errors. Raises InstrumentError with what the supply says."""
        self._link.send(text.encode() + b"\n")
        error = self.query("SYST:ERR?")
        if not error.startswith(("0,", "+0,")):
            raise InstrumentError(
                f"{self.name}: {text!r} failed: {error}.",
                fault="refused",
                remedy="Coils go to zero; look at the supply's panel.",
            )

    def _refuse_coupling(self) -> None:
        for ask, name in COUPLINGS:
            if name in self.settings.couplings and (said := self.query(ask)) not in UNCOUPLED:
                raise InstrumentError(
                    f"{self.name}: its outputs are coupled: {name} is {said}.",
                    fault="wrong mode",
                    remedy=f"Switch {name} off on its panel; the output stays open.",
                )

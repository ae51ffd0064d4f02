"""Aim-TTi PL-P, QL-P and MX-TP supplies, one output, native command set (MX100T manual p. 30, MX180T p. 35)."""

from __future__ import annotations

from contextlib import ExitStack
from dataclasses import dataclass

from labcal.bench.clock import Clock
from labcal.bench.instrument import after, quantity
from labcal.bench.links import Link
from labcal.bench.roles import Identity
from labcal.errors import InstrumentError

EVENTS = {
    128: "it was switched off and on again",
    32: "it does not know the command",
    16: "it could not execute the command",
    8: "the output did not reach its voltage",
    4: "a query was lost",
}
EXECUTION = {
    100: "number out of range",
    104: "not allowed with the output on",
    200: "another interface holds the lock",
}


@dataclass(frozen=True, slots=True)
class Settings:
    """Outputs are numbered from right to left. `compliance_V` bounds the voltage that drives the coil."""

    output: int = 1
    max_current_A: float = 3.0
    compliance_V: float = 20.0
    zero_current_A: float = 0.005
    ramp_A_per_s: float = 4.0
    timeout_s: float = 1.5
    interface_lock: bool = False  # while the output is on, no other interface may set anything (IFLOCK)


class TtiSupply:
    """A unipolar supply in constant current. A non-zero event register after a command is a failure."""

    roles = ("coil",)
    never = (rb"\*RST", rb"\*?SAV", rb"\*?RCL")
    bipolar, can_open = False, True

    current = quantity(
        "I{s.output}?", "I{s.output} {value:.4f}", unit="A", doc="Control the current set-point.",
        limits=lambda s: (0.0, s.max_current_A), tolerance=0.00101, read=lambda reply: _word(reply),
    )  # fmt: skip
    compliance = quantity(
        "V{s.output}?", "V{s.output} {value:.3f}", unit="V", doc="Control the voltage that may drive the coil.",
        limits=lambda s: (0.0, 60.0), tolerance=0.0101, read=lambda reply: _word(reply),
    )  # fmt: skip
    enabled = quantity(
        "OP{s.output}?", "OP{s.output} {value:d}", unit="1", doc="Control whether the output is on.",
        limits=lambda s: (0, 1),
    )  # fmt: skip
    sensed = quantity("I{s.output}O?", unit="A", doc="Measure the delivered current.", read=after("", "A"))

    def __init__(self, name: str, link: Link, clock: Clock, settings: Settings) -> None:
        self.name, self.settings, self._link = name, settings, link
        self.zero_current_A, self.ramp_A_per_s = settings.zero_current_A, settings.ramp_A_per_s

    def identify(self) -> Identity:
        """Ask who it is and clear what its event register remembers of the time before."""
        maker, model, serial, firmware = (*self.query("*IDN?").split(","), "", "", "")[:4]
        if "THURLBY" not in maker.upper() and "TTI" not in maker.upper():
            raise InstrumentError(
                f"{self.name}: {maker!r} answered, not an Aim-TTi supply.", fault="another instrument"
            )
        self.query("*ESR?")
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
        """Switch the output, confirmed; before it goes on, the compliance voltage is set."""
        if on:
            self._lock()
            self.compliance = self.settings.compliance_V
        self.enabled = on
        if not on and self.settings.interface_lock:
            self.query("IFUNLOCK")

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
        return reply.decode("ascii", "replace").strip()

    def command(self, text: str) -> None:
        """Tell, then look at the event register. Raises InstrumentError with what the supply says."""
        self._link.send(text.encode() + b"\n")
        events = self.query("*ESR?")
        if not events.isdigit() or int(events) & ~1:
            raise InstrumentError(
                f"{self.name}: {text!r} failed: {self._why(events)}.",
                fault="restarted" if events == "128" else "refused",
                remedy="Coils go to zero; look at the supply's panel.",
            )

    def _lock(self) -> None:
        if self.settings.interface_lock and (reply := self.query("IFLOCK")) != "1":
            raise InstrumentError(
                f"{self.name}: it refuses the lock ({reply!r}): another interface holds it.",
                fault="locked",
                remedy="Close the other program, or unlock it on the supply's panel.",
            )

    def _why(self, events: str) -> str:
        if not events.isdigit():
            return f"its event register came back as {events!r}"
        said = [text for bit, text in EVENTS.items() if int(events) & bit]
        if int(events) & 16:
            code = self.query("EER?")
            said.append(EXECUTION.get(int(code) if code.isdigit() else -1, f"execution error {code}"))
        return ", ".join(said)


def _word(reply: str) -> float:
    """The number of `I1 0.5000`: the second word."""
    return float(reply.split()[1])

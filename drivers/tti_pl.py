"""Aim-TTi PL-P, QL-P and MX-TP supplies, one output, native command set (MX100T manual p. 30, MX180T p. 35)."""

from __future__ import annotations

import re
from dataclasses import dataclass

from drivers.framing.scpi import Scpi
from drivers.framing.supply import CurrentSource
from labcal.bench.clock import Clock
from labcal.bench.driver_kit.quantity import after, decimal, quantity
from labcal.bench.driver_kit.roles import Identity
from labcal.bench.driver_kit.settings import Output, Positive
from labcal.bench.links import Link, abridged, quoted
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

TRIPS = {4: "over-voltage", 8: "over-current", 16: "power", 64: "thermal"}  # the last one needs its mains off and on


@dataclass(frozen=True, slots=True)
class Settings:
    """Outputs are numbered from right to left. `compliance_V` bounds the voltage that drives the coil."""

    output: Output = 1
    max_current_A: Positive = 3.0
    compliance_V: Positive = 20.0
    zero_current_A: float = 0.005
    ramp_A_per_s: float = 4.0
    timeout_s: Positive = 1.5
    interface_lock: bool = False  # while the output is on, no other interface may set anything (IFLOCK)


class TtiSupply(CurrentSource):
    """A unipolar supply in constant current. A non-zero event register after a command is a failure."""

    roles = ("coil",)
    never = (rb"\*RST", rb"\*?SAV", rb"\*?RCL")
    bipolar, can_open = False, True

    current = quantity(
        "I{s.output}?", "I{s.output} {value:.4f}", unit="A", doc="Control the current set-point.",
        limits=lambda s: (0.0, s.max_current_A), tolerance=0.00101, read=lambda reply: _word("I", reply),
    )  # fmt: skip
    compliance = quantity(
        "V{s.output}?", "V{s.output} {value:.3f}", unit="V", doc="Control the voltage that may drive the coil.",
        limits=lambda s: (0.0, 60.0), tolerance=0.0101, read=lambda reply: _word("V", reply),
    )  # fmt: skip
    enabled = quantity(
        "OP{s.output}?", "OP{s.output} {value:d}", unit="1", doc="Control whether the output is on.",
        limits=lambda s: (0, 1),
    )  # fmt: skip
    sensed = quantity("I{s.output}O?", unit="A", doc="Measure the delivered current.", read=after("", "A"))

    def __init__(self, name: str, link: Link, clock: Clock, settings: Settings) -> None:
        self.name, self.settings, self._link = name, settings, link
        self._scpi = Scpi(name, link, clock, settings.timeout_s)
        self.query, self.write, self.refuse_earlier = self._scpi.query, self._scpi.send, self._scpi.refuse_earlier
        self.zero_current_A, self.ramp_A_per_s = settings.zero_current_A, settings.ramp_A_per_s

    def identify(self) -> Identity:
        """Ask who it is and clear what its event register remembers of the time before."""
        who = self._scpi.identify(lambda maker, _: "THURLBY" in maker or "TTI" in maker, "an Aim-TTi supply")
        self.query("*ESR?")
        return who

    def output(self, on: bool) -> None:
        """Switch the output, confirmed; before it goes on, the compliance voltage is set."""
        if on:
            self._lock()
        super().output(on)
        if not on and self.settings.interface_lock:
            self.query("IFUNLOCK")

    def trip(self) -> str:
        """Which protection its limit event register remembers; reading clears it."""
        said = self.query(f"LSR{self.settings.output}?")
        if not said.isdigit():
            return ""
        return " and ".join(name for bit, name in TRIPS.items() if int(said) & bit)

    def release(self) -> None:
        """Give it back to its panel. Nothing is asked after it: any other message takes control again."""
        self._scpi.send("LOCAL")

    def close(self) -> None:
        """Let go of the link."""
        self._link.close()

    def command(self, text: str) -> None:
        """Tell, then look at the event register. Raises InstrumentError with what the supply says."""
        self._scpi.send(text)
        events = self.query("*ESR?")
        if not events.isdigit():
            self.refuse_earlier("*ESR?", events)
        if not events.isdigit() or int(events) & ~1:
            raise InstrumentError(
                f"{self.name}: {text!r} failed: {self._why(events)}.",
                fault="restarted" if events == "128" else "refused",
                remedy="Look at the supply's panel.",
            )

    def _lock(self) -> None:
        if self.settings.interface_lock and (reply := self.query("IFLOCK")) != "1":
            raise InstrumentError(
                f"{self.name}: it refuses the lock ({quoted(reply)}): another interface holds it.",
                fault="locked",
                remedy="Close the other program, or unlock it on the supply's panel.",
            )

    def _why(self, events: str) -> str:
        if not events.isdigit():
            return f"its event register came back as {quoted(events)}"
        said = [text for bit, text in EVENTS.items() if int(events) & bit]
        if int(events) & 16:
            code = self.query("EER?")
            said.append(EXECUTION.get(int(code) if code.isdigit() else -1, f"execution error {abridged(code)}"))
        return ", ".join(said) or f"its event register is {events}"


def _word(letter: str, reply: str) -> float:
    """The number of `I1 0.5000`, whose letter says what it is."""
    if not re.match(rf"{letter}[1-4] ", reply):
        raise ValueError(reply)
    return decimal(reply[3:].strip(" "))

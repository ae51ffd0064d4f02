"""What PI's controllers are told and asked in GCS 2: lines of words, values behind an axis, one error that is kept."""

from __future__ import annotations

from dataclasses import dataclass

from labcal.bench.driver_kit.quantity import decimal
from labcal.bench.links import Link, quoted
from labcal.errors import InstrumentError

ERRORS = {
    1: "a parameter it does not understand", 2: "a command it does not know",
    5: "not while its reference is unknown or its servo is off", 7: "beyond its limits", 10: "it was stopped",
    15: "no such axis", 17: "out of range", 23: "no such axis", 54: "a parameter it does not know",
    -1024: "its position was too far off, and its servo went off",
}  # fmt: skip
REMEDY = "Look at the stage, home it and try again."


@dataclass
class Conversation:
    """Questions to one axis and what it is told; each is asked for its error."""

    name: str
    link: Link
    axis: str
    timeout_s: float

    def command(self, words: str, value: str = "") -> None:
        """Tell the axis. Raises InstrumentError where it did not take it."""
        self.link.send(f"{words} {self.axis}{value}\n".encode())
        self.refuse_errors(words)

    def set(self, words: str, value: float, parameter: str = "") -> None:
        """Tell the axis a value, and read it back."""
        self.command(words, f"{parameter} {value:.5f}")
        if abs((held := self.number(f"{words}?", parameter)) - value) > 1e-3:
            message = f"{self.name}: {words}{parameter} was set to {value:g} and reads back {held:g}."
            raise InstrumentError(message, fault="read-back")

    def number(self, words: str, parameter: str = "") -> float:
        """The number that is asked for."""
        reply = self.value(words, parameter)
        try:
            return decimal(reply)
        except ValueError:
            raise self.wrong(words, reply) from None

    def value(self, words: str, parameter: str = "") -> str:
        """What stands behind the axis and `=` in the answer."""
        of = f"{self.axis}{parameter}"
        head, equals, value = (reply := self.ask(f"{words} {of}\n")).partition("=")
        if not equals or head.strip().upper() != of.upper():
            raise self.wrong(words, reply)
        return value.strip()

    def refuse_errors(self, words: str, *, forgive: int = 0) -> None:
        """Raise InstrumentError for the last error, which asking takes off; not for `forgive`."""
        if (code := self.error()) not in (0, forgive):
            message = f"{self.name}: {words} failed: error {code}, {ERRORS.get(code, 'see its manual')}."
            raise InstrumentError(message, fault="stage fault", remedy=REMEDY)

    def error(self) -> int:
        """The last error, which asking takes off."""
        reply = self.ask("ERR?\n")
        try:
            return int(reply)
        except ValueError:
            raise self.wrong("ERR?", reply) from None

    def ask(self, said: str) -> str:
        """A line of answer."""
        self.link.flush()
        reply = self.link.ask(said.encode(), end=b"\n", timeout_s=self.timeout_s)
        return reply.decode("ascii", "replace").strip()

    def wrong(self, words: str, reply: str) -> InstrumentError:
        """The error for a reply that is none to `words`."""
        return InstrumentError(f"{self.name}: {words} was answered {quoted(reply)}.", fault="wrong reply")

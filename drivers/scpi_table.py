"""Any SCPI supply whose words stand in a table: one that comes with labcal (`model`), or the bench file's own."""

from __future__ import annotations

import re
from dataclasses import dataclass

from drivers.framing.scpi import Scpi
from drivers.framing.scpi_table import NEVER, SAID, SAID_BY_SOME, Table, bit_of, names, shipped, stated, voltage
from drivers.framing.supply import CurrentSource
from labcal.bench.clock import Clock
from labcal.bench.driver_kit.quantity import decimal
from labcal.bench.driver_kit.roles import Identity
from labcal.bench.driver_kit.settings import Positive
from labcal.bench.links import Link, quoted
from labcal.errors import InstrumentError

SWITCHED = {"1": 1.0, "0": 0.0, "ON": 1.0, "OFF": 0.0}


@dataclass(frozen=True, slots=True)
class Settings:
    """`model` names a table that comes with labcal, `table` is the bench file's own: one of the two."""

    model: str = ""
    table: Table | None = None
    channel: int = 1
    max_current_A: Positive = 1.0
    compliance_V: Positive = 5.0
    zero_current_A: float = 0.01
    ramp_A_per_s: float = 4.0
    timeout_s: Positive = 1.5

    def __post_init__(self) -> None:
        if bool(self.model) == (self.table is not None):
            raise ValueError("state model, the name of a table of labcal, or table, your own")
        table = self.words
        if self.channel not in table.channels:
            raise ValueError(f"channel must be one of {', '.join(map(str, table.channels))}")
        if self.max_current_A > table.most_A:
            raise ValueError(f"max_current_A must be at most {table.most_A:g} A, which is all that it delivers")
        if self.compliance_V > table.most_V:
            raise ValueError(f"compliance_V must be at most {table.most_V:g} V, which is all that it delivers")

    @property
    def words(self) -> Table:
        """The table. Raises ValueError where none has the name of `model`."""
        return self.table if self.table is not None else shipped(self.model)

    @property
    def say(self) -> dict[str, str]:
        """Its messages to this channel, by their names in the table."""
        table = self.words
        return {name: table.to(self.channel, getattr(table, name)) for name in SAID + SAID_BY_SOME}


class TableSupply(CurrentSource):
    """A supply in constant current. Its errors are asked for after every set; every set is read back."""

    roles = ("coil",)
    never = NEVER

    current = stated(
        "ask_current", "set_current", unit="A", doc="Control the set-point.", least="resolution_A", floor="least_A",
        limits=lambda s: (-s.max_current_A if s.words.bipolar else 0.0, s.max_current_A),
    )  # fmt: skip
    compliance = voltage(
        "ask_voltage", "set_voltage", unit="V", doc="Control the voltage that may drive the coil.",
        least="resolution_V", limits=lambda s: (0.0, s.words.most_V),
    )  # fmt: skip
    enabled = stated(
        "ask_output", "output", unit="1", doc="Control whether the output is on.", limits=lambda s: (0, 1),
        read=lambda reply: SWITCHED[reply] if reply in SWITCHED else decimal(reply),
    )  # fmt: skip
    sensed = stated("measure_current", unit="A", doc="Measure the delivered current.")

    def __init__(self, name: str, link: Link, clock: Clock, settings: Settings) -> None:
        self.name, self.settings, self._link, table = name, settings, link, settings.words
        self._scpi = Scpi(
            name, link, clock, settings.timeout_s, table.gap_s, table.errors,
            end=table.terminator.encode(), no_error=table.no_error,
        )  # fmt: skip
        self.refuse_earlier, self._remote = self._scpi.refuse_earlier, False
        self.bipolar, self.can_open = table.bipolar, table.can_open
        self.zero_current_A, self.ramp_A_per_s = settings.zero_current_A, settings.ramp_A_per_s
        bits = dict(zip(table.channels, table.output_bit, strict=False))
        self._bits = {settings.say["ask_output"]: bits[settings.channel]} if bits else {}

    def identify(self) -> Identity:
        """Ask who it is, and empty the error queue of the time before."""
        self._remote, table = False, self.settings.words
        who = self._scpi.identify(
            table.fits, f"a supply whose maker fits {table.maker!r}, whose model {table.models!r}"
        )
        if table.errors:
            self._scpi.empty_errors()
        for question, pattern in table.expects.items():
            self._expect(table.to(self.settings.channel, question), pattern)
        return who

    def _expect(self, question: str, pattern: str) -> None:
        if not re.fullmatch(pattern, reply := self._scpi.query(question), re.IGNORECASE):
            message = f"{self.name}: {question} is answered {quoted(reply)}, and must be {pattern!r}."
            raise InstrumentError(message, fault="wrong mode", remedy="Set it at its panel, then try again.")

    def query(self, text: str) -> str:
        """Ask; of an answer that is read by its bits, the bit."""
        reply = self._scpi.query(text)
        return reply if text not in self._bits else bit_of(reply, self._bits[text])

    @staticmethod
    def recognise(identity: str) -> dict[str, str] | None:
        """The settings for an instrument that answers so to *IDN?; None where no table of labcal fits."""
        maker, model = (part.strip() for part in [*identity.split(","), ""][:2])
        return next(({"model": name} for name in names() if shipped(name).fits(maker, model)), None)

    def command(self, text: str) -> None:
        """Tell, under remote control where it needs to be told. Raises InstrumentError with what the supply says."""
        command = self._scpi.command if self.settings.words.errors else self._scpi.send
        held, self._remote = self._remote, False  # a fault may mean that it was switched off and on
        if self.settings.words.remote and not held:
            command(self.settings.words.remote)
        command(text)
        self._remote = True

    def write(self, text: str) -> None:
        """Tell, under remote control, and wait for nothing."""
        if self.settings.words.remote:
            self._scpi.send(self.settings.words.remote)
        self._scpi.send(text)

    def trip(self) -> str:
        """Which protection it says has tripped."""
        table, said = self.settings.words, dict[str, str]()
        for name, question in table.trips.items():
            reply = self._scpi.query(table.to(self.settings.channel, question))
            said[name] = bit_of(reply, table.trip_bit[name]) if name in table.trip_bit else reply
        return " and ".join(name for name, reply in said.items() if SWITCHED.get(reply))

    def release(self) -> None:
        """Give it back to its panel, where the table has a word for it. Nothing is asked after it."""
        if self.settings.words.local:
            self._scpi.send(self.settings.words.local)
        self._remote = False

    def close(self) -> None:
        """Let go of the link."""
        self._link.close()

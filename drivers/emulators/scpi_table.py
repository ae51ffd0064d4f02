"""A supply that speaks as its table says: what a driver tells by it, this understands, in long and short forms."""

from __future__ import annotations

import re
import string
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any

from drivers.emulators.line import Answers, Lab
from drivers.emulators.scpi import RANGE, Messages, short
from drivers.framing.scpi_table import Table

MARKS = {"value": "\ue000", "channel": "\ue001", "on": "\ue002"}  # letters of no alphabet, while words are shortened
SELECT = re.compile(r"(INST(?::N?SEL)?)(?:\?| (?:CH|OUTP?)?(\d))")  # by number or by name, whatever the table says
NETWORK_ALONE = (
    "delta-sm",
    "siglent-spd1000x",
    "siglent-spd3303x",
    "siglent-spd3303x-e",
)  # without a serial line, by their manuals
SWITCHED = {"1": "ON", "0": "OFF", "ON": "1", "OFF": "0"}  # SCPI 1999, 7.3: a state may be said in both ways
NUMBER = r"(?P<value>[+-]?(?:\d+\.?\d*|\.\d+)(?:E[+-]?\d+)?)"
Act = Callable[[float, "Channel", str], str]


@dataclass
class Channel:
    """One channel and the coil behind it; `tripped`: by which of the table's trips."""

    coil: Any
    volts: float = 0.0
    lower: float = 0.0
    amps: float = 0.0
    on: bool = False
    tripped: set[str] = field(default_factory=set)


def of_unit(example: str, coil: str) -> str:
    """The table's example as the unit at this coil says it: each has a serial number of its own, where it has any."""
    words = example.split(",")
    if coil != "x" and len(words) > 2 and words[2].strip(" 0"):
        words[2] = words[2][:-1] + coil.upper()
    return ",".join(words)


class TableEmulator(Answers):
    """A message that names no channel is for the one that was selected last."""

    baud = 9600

    def __init__(self, lab: Lab, roles: Mapping[str, Mapping[str, Any]], settings: Any) -> None:
        table: Table = settings.words
        self.wire = "tcp" if settings.model in NETWORK_ALONE else "serial"
        alone = settings.channel if len(roles) == 1 else 1
        self.channels = {int(s.get("channel", alone)): Channel(lab.coils[role[-1]]) for role, s in roles.items()}
        self._selected, self._table = min(self.channels), table
        who = of_unit(table.example, min(role[-1] for role in roles))
        self._scpi = Messages(who, self._do, self._reset, table.no_error, table.terminator)
        self._known = list(self._understood(table))
        super().__init__(self._scpi.line, end=table.terminator.encode()[-1:], delay_s=0.01)

    def trip(self, t_s: float, number: int, name: str) -> None:
        """A protection has switched a channel off."""
        self.channels[number].tripped.add(name)
        self._switch(t_s, self.channels[number], self._table.off)

    def _understood(self, table: Table) -> list[tuple[re.Pattern[str], Act]]:
        found: dict[str, Act] = {
            table.set_current: lambda t, c, value: self._set(t, c, "amps", float(value), table.most_A),
            table.set_voltage: lambda t, c, value: self._set(t, c, "volts", float(value), table.most_V),
            table.output: self._switch,
            table.ask_current: lambda t, c, _: f"{c.amps:.4f}",
            table.ask_voltage: lambda t, c, _: f"{c.volts:.4f}",
            table.measure_current: lambda t, c, _: f"{round(c.coil.current.now(t), 4):.4f}",
        }
        voltage = table.measure_current.replace("CURR", "VOLT").replace("CUR?", "VOL?")
        found[voltage] = lambda t, c, _: f"{c.coil.current.now(t) * c.coil.resistance_ohm:.4f}"
        found[table.ask_output] = lambda t, c, _: self._outputs() if table.output_bit else f"{c.on:d}"
        if table.set_lower:
            found[table.set_lower] = lambda t, c, value: self._set(t, c, "lower", float(value), table.most_V)
            found[table.ask_lower] = lambda t, c, _: f"{c.lower:.4f}"
        found |= {question: self._tripped(question) for question in table.trips.values()}
        found |= {question: self._mode(pattern) for question, pattern in table.expects.items()}
        found |= {words: lambda t, c, _: "" for words in (table.remote, table.local) if words}
        found |= {table.select: self._select} if table.select else {}
        return [(_pattern(words, table), act) for words, act in found.items()]

    def _do(self, t_s: float, message: str) -> str | None:
        for pattern, act in self._known:
            if found := pattern.fullmatch(message):
                named = found.groupdict()
                number = int(named.get("channel") or self._selected)
                if act == self._select:
                    return self._select(t_s, self.channels[number], f"{number}")
                return act(t_s, self.channels[number], named.get("value") or named.get("on") or "")
        chosen = SELECT.fullmatch(message)
        return self._chosen(chosen[1], chosen[2]) if chosen else None

    def _chosen(self, word: str, number: str | None) -> str:
        """The selected channel by number or by name, or another is selected; KeyError: it has none such."""
        if number is None:
            return f"{'' if 'NSEL' in word else 'CH'}{self._selected}"
        if int(number) not in self.channels:
            raise KeyError(number)
        self._selected = int(number)
        return ""

    def _select(self, t_s: float, channel: Channel, number: str) -> str:
        self._selected = int(number)
        return ""

    def _set(self, t_s: float, channel: Channel, what: str, value: float, most: float) -> str:
        least = -most if what == "lower" or (self._table.bipolar and what == "amps") else 0.0
        if not least <= value <= (0.0 if what == "lower" else 1.001 * most):
            return self._scpi.fault(RANGE)
        setattr(channel, what, value)
        return self._drive(t_s, channel)

    def _switch(self, t_s: float, channel: Channel, word: str) -> str:
        on = short(self._table.on)
        channel.on = word in (on, SWITCHED.get(on)) and not channel.tripped
        return self._drive(t_s, channel)

    def _drive(self, t_s: float, channel: Channel) -> str:
        channel.coil.drive(t_s, channel.amps, channel.volts, channel.on)
        return ""

    def _mode(self, pattern: str) -> Act:
        """It is set as it must be: what the pattern's letters are without its signs."""
        word = re.sub(r"\\w\*|[()]|\|.*", "", pattern)
        return lambda t, c, _: word

    def _tripped(self, question: str) -> Act:
        names = [name for name, asked in self._table.trips.items() if asked == question]
        bits = self._table.trip_bit
        return lambda t, c, _: f"{sum((name in c.tripped) << bits.get(name, 0) for name in names)}"

    def _outputs(self) -> str:
        bits = dict(zip(self._table.channels, self._table.output_bit, strict=True))
        return f"0x{sum(channel.on << bits[number] for number, channel in self.channels.items()):04x}"

    def _reset(self, t_s: float) -> None:
        for channel in self.channels.values():
            channel.volts = channel.amps = 0.0
            self._switch(t_s, channel, self._table.off)


def _pattern(words: str, table: Table) -> re.Pattern[str]:
    """What fits `words` in their short form, whatever number, channel and state stand in them."""
    parts = [text + MARKS.get(name or "", "") for text, name, _, _ in string.Formatter().parse(words)]
    pattern = re.escape(short("".join(parts).removeprefix(":")))
    stated = [short(word) for word in (table.on, table.off)]
    states = "|".join(map(re.escape, stated + [SWITCHED[word] for word in stated if word in SWITCHED]))
    for name, form in (("value", NUMBER), ("channel", r"(?P<channel>\d+)"), ("on", f"(?P<on>{states})")):
        pattern = pattern.replace(re.escape(MARKS[name]), form)
    return re.compile(pattern)

"""A supply's own words as a table: how it is asked and told, in bench.toml or in a file of `drivers/tables`."""

from __future__ import annotations

import re
import string
import tomllib
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path
from typing import Annotated, Any, Literal

from pydantic import AfterValidator, ConfigDict, Field, TypeAdapter

from labcal.bench.driver_kit.quantity import quantity
from labcal.bench.driver_kit.settings import NotNegative, Positive

TABLES = Path(__file__).parents[1] / "tables"
NEVER = (
    rb"\*(RST|SAV|RCL|TST|PSC|DDT)",
    rb"(?<![A-Z])(CAL|MEM|DIAG|INIT|TRIG|ARB|LIST|PROG|SEQ)",
    rb"SYST\w*:(SEC|COMM|PRES|PASS)",
    rb"OUTP\w*:(PAIR|SER|PAR|TRAC|PON|REL)\w*",
    rb"INST\w*:CO",  # coupled and combined outputs
)
SAID = (
    "set_current", "ask_current", "set_voltage", "ask_voltage", "measure_current", "output", "ask_output",
)  # fmt: skip
SAID_BY_SOME = ("set_lower", "ask_lower")


def _words(text: str, needs: tuple[str, ...], may: tuple[str, ...] = ("channel",)) -> str:
    """`text` as it stands. Raises ValueError where it could not be said, or names what is not known here."""
    if not text.isascii() or not text.isprintable():
        raise ValueError("must be one line of plain ASCII")
    try:
        named = [name for _, name, _, _ in string.Formatter().parse(text) if name is not None]
        text.format(value=0.5, channel=1, on="ON")
    except (ValueError, KeyError, IndexError, AttributeError) as error:
        raise ValueError("has braces that are none of {value:.3f}, {channel} and {on}") from error
    if unknown := [name for name in named if name not in (*needs, *may)]:
        raise ValueError(f"must not have {{{unknown[0]}}}")
    for name in needs:
        if named.count(name) != 1:
            raise ValueError(f"must have {{{name}}} once" + (", such as {value:.3f}" if name == "value" else ""))
    if any(re.search(pattern, text.encode(), re.IGNORECASE) for pattern in NEVER):
        raise ValueError("is among what labcal never sends to a supply")
    return text


def _question(text: str) -> str:
    if "?" not in text:
        raise ValueError("must be a question: it has no question mark")
    return _words(text, ())


def _number(text: str) -> str:
    _words(text, ("value",))
    if re.search(r"\{value:\.[1-9]\d?f\}", text) is None:
        raise ValueError("must have {value} with its digits, such as {value:.3f}")
    return text


def _pattern(text: str) -> str:
    try:
        re.compile(text)
    except re.error as error:
        raise ValueError(f"is no regular expression: {error}") from error
    return text


Question = Annotated[str, AfterValidator(_question)]
SetNumber = Annotated[str, AfterValidator(_number)]
Switch = Annotated[str, AfterValidator(lambda text: _words(text, ("on",)))]
Word = Annotated[str, AfterValidator(lambda text: _words(text, ()))]
Pattern = Annotated[str, AfterValidator(_pattern)]
Bit = Annotated[int, Field(ge=0, le=31)]


@dataclass(frozen=True, kw_only=True)
class Table:
    """How one family of supplies is spoken to; {channel}, {value:.3f} and {on} stand for what the driver fills in.

    `maker`, `models`: regular expressions that its *IDN? must fit, as `example` does. `select` goes before each message
    on the same line, where the words themselves name no channel. `remote` is said before it is told to act, `local` to
    give it back. `set_lower`, `ask_lower`: the limit of negative voltage, of a supply that has one. `errors` asks for
    the oldest error, "" where it tells none; `no_error` is how an empty queue reads.
    `trips`: by name, the question that is answered by a 1, or, with `trip_bit`, by a number that has this bit.
    `expects`: questions, and what each must be answered when it is identified: a mode that is set at its panel.
    `output_bit`, one a channel: the bit of the answer to `ask_output`. `most_A`, `most_V`: what a channel can deliver.
    `least_A`: what it is told where zero is meant, of one that takes no less.
    """

    __pydantic_config__ = ConfigDict(extra="forbid")

    maker: Pattern
    models: Pattern
    example: str
    set_current: SetNumber
    ask_current: Question
    set_voltage: SetNumber
    ask_voltage: Question
    measure_current: Question
    output: Switch
    ask_output: Question
    most_A: Positive
    most_V: Positive
    channels: tuple[Annotated[int, Field(ge=1, le=8)], ...] = (1,)
    select: Word = ""
    set_lower: SetNumber | Literal[""] = ""
    ask_lower: Question | Literal[""] = ""
    remote: Word = ""
    local: Word = ""
    errors: Word = "SYST:ERR?"
    no_error: str = '0,"No error"'
    trips: dict[str, Question] = field(default_factory=dict)
    trip_bit: dict[str, Bit] = field(default_factory=dict)
    output_bit: tuple[Bit, ...] = ()
    on: Word = "1"
    off: Word = "0"
    terminator: Literal["\n", "\r\n", "\r"] = "\n"
    resolution_A: Positive = 0.001
    least_A: NotNegative = 0.0
    resolution_V: Positive = 0.01
    gap_s: NotNegative = 0.0
    expects: dict[Question, Pattern] = field(default_factory=dict)
    bipolar: bool = False
    can_open: bool = True

    def __post_init__(self) -> None:
        maker, model = [*self.example.split(","), ""][:2]
        if not self.fits(maker.strip(), model.strip()):
            raise ValueError("example must be an answer to *IDN? that fits maker and models")
        if self.output_bit and len(self.output_bit) != len(self.channels):
            raise ValueError("output_bit must have one bit for each of channels")
        if stray := sorted(set(self.trip_bit) - set(self.trips)):
            raise ValueError(f"trip_bit has {stray[0]}, and trips has not")
        if bool(self.set_lower) != bool(self.ask_lower):
            raise ValueError("must have set_lower and ask_lower, or neither")
        if len(self.channels) > 1 and not self.select:
            for name in filter(lambda name: getattr(self, name), SAID + SAID_BY_SOME):
                if "{channel}" not in getattr(self, name) and not (name == "ask_output" and self.output_bit):
                    raise ValueError(f"{name} must have {{channel}}, or select must tell its channels apart")

    def fits(self, maker: str, model: str) -> bool:
        """Whether these, as *IDN? has them, are of this family."""
        return bool(re.search(self.maker, maker, re.IGNORECASE) and re.fullmatch(self.models, model, re.IGNORECASE))

    def to(self, channel: int, words: str) -> str:
        """A message to one channel, with {value…} and {on} left to be filled in."""
        text = f"{self.select};:{words.removeprefix(':')}" if self.select else words
        return text.replace("{channel}", f"{channel}")


@cache
def shipped(name: str) -> Table:
    """The table of `drivers/tables`. Raises ValueError where there is none of that name."""
    if name not in names():
        raise ValueError(f"there is no table {name!r}; there are {', '.join(names())}")
    with (TABLES / f"{name}.toml").open("rb") as file:
        return TypeAdapter(Table).validate_python(tomllib.load(file))


@cache
def names() -> tuple[str, ...]:
    """The tables that come with labcal."""
    return tuple(sorted(path.stem for path in TABLES.glob("*.toml")))


class stated(quantity):
    """A number whose words stand in the table, `least` and `floor` being the names of its resolution and of what it
    is at least there.
    """

    def __init__(self, get: str, set: str = "", *, least: str = "", floor: str = "", **rest: Any) -> None:
        super().__init__(f"{{s.say[{get}]}}", f"{{s.say[{set}]}}" if set else "", **rest)
        self.least, self.floor = least, floor

    def _message(self, device: Any, value: float) -> str:
        table = device.settings.words
        if self.floor and abs(value) < getattr(table, self.floor):
            value = getattr(table, self.floor)
        return super()._message(device, value).format(value=value, on=table.on if value else table.off)

    def _agrees(self, device: Any, value: float, held: float) -> bool:
        return abs(held - value) <= 1.01 * (getattr(device.settings.words, self.least) if self.least else 0.0)


LOWER = stated("ask_lower", "set_lower", unit="V", doc="Control the negative voltage.", least="resolution_V")
LOWER.label = "lower compliance"


class voltage(stated):
    """The voltage that may drive the coil; where the table has words for it, on the negative side too, and first."""

    def __set__(self, device: Any, value: float) -> None:
        if device.settings.words.set_lower:
            LOWER.__set__(device, -value)
        super().__set__(device, value)


def bit_of(reply: str, bit: int) -> str:
    """1 or 0 of a number such as 0x0224 or 1024; the reply itself where it is none."""
    try:
        return f"{int(reply, 16 if reply[:2].lower() == '0x' else 10) >> bit & 1}"
    except ValueError:
        return reply

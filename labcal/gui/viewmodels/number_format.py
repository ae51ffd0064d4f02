"""One way to write a number: sign always shown, thin groups of three, fixed decimals, unit said elsewhere, once."""

from __future__ import annotations

import re
from datetime import datetime, timedelta
from math import floor, isfinite, log10
from typing import Literal

from PySide6.QtCore import QLocale

from labcal.gui.translations.punctuation import with_head
from labcal.gui.translations.sentences import name_in_words
from labcal.gui.translations.translate import translated

FieldUnit = Literal["nT", "µT", "mG"]
PER_NT: dict[FieldUnit, float] = {"nT": 1.0, "µT": 1e-3, "mG": 1e-2}
DECIMALS: dict[FieldUnit, int] = {"nT": 1, "µT": 4, "mG": 3}
FIGURE_SPACE, NARROW_SPACE, MINUS = "\u2007", "\u202f", "\u2212"
MOUNTED, CLOSED = re.compile(r"mount-([xyz])(?:: (.+))?"), re.compile(r"closure-([xyz])")
POSITION = re.compile(r"position-(\d+)")  # a segment, whose step is "position 7"
TURN = re.compile(r"\b([xyz])([+-])(\d+(?:\.\d+)?)uT(?:-(\w+))?")


def format_number(value: float, decimals: int = 1, *, signed: bool = True) -> str:
    """`value` with a true minus sign, groups of three and the language's decimal mark: +19 998.7 or −3,2."""
    value = round(value, decimals) + 0.0  # no negative zero
    text = f"{value:+,.{decimals}f}" if signed else f"{value:,.{decimals}f}"
    return text.replace(",", NARROW_SPACE).replace("-", MINUS).replace(".", QLocale().decimalPoint())


def short_number(value: float | None) -> str:
    """`value` as it was stated, a limit: 0.5 or, by the language, 0,5; – where none was."""
    return "–" if value is None else f"{value:g}".replace("-", MINUS).replace(".", QLocale().decimalPoint())


def format_field(value_nT: float, unit: FieldUnit = "nT", *, signed: bool = True) -> str:
    """A field component, or with `signed` False a magnitude, in the display unit."""
    return format_number(value_nT * PER_NT[unit], DECIMALS[unit], signed=signed)


def format_duration(seconds: float) -> str:
    """Minutes and seconds, 06:40; hours where there are any, 1:06:40."""
    whole = max(0, round(seconds))
    hours, minutes, rest = whole // 3600, whole // 60 % 60, whole % 60
    return f"{hours}:{minutes:02}:{rest:02}" if hours else f"{minutes:02}:{rest:02}"


CLOCK_S = 60.0  # to which a time on the wall is said


def clock_time(now: datetime, in_s: float) -> str:
    """The time on the wall in so many seconds, to the minute: 07:42, and with its day where that is another."""
    then = now + timedelta(seconds=in_s)
    day = "" if then.date() == now.date() else QLocale().dayName(then.isoweekday(), QLocale.FormatType.ShortFormat)
    return f"{day} {then:%H:%M}".strip()


def step_title(name: str) -> str:
    """A step, a segment or a measurement as a person says it: "x-50uT-full" is "x −50 µT full".

    The step "zero" ends in a field: by that name alone it would say of energised coils that they are at zero. That of a
    mounting says how the DUT stands while it goes on: the first one is asked for in the step before.
    """
    if name == "zero":
        return translated("offset and first position")
    if found := MOUNTED.fullmatch(name):
        stands = translated("body {0} up").format(found[1].upper())
        return with_head(stands, name_in_words(found[2])) if found[2] else stands
    return turns_written(name_in_words(POSITION.sub(r"position \1", CLOSED.sub(r"closure \1", name))))


def needed_title(name: str) -> str:
    """What a person is needed for, where the step `name` begins with a question."""
    if name == "closing":  # where a preflight comes back to its first mounting
        return translated("mount it as at first")
    found = MOUNTED.fullmatch(name)
    return translated("mount it with body {0} up").format(found[1].upper()) if found else step_title(name)


def turns_written(text: str) -> str:
    """`text` with each turn in it as tables have it: "x-50uT-full" is "x −50 µT full"."""
    return TURN.sub(lambda m: f"{m[1]} {m[2].replace('-', MINUS)}{m[3]} µT {m[4] or ''}".rstrip(), text)


def decimals_for(u: float, value: float) -> int:
    """Decimals that show two figures of the uncertainty; of a value without one, four figures."""
    shown = u if u > 0 else abs(value) / 100
    if not isfinite(shown) or shown == 0:
        return 0
    return min(6, max(0, 1 - floor(log10(shown))))

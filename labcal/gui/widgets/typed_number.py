"""Numbers as people type them, by the locale, and as everything below the window states them: with a point."""

from __future__ import annotations

import re

from PySide6.QtCore import QLocale

from labcal.gui.translations.translate import translated

GROUPED = re.compile(r"(?<!\d)[1-9]\d{0,2}([.,])\d{3}(?!\d)")  # 20,000: twenty, or twenty thousand?
SPACED = re.compile(r"\d[\s'\u2019\u202f\u00a0]\d")
LISTED = re.compile(r"\d,\d")  # in a list a comma stands between two numbers, with a blank behind it


class NotClear(ValueError):
    """What was typed may be meant in two ways; the words say which."""


def decimal_mark() -> str:
    """Of whoever sits here: of the window's language, or of the system."""
    return "," if "," in (QLocale().decimalPoint(), QLocale.system().decimalPoint()) else "."


def number_stated(text: str, mark: str | None = None) -> str:
    """One number that was typed, with a point. Raises NotClear where it has marks between thousands."""
    text, mark = text.strip(), mark or decimal_mark()
    grouped = GROUPED.search(text)
    if SPACED.search(text) or ("," in text and "." in text) or (grouped and (grouped[1] == "," or mark == ",")):
        raise NotClear(translated("no marks between thousands: 20000, not 20 000, 20,000 or 20.000"))
    if "," in text and mark != ",":
        raise NotClear(translated("a point stands before decimals here: 1.5, not 1,5"))
    return text.replace(",", ".")


def numbers_stated(text: str) -> str:
    """Several numbers apart by commas, as they were typed. Raises NotClear where a comma may be within a number."""
    if LISTED.search(text):
        raise NotClear(translated("a blank after each comma, and a point before decimals: 20000, 50000.5"))
    for part in text.split(","):
        if SPACED.search(part.strip()):
            raise NotClear(translated("no marks between thousands: 20000, not 20 000, 20,000 or 20.000"))
    return text

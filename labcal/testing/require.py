"""How a broken promise is reported: an AssertionError whose sentence says what was seen and what to do."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from contextlib import contextmanager

from labcal.errors import InputError


def require(kept: object, sentence: str) -> None:
    """Raise AssertionError with this sentence where a promise is not kept; `python -O` does not silence it."""
    if not kept:
        raise AssertionError(sentence)


def near(value: float, wanted: float, within: float) -> bool:
    """Whether a number is there and as it should be."""
    return math.isfinite(value) and abs(value - wanted) <= within


@contextmanager
def refused(kind: type[Exception], sentence: str, *, words: str = "", fault: str = "") -> Iterator[None]:
    """What happens inside must raise `kind`, its message holding `words` (a pattern), its fault state `fault`."""
    try:
        yield
    except kind as error:
        require(re.search(words, str(error)), f"{sentence} It was refused with {str(error)!r}, which lacks {words!r}.")
        found = getattr(error, "fault", "")
        require(not fault or found == fault, f"{sentence} Its error says fault={found!r}, not {fault!r}.")
        return
    raise AssertionError(sentence)


@contextmanager
def answered(sentence: str) -> Iterator[None]:
    """What happens inside must not be refused as wrong input."""
    try:
        yield
    except InputError as error:
        raise AssertionError(f"{sentence} {error}") from error

"""Whatever a procedure or a bench raised, in one sentence for the record."""

from __future__ import annotations

from labcal.bench.coils.state import NOT_BY_REFERENCE
from labcal.errors import words_of_system


def in_a_sentence(fault: BaseException) -> str:
    """What it says; of one that says nothing, its name."""
    try:
        words = words_of_system(fault) if isinstance(fault, OSError) else str(fault)
    except BaseException:  # of a procedure of one's own, whatever its exceptions do
        words = ""
    return words or type(fault).__name__


def what_else(fault: Exception | None, said: str) -> str:
    """What went wrong, where that was not said already."""
    if fault is None or (NOT_BY_REFERENCE in said and NOT_BY_REFERENCE in str(fault)):
        return ""
    return f": {in_a_sentence(fault)}"

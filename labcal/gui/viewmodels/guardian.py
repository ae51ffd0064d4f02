"""What the guardian is, in one sentence, for every place where the word stands."""

from __future__ import annotations

from PySide6.QtCore import QT_TRANSLATE_NOOP

from labcal.gui.translations.translate import translated

GUARDIAN = "guardian"
TEXTS = (QT_TRANSLATE_NOOP("Words", "guardian"),)
IS = QT_TRANSLATE_NOOP(
    "Words",
    "The guardian is a program of its own beside labcal: it holds the lines of the supplies, and takes every coil to "
    "zero when a session ends, breaks off or no longer answers.",
)


def guardian_is(*words: str) -> str:
    """The sentence, where any of these (English) words speak of the guardian; else ""."""
    return translated(str(IS)) if any(GUARDIAN in one.lower() for one in words) else ""

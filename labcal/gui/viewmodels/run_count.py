"""How many runs the store has, in the same words on every page."""

from __future__ import annotations

from PySide6.QtCore import QT_TRANSLATE_NOOP

from labcal.gui.translations.translate import translated

COUNTED = QT_TRANSLATE_NOOP("Words", "{0} in the store")
FOUND = QT_TRANSLATE_NOOP("Words", "{0} of {1} in the store")


def count_words(there: int, found: int | None = None) -> str:
    """How many there are, and how many of them are shown where these are fewer."""
    if found is None or found == there:
        return translated(str(COUNTED)).format(there)
    return translated(str(FOUND)).format(found, there)

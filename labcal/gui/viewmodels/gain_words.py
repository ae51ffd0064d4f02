"""The nine gains K of a calibration by their plain names, and what each is."""

from __future__ import annotations

from PySide6.QtCore import QT_TRANSLATE_NOOP

from labcal.gui.translations.translate import translated

AXES = "xyz"
TEXTS = (
    QT_TRANSLATE_NOOP("Words", "gain K {0} by {1}"),
    QT_TRANSLATE_NOOP("Words", "What a reading along {1} adds to the field along {0}."),
)
NAME, MEANS = map(str, TEXTS)
GAINS = tuple((of, by) for of in AXES for by in AXES)  # row by row, as K is stored


def gain_name(of: str, by: str) -> str:
    """In the window's language, of the field along `of` by the reading along `by`."""
    return translated(NAME).format(of, by)


def gain_means(of: str, by: str) -> str:
    """The same as a sentence."""
    return translated(MEANS).format(of, by)

"""What is said of hands and coils, in no more lines than leave the instruments in sight: the gravest stays whole."""

from __future__ import annotations

from collections.abc import Iterator

from PySide6.QtCore import QT_TRANSLATE_NOOP, Qt
from PySide6.QtWidgets import QLabel

from labcal.gui.translations.punctuation import listed_apart, parted
from labcal.gui.translations.translate import translated
from labcal.gui.viewmodels.in_brief import in_brief

MOST_LINES = 7  # of all that is said of hands and coils: below them the instruments stand in sight at 1360 x 860
MORE = QT_TRANSLATE_NOOP("Words", "and {0} more")


def said_shorter(why: str, coils: str, *, may: bool = False) -> Iterator[tuple[str, str]]:
    """The reasons and what is said of the coils: whole, and then each time in fewer words, the first reason whole.

    What to do stays longer than how it was found; what a reason has said of the coils is not said again. `may`: hands
    may go in; then what follows is what that rests on, and stays whole.
    """
    yield why, coils
    if may:
        return
    first, *others = parted(why)
    short = in_brief(coils)
    known = short.partition(" ")[2] in why
    to_do = coils.partition(". ")[2] if known else ""
    yield why, to_do or ("" if known else short)
    without_figures = listed_apart([first, *(one.partition(" (")[0] for one in others)])
    yield without_figures, to_do or ("" if known else short)
    counted = listed_apart([first, translated(str(MORE)).format(len(others))]) if others else first
    for reasons in (without_figures, counted):
        yield reasons, "" if known or why else short


def lines(said: QLabel, text: str, width: int) -> int:
    """How many `text` takes in this label, where it is `width` wide."""
    if not text:
        return 0
    flags = int(said.alignment() | Qt.TextFlag.TextWordWrap)
    metrics = said.fontMetrics()
    return -(-metrics.boundingRect(0, 0, width, 10**6, flags, text).height() // metrics.lineSpacing())

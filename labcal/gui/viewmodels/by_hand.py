"""The one order of acts where a coil is not confirmed at zero: COILS OFF, which stops a platform too, then by hand."""

from __future__ import annotations

from collections.abc import Sequence

from PySide6.QtCore import QT_TRANSLATE_NOOP

from labcal.gui.translations.translate import translated
from labcal.gui.viewmodels.lab_now import age_words

BY_HAND = QT_TRANSLATE_NOOP("Words", "COILS OFF (F12), then switch off by hand: {0}")
NOW_BY_HAND = QT_TRANSLATE_NOOP("Words", "Switch off by hand: {0}")
NOT_READ = QT_TRANSLATE_NOOP("Words", "Still to be read: {0}")

LAST_READ = QT_TRANSLATE_NOOP("Words", "{0} (last read {1})")
PRESSED = QT_TRANSLATE_NOOP("Words", "COILS OFF was pressed at {0}; nobody has confirmed it")


def last_read(name: str, old_s: int) -> str:
    """A supply that was read, and how long ago."""
    return translated(str(LAST_READ)).format(name, age_words(old_s))


def pressed_words(at: str) -> str:
    """That COILS OFF was pressed `at` that time, and nothing came of it yet that anybody saw; "" where it was not."""
    return translated(str(PRESSED)).format(at) if at else ""


def by_hand_words(supplies: Sequence[str], *, pressed: bool = False) -> str:
    """What a person does about these `supplies`; "" of none. `pressed`: COILS OFF was, and is not ordered again."""
    return translated(str(NOW_BY_HAND if pressed else BY_HAND)).format(", ".join(supplies)) if supplies else ""


def not_read_words(supplies: Sequence[str]) -> str:
    """Of those that nobody has asked since: nothing is known against them."""
    return translated(str(NOT_READ)).format(", ".join(supplies)) if supplies else ""

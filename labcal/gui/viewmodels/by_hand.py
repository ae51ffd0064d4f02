"""The one order of acts where a coil is not confirmed at zero: COILS OFF, which stops a platform too, then by hand."""

from __future__ import annotations

from collections.abc import Sequence

from PySide6.QtCore import QT_TRANSLATE_NOOP

from labcal.gui.translations.translate import translated

BY_HAND = QT_TRANSLATE_NOOP("Words", "COILS OFF (F12), then switch off by hand: {0}")
NOT_READ = QT_TRANSLATE_NOOP("Words", "Not read yet: {0}")


def by_hand_words(supplies: Sequence[str]) -> str:
    """What a person does about these `supplies`; "" of none."""
    return translated(str(BY_HAND)).format(", ".join(supplies)) if supplies else ""


def not_read_words(supplies: Sequence[str]) -> str:
    """Of those that nobody has asked since: nothing is known against them."""
    return translated(str(NOT_READ)).format(", ".join(supplies)) if supplies else ""

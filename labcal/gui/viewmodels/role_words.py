"""What an instrument is there for, in words, in the order in which a bench is listed."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QT_TRANSLATE_NOOP

from labcal.gui.translations.translate import translated
from labcal.gui.viewmodels.number_format import format_number

ROLES = {
    "coil-x": QT_TRANSLATE_NOOP("Words", "coil x"),
    "coil-y": QT_TRANSLATE_NOOP("Words", "coil y"),
    "coil-z": QT_TRANSLATE_NOOP("Words", "coil z"),
    "polarity": QT_TRANSLATE_NOOP("Words", "contacts"),
    "interlock": QT_TRANSLATE_NOOP("Words", "interlock"),
    "platform": QT_TRANSLATE_NOOP("Words", "platform"),
    "reference": QT_TRANSLATE_NOOP("Words", "reference"),
    "dut": QT_TRANSLATE_NOOP("Words", "DUT"),
}
ORDER = tuple(ROLES)


def role_word(role: str) -> str:
    """The role of a bench file in the window's language."""
    return translated(str(ROLES[role]))


def reading_text(role: str, values: Sequence[float] | NDArray[np.float64]) -> str:
    """The last sample of an instrument, short."""
    unit = {"dut": "", "reference": " nT", "platform": "°"}.get(role, "")
    return "  ".join(format_number(float(value), 1) for value in values[:3]) + unit

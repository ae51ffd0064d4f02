"""What makes most of the U of a calibration, in one line. No widgets."""

from __future__ import annotations

import math
import re

from PySide6.QtCore import QT_TRANSLATE_NOOP

from labcal.gui.ipc.answers import BudgetLine, CalibrationFile
from labcal.gui.translations.sentences import name_in_words
from labcal.gui.translations.translate import translated
from labcal.gui.viewmodels.number_format import format_number

OF_THE_FIELD = "b "  # as lines of a budget begin: a component of the field of one reading
MOUNTING = "rotation axes in the body"  # how the DUT stands on the platform
LARGEST = QT_TRANSLATE_NOOP("Words", "U of one component of the field: up to {0} nT (k = 2), {1} % of it from {2}.")
MOUNTED = QT_TRANSLATE_NOOP(
    "Words", "U of one component of the field: {0} nT (k = 2), mostly from the mounting, declared good to {1}°."
)
LOWERED = QT_TRANSLATE_NOOP(
    "Words", "To lower it, mount more exactly and declare that (u_mounting_deg): docs/certificate.md"
)
SAYS_MORE = QT_TRANSLATE_NOOP("Words", "What it is made of: docs/certificate.md")
AT = re.compile(r"([\d.]+) µT ")  # the field that a line of the budget is for
DECLARED = QT_TRANSLATE_NOOP("Words", "the declared mounting ({0})")


def largest_of_U(one: CalibrationFile | None) -> str:
    """The largest U of a component of the field, and its main source; "" where there is no budget."""
    if (worst := _worst(one)) is None:
        return ""
    source, share = worst.sources[0]
    if (at := _by_mounting(worst)) is not None:
        part = math.sqrt(share) * worst.U
        declared = math.degrees(part / worst.k / (1e3 * at))  # a turn by so much moves so much of the field
        U = format_number(worst.U, 0, signed=False)
        return translated(str(MOUNTED)).format(U, format_number(declared, 1, signed=False))
    words = name_in_words(source)
    words = translated(str(DECLARED)).format(words) if source.startswith(MOUNTING) else words
    U = format_number(worst.U, 0, signed=False)
    return translated(str(LARGEST)).format(U, format_number(100 * share, 0, signed=False), words)


def how_to_lower_U(one: CalibrationFile | None) -> str:
    """What is to be done about it, or where more is said; "" where there is no budget."""
    if (worst := _worst(one)) is None:
        return ""
    return translated(str(SAYS_MORE if _by_mounting(worst) is None else LOWERED))


def _worst(one: CalibrationFile | None) -> BudgetLine | None:
    lines = [] if one is None else [line for line in one.budget if line.quantity.startswith(OF_THE_FIELD)]
    worst = max(lines, key=lambda line: line.U, default=None)
    return None if worst is None or not worst.sources else worst


def _by_mounting(worst: BudgetLine) -> float | None:
    """The field [µT] that the line is for, where more than half of it is how the DUT stands; else None."""
    source, share = worst.sources[0]
    at = AT.match(worst.at)
    return float(at[1]) if at is not None and source.startswith(MOUNTING) and share > 0.5 else None

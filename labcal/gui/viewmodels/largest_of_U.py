"""What makes most of the U of a calibration, in one line. No widgets."""

from __future__ import annotations

import math
import re

from PySide6.QtCore import QT_TRANSLATE_NOOP

from labcal.gui.ipc.answers import CalibrationFile
from labcal.gui.translations.sentences import name_in_words
from labcal.gui.translations.translate import translated
from labcal.gui.viewmodels.number_format import format_number

OF_THE_FIELD = "b "  # as lines of a budget begin: a component of the field of one reading
MOUNTING = "rotation axes in the body"  # how the DUT stands on the platform
LARGEST = QT_TRANSLATE_NOOP(
    "Words", "U of one component of the field is up to {0} nT (k = 2), {1} % of it from {2}: docs/certificate.md"
)
MOUNTED = QT_TRANSLATE_NOOP(
    "Words",
    "Most of U of one component of the field, {0} of {1} nT (k = 2), is the mounting: the run declares it good to {2}° "
    "(u_mounting_deg). To lower it, mount more exactly and declare that: docs/certificate.md",
)
AT = re.compile(r"([\d.]+) µT ")  # the field that a line of the budget is for
DECLARED = QT_TRANSLATE_NOOP("Words", "the declared mounting ({0})")


def largest_of_U(one: CalibrationFile | None) -> str:
    """The largest U of a component of the field, and its main source; "" where there is no budget."""
    lines = [] if one is None else [line for line in one.budget if line.quantity.startswith(OF_THE_FIELD)]
    worst = max(lines, key=lambda line: line.U, default=None)
    if worst is None or not worst.sources:
        return ""
    source, share = worst.sources[0]
    if source.startswith(MOUNTING) and share > 0.5 and (at := AT.match(worst.at)) is not None:
        part = math.sqrt(share) * worst.U
        declared = math.degrees(part / worst.k / (1e3 * float(at[1])))  # a turn by so much moves so much of the field
        figures = (format_number(one, 0, signed=False) for one in (part, worst.U))
        return translated(str(MOUNTED)).format(*figures, format_number(declared, 1, signed=False))
    words = name_in_words(source)
    words = translated(str(DECLARED)).format(words) if source.startswith(MOUNTING) else words
    U = format_number(worst.U, 0, signed=False)
    return translated(str(LARGEST)).format(U, format_number(100 * share, 0, signed=False), words)

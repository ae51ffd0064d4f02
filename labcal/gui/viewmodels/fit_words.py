"""Whether a fit is good, in words: what it leaves over, held out, beside the noise that the run states.

Not beside that of the method, which makes it of what is left over.
"""

from __future__ import annotations

from PySide6.QtCore import QT_TRANSLATE_NOOP

from labcal.gui.ipc.answers import Fitted
from labcal.gui.translations.translate import translated
from labcal.gui.viewmodels.number_format import format_number

REACHED = 1.15  # of the noise: as the loop calls a run clean
GOOD = QT_TRANSLATE_NOOP("Words", "✓ Good: {0} nT are left over, no more than the stated noise, {1} nT.")
DOUBT = QT_TRANSLATE_NOOP(
    "Words", "▲ Not good yet: {0} nT are left over, the stated noise is {1} nT. Trace the residual."
)
NO_NOISE = QT_TRANSLATE_NOOP("Words", "{0} nT are left over; no noise is stated to compare it with.")


def said_of(method: str, fitted: Fitted | None) -> tuple[str, str]:
    """A sentence about the fit by `method`, and its state: good, warning, or "" where nothing is known."""
    left = None if fitted is None else fitted.fit.holdout_rms_scalar_nT
    if fitted is None or left is None:
        return "", ""
    shown = format_number(left, signed=False)
    if fitted.stated_nT is None:
        return f"{method}: {translated(str(NO_NOISE)).format(shown)}", ""
    good = left <= REACHED * fitted.stated_nT
    words = translated(str(GOOD if good else DOUBT)).format(shown, format_number(fitted.stated_nT, signed=False))
    return f"{method}: {words}", "good" if good else "warning"

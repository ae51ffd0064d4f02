"""Who is not looked at while no run goes on, and is said not to be. No widgets.

It is the DUT: to look at it takes its port again and again. Opening a serial port resets many a microcontroller, a
driver's first commands may switch its mode or its stream, and whoever develops it may read it by a program of their
own. A run asks it who it is before anything is energised; one that was lost is looked at until it is back. At a run's
question it rests as well: the next step reads it.
"""

from __future__ import annotations

from PySide6.QtCore import QT_TRANSLATE_NOOP

from labcal.gui.translations.translate import translated
from labcal.gui.viewmodels.lab_now import Light

NOT_AT_REST = QT_TRANSLATE_NOOP("Words", "not looked at at rest")
WHY = QT_TRANSLATE_NOOP(
    "Words",
    "To look at it opens its port: that resets many a microcontroller, or switches what it sends. Read all asks it who "
    "it is.",
)
NEXT_STEP = QT_TRANSLATE_NOOP("Words", "read again in the next step")


def not_at_rest(role: str, light: Light, *, driven: bool) -> str:
    """What is added to how an instrument of this role stands; "" where it is looked at, or was heard just now."""
    if role != "dut" or light != "old":
        return ""
    return translated(str(NEXT_STEP if driven else NOT_AT_REST))


def why_not_at_rest(standing: str) -> str:
    """Why nobody looks, where that is how an instrument stands, in words."""
    return translated(str(WHY)) if translated(str(NOT_AT_REST)) in standing else ""

"""What comes before a plug: nobody is sent to one while a coil or the platform is not known to rest. No widgets."""

from __future__ import annotations

from PySide6.QtCore import QT_TRANSLATE_NOOP

from labcal.gui.translations.translate import translated
from labcal.gui.viewmodels.field_witness import still_live
from labcal.gui.viewmodels.lab_now import LabNow, mark_of, platform_mark

BY_HAND = QT_TRANSLATE_NOOP(
    "Words", "First press COILS OFF (F12), then switch off by hand the supply that does not answer."
)
CONTROLLER = QT_TRANSLATE_NOOP("Words", "First stop the platform at its controller, and see it stand.")
WAIT = QT_TRANSLATE_NOOP("Words", "First wait until hands may go in.")


def first_thing(now: LabNow) -> str:
    """The gravest first: the coils, then the platform; "" where neither is on, turns or may."""
    if not still_live(now):
        return ""
    coils = mark_of(now.coil_words)[1] == "bad" and now.coils_at_zero is False
    platform = platform_mark(now.platform_words)[1] == "bad"
    return translated(str(BY_HAND if coils else CONTROLLER if platform else WAIT))

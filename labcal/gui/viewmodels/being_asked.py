"""Whoever was not asked yet is being asked, while everybody is: by a person, or as a run begins. No widgets."""

from __future__ import annotations

from dataclasses import replace

from PySide6.QtCore import QT_TRANSLATE_NOOP

from labcal.gui.translations.translate import translated
from labcal.gui.viewmodels.lab_now import LabNow, Light

ASKED = QT_TRANSLATE_NOOP("Words", "being asked")


def being_asked(now: LabNow) -> LabNow:
    """The lab, with nobody in it of whom it is said that they are not asked."""
    return replace(now, lights=tuple(_asked(*one) for one in now.lights))


def _asked(name: str, light: Light, said: str) -> tuple[str, Light, str]:
    return (name, "waiting", translated(str(ASKED))) if light == "absent" and not said else (name, light, said)

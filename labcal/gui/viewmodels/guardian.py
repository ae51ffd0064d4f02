"""What the guardian is, in one sentence, for every place where the word stands."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import QT_TRANSLATE_NOOP

from labcal.gui.ipc.bench_facts import Bench
from labcal.gui.translations.translate import translated

if TYPE_CHECKING:
    from labcal.gui.viewmodels.lab_now import Lights

GUARDED = ("coil-", "polarity", "interlock")  # roles
GUARDIAN = "guardian"
TEXTS = (QT_TRANSLATE_NOOP("Words", "guardian"),)
IN_RUN = QT_TRANSLATE_NOOP("Words", "only in a run")
IS = QT_TRANSLATE_NOOP(
    "Words",
    "The guardian is a program of its own beside labcal: it holds the lines of the supplies, and takes every coil to "
    "zero when a session ends, breaks off or no longer answers.",
)


def guardian_is(*words: str) -> str:
    """The sentence, where any of these (English) words speak of the guardian; else ""."""
    return translated(str(IS)) if any(GUARDIAN in one.lower() for one in words) else ""


def with_guardian(lights: Lights, facts: Bench | None) -> Lights:
    """The list of who is there: of a bench that a guardian belongs to it stands below the others, in a run or not."""
    if facts is None or facts.virtual_time or any(name == GUARDIAN for name, *_ in lights):
        return lights
    lines = [one.link for one in facts.instruments.values() if one.role.startswith(GUARDED)]
    own = [link for link in lines if not link.startswith(("emulated://", "manual://"))]
    return (*lights, (GUARDIAN, "absent", translated(str(IN_RUN)))) if own else lights

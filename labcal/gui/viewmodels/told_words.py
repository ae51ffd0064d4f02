"""What a run's record tells of interruptions and notes, in words."""

from __future__ import annotations

from PySide6.QtCore import QT_TRANSLATE_NOOP

from labcal.gui.translations.translate import translated
from labcal.gui.viewmodels.number_format import step_title
from labcal.record.told import Interruption, Told

TEXTS = (
    QT_TRANSLATE_NOOP("Words", "▲ Interrupted once: {0}. Measured again: {1}."),
    QT_TRANSLATE_NOOP("Words", "▲ Interrupted {0} times: {1}. Measured again: {2}."),
    QT_TRANSLATE_NOOP("Words", "nothing"),
    QT_TRANSLATE_NOOP("Words", "at {0}, for {1}"),
    QT_TRANSLATE_NOOP("Words", "before its first step, for {0}"),
    QT_TRANSLATE_NOOP("Words", "at {0}"),
    QT_TRANSLATE_NOOP("Words", "before its first step"),
    QT_TRANSLATE_NOOP("Words", "nobody knows how long"),
    QT_TRANSLATE_NOOP("Words", "{0} s"),
    QT_TRANSLATE_NOOP("Words", "{0} min"),
    QT_TRANSLATE_NOOP("Words", "{0} h"),
    QT_TRANSLATE_NOOP("Words", "Noted, in the run's record (History shows it): {0}"),
)
ONCE, OFTEN, NOTHING, AT, BEFORE, AT_ALONE, BEFORE_ALONE, UNKNOWN, SECONDS, MINUTES, HOURS, NOTED = map(str, TEXTS)


def interrupted_words(told: Told) -> str:
    """How often, where, for how long, and what was measured again; "" where nothing was interrupted."""
    if not told.interruptions:
        return ""
    where = "; ".join(map(_one, told.interruptions))
    names = dict.fromkeys(step_title(name) for one in told.interruptions for name in one.again)
    again = ", ".join(names) or translated(NOTHING)
    often = len(told.interruptions)
    return translated(ONCE).format(where, again) if often == 1 else translated(OFTEN).format(often, where, again)


def noted_words(told: Told) -> str:
    """What was noted, and where that is kept; "" where nothing was."""
    return translated(NOTED).format(" · ".join(told.notes)) if told.notes else ""


def _one(interruption: Interruption) -> str:
    if not interruption.timed:
        return translated(AT_ALONE).format(step_title(interruption.at)) if interruption.at else translated(BEFORE_ALONE)
    gone = translated(UNKNOWN) if interruption.gone_s is None else _long(interruption.gone_s)
    if not interruption.at:
        return translated(BEFORE).format(gone)
    return translated(AT).format(step_title(interruption.at), gone)


def _long(seconds: float) -> str:
    """In the unit that leaves two figures."""
    if seconds < 120:
        return translated(SECONDS).format(f"{seconds:.0f}")
    return translated(MINUTES if seconds < 7200 else HOURS).format(f"{seconds / (60 if seconds < 7200 else 3600):.0f}")

"""What a run's record tells of interruptions and notes, in words."""

from __future__ import annotations

from collections import Counter

from PySide6.QtCore import QT_TRANSLATE_NOOP

from labcal.gui.translations.punctuation import listed_apart, with_head
from labcal.gui.translations.sentences import in_words
from labcal.gui.translations.translate import translated
from labcal.gui.viewmodels.number_format import step_title
from labcal.gui.viewmodels.run_verdict import listed
from labcal.record.told import Interruption, Told

TEXTS = (
    QT_TRANSLATE_NOOP("Words", "▲ One interruption: {0}. Measured again: {1}."),
    QT_TRANSLATE_NOOP("Words", "▲ {0} interruptions: {1}. Measured again: {2}."),
    QT_TRANSLATE_NOOP("Words", "▲ One interruption: {0}."),
    QT_TRANSLATE_NOOP("Words", "▲ {0} interruptions: {1}."),
    QT_TRANSLATE_NOOP("Words", "at {0}, for {1}"),
    QT_TRANSLATE_NOOP("Words", "before its first step, for {0}"),
    QT_TRANSLATE_NOOP("Words", "at {0}"),
    QT_TRANSLATE_NOOP("Words", "before its first step"),
    QT_TRANSLATE_NOOP("Words", "nobody knows how long"),
    QT_TRANSLATE_NOOP("Words", "{0} s"),
    QT_TRANSLATE_NOOP("Words", "{0} min"),
    QT_TRANSLATE_NOOP("Words", "{0} h"),
    QT_TRANSLATE_NOOP("Words", "Noted, in the run's record (History shows it): {0}"),
    QT_TRANSLATE_NOOP("Words", "Noted: {0}"),
    QT_TRANSLATE_NOOP("Words", "The procedure noted {0} more, the last: {1}"),
    QT_TRANSLATE_NOOP("Words", "Estimates on the way: {0} notes; no verdict rests on them."),
    QT_TRANSLATE_NOOP("Words", "Estimates on the way: 1 note; no verdict rests on it."),
    QT_TRANSLATE_NOOP("Words", "▲ Open in the run itself: {0}. An approval takes that as it is."),
    QT_TRANSLATE_NOOP("Words", "{0} not measured"),
)
ONCE, OFTEN, ONCE_ALONE, OFTEN_ALONE, AT, BEFORE, AT_ALONE, BEFORE_ALONE, *_LENGTHS = map(str, TEXTS[:12])
UNKNOWN, SECONDS, MINUTES, HOURS = _LENGTHS
_NOTES = map(str, TEXTS[12:])
NOTED, NOTED_HERE, REMARKED, ESTIMATED, ESTIMATED_ONCE, OPEN, MISSING = _NOTES
SO_FAR = "offsets so far"  # as a running estimate begins: it has no part in a verdict


def interrupted_words(told: Told) -> str:
    """How often, where, for how long, and what was measured again so far; "" where nothing was interrupted."""
    if not told.interruptions:
        return ""
    places = Counter(map(_one, told.interruptions))
    where = listed_apart([place if often == 1 else f"{place} ({often}×)" for place, often in places.items()])
    names = dict.fromkeys(step_title(name) for one in told.interruptions for name in one.again)
    again, often = ", ".join(names), len(told.interruptions)
    if often == 1:
        return translated(ONCE if again else ONCE_ALONE).format(where, again)
    return translated(OFTEN if again else OFTEN_ALONE).format(often, where, again)


def noted_words(told: Told, *, here: bool = False) -> str:
    """What people noted, and where that is kept unless it is `here`; "" where nothing was."""
    return translated(NOTED_HERE if here else NOTED).format(" · ".join(told.notes)) if told.notes else ""


def serials_words(told: Told) -> str:
    """Which instruments named another serial than was stated; "" where none did."""
    return f"▲ {listed_apart([*map(in_words, told.other_serials)])}." if told.other_serials else ""


def remarked_words(told: Told) -> str:
    """What the procedure noted itself, in one line: how often, and the last of it; "" where nothing was."""
    if not told.remarks:
        return ""
    if told.remarks[-1].startswith(SO_FAR):
        several = len(told.remarks) > 1
        return translated(ESTIMATED if several else ESTIMATED_ONCE).format(len(told.remarks))
    return translated(REMARKED).format(len(told.remarks), in_words(told.remarks[-1]))


def open_words(told: Told) -> str:
    """Which of the run's checks are open, with value and limit, and whose serial is another; "" where all is well."""
    others = list(map(in_words, told.other_serials))
    judged = [with_head(translated(one.verdict), listed((one,))) for one in told.open]
    missing = [translated(MISSING).format(step_title(name)) for name in told.not_measured]
    return translated(OPEN).format(listed_apart([*others, *judged, *missing])) if others or judged or missing else ""


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

"""After COILS OFF in a run: what it was pressed for, in the words that are read from the cage. No widgets."""

from __future__ import annotations

from PySide6.QtCore import QT_TRANSLATE_NOOP

from labcal.bench.coils import state
from labcal.gui.translations.sentences import in_words
from labcal.gui.translations.translate import translated
from labcal.gui.viewmodels.failed_step import SHOWN
from labcal.gui.viewmodels.lab_now import LabNow, age_words, mark_of, platform_mark
from labcal.gui.viewmodels.watched import as_watched

OFF = QT_TRANSLATE_NOOP("Words", "{0} COILS OFF: {1}")
SEEN = QT_TRANSLATE_NOOP("Words", "the reference agreed {0}")
STANDS = QT_TRANSLATE_NOOP("Words", "platform stands")


def off_headline(now: LabNow) -> tuple[str, str]:
    """The words and their state; where the coils are not at zero no more than that, the card above says which.

    Green as long as everybody it speaks of answers, and is read again and again; what is older has its age and
    another colour, as every other value. How old the rest is, the side panel says.
    """
    now = as_watched(now)
    if not now.coil_words:
        return "", ""
    if now.coils_at_zero is False:
        return translated("HANDS OFF"), "bad"
    coils = in_words(state.AT_ZERO if now.coils_at_zero else now.coil_words.partition(";")[0])
    shape, mark = mark_of(now.coil_words)
    turns = platform_mark(now.platform_words)[1]
    stands = translated(str(STANDS)) if turns == "good" else in_words(now.platform_words)
    if turns not in ("", "good"):
        shape, mark = "▲", "warning"
    seen = translated(str(SEEN)).format(age_words(now.reference_old_s)) if _seen_before(now) else ""
    lost = translated(str(SHOWN)).format(", ".join(now.silent_tellers)).lstrip("✕ ") if now.silent_tellers else ""
    if lost:
        shape, mark = "▲", "warning"
    return translated(str(OFF)).format(shape, ", ".join(filter(None, (coils, stands, seen, lost)))), mark


def _seen_before(now: LabNow) -> bool:
    """Whether the supplies alone have been read since the reference agreed, which is to be read again."""
    old = now.reference_agreed and now.reference_old_s is not None
    return old and now.coil_words.startswith(state.BY_WORD) and now.alone != state.NOT_READ_ON

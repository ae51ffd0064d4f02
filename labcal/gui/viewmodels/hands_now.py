"""Whether a person may reach into the lab now, and why not: the one rule of it. No widgets."""

from __future__ import annotations

from PySide6.QtCore import QT_TRANSLATE_NOOP

from labcal.bench.coils import state
from labcal.bench.coils.agreement import CHANGED
from labcal.gui.translations.sentences import in_words
from labcal.gui.translations.translate import translated
from labcal.gui.viewmodels.field_witness import field_says
from labcal.gui.viewmodels.in_brief import in_brief
from labcal.gui.viewmodels.lab_now import OFF, STOP_UNSEEN, LabNow, platform_mark
from labcal.gui.viewmodels.watched import as_watched, is_watched, let_in_s, watched_age_s

ALONE = "alone"  # the state of a yes that one witness gives: they may, and it is no all clear
MAY = "good", ALONE  # the states of a yes
READ = QT_TRANSLATE_NOOP("Words", "read {0} s ago")
TEXTS = (
    QT_TRANSLATE_NOOP("Words", "▲ Hands off: {0}"),
    QT_TRANSLATE_NOOP("Words", "▲ Hands off: not read yet"),
    QT_TRANSLATE_NOOP("Words", "▲ Hands off: not read since {0}; move the mouse, and it is read again"),
    QT_TRANSLATE_NOOP("Words", "▲ Hands off: the coils are not being read"),
    QT_TRANSLATE_NOOP("Words", "▲ Hands off: the platform is not being read"),
    QT_TRANSLATE_NOOP("Words", "✓ Hands may go in: {0}"),
    QT_TRANSLATE_NOOP("Words", "● Hands may go in: {0}"),
    QT_TRANSLATE_NOOP("Words", "▲ Hands off: a run of {0} was cut off; the coils are not known"),
    QT_TRANSLATE_NOOP("Words", "▲ Hands off: another process drives a run of {0}; the coils may be on"),
)


def hands_words(coil_words: str, platform_words: str) -> tuple[str, str]:
    """Whether a person may reach in now, yes or no first, and the state that goes with it; every reason in short.

    Green only where supplies and reference both say zero: what one of them says alone is amber. A no is red.
    """
    if why := reasons(coil_words, platform_words):
        return translated("▲ Hands off: {0}").format("; ".join(why)), "bad"
    if platform_mark(platform_words)[1] == "old":  # it stood, and nobody has looked since
        return translated("▲ Hands off: the platform is not being read"), OFF
    if coil_words == state.NOT_READ:  # nothing is known to be wrong: an alarm each morning would be learned away
        return translated("▲ Hands off: not read yet"), OFF
    if coil_words == state.AT_ZERO:
        return translated("✓ Hands may go in: {0}").format(in_words(state.BY_BOTH)), "good"
    if CHANGED in coil_words:  # a current that its supply does not own to, or something very magnetic
        return translated("▲ Hands off: {0}").format(in_words(CHANGED)), OFF
    if coil_words.startswith(state.BY_WORD):
        return translated("● Hands may go in: {0}").format(in_words(coil_words)), ALONE
    return translated("▲ Hands off: the coils are not being read"), OFF  # they were, and were at zero


def reasons(coil_words: str, platform_words: str) -> list[str]:
    """What is on, turns, or is not confirmed, in words: the coils first; none where nothing is known to be wrong."""
    calm = coil_words.startswith((state.AT_ZERO, state.BY_WORD, state.WAS_ZERO, state.WAS_ZERO_BY_WORD))
    why = [] if calm or coil_words == state.NOT_READ or CHANGED in coil_words else [_of_coils(coil_words)]
    turns = platform_mark(platform_words)[1] in ("warning", "bad")
    return why + ([in_words(platform_words.partition(",")[0])] if turns else [])


def _of_coils(coil_words: str) -> str:
    """The currents; of the rest what it is, without the figures."""
    if coil_words.startswith(state.ON):
        return in_words(coil_words.partition(", read back ")[0])
    return in_words(in_brief(coil_words))


def left_words(now: LabNow) -> str:
    """Of a run that nobody has ended: it goes on elsewhere, or left coils that nobody has read since; "" else."""
    if now.left_by and now.driven_elsewhere:
        return translated("▲ Hands off: another process drives a run of {0}; the coils may be on").format(now.left_by)
    if now.left_by and now.coil_words in ("", state.NOT_READ):
        return translated("▲ Hands off: a run of {0} was cut off; the coils are not known").format(now.left_by)
    return ""


def hands_of(now: LabNow) -> tuple[str, str]:
    """As `hands_words`, by the one rule of how old that may be, `is_watched`: till then the words stay as they are.

    Who gives no answer when it is looked at lets nobody in by what it said before. "bad" where a reason is known, which
    is as loud at rest as in a run; `OFF` where nobody has looked.
    """
    if left := left_words(now):
        return left, "bad"
    to_stop = translated(str(STOP_UNSEEN)) if now.stop_unseen and _rests(now.platform_words) else ""
    first = [*filter(None, (now.closed_with, now.earlier_on, field_says(now), to_stop))]  # whatever a supply says
    if first:
        why = [*first, *reasons(now.coil_words or state.NOT_READ, now.platform_words)]
        return translated("▲ Hands off: {0}").format("; ".join(why)), "bad"
    said, mark = _hands_by_age(now)
    if mark != "bad" and now.coils_lost:
        return translated("▲ Hands off: the coils are not being read"), "bad"
    if mark != "bad" and now.platform_lost:
        return translated("▲ Hands off: the platform is not being read"), "bad"
    if mark != "bad" and now.unread_since:
        words = translated("▲ Hands off: not read since {0}; move the mouse, and it is read again")
        return words.format(now.unread_since), OFF
    return said, mark


def _rests(platform_words: str) -> bool:
    """As it was read last, however long ago."""
    return platform_mark(platform_words)[1] in ("", "good", "old")


def _hands_by_age(now: LabNow) -> tuple[str, str]:
    seen = now.coil_words == state.AT_ZERO or now.coil_words.startswith(state.WAS_ZERO)
    zero = seen or now.coil_words.startswith((state.BY_WORD, state.WAS_ZERO_BY_WORD))
    stands = _rests(now.platform_words)
    if zero and now.coils_late:  # whoever has to wait for their answer is not read either
        return hands_words(state.WAS_ZERO, now.platform_words.partition(",")[0] if stands else now.platform_words)
    if not zero or not stands or CHANGED in now.coil_words or not watched_age_s(now) or not is_watched(now):
        return hands_words(now.coil_words or state.NOT_READ, now.platform_words)
    watched = as_watched(now)  # what a reading has shown keeps its words as long as it may be relied on
    return hands_words(watched.coil_words, watched.platform_words)


def read_words(now: LabNow, mark: str) -> str:
    """How old the oldest reading is that lets hands in, beside a yes; "" beside a no, which says itself why."""
    age_s = let_in_s(now) if mark in MAY else 0
    return translated(str(READ)).format(age_s) if age_s else ""


def dated(words: str, mark: str, now: LabNow) -> tuple[str, str]:
    """The same with that age, where both stand in one line."""
    return " · ".join(filter(None, (words, read_words(now, mark)))), mark

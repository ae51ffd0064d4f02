"""What is read on at rest: how old what lets hands in is, and how old it may be. No widgets."""

from __future__ import annotations

from dataclasses import replace

from labcal.bench.coils import state
from labcal.gui.viewmodels.lab_now import WATCHED_S, LabNow, platform_mark


def as_watched(now: LabNow) -> LabNow:
    """What was read at rest up to `WATCHED_S` ago is read on and stands: the same without its age."""
    if now.coils_lost or now.platform_lost or now.coils_late or not is_watched(now):
        return now
    if now.coil_words.startswith(state.WAS_ZERO) or _seen_between(now):
        now = replace(now, coil_words=state.AT_ZERO, coils_at_zero=True)
    elif now.coil_words.startswith(state.WAS_ZERO_BY_WORD):
        words = f"{state.BY_WORD}: {now.alone}" if now.alone else state.BY_WORD
        now = replace(now, coil_words=words, coils_at_zero=True)
    stood = platform_mark(now.platform_words)[1] == "old"
    return replace(now, platform_words=now.platform_words.partition(",")[0]) if stood else now


def is_watched(now: LabNow) -> bool:
    """Whether nothing of what lets hands in is older than it may be."""
    return (now.coil_old_s or 0) <= WATCHED_S and (now.platform_old_s or 0) <= now.others_by_s


def watched_age_s(now: LabNow) -> int:
    """How old the oldest is of what lets hands in, in whole seconds; 0 where all is fresh."""
    reference_s = now.reference_old_s if _seen_between(now) else 0
    return max(now.coil_old_s or 0, now.platform_old_s or 0, reference_s or 0)


def let_in_s(now: LabNow) -> int:
    """How old the oldest reading is that lets hands in, in seconds that have begun; 0 where none is known."""
    coils, platform, reference = now.begun_s
    seen = now.coil_words == state.AT_ZERO or _seen_between(now) or now.coil_words.startswith(state.WAS_ZERO)
    return max(coils, platform, reference if seen else 0)


def _seen_between(now: LabNow) -> bool:
    """Whether the reference has seen the zero between two looks at the coils: it is looked at less often."""
    recent = now.reference_agreed and 0 <= (now.reference_old_s or 0) <= now.others_by_s
    read_on = now.alone != state.NOT_READ_ON and not now.driven
    return recent and read_on and now.coil_words.startswith(state.BY_WORD)

"""Since when an instrument does not answer, by the clock on the wall: the same words as long as it is lost."""

from __future__ import annotations

import time
from collections.abc import Iterable
from datetime import datetime, timedelta

from PySide6.QtCore import QT_TRANSLATE_NOOP

from labcal.gui.translations.translate import translated
from labcal.gui.viewmodels.lab_now import LabNow, shown_name

WHO = QT_TRANSLATE_NOOP("Words", "✕ No answer from {0}.")
FIRST = QT_TRANSLATE_NOOP(
    "Words", "Put that right first: see to plug and power. “Hands off” is not taken before it answers."
)
TOO = QT_TRANSLATE_NOOP("Words", "See to plug and power as well: nothing is measured before it answers.")
SINCE = QT_TRANSLATE_NOOP("Words", "{0} (since {1})")


class LostSince:
    """Remembers it of each from when it was first seen to be lost."""

    def __init__(self) -> None:
        self._since = dict[str, str]()

    def named(self, now: LabNow) -> list[str]:
        """Who is lost, each with since when."""
        return [translated(str(SINCE)).format(one, since) for one, since in self.since(now).items()]

    def since(self, now: LabNow) -> dict[str, str]:
        """By who is lost: from when it was heard last, where it was."""
        heard_s = {shown_name(name): at_s for name, at_s in now.heard_at_s}
        self._since = {one: self._since.get(one) or _on_the_wall(heard_s.get(one)) for one in now.failed}
        return self._since


def _on_the_wall(heard_s: float | None) -> str:
    """The time of its last word, to the second in which it was: as its age is said elsewhere."""
    age_s = 0.0 if heard_s is None else time.monotonic() - heard_s
    return f"{datetime.now() - timedelta(seconds=age_s):%H:%M:%S}"


def to_be_seen_to(lost: Iterable[str], before: str, *, is_ready: bool) -> str:
    """Who is `lost` at a question, and what to do, `before` that what comes first; `is_ready`: it asks for hands off.

    Also where the answer sends nobody there: at the next question it may have been silent for long.
    """
    who, to_do = translated(str(WHO)).format(", ".join(lost)), translated(str(FIRST if is_ready else TOO))
    return " ".join(filter(None, (who, before, to_do)))

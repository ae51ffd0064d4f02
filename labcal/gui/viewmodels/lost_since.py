"""Since when an instrument does not answer, by the clock on the wall: the same words as long as it is lost."""

from __future__ import annotations

from datetime import datetime, timedelta

from PySide6.QtCore import QT_TRANSLATE_NOOP

from labcal.gui.translations.translate import translated
from labcal.gui.viewmodels.lab_now import LabNow, shown_name

SINCE = QT_TRANSLATE_NOOP("Words", "{0} (since {1})")


class LostSince:
    """Remembers it of each from when it was first seen to be lost."""

    def __init__(self) -> None:
        self._since = dict[str, str]()

    def named(self, now: LabNow) -> list[str]:
        """Who is lost, each with since when: from when it was heard last, where it was."""
        ages = {shown_name(name): old_s for name, old_s in now.heard_old_s}
        self._since = {one: self._since.get(one) or _ago(ages.get(one) or 0) for one in now.failed}
        return [translated(str(SINCE)).format(one, since) for one, since in self._since.items()]


def _ago(seconds: int) -> str:
    return f"{datetime.now() - timedelta(seconds=seconds):%H:%M:%S}"

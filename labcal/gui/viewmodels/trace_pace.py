"""How far the tracing of a residual is: by its stage, and by what it last said of its time. No widgets."""

from __future__ import annotations

import re
import time
from collections.abc import Callable
from datetime import datetime

from PySide6.QtCore import QT_TRANSLATE_NOOP

from labcal.gui.translations.translate import translated

LEFT = re.compile(r"this run takes about (\d+) s more")
STAGES = ("fitting the base model", "scoring every effect", "this run takes", "the selection on each part",
          "what does as well", "holding out blocks")  # fmt: skip
SAID = QT_TRANSLATE_NOOP("Words", "about {0} s more, said at {1}")


class TracePace:
    """`hear` what the loop says, in its order."""

    def __init__(self, now: Callable[[], float] = time.monotonic) -> None:
        self._now, self._began_s, self._stage = now, now(), 0
        self._left_s: float | None = None
        self._said_s, self._said_at = 0.0, ""

    def hear(self, text: str) -> None:
        """A step of the whole, or how much time is left of it."""
        reached = [n for n, stage in enumerate(STAGES) if stage in text]
        self._stage = max([self._stage, *reached])
        if found := LEFT.search(text):
            self._left_s, self._said_s = float(found[1]), self._now()
            self._said_at = f"{datetime.now():%H:%M:%S}"

    def words(self) -> str:
        """The last estimate with its time; "" before there is one, and once what it promised is over."""
        if self._left_s is None or self._now() - self._said_s >= self._left_s:
            return ""
        return translated(str(SAID)).format(f"{self._left_s:.0f}", self._said_at)

    def share(self) -> float:
        """What is over, 0 to 1: by the stage, and within the long ones by the estimate; never whole before the end."""
        by_stage = self._stage / len(STAGES)
        if self._left_s is None:
            return by_stage
        over_s = self._now() - self._began_s
        return max(by_stage, min(0.95, over_s / (self._said_s - self._began_s + self._left_s)))

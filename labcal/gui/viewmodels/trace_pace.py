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
TEXTS = (
    QT_TRANSLATE_NOOP("Words", "about {0} s more, said at {1}"),
    QT_TRANSLATE_NOOP("Words", "about {0} s more, longer than was said before; said at {1}"),
)
SAID, LONGER = map(str, TEXTS)


class TracePace:
    """`hear` what the loop says, in its order."""

    def __init__(self, now: Callable[[], float] = time.monotonic) -> None:
        self._now, self._began_s, self._stage = now, now(), 0
        self._left_s: float | None = None
        self._said_s, self._said_at, self._longer, self._share = 0.0, "", False, 0.0

    def hear(self, text: str) -> None:
        """A step of the whole, or how much time is left of it."""
        reached = [n for n, stage in enumerate(STAGES) if stage in text]
        self._stage = max([self._stage, *reached])
        if found := LEFT.search(text):
            ends_s = None if self._left_s is None else self._said_s + self._left_s
            self._left_s, self._said_s = float(found[1]), self._now()
            self._longer = ends_s is not None and self._said_s + self._left_s > ends_s + 1.0  # it is said in seconds
            self._said_at = f"{datetime.now():%H:%M:%S}"

    def words(self) -> str:
        """The last estimate with its time; "" before there is one, and once what it promised is over."""
        if self._left_s is None or self._now() - self._said_s >= self._left_s:
            return ""
        return translated(LONGER if self._longer else SAID).format(f"{self._left_s:.0f}", self._said_at)

    def share(self) -> float | None:
        """What is over, 0 to 1: by the stage, and within the long ones by the estimate; never whole before the end.

        It never goes back, whatever an estimate says that is longer. None before anything is over: nobody knows then.
        """
        by_estimate = 0.0
        if self._left_s is not None:
            by_estimate = (self._now() - self._began_s) / (self._said_s - self._began_s + self._left_s)
        self._share = max(self._share, self._stage / len(STAGES), min(0.95, by_estimate))
        return self._share or None

"""What a person who waits is told: what is being weighed, and what is known so far should it be stopped."""

from __future__ import annotations

import time
from collections.abc import Callable

Progress = Callable[[str], None]
QUIET_s = 5.0  # between two steps of a search: quick ones are not told
NOTHING = "so far nothing has the evidence of a name"


class Telling:
    """Passes steps on to `progress`, those of a search where nothing was said for a while."""

    def __init__(self, progress: Progress) -> None:
        self.progress, self.doing, self.known, self._said_s = progress, "", "", time.monotonic()

    def step(self, doing: str) -> None:
        """Tell a step of the whole."""
        self.doing, self._said_s = doing, time.monotonic()
        self.progress(f"{doing}; {self.known}" if self.known else doing)

    def weighing(self, doing: str, known: str) -> None:
        """Tell what a search weighs, and what it has found."""
        self.doing, self.known = doing, known
        if time.monotonic() - self._said_s > QUIET_s:
            self.step(doing)

    def stopped(self) -> None:
        """Tell what is known when the work is stopped."""
        self.progress(f"stopped while {self.doing}; {self.known or 'nothing is known yet'}")

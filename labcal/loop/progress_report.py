"""Progress of a long run: which step it is at, and what is known so far should it be stopped."""

from __future__ import annotations

import time
from collections.abc import Callable

Progress = Callable[[str], None]
SILENT_s = 5.0  # between two steps of a search: quick ones are not reported
NOTHING = "so far nothing has the evidence of a name"


class ProgressReport:
    """Passes steps on to `progress`, those of a search where nothing was reported for a while."""

    def __init__(self, progress: Progress) -> None:
        self.progress, self.doing, self.known, self._reported_s = progress, "", "", time.monotonic()

    def step(self, doing: str) -> None:
        """Report a step of the whole."""
        self.doing, self._reported_s = doing, time.monotonic()
        self.progress(f"{doing}; {self.known}" if self.known else doing)

    def scoring(self, doing: str, known: str) -> None:
        """Report what a search scores, and what it has found."""
        self.doing, self.known = doing, known
        if time.monotonic() - self._reported_s > SILENT_s:
            self.step(doing)

    def stopped(self) -> None:
        """Report what is known when the work is stopped."""
        self.progress(f"stopped while {self.doing}; {self.known or 'nothing is known yet'}")

"""A simulated run keeps step with its window: it stands still while that has not taken what was said long ago."""

from __future__ import annotations

import threading
import time
from collections import deque
from collections.abc import Callable

AHEAD_S = 0.2  # by so much a run may be ahead of what its window has taken
LOOK_S = 0.005


class KeepsStep:
    """Counts the lines that went to a window, and those that it says it has `taken`; one that never says so has all."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self.begin()

    def begin(self) -> None:
        """Another window listens: of what went to the one before it takes nothing."""
        with self._lock:
            self._sent_s, self._number, self._says = deque[float](), 0, False

    def sent(self) -> None:
        """A line went out."""
        with self._lock:
            self._sent_s.append(time.monotonic())

    def taken(self, lines: int) -> None:
        """So many in all."""
        with self._lock:
            self._says = True
            while self._number < lines and self._sent_s:
                self._number += 1
                self._sent_s.popleft()

    @property
    def ahead_s(self) -> float:
        """How long ago the oldest line was said that is not taken; 0 where there is none."""
        with self._lock:
            return time.monotonic() - self._sent_s[0] if self._says and self._sent_s else 0.0

    def wait(self, ends: Callable[[], bool]) -> None:
        """Until the window has caught up; or at once where the run `ends`, for its way out waits for nobody."""
        while self.ahead_s > AHEAD_S and not ends():
            time.sleep(LOOK_S)

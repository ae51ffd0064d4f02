"""A time on the wall that is promised: it stays as it was said for as long as "about" is true of it. No Qt."""

from __future__ import annotations

from labcal.gui.viewmodels.number_format import CLOCK_S


class Promised:
    """Said to the minute: an estimate that differs by less is the same, and moves nothing.

    What a person takes moves it by as much, and by no more.
    """

    def __init__(self) -> None:
        self._at_s: float | None = None
        self._waits_since_s: float | None = None

    def waits(self, now_s: float) -> None:
        """For a person, from now on."""
        if self._waits_since_s is None:
            self._waits_since_s = now_s

    def goes_on(self, now_s: float) -> None:
        """Somebody answered."""
        if self._at_s is not None and self._waits_since_s is not None:
            self._at_s += now_s - self._waits_since_s
        self._waits_since_s = None

    def in_s(self, now_s: float, estimated_s: float) -> float:
        """In how long it comes, which is `estimated_s` by what is known now: as it was said, where that holds still."""
        comes_s = now_s + estimated_s
        if self._at_s is None or abs(comes_s - self._at_s) > CLOCK_S or self._at_s <= now_s:
            self._at_s = comes_s
        return self._at_s - now_s

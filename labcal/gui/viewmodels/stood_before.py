"""A platform that was read to stand when it was told to stop stands until something orders it to turn. No widgets."""

from __future__ import annotations

from labcal.bench.coils.state import PlatformReading
from labcal.gui.viewmodels.lab_now import WATCHED_S


class StoodBefore:
    """Whether it stood as COILS OFF was pressed: an order to stop is no reason to fear that it turns."""

    def __init__(self) -> None:
        self.holds = False
        self._free_s = 0.0  # since when no run can have turned it
        self._read_s: float | None = None  # when it was read to stand, at the last such order

    def run_over(self, now_s: float) -> None:
        """A run is at its end, or was ended: what it read of the platform before says nothing of its last orders."""
        self._free_s, self.holds, self._read_s = now_s, False, None

    def ordered(self, platform: PlatformReading | None, now_s: float, *, may_be_turned: bool) -> None:
        """It is told to stop; `may_be_turned`: by a run that goes on, here or elsewhere, or its line is silent.

        A second order before it was read again changes nothing.
        """
        read_s = None if platform is None or platform.moving is not False else platform.read_s
        known = read_s is not None and read_s > self._free_s and not may_be_turned
        self.holds = known and read_s is not None and (now_s - read_s <= WATCHED_S or read_s == self._read_s)
        self._read_s = read_s if self.holds else None

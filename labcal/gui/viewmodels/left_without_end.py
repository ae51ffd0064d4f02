"""A run on this bench that no window saw end: another process drives it still, or was killed with the coils on.

Whoever opens a window then is told so, until the coils are read or it is gone on with. No widgets.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Protocol

from PySide6.QtCore import QObject, QTimer, Signal

from labcal.gui.ipc.bench_facts import Bench
from labcal.gui.ipc.record_messages import LookForLeft
from labcal.gui.viewmodels.lab import LabViewModel
from labcal.gui.viewmodels.lab_now import LabNow
from labcal.gui.viewmodels.lab_watch import LabWatch
from labcal.gui.viewmodels.left_unconfirmed import LeftUnconfirmed
from labcal.gui.viewmodels.run import RunViewModel
from labcal.record.left_running import LeftRunning

AGAIN_MS = 3000  # between two looks, while another process drives the bench


class AsksStore(Protocol):
    """Whose bench is open."""

    bench: str
    facts: Bench | None
    lab: LabViewModel
    run: RunViewModel
    watch: LabWatch

    def by_hand(self) -> tuple[str, ...]:
        """The supplies that a person has to switch off."""

    def request(self, command: LookForLeft, then: Callable[[LeftRunning | None], object]) -> None:
        """Ask a worker."""


class LeftWithoutEnd(QObject):
    """`found`: the last run on the bench of `window`, where that has no end."""

    changed = Signal()

    def __init__(self, window: AsksStore) -> None:
        super().__init__()
        self._window = window
        self.found: LeftRunning | None = None
        self.unconfirmed = LeftUnconfirmed()
        self.timer = QTimer(self, interval=AGAIN_MS)
        self.timer.timeout.connect(self.look)

    def look_early(self) -> None:
        """What a window before this one left is said while the bench is being opened."""
        if self._window.facts is None:
            self.unconfirmed.look(self._window.bench)
            self.changed.emit()

    def look(self) -> None:
        """Look into the store; a run of this window says itself how it is."""
        facts = self._window.facts
        self.unconfirmed.look(self._window.bench)
        if facts is not None and self.unconfirmed.left and not self._window.run.alive:
            self._window.watch.read_all()  # nobody has to ask for it
        if facts is None or self._window.run.alive:
            return self._take("", None)
        return self._window.request(LookForLeft(facts.name), lambda found: self._take(facts.name, found))

    def forget(self) -> None:
        """Of another bench nothing is known."""
        self.found, self.unconfirmed = None, LeftUnconfirmed()
        self.timer.stop()

    def _take(self, bench: str, found: LeftRunning | None) -> None:
        facts = self._window.facts
        if found is not None and (facts is None or facts.name != bench or self._window.run.alive):
            return  # it comes too late
        self.timer.start() if found is not None and found.goes_on else self.timer.stop()
        if found != self.found:
            self.found = found
            self.changed.emit()

    def seen_in(self, now: LabNow) -> LabNow:
        """The lab with what that run has to do with it, and what a window before this one has left."""
        self.unconfirmed.keep(now, self._window.by_hand(), self._window.facts)
        now = self.unconfirmed.seen_in(now)
        if self.found is None or now.driven:
            return now
        return replace(now, left_by=self.found.dut_serial, driven_elsewhere=self.found.goes_on)

    def close(self) -> None:
        """What is not confirmed now is so as the window closes."""
        self.timer.stop()
        now = replace(self._window.lab.state.now, closed_with="")
        self.unconfirmed.keep(now, self._window.by_hand(), self._window.facts, closing=True)

    def objection(self) -> str:
        """Why nothing may begin here now; "" where that run has ended, or was cut off."""
        if self.found is None or not self.found.goes_on or self._window.run.alive:
            return ""
        words = self.tr("Another process still drives a run of {0} on this bench: wait until it has ended.")
        return words.format(self.found.dut_serial)

"""Supplies that an earlier session on this bench file left at other links: named apart, until they are said to be gone.

They are no coils of this bench: they have no row, and hold no zero of it. One that still carries a current keeps hands
off all the same.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from typing import Protocol

from PySide6.QtCore import QObject, Signal, SignalInstance

from labcal.gui.ipc.bench_facts import EarlierSupply
from labcal.gui.ipc.client import Client
from labcal.gui.ipc.lab_messages import EarlierAreGone
from labcal.gui.viewmodels.lab import LabViewModel
from labcal.gui.viewmodels.lab_now import LabNow


class OnBench(Protocol):
    """Whose bench it is, and who is asked."""

    bench: str
    lab: LabViewModel
    off_worker: Client

    @property
    def fault(self) -> SignalInstance:
        """Of anything that has no card of its own."""


class EarlierSupplies(QObject):
    """`left`: those that were not read back at zero when COILS OFF asked for them last."""

    changed = Signal()

    def __init__(self, window: OnBench) -> None:
        super().__init__()
        self._window = window
        self.left: tuple[EarlierSupply, ...] = ()

    def take(self, left: Iterable[EarlierSupply]) -> None:
        """As COILS OFF found them."""
        before, self.left = self.left, tuple(left)
        if self.left != before:
            self.changed.emit()

    @property
    def gone(self) -> tuple[EarlierSupply, ...]:
        """Those at whose link nothing is any more: of these a person may say so."""
        return tuple(one for one in self.left if one.gone)

    def seen_in(self, now: LabNow) -> LabNow:
        """The lab, with those that answer and still carry a current."""
        on = ", ".join(one.name for one in self.left if one.flows)
        words = self.tr("a supply of an earlier session is not at zero: {0}").format(on)
        return replace(now, earlier_on=words) if on else now

    def say_gone(self) -> None:
        """Whoever works here says that these are there no more; it is kept in the audit log."""
        window, gone = self._window, self.gone
        who = window.lab.state.operator
        asked = EarlierAreGone(window.bench, tuple(one.port for one in gone), who)
        window.off_worker.request(asked, lambda _: self._are_gone(gone, who), window.fault.emit)

    def _are_gone(self, gone: tuple[EarlierSupply, ...], who: str) -> None:
        self.take(one for one in self.left if one not in gone)
        words = self.tr("{0}: gone, says {1}; it is kept in the audit log")
        self._window.lab.update(message=words.format(", ".join(one.name for one in gone), who))

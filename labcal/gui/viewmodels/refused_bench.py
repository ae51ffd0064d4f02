"""A bench file that was not taken: which bench is open now, said for as long as it is news."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from PySide6.QtCore import QT_TRANSLATE_NOOP

from labcal.gui.ipc.wire import Fault
from labcal.gui.translations.translate import translated
from labcal.gui.viewmodels.lab import LabViewModel

STAYS = QT_TRANSLATE_NOOP("Words", "The bench that was open stays open: {0}.")


class RefusedBench:
    """Its card goes with the next bench that is taken, and with another page. `say` shows it, `over` takes it away."""

    def __init__(self, lab: LabViewModel, say: Callable[[Fault], object], over: Callable[[Fault], object]) -> None:
        self._lab, self._say, self._over = lab, say, over
        self._said: Fault | None = None

    def say(self, fault: Fault) -> None:
        """Why it was not taken, and that the one before stays."""
        self._lab.update(message="", opening=False)
        open_still = self._lab.state.bench
        stays = translated(str(STAYS)).format(open_still) if open_still else ""
        self._said = replace(fault, remedy=" ".join(filter(None, (fault.remedy, stays))))
        self._say(self._said)

    def put_away(self) -> None:
        """It is past."""
        said, self._said = self._said, None
        if said is not None:
            self._over(said)

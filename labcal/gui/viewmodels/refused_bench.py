"""A bench file that was not taken: which bench is open now, said for as long as it is news."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from PySide6.QtCore import QT_TRANSLATE_NOOP

from labcal.gui.ipc.wire import Fault
from labcal.gui.translations.translate import translated

if TYPE_CHECKING:
    from labcal.gui.viewmodels.app_state import AppState

STAYS = QT_TRANSLATE_NOOP("Words", "The bench that was open stays open: {0}.")


class RefusedBench:
    """Its card goes with the next bench that is taken, and with another page."""

    def __init__(self, app_state: AppState) -> None:
        self._app_state = app_state
        self._said: Fault | None = None

    def say(self, fault: Fault) -> None:
        """Why it was not taken, and that the one before stays."""
        state = self._app_state
        state.lab.update(message="", opening=False)
        stays = "" if state.facts is None else translated(str(STAYS)).format(state.facts.name)
        self._said = replace(fault, remedy=" ".join(filter(None, (fault.remedy, stays))))
        state.fault.emit(self._said)

    def put_away(self) -> None:
        """It is past."""
        said, self._said = self._said, None
        if said is not None:
            self._app_state.fault_over.emit(said)

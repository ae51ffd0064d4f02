"""The simulated lab, taken as the bench by one click."""

from __future__ import annotations

from PySide6.QtCore import QT_TRANSLATE_NOOP

from labcal.gui.ipc.messages import FindSimulatedBench
from labcal.gui.translations.translate import translated
from labcal.gui.viewmodels.app_state import AppState

OPENING = QT_TRANSLATE_NOOP("Words", "Opening the simulated lab …")


def open_simulated_bench(app_state: AppState) -> None:
    """Ask where its file is and open that; says so at once, because the first answer of a worker takes seconds."""
    if not app_state.run.alive:
        app_state.lab.update(message=translated(str(OPENING)))
    app_state.request(FindSimulatedBench(), app_state.open_bench)

"""What the record of one run tells beside its rows: interruptions, and what was noted."""

from __future__ import annotations

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QVBoxLayout, QWidget

from labcal.gui.ipc.record_messages import TellRecord
from labcal.gui.viewmodels.app_state import AppState
from labcal.gui.viewmodels.told_words import interrupted_words, noted_words
from labcal.gui.widgets.common import label, set_state
from labcal.record.told import Told


class RecordWords(QWidget):
    """Asks for itself; nothing is seen of a run of which there is nothing to tell."""

    def __init__(self, app_state: AppState, *, centred: bool = False) -> None:
        super().__init__()
        self._app_state, self._run = app_state, ""
        self.interrupted, self.noted = label("", wrap=True), label("", wrap=True)
        set_state(self.interrupted, "warning")
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        for words in (self.interrupted, self.noted):
            if centred:
                words.setAlignment(Qt.AlignmentFlag.AlignCenter)
            column.addWidget(words)
        self._show(Told())

    def show_run(self, run: str) -> None:
        """Of this run; the same one again is read again. None where it is ""."""
        if run != self._run:
            self._show(Told())
        self._run = run
        if run:
            self._app_state.quick_worker.request(
                TellRecord(run), lambda told: self._told(run, told), lambda _: self._told(run, Told())
            )

    def _told(self, run: str, told: Told) -> None:
        if run == self._run:
            self._show(told)

    def _show(self, told: Told) -> None:
        for shown, words in ((self.interrupted, interrupted_words(told)), (self.noted, noted_words(told))):
            shown.setText(words)
            shown.setVisible(bool(words))
